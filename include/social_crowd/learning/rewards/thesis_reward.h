#pragma once

#include <vector>

#include "social_crowd/learning/rewards/reward.h"

namespace crowd {

/// @brief The thesis's reward: a prize on arrival, else a goal part and an obstacle part (3.6-3.9), less a penalty for
/// staying.
class ThesisReward : public Reward {
 public:
  static constexpr const char* TYPE = "thesis";

  enum class GoalPart {
    DISTANCE_GAINED,  ///< (3.6) by how much the distance to the goal has shrunk [m]
    COSINE_CUBED,     ///< (3.7) cos^3 of the angle between the new heading and the goal
  };

  struct Parameters {
    GoalPart goal = GoalPart::COSINE_CUBED;
    double arrival = 100.0;
    /// What an obstacle of distance class 1 costs; class D costs this / 10^(2 (D-1)). (3.8): 80, for the nearest one;
    /// (3.9): 10, summed over the occupied sectors.
    double obstacle_cost = 80.0;
    double stay_cost = 0.0;  ///< of a tick in which the agent did not move (thesis 5.2)
  };

  ThesisReward(const Parameters& parameters, const StateSet& state_set);

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

  /// @brief The obstacle part of a row, 0 or negative.
  double obstaclePart(Row row) const { return obstacle_parts_[row]; }

 private:
  double goalPart(const AgentPerception& before, const AgentPerception& after) const;

  Parameters parameters_;
  std::vector<double> obstacle_parts_;  // of each row
};

/// @brief Reads a map {goal, arrival, obstacle_cost, stay_cost}. @throws InputError
std::shared_ptr<const Reward> readThesisReward(YamlMap& map, const StateSet& state_set);

}  // namespace crowd
