#include "learning/rl/td_learner.h"

namespace crowd {
namespace {

/// Counts a visit and returns the change of the value (3.1).
double visit(QTable& table, Row row, Action action, double target, const LearningRateSchedule& learning_rates) {
  return learning_rates.at(table.countVisit(row, action)) * (target - table.value(row, action));
}

}  // namespace

void TdLearner::fadeTraces(const QTable& table, const Rows& rows, Action action, const LearningParameters& parameters) {
  const bool greedy = table.value(rows[action], action) >= table.greedyValue(rows);
  if (!greedy) {
    traces_.clear();  // Watkins: rewards after an exploring action do not evaluate the greedy policy
  } else if (has_decision_) {
    decayTraces(parameters.gamma * parameters.lambda);
  }
}

void TdLearner::update(QTable& table, double target, const LearningParameters& parameters,
                       const LearningRateSchedule& learning_rates, const Mirror& mirror) {
  const double step = visit(table, row_, action_, target, learning_rates);
  const bool has_image = mirror.hasImage(row_, action_);
  const double mirrored_step =
      has_image ? visit(table, mirror.row(row_), mirror.action(action_), target, learning_rates) : step;
  if (parameters.lambda > 0.0) return addToTraces(table, step, mirrored_step, mirror);
  table.addTo(row_, action_, step);
  if (has_image) table.addTo(mirror.row(row_), mirror.action(action_), mirrored_step);
}

void TdLearner::addToTraces(QTable& table, double step, double mirrored_step, const Mirror& mirror) {
  remember({row_, action_, 1.0});
  for (const auto& [row, action, eligibility] : traces_) {
    table.addTo(row, action, step * eligibility);
    if (mirror.hasImage(row, action)) {
      table.addTo(mirror.row(row), mirror.action(action), mirrored_step * eligibility);
    }
  }
}

void TdLearner::remember(const Trace& trace) {
  const auto same = [&](const Trace& other) { return other.row == trace.row && other.action == trace.action; };
  const auto found = std::find_if(traces_.begin(), traces_.end(), same);
  if (found == traces_.end()) {
    traces_.push_back(trace);
  } else {
    found->eligibility += trace.eligibility;
  }
}

void TdLearner::decayTraces(double factor) {
  for (Trace& trace : traces_) trace.eligibility *= factor;
  const auto negligible = [](const Trace& trace) { return trace.eligibility < NEGLIGIBLE_TRACE; };
  traces_.erase(std::remove_if(traces_.begin(), traces_.end(), negligible), traces_.end());
}

}  // namespace crowd
