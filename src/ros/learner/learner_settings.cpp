#include "ros/learner/learner_settings.h"

namespace crowd {
namespace {

template <typename Enum, std::size_t COUNT>
std::vector<std::string> choicesOf(const EnumNames<Enum, COUNT>& names) {
  return {names.names().begin(), names.names().end()};
}

}  // namespace

LiveParameters<LearnerSettings> liveLearnerParameters() {
  using P = LearningParameters;
  LiveParameters<LearnerSettings> live;
  const auto add = [&](LiveDescription about, auto member) {
    live.add(
        std::move(about), [member](auto& settings) -> auto& { return settings.plan.parameters.*member; });
  };
  live.add<std::string>(
      {"mode", "training: explore and learn; demo: greedy, the table does not change", {}, choicesOf(MODES)},
      [](const LearnerSettings& settings) { return MODES.nameOf(settings.mode); },
      [](LearnerSettings& settings, const std::string& name) { settings.mode = MODES.parse(name); });
  add({"alpha", "learning rate", P::ALPHA, {}}, &P::alpha);
  add({"alpha_decay", "decay of the learning rate with the visits", P::FRACTION, {}}, &P::alpha_decay);
  add({"gamma", "discount factor", P::GAMMA, {}}, &P::gamma);
  add({"lambda", "decay of the eligibility traces", P::FRACTION, {}}, &P::lambda);
  live.add<double>(
      {"epsilon", "probability of a random decision in training mode; a new value ends a schedule", P::FRACTION, {}},
      [](const LearnerSettings& settings) { return settings.plan.parameters.epsilon; },
      [](LearnerSettings& settings, const double& epsilon) {
        settings.plan.parameters.epsilon = epsilon;
        settings.plan.epsilon = EpsilonSchedule::constant(epsilon);
      });
  add({"mirrored", "learn every experience with left and right exchanged, too", {}, {}}, &P::mirrored);
  live.add<std::string>(
      {"ties", "choice among equal values", {}, choicesOf(TIES)},
      [](const LearnerSettings& settings) { return TIES.nameOf(settings.plan.parameters.ties); },
      [](LearnerSettings& settings, const std::string& name) { settings.plan.parameters.ties = TIES.parse(name); });
  return live;
}

}  // namespace crowd
