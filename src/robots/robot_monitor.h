#pragma once

#include <string>
#include <vector>

#include "robots/metrics/robot_sampler.h"
#include "robots/metrics/robot_track.h"
#include "robots/metrics/walkable_area.h"
#include "scenario/robot_metric_options.h"
#include "social_crowd/robot_result.h"
#include "world/world.h"

namespace crowd {

/// @brief Measures robots tick by tick (docs/metrics.md): those of a world, or of a log of poses. The owner calls
/// observe() after each tick. Without robots it does nothing. Not thread-safe.
class RobotMonitor {
 public:
  /// @brief Measures the robots of a world, which is at the start of the scene.
  RobotMonitor(const Scene& scene, const World& world);
  /// @brief Measures the robots of a scene at its start.
  /// @param gates walls of the gates, which are open on shortest ways
  RobotMonitor(const RobotMetricOptions& options, std::vector<Segment> gates, const ObservedScene& start);

  /// @brief Measures robots that have just been added to the world, as the last ones.
  void add(const World& world);
  /// @brief Forgets a robot that is removed from the world.
  void remove(RobotId robot);
  /// @brief Measures a tick that has just ended.
  void observe(const World& world) {
    if (tracks_.empty()) return;
    scene_.observe(world);
    observe(scene_);
  }
  void observe(const ObservedScene& scene);

  std::size_t size() const { return tracks_.size(); }
  const std::string& nameOf(RobotId id) const { return tracks_[id].name(); }
  /// @brief What was measured of a robot in the last tick, or at the start; null if it had arrived before.
  const RobotSample* sampleOf(RobotId id) const { return measured_[id] ? &tracks_[id].last() : nullptr; }
  /// @brief The results by robot, without those that need more than one episode, and without `aggregated_time`.
  std::vector<RobotResult> results() const;

 private:
  /// Measures the robots of a scene that were added to it.
  void add(const ObservedScene& scene);
  ShortestWay waysOf(const ObservedScene& scene, const Robot& robot) const;
  /// Notes where people and robots are.
  void notePlaces(const ObservedScene& scene);

  RobotMetricOptions options_;
  std::vector<Segment> gates_;
  ObservedScene scene_;  // scratch
  RobotSampler sampler_;
  std::vector<RobotTrack> tracks_;
  std::vector<bool> measured_;       // in the last tick
  std::vector<WalkableArea> areas_;  // by robot: the floor around its start
  Eigen::AlignedBox2d used_;         // contains all places so far where people and robots were [m]
};

}  // namespace crowd
