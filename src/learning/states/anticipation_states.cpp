#include <algorithm>
#include <array>
#include <vector>

#include "common/portable_math.h"
#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "learning/actions/action_set.h"
#include "learning/states/move_features.h"
#include "learning/states/row_meaning.h"
#include "learning/states/state_set.h"
#include "simd/kernels.h"

namespace crowd {
namespace {

constexpr double LONGEST_TIME = 60.0;      // [s]
constexpr double FASTEST_APPROACH = 10.0;  // [maximum speeds]
constexpr double MOST_SPACE = 5.0;         // [m]

/// A digit of the row numbers: the class of a quantity, the number of limits that it reaches.
/// @param sign the limits are compared with sign * value
simd::ClassDigit digitOf(const MoveFeatures::Lanes& values, const std::vector<float>& limits, float sign = 1.0F) {
  static_assert(MoveFeatures::LANES % simd::VALUES_PADDED == 0, "kernels read whole registers");
  return {values.data(), sign, limits.data(), limits.size()};
}

/// One row per action, computed from the features of its move (see MoveFeatures): times to collision with agents
/// and with static bodies, the admissible fraction, the turn; and the fastest approach of another agent. There is no
/// terminal row.
///
/// Each quantity is encoded by its class, the number of its limits that it reaches. A quantity without limits is not
/// encoded. The classes are the digits of the row number, each with a base of its own. Source: docs/state_sets.md.
class AnticipationStates : public StateSet, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "anticipation";
  static std::shared_ptr<const StateSet> read(YamlMap& map, const ActionSet& action_set);

  struct Parameters {
    double vision_radius = 6.0;         ///< [m]
    double wall_distance = 0.6;         ///< up to which walls count; those farther away are left to way-finding [m]
    std::uint32_t max_neighbours = 16;  ///< the nearest ones; 0: no limit
    /// Reciprocal time to collision (van den Berg et al. 2008), at the relative velocity 2 v - own last - other's last
    /// [s].
    std::vector<double> reciprocal_times = {0.5, 1, 1.5, 2, 3, 4, 6};
    /// Time to collision with an agent that keeps its velocity [s].
    std::vector<double> constant_velocity_times = {1, 2, 4};
    /// Time to collision with a wall or an obstacle [s].
    std::vector<double> static_times = {0.5, 1, 2, 3, 4.5};
    /// Fraction of the wanted displacement that the separation rule admits.
    std::vector<double> admissible_fractions = {0.05, 0.5, 0.95};
    /// Angle to the direction of the last move, to either side [degrees].
    std::vector<double> turns = {4, 15, 45};
    /// Fastest approach of another agent if this one had its preferred velocity [maximum speeds].
    std::vector<double> oncoming = {1.2};
    /// By which other agents count as larger in the times to collision, as far as that leaves a part of
    /// the gap to the nearest one [m].
    double personal_space = 0.0;
    CandidateSpeeds candidate_speeds = CandidateSpeeds::WANTED;
  };

  /// @param actions number of actions of the action set
  AnticipationStates(const Parameters& parameters, Action actions);

  Row rowCount() const override { return row_count_; }
  std::size_t rowsPerPerception() const override { return actions_; }
  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  /// Returns the same row: no quantity depends on left and right.
  Row mirrored(Row row) const override { return row; }
  double visionRadius() const override { return parameters_.vision_radius; }
  double wallDistance() const override { return parameters_.wall_distance; }
  std::uint32_t maxNeighbours() const override { return parameters_.max_neighbours; }
  std::string spec() const override;
  RowMeaning meaning() const override;

 private:
  /// Limits of classes, in single precision like the features.
  using Limits = std::vector<float>;
  void addLimits(const std::vector<double>& limits, Limits& single);
  /// Writes the row of each of the first `count` moves.
  void findRows(const MoveFeatures& features, std::size_t count, Row* rows) const;

