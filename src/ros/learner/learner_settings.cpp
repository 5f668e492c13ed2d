#include "social_crowd/ros/learner/learner_settings.h"

namespace crowd {
namespace {

template <typename Enum, std::size_t COUNT>
std::vector<std::string> choicesOf(const EnumNames<Enum, COUNT>& names) {
  return {names.names().begin(), names.names().end()};
}

/// Adds a member of the learning parameters.
template <typename Value>
void addMember(LiveParameters<LearnerSettings>& live, LiveDescription about, Value LearningParameters::*member) {
  live.add<Value>(
      std::move(about), [member](const LearnerSettings& settings) { return settings.plan.parameters.*member; },
      [member](LearnerSettings& settings, const Value& value) { settings.plan.parameters.*member = value; });
}

}  // namespace

LiveParameters<LearnerSettings> liveLearnerParameters() {
  using P = LearningParameters;
  LiveParameters<LearnerSettings> live;
  live.add<std::string>(
      {"mode", "training: explore and learn; demo: greedy, the table does not change", {}, choicesOf(MODES)},
      [](const LearnerSettings& settings) { return MODES.nameOf(settings.mode); },
      [](LearnerSettings& settings, const std::string& name) { settings.mode = MODES.parse(name); });
  addMember(live, {"alpha", "learning rate", P::ALPHA, {}}, &P::alpha);
  addMember(live, {"alpha_decay", "decay of the learning rate with the visits", P::FRACTION, {}}, &P::alpha_decay);
  addMember(live, {"gamma", "discount factor", P::GAMMA, {}}, &P::gamma);
  addMember(live, {"lambda", "decay of the eligibility traces", P::FRACTION, {}}, &P::lambda);
  live.add<double>(
      {"epsilon", "probability of a random decision in training mode; a new value ends a schedule", P::FRACTION, {}},
      [](const LearnerSettings& settings) { return settings.plan.parameters.epsilon; },
      [](LearnerSettings& settings, const double& epsilon) {
        settings.plan.parameters.epsilon = epsilon;
        settings.plan.epsilon = EpsilonSchedule::constant(epsilon);
      });
  addMember(live, {"mirrored", "learn every experience with left and right exchanged, too", {}, {}}, &P::mirrored);
  live.add<std::string>(
      {"ties", "choice among equal values", {}, choicesOf(TIES)},
      [](const LearnerSettings& settings) { return TIES.nameOf(settings.plan.parameters.ties); },
      [](LearnerSettings& settings, const std::string& name) { settings.plan.parameters.ties = TIES.parse(name); });
  return live;
}

}  // namespace crowd
