#pragma once

#include <vector>

#include "social_crowd/learning/actions/action_set.h"
#include "social_crowd/learning/states/move_features.h"
#include "social_crowd/learning/states/state_set.h"

namespace crowd {

/// @brief One row per action: what would come of that move? When it would touch another agent or a thing that yields to
/// nobody, how much of it the separation rule leaves, how sharp a turn it is; and whether anybody comes the other way.
///
/// A quantity is told by its class: how many of its limits it reaches. A quantity without limits is not told.
class AnticipationStates : public StateSet {
 public:
  static constexpr const char* TYPE = "anticipation";

  struct Parameters {
    double vision_radius = 6.0;         ///< [m]
    std::uint32_t max_neighbours = 16;  ///< the nearest so many; 0: no limit
    /// Time to collision with an agent that does half of what is needed: at 2 x mine - my last - its last velocity [s].
    std::vector<double> reciprocal_times = {0.5, 1, 1.5, 2, 3, 4, 6};
    /// Time to collision with an agent that goes on as it does [s].
    std::vector<double> constant_velocity_times = {1, 2, 4};
    /// Time to collision with a wall or an obstacle [s].
    std::vector<double> static_times = {0.5, 1, 2, 3, 4.5};
    /// What the separation rule leaves of the displacement.
    std::vector<double> admissible_fractions = {0.05, 0.5, 0.95};
    /// To either side of the way the agent went last [degrees].
    std::vector<double> turns = {4, 15, 45};
    /// Fastest approach of another agent if this one walked to its goal at full speed [in units of that].
    std::vector<double> oncoming = {1.2};
  };

  /// @param actions number of actions of the action set
  AnticipationStates(const Parameters& parameters, Action actions);

  Row rowCount() const override { return row_count_; }
  std::size_t rowsPerPerception() const override { return actions_; }
  bool needsMoves() const override { return true; }
  void findRows(const DecisionContext& context) const override;
  void findRowsOfAll(const DecisionBatch& contexts) const override;
  /// @brief The same row: none of its quantities tells left from right.
  Row mirrored(Row row) const override { return row; }
  std::vector<int> distanceClasses(Row /*row*/) const override { return {}; }
  std::vector<OccupiedSector> occupiedSectors(const Perception& /*perception*/) const override { return {}; }
  std::vector<double> distanceLimits() const override { return {parameters_.vision_radius}; }
  std::uint32_t maxNeighbours() const override { return parameters_.max_neighbours; }
  std::string spec() const override;

  /// @brief Writes a row for each of the first `count` moves.
  void findRows(const MoveFeatures& features, std::size_t count, Row* rows) const;

 private:
  /// Limits of classes, in single precision as what is compared with them.
  using Limits = std::vector<float>;
  void addLimits(const std::vector<double>& limits, Limits& single);

  Parameters parameters_;
  Action actions_;
  Limits reciprocal_times_;
  Limits constant_velocity_times_;
  Limits static_times_;
  Limits admissible_fractions_;
  Limits turn_cosines_;  // minus the cosines, so that they rise
  Limits oncoming_;
  double min_fraction_ = 0.0;
  Row row_count_ = 1;
};

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const StateSet> readAnticipationStates(YamlMap& map, Action actions);

}  // namespace crowd
