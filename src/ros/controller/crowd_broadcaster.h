#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <social_crowd/AgentStates.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "common/object_pool.h"
#include "ros/controller/controller_parameters.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Publishes agents, scenario, results, tf and clock of the crowd controller.
class CrowdBroadcaster {
 public:
  /// @param parameters of the owner; the rate of agents may change between two calls
  CrowdBroadcaster(ros::NodeHandle node, const ControllerParameters& parameters);

  /// @brief With ~publish_clock, advances the simulated clock.
  void advanceClock(double seconds);
  /// @brief With ~publish_clock, publishes the simulated clock.
  void publishClock();
  /// @brief Publishes agents and, with ~publish_tf, tf, if they have subscribers. Does nothing if the world has
  /// not changed since, or the rate would be exceeded.
  void publishAgents(const Episode& episode);
  /// @brief The same regardless of the rate, before a pause of unknown length.
  void publishAgentsNow(const Episode& episode);
  void publishScenario(const Episode& episode, std::uint64_t instance);
  /// @brief Publishes the walls if they have changed since the last call, or are those of another episode.
  void publishWalls(const Episode& episode);
  /// @brief Publishes the map if it is another one than at the last call; an empty one in place of one that is gone.
  void publishMap(const Episode& episode);
  /// @param number of the episode
  void publishResult(const EpisodeResult& result, std::uint64_t number, std::uint64_t instance, std::uint64_t missed,
                     std::uint64_t dropped);

  /// @brief Returns a header with frame map and the present time (simulated time with ~publish_clock).
  std_msgs::Header header() const;
  /// @brief The time at the end of a tick of this duration [s] that is about to be executed: without ~publish_clock,
  /// the present time, as ticks take almost no time.
  ros::Time timeIn(double tick_duration) const {
    return publish_clock_ ? clock_ + ros::Duration(tick_duration) : ros::Time::now();
  }

 private:
  bool isDueToPublishAgents() const;
  bool hasPublishedAgents(const Episode& episode) const;
  void publishStates(const Episode& episode);
  void publishPoses(const Episode& episode);
  void publishFrames(const Episode& episode);

  ros::NodeHandle node_;
  bool publish_clock_;
  ros::Time clock_;
  const ControllerParameters& parameters_;
  ros::SteadyTime agents_published_at_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> agents_published_;  // episode, and number of changes
  ros::Publisher agents_;
  ros::Publisher poses_;
  ObjectPool<social_crowd::AgentStatesPtr> states_;
  ros::Publisher scenario_;
  ros::Publisher walls_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> walls_published_;  // episode, and number of changes
  ros::Publisher map_;                                                      // advertised with the first map
  std::shared_ptr<const OccupancyMap> map_published_;
  ros::Publisher results_;
  ros::Publisher clock_publisher_;
  std::optional<tf2_ros::TransformBroadcaster> frames_broadcaster_;  // only with ~publish_tf
  ros::Publisher frames_subscribers_;  // for the number of subscribers of /tf, which the broadcaster does not report
  std::vector<geometry_msgs::TransformStamped> frames_;  // of the last tick that was published
};

}  // namespace crowd
