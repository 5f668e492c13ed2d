#pragma once

#include <vector>

#include "learning/rl/learning_parameters.h"
#include "learning/rl/learning_rate_schedule.h"
#include "learning/rl/mirror.h"
#include "learning/rl/q_table.h"

namespace crowd {

/// @brief Q-learning of one agent (thesis, (3.1); Watkins 1989), with Watkins's eligibility traces, on a Q-table that
/// it may share with other agents. Independent of perceptions.
///
/// Call contract: choose an action for the rows of the state, call recordDecision(), carry the action out, then call
/// learn() with the reward and the rows of the next state, or learnTerminal(). Not thread-safe, also with respect to
/// the table.
///
/// With a mirror, the same targets also update the mirror images of the decision and of its traces, as if another agent
/// had made the same experience with left and right exchanged. A pair that is its own mirror image is updated once. A
/// table in which mirror images have equal values keeps this property, bit for bit.
class TdLearner {
 public:
  /// @brief Records the action that was chosen, for the next learn(). Clears the traces if the action is not greedy.
  void recordDecision(const QTable& table, const Rows& rows, Action action, const LearningParameters& parameters) {
    if (parameters.lambda > 0.0) {
      fadeTraces(table, rows, action, parameters);
    } else {
      traces_.clear();
    }
    has_decision_ = true;
    row_ = rows[action];
    action_ = action;
  }

  /// @brief Updates the table for the recorded decision (3.1).
  /// @param next rows of the next state
  void learn(QTable& table, double reward, const Rows& next, const LearningParameters& parameters,
             const LearningRateSchedule& learning_rates, const Mirror& mirror = Mirror()) {
    update(table, reward + parameters.gamma * table.greedyValue(next), parameters, learning_rates, mirror);
  }

  /// @brief Updates the table for a recorded decision that ended the episode: the target is the reward alone.
  void learnTerminal(QTable& table, double reward, const LearningParameters& parameters,
                     const LearningRateSchedule& learning_rates, const Mirror& mirror = Mirror()) {
    update(table, reward, parameters, learning_rates, mirror);
    resetTraces();
  }

  /// @brief Whether a decision is recorded.
  bool hasDecision() const { return has_decision_; }

  /// @brief Clears the recorded decision and the traces; does not change the table.
  void resetTraces() {
    has_decision_ = false;
    traces_.clear();
  }

 private:
  struct Trace {
    Row row = 0;
    Action action = 0;
    double eligibility = 0.0;
  };
  static constexpr double NEGLIGIBLE_TRACE = 1e-6;

  void update(QTable& table, double target, const LearningParameters& parameters,
              const LearningRateSchedule& learning_rates, const Mirror& mirror);
  void fadeTraces(const QTable& table, const Rows& rows, Action action, const LearningParameters& parameters);
  void addToTraces(QTable& table, double step, double mirrored_step, const Mirror& mirror);
  void remember(const Trace& trace);
  void decayTraces(double factor);

  bool has_decision_ = false;
  Row row_ = 0;
  Action action_ = 0;
  std::vector<Trace> traces_;  // of earlier decisions; unused with lambda 0
};

}  // namespace crowd
