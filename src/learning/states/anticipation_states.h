#pragma once

#include <vector>

#include "learning/actions/action_set.h"
#include "learning/states/move_features.h"
#include "learning/states/row_meaning.h"
#include "learning/states/state_set.h"

namespace crowd {

/// @brief One row per action, computed from the features of its move (see MoveFeatures): times to collision with agents
/// and with static bodies, the admissible fraction, the turn; and the fastest approach of another agent. There is no
/// terminal row.
///
/// Each quantity is encoded by its class, the number of its limits that it reaches. A quantity without limits is not
/// encoded. The classes are the digits of the row number, each with a base of its own. Source: docs/state_sets.md.
class AnticipationStates : public StateSet, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "anticipation";

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
  /// @brief Returns the same row: no quantity depends on left and right.
  Row mirrored(Row row) const override { return row; }
  double visionRadius() const override { return parameters_.vision_radius; }
  double wallDistance() const override { return parameters_.wall_distance; }
  std::uint32_t maxNeighbours() const override { return parameters_.max_neighbours; }
  std::string spec() const override;
  RowMeaning meaning() const override;

  /// @brief Writes the row of each of the first `count` moves.
  void findRows(const MoveFeatures& features, std::size_t count, Row* rows) const;

 private:
  /// Limits of classes, in single precision like the features.
  using Limits = std::vector<float>;
  void addLimits(const std::vector<double>& limits, Limits& single);

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

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const StateSet> readAnticipationStates(YamlMap& map, const ActionSet& action_set);

}  // namespace crowd