  Parameters parameters_;
  Action actions_;
  Limits reciprocal_times_;
  Limits constant_velocity_times_;
  Limits static_times_;
  Limits admissible_fractions_;
  Limits turn_cosines_;  // negative cosines, which ascend with the angle
  Limits oncoming_;
  CollisionPrediction prediction_;
  Row row_count_ = 1;
};

AnticipationStates::AnticipationStates(const Parameters& parameters, Action actions)
    : parameters_(parameters),
      actions_(actions),
      prediction_{parameters.candidate_speeds, 0.0, parameters.personal_space} {
  std::vector<double> turns;
  for (const double turn : parameters.turns) turns.push_back(-portable::cos(toRadians(turn)));
  addLimits(parameters.reciprocal_times, reciprocal_times_);
  addLimits(parameters.constant_velocity_times, constant_velocity_times_);
  addLimits(parameters.static_times, static_times_);
  addLimits(parameters.admissible_fractions, admissible_fractions_);
  addLimits(turns, turn_cosines_);
  addLimits(parameters.oncoming, oncoming_);
  if (!parameters.admissible_fractions.empty()) prediction_.min_fraction = parameters.admissible_fractions.front();
}

void AnticipationStates::addLimits(const std::vector<double>& limits, Limits& single) {
  single.assign(limits.begin(), limits.end());
  row_count_ *= static_cast<Row>(limits.size() + 1);
}

void AnticipationStates::findRows(const MoveFeatures& features, std::size_t count, Row* rows) const {
  const auto digits = {digitOf(features.reciprocal_times, reciprocal_times_),
                       digitOf(features.constant_velocity_times, constant_velocity_times_),
                       digitOf(features.static_times, static_times_),
                       digitOf(features.admissible_fractions, admissible_fractions_),
                       digitOf(features.turn_cosines, turn_cosines_, -1.0F)};
  // The last digit is the same for all moves.
  const auto reached = [&](float limit) { return features.oncoming >= limit; };
  const auto last = static_cast<std::uint32_t>(std::count_if(oncoming_.begin(), oncoming_.end(), reached));
  const auto classes = static_cast<std::uint32_t>(oncoming_.size() + 1);
  simd::kernels().find_row_numbers(digits.begin(), digits.size(), {classes, last}, count, rows);
}

void AnticipationStates::findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const {
  std::array<MoveFeatures, MAX_BATCH> features;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (Action first = 0; first < actions_; first += MoveFeatures::LANES) {
    const std::size_t count = std::min<std::size_t>(actions_ - first, MoveFeatures::LANES);
    computeMoveFeatures(batch, moves + first / MoveFeatures::LANES, blocksOf(actions_), count, prediction_,
                        features.data());
    for (std::size_t k = 0; k < batch.size(); ++k) findRows(features[k], count, rows + k * actions_ + first);
  }
}

std::string AnticipationStates::spec() const {
  const CandidateSpeeds speeds = parameters_.candidate_speeds;
  return std::string("{type: ") + TYPE + ", vision_radius: " + toText(parameters_.vision_radius) +
         ", wall_distance: " + toText(parameters_.wall_distance) +
         ", max_neighbours: " + std::to_string(parameters_.max_neighbours) +
         ", reciprocal_times: " + toText(parameters_.reciprocal_times) +
         ", constant_velocity_times: " + toText(parameters_.constant_velocity_times) +
         ", static_times: " + toText(parameters_.static_times) +
         ", admissible_fractions: " + toText(parameters_.admissible_fractions) +
         ", turns: " + toText(parameters_.turns) + ", oncoming: " + toText(parameters_.oncoming) +
         (parameters_.personal_space > 0.0 ? ", personal_space: " + toText(parameters_.personal_space) : "") +
         (speeds == CandidateSpeeds::WANTED ? "" : ", candidate_speeds: " + CANDIDATE_SPEEDS.nameOf(speeds)) + "}";
}

RowMeaning AnticipationStates::meaning() const {
  const Parameters& p = parameters_;
  return {{{"reciprocal time to collision", classNames(p.reciprocal_times, " s")},
           {"constant-velocity time to collision", classNames(p.constant_velocity_times, " s")},
           {"time to collision with static bodies", classNames(p.static_times, " s")},
           {"admissible fraction of the move", classNames(p.admissible_fractions, "")},
           {"turn", classNames(p.turns, "°")},
           {"approach of another agent", classNames(p.oncoming, " of the maximum speed")}},
          {},
          false};
}

std::shared_ptr<const StateSet> AnticipationStates::read(YamlMap& map, const ActionSet& action_set) {
  map.allow({"type", "vision_radius", "wall_distance", "max_neighbours", "reciprocal_times", "constant_velocity_times",
             "static_times", "admissible_fractions", "turns", "oncoming", "personal_space", "candidate_speeds"});
  Parameters parameters;
  parameters.vision_radius = map.number("vision_radius", limits::DISTANCE, parameters.vision_radius);
  parameters.wall_distance = map.number("wall_distance", limits::DISTANCE, parameters.wall_distance);
  parameters.max_neighbours =
      static_cast<std::uint32_t>(map.whole("max_neighbours", 0, limits::NEIGHBOURS, parameters.max_neighbours));
  double rows = 1.0;
  const auto read = [&](const char* key, double highest, std::vector<double>& classes) {
    classes = map.risingNumbers(key, 0.0, highest, classes);
    rows *= static_cast<double>(classes.size() + 1);
  };
  read("reciprocal_times", LONGEST_TIME, parameters.reciprocal_times);
  read("constant_velocity_times", LONGEST_TIME, parameters.constant_velocity_times);
  read("static_times", LONGEST_TIME, parameters.static_times);
  read("admissible_fractions", 1.0, parameters.admissible_fractions);
  read("turns", 180.0, parameters.turns);
  read("oncoming", FASTEST_APPROACH, parameters.oncoming);
  parameters.personal_space = map.number("personal_space", {NumberRule::NOT_NEGATIVE, MOST_SPACE, "m"}, 0.0);
  parameters.candidate_speeds = CANDIDATE_SPEEDS.read(map, parameters.candidate_speeds);
  if (rows > static_cast<double>(limits::Q_VALUES)) {
    throwProblem(map.place(), map.node(),
                 "expected limits for at most " + std::to_string(limits::Q_VALUES) + " rows, got " + toText(rows));
  }
  return std::make_shared<AnticipationStates>(parameters, action_set.size());
}

}  // namespace

StateSetType anticipationStates() {
  return {AnticipationStates::TYPE, "one row per action: times to collision and admissible fraction of its move",
          AnticipationStates::read};
}

}  // namespace crowd
