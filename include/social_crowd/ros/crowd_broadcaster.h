#pragma once

#include <ros/ros.h>
#include <social_crowd/Perceptions.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <memory>

#include "social_crowd/ros/controller_parameters.h"
#include "social_crowd/simulation/episode.h"

namespace crowd {

/// @brief Everything the crowd controller tells the world: perceptions, where everybody is, results, tf and clock.
class CrowdBroadcaster {
 public:
  CrowdBroadcaster(ros::NodeHandle node, const ControllerParameters& parameters);

  /// @brief Moves the simulated clock and publishes it, where a clock is asked for.
  void advanceClock(double seconds);
  void publishPerceptions(const Episode& episode);
  /// @brief The same message once more, for learners that were connecting when it was sent.
  void repeatPerceptions() { perceptions_.publish(last_perceptions_); }
  /// @brief Agents, and tf where it is asked for.
  void publishAgents(const Episode& episode);
  void publishScenario(const Episode& episode, std::uint64_t instance);
  void publishResult(const Episode& episode, std::uint64_t instance, std::uint64_t missed, std::uint64_t dropped);

  /// @brief A number of this run of the controller, for perceptions and the answers to them.
  std::uint64_t run() const { return run_; }

 private:
  std_msgs::Header header() const;
  void publishFrames(const Episode& episode);

  std::uint64_t run_;
  bool publish_clock_;
  ros::Time clock_;
  ros::Publisher perceptions_;
  boost::shared_ptr<social_crowd::Perceptions> last_perceptions_;
  ros::Publisher agents_;
  ros::Publisher scenario_;
  ros::Publisher results_;
  ros::Publisher clock_publisher_;
  std::unique_ptr<tf2_ros::TransformBroadcaster> frames_;
};

}  // namespace crowd
