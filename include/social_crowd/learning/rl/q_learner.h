#pragma once

#include <algorithm>
#include <vector>

#include "social_crowd/learning/rl/learning_parameters.h"
#include "social_crowd/learning/rl/learning_rate_schedule.h"
#include "social_crowd/learning/rl/mirror.h"
#include "social_crowd/learning/rl/q_table.h"

namespace crowd {

/// @brief Q-learning (3.1) of one agent on a Q-table that it may share with others: updates with Watkins's eligibility
/// traces, and choice of actions. Knows nothing of perceptions.
///
/// Use: choose an action for the rows of the present state, carry it out, then learn from the reward and the rows of
/// the state it led to (or learnTerminal), choose again. With a mirror, the same targets also teach the mirror images
/// of the decision and of those that traces lead back to, as if another agent had lived through all of it with left and
/// right exchanged; what is its own mirror image is learned once. A table in which mirror images are equal stays so,
/// bit for bit.
class QLearner {
 public:
  static constexpr double FIRST_OF_TIES = 0.0;

  /// @brief Greedy choice (pure control).
  /// @param tie in [0, 1), decides between equal values; 0: the first
  static Action chooseGreedy(const QTable& table, const Rows& rows, double tie = FIRST_OF_TIES) {
    return tie > FIRST_OF_TIES ? table.greedyAction(rows, tie) : table.greedyAction(rows);
  }

  /// @brief Epsilon-greedy choice: with probability epsilon any action, else the greedy one.
  /// @param draw uniform in [0, 1), decides whether to explore; @param any uniform in [0, 1), decides on which action.
  /// @param tie as in chooseGreedy()
  static Action chooseExploring(const QTable& table, const Rows& rows, double epsilon, double draw, double any,
                                double tie = FIRST_OF_TIES) {
    if (draw >= epsilon) return chooseGreedy(table, rows, tie);
    return std::min(static_cast<Action>(any * table.actions()), table.actions() - 1);
  }

  /// @brief Notes that an action was taken; the next learn() is about it. Cuts the traces if the action is not greedy.
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

  /// @brief Learns from the noted decision: it brought `reward` and led to a state with these rows.
  void learn(QTable& table, double reward, const Rows& next, const LearningParameters& parameters,
             const LearningRateSchedule& learning_rates, const Mirror& mirror = Mirror()) {
    update(table, reward + parameters.gamma * table.greedyValue(next), parameters, learning_rates, mirror);
  }

  /// @brief Learns from the noted decision: it brought `reward` and ended the episode; nothing is expected beyond.
  void learnTerminal(QTable& table, double reward, const LearningParameters& parameters,
                     const LearningRateSchedule& learning_rates, const Mirror& mirror = Mirror()) {
    update(table, reward, parameters, learning_rates, mirror);
    resetTraces();
  }

  bool hasDecision() const { return has_decision_; }

  /// @brief Forgets the noted decision and the traces; the table stays.
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
