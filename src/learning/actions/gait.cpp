#include "learning/actions/gait.h"

#include <cmath>

#include "common/text/numbers.h"
#include "geometry/geometry.h"

namespace crowd {
namespace {

constexpr double SWAY_TIME = 0.8;    // between two random values [s]
constexpr double WANDER_TIME = 4.0;  // [s]
constexpr double PACE_TIME = 0.6;    // [s]
constexpr double LEAST = 0.3;        // of the deviations of an agent, as a factor
constexpr double MOST = 1.7;

constexpr NumberLimit DEVIATION{NumberRule::NOT_NEGATIVE, 45.0, "degrees"};
constexpr NumberLimit RATE{NumberRule::NOT_NEGATIVE, 10.0, "1/s"};

enum Series : std::uint64_t { EXTENT, SWAY, WANDER, PACE, SHIFT };

double valueAt(const KeyedRandom& series, std::uint64_t knot) { return series.with(knot).uniform(-1.0, 1.0); }

/// A smooth function of time from -1 to 1: random values at regular times, with cubic steps between them.
double smoothNoise(const KeyedRandom& series, double time, double spacing) {
  const double place = std::max(0.0, time / spacing);
  const double knot = std::floor(place);
  const double part = place - knot;
  const double step = part * part * (3.0 - 2.0 * part);
  const auto number = static_cast<std::uint64_t>(knot);
  const double from = valueAt(series, number);
  return from + step * (valueAt(series, number + 1) - from);
}

}  // namespace

GaitDeviation Gait::at(const KeyedRandom& agent, double time) const {
  const double extent = agent.with(EXTENT).uniform(LEAST, MOST);
  const double slow = smoothNoise(agent.with(PACE), time, PACE_TIME);
  return {extent * toRadians(sway * smoothNoise(agent.with(SWAY), time, SWAY_TIME) +
                             wander * smoothNoise(agent.with(WANDER), time, WANDER_TIME)),
          1.0 - std::min(0.9, extent * pace * 0.5 * (1.0 - slow))};
}

std::optional<std::uint32_t> Gait::shiftAt(const KeyedRandom& agent, std::uint32_t moves, std::uint64_t tick,
                                           double duration) const {
  if (shift <= 0.0) return std::nullopt;
  KeyedRandom chance = agent.with(SHIFT).with(tick);
  if (chance.uniform() >= shift * duration) return std::nullopt;
  return chance.below(moves);
}

Gait readGait(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"sway", "wander", "pace", "shift"});
  return {map.number("sway", DEVIATION, 0.0), map.number("wander", DEVIATION, 0.0),
          map.number("pace", NumberRule::FRACTION, 0.0), map.number("shift", RATE, 0.0)};
}

/// The last key is absent while it is 0: headers of tables stay as they were.
std::string toText(const Gait& gait) {
  return "{sway: " + toText(gait.sway) + ", wander: " + toText(gait.wander) + ", pace: " + toText(gait.pace) +
         (gait.shift > 0.0 ? ", shift: " + toText(gait.shift) : "") + "}";
}

}  // namespace crowd
