#pragma once

#include <vector>

#include "common/text/enum_names.h"
#include "learning/rewards/reward.h"
#include "learning/states/obstacle_classes.h"

namespace crowd {

/// @brief The reward of the thesis: a constant on arrival, else a goal part plus an obstacle part (3.6-3.9), less a
/// penalty on staying. Without unit: as in the thesis, the parts are added as numbers, also with a goal part in metres.
/// The keys and members `obstacle_cost` and `stay_cost` are penalties.
class ThesisReward : public Reward {
 public:
  static constexpr const char* TYPE = "thesis";

  enum class GoalPart {
    DISTANCE_GAINED,  ///< (3.6) decrease of the distance to the goal [m]
    COSINE_CUBED,     ///< (3.7) cos^3 of the angle between the new heading and the goal
  };
  static constexpr EnumNames<GoalPart, 2> GOAL_PARTS{"goal", {"distance_gained", "cosine_cubed"}};

  struct Parameters {
    GoalPart goal = GoalPart::COSINE_CUBED;
    double arrival = 100.0;  ///< reward on arrival, in place of all other parts
    /// Penalty on an obstacle of distance class 1; that on class D is this / 10^(2 (D-1)). (3.8): 80, for the nearest
    /// obstacle; (3.9): 10, summed over the occupied sectors.
    double obstacle_cost = 80.0;
    double stay_cost = 0.0;  ///< penalty on a tick in which the agent did not move (thesis 5.2)
  };

  /// @brief Computes the obstacle part of every row of a state set.
  /// @param row_count number of rows of the state set
  ThesisReward(const Parameters& parameters, const RowDistanceClasses& state_set, Row row_count);

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

  /// @brief Returns the obstacle part of a row, 0 or negative.
  double obstaclePart(Row row) const { return obstacle_parts_[row]; }

 private:
  double goalPart(const AgentPerception& before, const AgentPerception& after) const;

  Parameters parameters_;
  std::vector<double> obstacle_parts_;  // of each row
};

/// @brief Reads a map {goal, arrival, obstacle_cost, stay_cost}.
/// @throws InputError, also if the rows of the state set do not encode distance classes
std::shared_ptr<const Reward> readThesisReward(YamlMap& map, const StateSet& state_set);

}  // namespace crowd
