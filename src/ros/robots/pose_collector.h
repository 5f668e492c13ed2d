#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robots/external_robot.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Numbers of poses of an external robot in an episode.
struct PoseInput {
  PoseCounts counts;
  std::uint64_t without_frame = 0;  ///< refused: no transform from their frame to `map`
};

/// @brief Takes the poses of the robots that live elsewhere (Drive::EXTERNAL) from `odom` or tf and moves them there in
/// each tick. It warns once for each robot and kind of problem. All functions run in the main loop.
class PoseCollector {
 public:
  /// @param node whose callbacks the main loop serves @param clock the present time
  PoseCollector(const ros::NodeHandle& node, std::function<ros::Time()> clock)
      : node_(node), clock_(std::move(clock)) {}

  /// @brief The robots of this episode are other ones than before: subscribes to their poses.
  void subscribe(const Episode& episode);
  /// @brief Begins an episode with the robots of subscribe(); it must outlive the next call.
  void begin(Episode& episode);
  /// @brief Moves the robots to where they are at the end of the coming tick. @param now its time
  void place(const ros::Time& now);
  /// @brief Empty unless the robot is external.
  std::optional<PoseInput> inputOf(RobotId robot) const;

 private:
  enum class Problem : std::uint8_t { NOT_FINITE, BACKWARDS, JUMP, GAP, STALE, WITHOUT_FRAME };

  struct Source {
    RobotId id = 0;
    std::string name;
    std::string base;    // frame of the robot; empty: its poses come from the topic
    std::string origin;  // where its poses come from, for warnings
    ExternalRobot robot{0.0, 0.0};
    std::uint64_t without_frame = 0;
    ros::Subscriber odometry;
  };

  void take(Source& source, const nav_msgs::Odometry& message);
  void takeTransform(Source& source);
  void take(Source& source, const Pose& pose, const ros::Time& measured);
  /// Pose in `map` of something in a frame; empty, with a warning, if tf does not know the frame.
  std::optional<Pose> toMap(Source& source, const std::string& frame, const Pose& pose);
  void warn(const Source& source, Problem problem, const std::string& text);
  void warnOfStaleness(const Source& source, const ros::Time& now);

  ros::NodeHandle node_;
  std::function<ros::Time()> clock_;
  Episode* episode_ = nullptr;
  std::vector<std::unique_ptr<Source>> sources_;  // of external robots
  std::set<std::pair<RobotId, Problem>> warned_;
  tf2::BufferCore frames_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;  // with external robots
};

}  // namespace crowd
