#pragma once

#include <cstdint>
#include <vector>

#include "learning/learner.h"
#include "robots/controllers/robot_perceiver.h"

namespace crowd {

/// @brief Drives a robot as the learned agents walk: the robot perceives what an agent at its place perceives
/// (Viewers::inPlaceOf()), the learner decides greedily for it with the same Q-table, state set and action set, and
/// its relative action becomes a command: steer() in the direction of the action, at its share of the maximum speed.
///
/// The actions assume a body that changes its velocity within a tick. A robot follows as fast as its limits permit, so
/// that what excludes contacts between agents does not exclude contacts that the robot causes.
class LearnedRobot {
 public:
  /// @param learner must outlive it and not change meanwhile; several robots may share it
  /// @param episode its number; with the tick it seeds random tie-breaking
  /// @param finds_ways whether ways lead round walls, as agents do with way-finding; else the robot drives straight to
  /// its goal
  LearnedRobot(const Learner& learner, std::uint64_t episode, bool finds_ways)
      : learner_(&learner), perceiver_(episode, finds_ways) {}

  /// @brief The command of the coming tick; call it once a tick. @param goal [m], `map`
  Twist command(const World& world, RobotId id, const Vector2& goal);

 private:
  const Learner* learner_;
  RobotPerceiver perceiver_;
  DecisionWorkspace decision_workspace_;
  std::vector<AgentAction> actions_;
  bool turns_ = false;  // on the spot, after an impact
};

}  // namespace crowd
