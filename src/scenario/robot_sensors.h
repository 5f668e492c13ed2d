#pragma once

#include <cstdint>
#include <optional>

#include "common/text/enum_names.h"
#include "geometry/geometry.h"

namespace crowd {

/// @brief How a laser scanner sees people. BODIES: the discs of their bodies. LEGS: two legs that swing as they walk.
enum class SeenPeople : std::uint8_t { BODIES = 0, LEGS = 1 };
inline constexpr EnumNames<SeenPeople, 2> SEEN_PEOPLE{"people", {"bodies", "legs"}};

/// @brief A laser scanner of a robot.
struct ScanSpec {
  std::uint32_t rays = 720;
  double first_angle = -PI;  ///< of the first ray, sensor frame [rad]
  double last_angle = PI;    ///< of the last ray [rad]; of a full circle, one increment behind the last ray
  double min_range = 0.1;    ///< [m]
  double max_range = 20.0;   ///< [m]
  Pose mount;                ///< of the sensor in the robot's frame
  double noise = 0.0;        ///< standard deviation of a range [m]
  double dropout = 0.0;      ///< share of the rays without a range
  double period = 0.0;       ///< time between scans [s]; 0: one each tick
  SeenPeople people = SeenPeople::BODIES;
  std::uint32_t rings = 0;          ///< of a cloud of points, besides the flat scan; 0: none
  double lowest_ring = -PI / 12.0;  ///< elevation of the lowest ring [rad]
  double highest_ring = PI / 12.0;  ///< elevation of the highest ring [rad]
  double height = 0.0;              ///< of the sensor above the floor [m]
};

/// @brief What a tracker of people on a robot reports. The defaults are the truth.
struct TrackSpec {
  bool occlusion = false;         ///< only people whom a ray of its scanner meets
  double range = INFINITE;        ///< of people from the scanner [m]
  double noise = 0.0;             ///< standard deviation of positions, in x and in y [m]
  double velocity_noise = 0.0;    ///< standard deviation of velocities, in x and in y [m/s]
  double missed = 0.0;            ///< probability that a person is not detected in a tick
  double false_detections = 0.0;  ///< mean number in a second, where nobody is
  /// A track is predicted for this time without a detection [s]; a person who is detected later gets another one. Not
  /// set: nothing is predicted, and everybody keeps the number of the agent.
  std::optional<double> keep;
};

/// @brief Standard deviations of the systematic errors of a robot's odometry, which are drawn once in an episode.
struct OdometrySpec {
  double distance = 0.0;           ///< relative error of distances
  double rotation = 0.0;           ///< relative error of rotations
  double heading_per_metre = 0.0;  ///< change of the heading on a straight way [rad/m]
};

}  // namespace crowd
