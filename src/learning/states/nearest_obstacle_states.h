#pragma once

#include "learning/directions.h"
#include "learning/states/row_meaning.h"
#include "learning/states/sector_states.h"
#include "learning/states/sectors.h"

namespace crowd {

/// @brief The thesis's state set 1 (3.2-3.4): sector of the goal, and sector and distance class of the nearest
/// rim of an agent, obstacle or wall.
///
/// With G the goal sector (nG of them), A the obstacle sector (nO), D the distance class (1 .. nD):
/// nothing perceived: G; else (nG - 1) + G * (nO * nD) + A * nD + D; terminal: nG * nO * nD + nG.
class NearestObstacleStates : public SectorStates, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "nearest_obstacle";

  struct Parameters {
    int goal_sectors = 8;
    std::vector<double> obstacle_sectors = {15, 45, 90, 180};  ///< outer limits to either side [degrees]
    DistanceClasses distances;
    Directions directions = Directions::RELATIVE;
  };

  /// @brief The contents of a state.
  struct Situation {
    int goal_sector = 0;
    int obstacle_sector = 0;
    int distance_class = 0;  ///< 0: nothing perceived
  };

  NearestObstacleStates() : NearestObstacleStates(Parameters()) {}
  explicit NearestObstacleStates(const Parameters& parameters);

  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  Row mirrored(Row row) const override;
  std::vector<int> distanceClasses(Row row) const override;
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override;
  std::string spec() const override;
  RowMeaning meaning() const override;

  /// @brief Returns the contents of the state that a perception maps to.
  Situation describe(const Perception& perception) const;
  /// @brief Returns the row of a situation, (3.2) and (3.3).
  Row rowOf(const Situation& situation) const;
  /// @brief Inverse of rowOf(). @param row not the terminal row
  Situation situationOf(Row row) const;
  Row terminal() const override;  // (3.4)

 private:
  /// Returns the angle between the x axis of the agent's frame and the direction that sectors are relative to [rad].
  double frameAngle(const Perception& perception) const {
    return directions_ == Directions::ABSOLUTE ? perception.self.pose.heading : 0.0;
  }

  EvenSectors goal_sectors_;
  MirroredSectors obstacle_sectors_;
  Directions directions_;
};

/// @brief Reads a map {goal_sectors, obstacle_sectors, collision_radius, vision_radius}, all optional.
/// @throws InputError
std::shared_ptr<const StateSet> readNearestObstacleStates(YamlMap& map, const ActionSet& action_set);

}  // namespace crowd
