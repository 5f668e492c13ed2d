#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "social_crowd/common/yaml_reader.h"
#include "social_crowd/learning/state_set.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief How much a decision was worth, judged by what the agent perceives after it: a prize on arrival, else a goal
/// part and an obstacle part (thesis 3.6-3.9).
class Reward {
 public:
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
  };

  Reward(const Parameters& parameters, const StateSet& state_set);

  /// @param before what the agent knew of itself when it decided
  /// @param after what it perceives now
  /// @param row the row that `after` maps to; not used on arrival
  double operator()(const AgentPerception& before, const AgentPerception& after, Row row) const;

  /// @brief The obstacle part of a row, 0 or negative.
  double obstaclePart(Row row) const { return obstacle_parts_[row]; }
  /// @brief Parameters as one canonical line of YAML.
  std::string spec() const;

 private:
  Parameters parameters_;
  std::vector<double> obstacle_parts_;  // of each row
};

/// @brief The reward that a YAML map describes, for a state set.
/// @throws InputError if a parameter is wrong.
Reward makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set);

}  // namespace crowd
