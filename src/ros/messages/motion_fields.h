#pragma once

#include <cstdint>
#include <optional>

#include "geometry/motion_limits.h"

namespace crowd {

/// @brief Motion limits as in messages, in which 0 stands for no limit.
struct MotionFields {
  double acceleration = 0.0;  ///< [m/s2]
  double braking = 0.0;       ///< [m/s2]
  double turn_rate = 0.0;     ///< [rad/s]
};

/// @brief Limits as fields.
MotionFields toFields(const MotionLimits& motion);
/// @brief Inverse of toFields(), for any numbers; refusalOf() says whether they are limits.
MotionLimits fromFields(const MotionFields& fields);

/// @brief The motion that the vision of received perceptions has.
/// @param source a constant of Perceptions.msg; limits of the scenario hold for any model
std::optional<MotionLimits> requestOf(std::uint8_t source, const MotionLimits& motion);

}  // namespace crowd
