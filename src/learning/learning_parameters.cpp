#include "social_crowd/learning/learning_parameters.h"

#include <cmath>

#include "social_crowd/common/numbers.h"

namespace crowd {

Ties parseTies(const std::string& text) {
  if (text == "first") return Ties::FIRST;
  if (text == "random") return Ties::RANDOM;
  throw InputError("ties: expected first or random, got '" + text + "'");
}

std::string toText(Ties ties) { return ties == Ties::FIRST ? "first" : "random"; }

std::string LearningParameters::problems() const {
  std::string problems;
  const auto require = [&](bool fine, const char* name, const char* expected, double got) {
    if (fine) return;
    if (!problems.empty()) problems += "; ";
    problems += std::string(name) + ": expected " + expected + ", got " + toText(got);
  };
  require(alpha > 0.0 && alpha <= 1.0, "alpha", "a number above 0, at most 1", alpha);
  require(gamma >= 0.0 && gamma < 1.0, "gamma", "a number from 0 to below 1", gamma);
  require(lambda >= 0.0 && lambda <= 1.0, "lambda", "a number from 0 to 1", lambda);
  require(alpha_decay >= 0.0 && alpha_decay <= 1.0, "alpha_decay", "a number from 0 to 1", alpha_decay);
  require(epsilon >= 0.0 && epsilon <= 1.0, "epsilon", "a number from 0 to 1", epsilon);
  return problems;
}

double EpsilonSchedule::at(std::uint64_t episode) const {
  if (episode >= episodes) return last;
  const double share = static_cast<double>(episode) / static_cast<double>(episodes);
  if (shape == Shape::EXPONENTIAL) return first * std::pow(last / first, share);
  return first + share * (last - first);
}

namespace {

EpsilonSchedule readEpsilon(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsMap()) return EpsilonSchedule::constant(readNumber(node, place, NumberRule::SHARE));
  const YamlMap map(node, place, {"from", "to", "episodes", "shape"});
  EpsilonSchedule schedule;
  schedule.first = map.number("from", NumberRule::SHARE);
  schedule.last = map.number("to", NumberRule::SHARE);
  schedule.episodes = static_cast<std::uint64_t>(map.whole("episodes", 1, INT64_MAX));
  const std::string shape = map.text("shape", "linear");
  if (shape == "exponential") {
    schedule.shape = EpsilonSchedule::Shape::EXPONENTIAL;
    if (schedule.first <= 0.0 || schedule.last <= 0.0) {
      throwExpected(place, node, "from and to above 0 for an exponential schedule");
    }
  } else if (shape != "linear") {
    throwExpected(map.placeOf("shape"), map.need("shape"), "linear or exponential");
  }
  return schedule;
}

}  // namespace

void readParameter(const YamlMap& map, const std::string& key, double LearningParameters::*member,
                   LearningParameters& parameters) {
  if (!map.has(key)) return;
  LearningParameters alone;
  alone.*member = map.number(key, NumberRule::ANY);
  if (!alone.problems().empty()) throwProblem(map.placeOf(key), map.need(key), alone.problems());
  parameters.*member = alone.*member;
}

Ties readTies(const YamlMap& map) {
  try {
    return parseTies(map.text("ties", toText(Ties::FIRST)));
  } catch (const InputError&) {
    throwExpected(map.placeOf("ties"), map.need("ties"), "first or random");
  }
}

LearningPlan readLearningPlan(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"alpha", "alpha_decay", "gamma", "lambda", "mirrored", "ties", "epsilon"});
  LearningPlan plan;
  readParameter(map, "alpha", &LearningParameters::alpha, plan.parameters);
  readParameter(map, "alpha_decay", &LearningParameters::alpha_decay, plan.parameters);
  readParameter(map, "gamma", &LearningParameters::gamma, plan.parameters);
  readParameter(map, "lambda", &LearningParameters::lambda, plan.parameters);
  plan.parameters.mirrored = map.flag("mirrored", plan.parameters.mirrored);
  plan.parameters.ties = readTies(map);
  plan.epsilon = EpsilonSchedule::constant(plan.parameters.epsilon);
  if (map.has("epsilon")) plan.epsilon = readEpsilon(map.need("epsilon"), map.placeOf("epsilon"));
  plan.parameters.epsilon = plan.epsilon.at(0);
  return plan;
}

}  // namespace crowd
