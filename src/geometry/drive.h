#pragma once

#include <cstdint>

#include "common/text/enum_names.h"
#include "geometry/geometry.h"

namespace crowd {

/// @brief Velocity of a robot in its own frame (x ahead, y left).
struct Twist {
  Vector2 linear = Vector2::Zero();  ///< [m/s]
  double rotation = 0.0;             ///< counterclockwise [rad/s]

  bool isFinite() const;
};

/// @brief How a robot moves. DIFFERENTIAL: along its heading, and it turns on the spot. HOLONOMIC: in all directions.
/// ACKERMANN: along its heading, and it turns on curves only. EXTERNAL: its pose comes from elsewhere.
enum class Drive : std::uint8_t { DIFFERENTIAL = 0, HOLONOMIC = 1, ACKERMANN = 2, EXTERNAL = 3 };
inline constexpr EnumNames<Drive, 4> DRIVES{"drive", {"differential", "holonomic", "ackermann", "external"}};

/// @brief Limits of a robot's motion.
struct DriveLimits {
  double max_speed = 0.0;                  ///< [m/s]
  double max_rotation = 1.0;               ///< [rad/s]
  double max_acceleration = 1.0;           ///< [m/s^2]
  double max_rotation_acceleration = 2.0;  ///< [rad/s^2]
  double min_turning_radius = 0.0;         ///< of curves [m]; ACKERMANN only
};

/// @brief The twist of the next tick: the wanted one as far as the drive and its limits allow. It holds for the whole
/// tick. With ACKERMANN the turning radius is kept even where the rotation then changes faster than its limit.
/// @param last of the tick before @param tick_duration [s]
Twist limitTwist(Drive drive, const DriveLimits& limits, const Twist& last, const Twist& wanted, double tick_duration);

/// @brief The pose after a time at a constant twist: on an arc. @param pose in any frame @param time [s]
Pose drivePose(const Pose& pose, const Twist& twist, double time);

/// @brief The constant twist that leads from one pose to another in a time, with a turn of less than half a turn: the
/// inverse of drivePose(). @param time above 0 [s]
Twist twistBetween(const Pose& from, const Pose& to, double time);

/// @brief Upper bound of the distance between the position of a robot within its limits at the end of a tick, and the
/// position that its velocity at the start of the tick leads to [m]. At earlier times of the tick the bound is the same
/// share of it. @param tick_duration [s]
double deviation(const DriveLimits& limits, double tick_duration);

}  // namespace crowd
