#pragma once

#include <cstdint>
#include <vector>

#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief How near walls and obstacles are. Not thread-safe.
class Surroundings {
 public:
  /// @brief Distance from a robot's footprint to the nearest wall [m]; infinite without walls, 0 or less if they have a
  /// common point.
  double wallDistance(const ObservedScene& scene, const Robot& robot);
  /// @brief The same to the nearest obstacle [m].
  static double obstacleDistance(const ObservedScene& scene, const Robot& robot);
  /// @brief Distance from the rim of a person to the nearest wall or obstacle [m]; infinite without any.
  static double clearanceOf(const ObservedScene& scene, const ObservedPerson& person);

 private:
  std::vector<std::uint32_t> near_walls_;  // scratch
};

}  // namespace crowd
