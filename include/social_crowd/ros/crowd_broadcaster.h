#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <social_crowd/AgentStates.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "social_crowd/common/object_pool.h"
#include "social_crowd/ros/controller_parameters.h"
#include "social_crowd/simulation/episode.h"

namespace crowd {

/// @brief Publishes all that the crowd controller publishes except perceptions: agents, scenario, results, tf and
/// clock.
class CrowdBroadcaster {
 public:
  /// @param node its queue serves learners that come later
  CrowdBroadcaster(ros::NodeHandle node, const ControllerParameters& parameters);

  /// @brief Moves the simulated clock and publishes it, where a clock is asked for.
  void advanceClock(double seconds);
  /// @brief Agents, and tf where it is asked for, if somebody listens; unless this tick's were told already, or others
  /// so short ago that the rate would be exceeded.
  void tellAgents(const Episode& episode);
  /// @brief The same however short ago: nothing will be told for a while.
  void tellAgentsNow(const Episode& episode);
  void publishScenario(const Episode& episode, std::uint64_t instance);
  void publishResult(const Episode& episode, std::uint64_t instance, std::uint64_t missed, std::uint64_t dropped);

  /// @brief Header of a message in the frame map, stamped now (simulated time where the clock is published).
  std_msgs::Header header() const;

 private:
  bool hasToldAgents(const Episode& episode) const;
  void publishStates(const Episode& episode);
  void publishFrames(const Episode& episode);

  bool publish_clock_;
  ros::Time clock_;
  ros::WallDuration agents_period_;
  ros::SteadyTime agents_told_at_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> agents_told_;  // episode and tick
  ros::Publisher agents_;
  ObjectPool<social_crowd::AgentStatesPtr> states_;
  ros::Publisher scenario_;
  ros::Publisher results_;
  ros::Publisher clock_publisher_;
  std::optional<tf2_ros::TransformBroadcaster> frames_broadcaster_;  // none where no tf is asked for
  ros::Publisher frames_subscribers_;  // counts the subscribers of /tf, which the broadcaster does not tell
  std::vector<geometry_msgs::TransformStamped> frames_;  // of the last tick that was published
};

}  // namespace crowd
