#include "social_crowd/learning/anticipation_states.h"

#include <algorithm>
#include <array>

#include "simd/kernels.h"
#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

constexpr double LONGEST_TIME = 60.0;      // [s]
constexpr double FASTEST_APPROACH = 10.0;  // [top speeds]

/// A digit of row numbers: the classes of a quantity, which are as many limits as it reaches.
/// @param sign what is compared with the limits is sign * value
simd::ClassDigit digitOf(const MoveOutlooks::Lanes& values, const std::vector<float>& limits, float sign = 1.0F) {
  static_assert(MoveOutlooks::LANES % simd::VALUES_PADDED == 0, "kernels read so many");
  return {values.data(), sign, limits.data(), limits.size()};
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
  const auto digits = {digitOf(outlooks.reciprocal_times, reciprocal_times_),
                       digitOf(outlooks.selfish_times, selfish_times_), digitOf(outlooks.fixed_times, fixed_times_),
                       digitOf(outlooks.shares, shares_), digitOf(outlooks.turn_cosines, turn_cosines_, -1.0F)};
  // The last digit is the same for all moves.
  const auto reached = [&](float limit) { return outlooks.oncoming >= limit; };
  const auto last = static_cast<std::uint32_t>(std::count_if(oncoming_.begin(), oncoming_.end(), reached));
  const auto classes = static_cast<std::uint32_t>(oncoming_.size() + 1);
  simd::kernels().find_row_numbers(digits.begin(), digits.size(), {classes, last}, count, rows);
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
