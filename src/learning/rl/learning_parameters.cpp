#include "learning/rl/learning_parameters.h"

#include <array>
#include <utility>

#include "common/portable_math.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"

namespace crowd {
namespace {

constexpr std::size_t LONGEST_TEXT = 10'000;

/// Returns the only document of a text; undefined if there is none, or there are several.
YAML::Node documentOf(const std::string& text, const std::string& name) {
  requireShort(name, text, LONGEST_TEXT);
  const std::vector<YAML::Node> documents = parseYamlStream(text, name);
  return documents.size() == 1 ? documents.front() : YAML::Node(YAML::NodeType::Undefined);
}

}  // namespace

std::string LearningParameters::problems() const {
  std::string problems;
  const auto require = [&](const NumberRange& range, const char* name, double got) {
    if (range.contains(got)) return;
    if (!problems.empty()) problems += "; ";
    problems += std::string(name) + ": expected " + toText(range) + ", got " + toText(got);
  };
  require(ALPHA, "alpha", alpha);
  require(GAMMA, "gamma", gamma);
  require(FRACTION, "lambda", lambda);
  require(FRACTION, "alpha_decay", alpha_decay);
  require(FRACTION, "epsilon", epsilon);
  return problems;
}

double EpsilonSchedule::at(std::uint64_t episode) const {
  if (episode >= episodes) return last;
  const double fraction = static_cast<double>(episode) / static_cast<double>(episodes);
  if (shape == Shape::EXPONENTIAL) return first * portable::pow(last / first, fraction);
  return first + fraction * (last - first);
}

EpsilonSchedule readEpsilon(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsDefined() || !node.IsMap())
    return EpsilonSchedule::constant(readNumber(node, place, NumberRule::FRACTION));
  const YamlMap map(node, place, {"from", "to", "episodes", "shape"});
  EpsilonSchedule schedule;
  schedule.first = map.number("from", NumberRule::FRACTION);
  schedule.last = map.number("to", NumberRule::FRACTION);
  schedule.episodes = static_cast<std::uint64_t>(map.whole("episodes", 1, INT64_MAX));
  schedule.shape = EpsilonSchedule::SHAPES.read(map, schedule.shape);
  const bool has_zero = schedule.first <= 0.0 || schedule.last <= 0.0;
  if (schedule.shape == EpsilonSchedule::Shape::EXPONENTIAL && has_zero) {
    throwExpected(place, node, "from and to above 0 for an exponential schedule");
  }
  return schedule;
}

EpsilonSchedule parseEpsilon(const std::string& text, const std::string& name) {
  return readEpsilon(documentOf(text, name), {name, 0, ""});
}

void readParameter(const YamlMap& map, const std::string& key, double LearningParameters::*member,
                   LearningParameters& parameters) {
  const YAML::Node node = map.find(key);
  if (!node) return;
  LearningParameters alone;
  alone.*member = readNumber(node, map.placeOf(key));
  // The place contains the key, so it is removed from the message.
  if (!alone.problems().empty()) throwProblem(map.placeOf(key), node, alone.problems().substr(key.size() + 2));
  parameters.*member = alone.*member;
}

LearningPlan readLearningPlan(const YAML::Node& node, const YamlPlace& place, const LearningPlan& otherwise) {
  const YamlMap map(node, place, {"alpha", "alpha_decay", "gamma", "lambda", "mirrored", "ties", "epsilon"});
  LearningPlan plan = otherwise;
  readParameter(map, "alpha", &LearningParameters::alpha, plan.parameters);
  readParameter(map, "alpha_decay", &LearningParameters::alpha_decay, plan.parameters);
  readParameter(map, "gamma", &LearningParameters::gamma, plan.parameters);
  readParameter(map, "lambda", &LearningParameters::lambda, plan.parameters);
  plan.parameters.mirrored = map.flag("mirrored", plan.parameters.mirrored);
  plan.parameters.ties = TIES.read(map, plan.parameters.ties);
  if (const YAML::Node epsilon = map.find("epsilon")) {
    plan.epsilon = readEpsilon(epsilon, map.placeOf("epsilon"));
    plan.parameters.epsilon = plan.epsilon.at(0);
  }
  return plan;
}

LearningPlan changedPlan(const LearningPlan& plan, const std::string& text, const std::string& name) {
  const YAML::Node document = documentOf(text, name);
  if (!document.IsDefined() || !document.IsMap()) {
    throw InputError(name + ": expected a map such as {alpha: 0.05, epsilon: 0}, got " + inQuotes(text));
  }
  return readLearningPlan(document, {name, 0, ""}, plan);
}

std::string toText(const EpsilonSchedule& schedule) {
  if (schedule.episodes == 0 || schedule.first == schedule.last) return toText(schedule.last);
  return "{from: " + toText(schedule.first) + ", to: " + toText(schedule.last) +
         ", episodes: " + std::to_string(schedule.episodes) +
         ", shape: " + EpsilonSchedule::SHAPES.nameOf(schedule.shape) + "}";
}

namespace {

constexpr std::size_t KEYS = 7;

/// Returns the keys of a plan with their values.
std::array<std::pair<const char*, std::string>, KEYS> entriesOf(const LearningPlan& plan) {
  const LearningParameters& parameters = plan.parameters;
  return {{{"alpha", toText(parameters.alpha)},
           {"alpha_decay", toText(parameters.alpha_decay)},
           {"gamma", toText(parameters.gamma)},
           {"lambda", toText(parameters.lambda)},
           {"mirrored", parameters.mirrored ? "true" : "false"},
           {"ties", TIES.nameOf(parameters.ties)},
           {"epsilon", toText(plan.epsilon)}}};
}

}  // namespace

std::string toText(const LearningPlan& plan) {
  std::string text;
  for (const auto& [key, value] : entriesOf(plan))
    text += (text.empty() ? "{" : ", ") + std::string(key) + ": " + value;
  return text + "}";
}

std::string differences(const LearningPlan& before, const LearningPlan& after) {
  const auto old_entries = entriesOf(before);
  const auto new_entries = entriesOf(after);
  std::string text;
  for (std::size_t i = 0; i < KEYS; ++i) {
    if (old_entries[i] == new_entries[i]) continue;
    text += (text.empty() ? "" : ", ") + std::string(new_entries[i].first) + " from " + old_entries[i].second + " to " +
            new_entries[i].second;
  }
  return text;
}

}  // namespace crowd
