#pragma once

#include <optional>
#include <vector>

#include "robots/metrics/conflicts.h"
#include "robots/metrics/group_space.h"
#include "robots/metrics/observed_scene.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/surroundings.h"

namespace crowd {

/// @brief Measures the robots of a scene at the end of a tick. Call begin() once for each tick. Not thread-safe.
class RobotSampler {
 public:
  void begin(const ObservedScene& scene);

  /// @brief What is measured of a robot. @param before of the same robot at the end of the tick before
  /// @param goal number of the goal that it drove to in this tick
  RobotSample measure(const ObservedScene& scene, RobotId id, const RobotSample& before, std::size_t goal);
  /// @brief The same at the start, before it moves: it has no acceleration.
  RobotSample measureStart(const ObservedScene& scene, RobotId id);
  /// @brief Of a robot that is not measured now, what later samples need: its motion, and what it is at.
  RobotSample follow(const ObservedScene& scene, RobotId id, const RobotSample& before);

 private:
  void measurePlace(const ObservedScene& scene, RobotId id, RobotSample& sample);
  void measureEncounters(const ObservedScene& scene, RobotId id, std::size_t goal, RobotSample& sample);
  static void measurePeople(const ObservedScene& scene, const Robot& robot, RobotSample& sample);
  void measureForces(const ObservedScene& scene, const Robot& robot, RobotSample& sample);
  void measureClearance(const ObservedScene& scene, const Robot& robot, RobotSample& sample);

  GroupSpaces groups_;
  Conflicts conflicts_;
  Surroundings surroundings_;
  std::optional<double> force_on_people_;  // of walls and obstacles, mean over the people, once asked for [m/s^2]
};

}  // namespace crowd
