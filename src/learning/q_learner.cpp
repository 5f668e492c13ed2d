#include "social_crowd/learning/q_learner.h"

#include <algorithm>

namespace crowd {
namespace {

/// Counts a visit; returns by how much it moves the value (3.1).
double visit(QTable& table, Row row, Action action, double target, const LearningParameters& parameters) {
  table.countVisit(row, action);
  return parameters.stepSize(table.visits(row, action)) * (target - table.value(row, action));
}

}  // namespace

Action QLearner::chooseExploring(const QTable& table, const Rows& rows, double epsilon, double draw, double any) {
  if (draw >= epsilon) return chooseGreedy(table, rows);
  return std::min(static_cast<Action>(any * table.actions()), table.actions() - 1);
}

void QLearner::noteDecision(const QTable& table, const Rows& rows, Action action,
                            const LearningParameters& parameters) {
  if (parameters.lambda > 0.0) {
    const bool greedy = table.value(rows[action], action) >= table.greedyValue(rows);
    if (!greedy) {
      traces_.clear();  // Watkins: what follows an exploring action says nothing of the greedy policy before it
    } else if (has_decision_) {
      decayTraces(parameters.gamma * parameters.lambda);
    }
  } else {
    traces_.clear();
  }
  has_decision_ = true;
  row_ = rows[action];
  action_ = action;
}

void QLearner::learn(QTable& table, double reward, const Rows& next, const LearningParameters& parameters,
                     const Mirror& mirror) {
  update(table, reward + parameters.gamma * table.greedyValue(next), parameters, mirror);
}

void QLearner::learnTerminal(QTable& table, double reward, const LearningParameters& parameters, const Mirror& mirror) {
  update(table, reward, parameters, mirror);
  resetTraces();
}

void QLearner::update(QTable& table, double target, const LearningParameters& parameters, const Mirror& mirror) {
  const auto has_image = [&](Row row, Action action) {
    return mirror.row(row) != row || mirror.action(action) != action;
  };
  const double step = visit(table, row_, action_, target, parameters);
  const double mirrored_step =
      has_image(row_, action_) ? visit(table, mirror.row(row_), mirror.action(action_), target, parameters) : step;
  const auto add = [&](Row row, Action action, double eligibility) {
    table.addTo(row, action, step * eligibility);
    if (has_image(row, action)) table.addTo(mirror.row(row), mirror.action(action), mirrored_step * eligibility);
  };
  if (parameters.lambda <= 0.0) {
    add(row_, action_, 1.0);
    return;
  }
  remember({row_, action_, 1.0});
  for (const Trace& trace : traces_) add(trace.row, trace.action, trace.eligibility);
}

void QLearner::remember(const Trace& trace) {
  const auto same = [&](const Trace& other) { return other.row == trace.row && other.action == trace.action; };
  const auto found = std::find_if(traces_.begin(), traces_.end(), same);
  if (found == traces_.end()) {
    traces_.push_back(trace);
  } else {
    found->eligibility += trace.eligibility;
  }
}

void QLearner::decayTraces(double factor) {
  for (Trace& trace : traces_) trace.eligibility *= factor;
  const auto negligible = [](const Trace& trace) { return trace.eligibility < NEGLIGIBLE_TRACE; };
  traces_.erase(std::remove_if(traces_.begin(), traces_.end(), negligible), traces_.end());
}

void QLearner::resetTraces() {
  has_decision_ = false;
  traces_.clear();
}

}  // namespace crowd
