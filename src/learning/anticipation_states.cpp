#include "social_crowd/learning/anticipation_states.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "social_crowd/common/numbers.h"
#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

constexpr double LONGEST_TIME = 60.0;      // [s]
constexpr double FASTEST_APPROACH = 10.0;  // [top speeds]

using Lanes = MoveOutlooks::Lanes;

// Lanes that fit into a register, so that what is counted stays there.
constexpr std::size_t BLOCK = 8;
using Values = float __attribute__((vector_size(BLOCK * sizeof(float))));
using Counts = std::int32_t __attribute__((vector_size(BLOCK * sizeof(float))));
static_assert(MoveOutlooks::LANES % BLOCK == 0, "whole blocks");

/// A digit of the rows of all moves: the class of each value, that is how many limits it reaches.
struct Digit {
  const Lanes& values;
  float sign;  // what is compared is sign * value
  const std::vector<float>& limits;
};

/// The row of each of the first `count` moves. The last digit is the same for all of them.
CROWD_VECTORISED void combine(const std::array<Digit, 5>& digits, float last, const std::vector<float>& last_limits,
                              std::size_t count, Row* rows) {
  constexpr std::size_t BLOCKS = MoveOutlooks::LANES / BLOCK;
  std::array<Counts, BLOCKS> counts{};
  for (const Digit& digit : digits) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written right below
    std::array<Values, BLOCKS> values;
    for (std::size_t i = 0; i < BLOCKS; ++i) {
      std::memcpy(&values[i], &digit.values[i * BLOCK], sizeof(Values));
      values[i] *= digit.sign;
      counts[i] *= static_cast<std::int32_t>(digit.limits.size() + 1);
    }
    for (const float limit : digit.limits) {
      for (std::size_t i = 0; i < BLOCKS; ++i) counts[i] -= values[i] >= limit;  // true is -1
    }
  }
  Counts last_class{};
  for (const float limit : last_limits) last_class -= Values{} + last >= limit;
  for (Counts& block : counts) block = block * static_cast<std::int32_t>(last_limits.size() + 1) + last_class;
  for (std::size_t first = 0; first < count; first += BLOCK) {
    const Counts& block = counts[first / BLOCK];
    if (first + BLOCK <= count) {
      std::memcpy(&rows[first], &block, sizeof(block));
    } else {
      for (std::size_t i = first; i < count; ++i) rows[i] = static_cast<Row>(block[i - first]);
    }
  }
}

}  // namespace

AnticipationStates::AnticipationStates(const Parameters& parameters, Action actions)
    : parameters_(parameters), actions_(actions) {
  std::vector<double> turns;
  for (const double turn : parameters.turns) turns.push_back(-std::cos(toRadians(turn)));
  addLimits(parameters.reciprocal_times, reciprocal_times_);
  addLimits(parameters.selfish_times, selfish_times_);
  addLimits(parameters.fixed_times, fixed_times_);
  addLimits(parameters.shares, shares_);
  addLimits(turns, turn_cosines_);
  addLimits(parameters.oncoming, oncoming_);
  if (!parameters.shares.empty()) least_share_ = parameters.shares.front();
}

void AnticipationStates::addLimits(const std::vector<double>& limits, Limits& single) {
  single.assign(limits.begin(), limits.end());
  row_count_ *= static_cast<Row>(limits.size() + 1);
}

void AnticipationStates::findRows(const MoveOutlooks& outlooks, std::size_t count, Row* rows) const {
  combine({{{outlooks.reciprocal_times, 1.0F, reciprocal_times_},
            {outlooks.selfish_times, 1.0F, selfish_times_},
            {outlooks.fixed_times, 1.0F, fixed_times_},
            {outlooks.shares, 1.0F, shares_},
            {outlooks.turn_cosines, -1.0F, turn_cosines_}}},
          outlooks.oncoming, oncoming_, count, rows);
}

void AnticipationStates::findRows(const Chooser& chooser) const { findRowsOfAll({&chooser, 1}); }

void AnticipationStates::findRowsOfAll(const Choosers& choosers) const {
  std::array<MoveOutlooks, MAX_CHOOSERS> outlooks;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (Action first = 0; first < actions_; first += MoveOutlooks::LANES) {
    const std::size_t count = std::min<std::size_t>(actions_ - first, MoveOutlooks::LANES);
    foresee(choosers, first / MoveOutlooks::LANES, count, least_share_, outlooks.data());
    for (std::size_t k = 0; k < choosers.size(); ++k) findRows(outlooks[k], count, choosers[k].rows + first);
  }
}

std::string AnticipationStates::spec() const {
  return std::string("{type: ") + TYPE + ", vision_radius: " + toText(parameters_.vision_radius) +
         ", max_bodies: " + std::to_string(parameters_.max_bodies) +
         ", reciprocal_times: " + toText(parameters_.reciprocal_times) +
         ", selfish_times: " + toText(parameters_.selfish_times) + ", fixed_times: " + toText(parameters_.fixed_times) +
         ", shares: " + toText(parameters_.shares) + ", turns: " + toText(parameters_.turns) +
         ", oncoming: " + toText(parameters_.oncoming) + "}";
}

std::shared_ptr<const StateSet> readAnticipationStates(YamlMap& map, Action actions) {
  map.allow({"type", "vision_radius", "max_bodies", "reciprocal_times", "selfish_times", "fixed_times", "shares",
             "turns", "oncoming"});
  AnticipationStates::Parameters parameters;
  parameters.vision_radius = map.number("vision_radius", NumberRule::POSITIVE, parameters.vision_radius);
  parameters.max_bodies = static_cast<std::uint32_t>(map.whole("max_bodies", 0, INT32_MAX, parameters.max_bodies));
  const auto read = [&](const char* key, double highest, std::vector<double>& limits) {
    limits = map.risingNumbers(key, 0.0, highest, limits);
  };
  read("reciprocal_times", LONGEST_TIME, parameters.reciprocal_times);
  read("selfish_times", LONGEST_TIME, parameters.selfish_times);
  read("fixed_times", LONGEST_TIME, parameters.fixed_times);
  read("shares", 1.0, parameters.shares);
  read("turns", 180.0, parameters.turns);
  read("oncoming", FASTEST_APPROACH, parameters.oncoming);
  return std::make_shared<AnticipationStates>(parameters, actions);
}

}  // namespace crowd
