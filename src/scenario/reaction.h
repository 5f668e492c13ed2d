#pragma once

#include <cstdint>

#include "common/text/enum_names.h"

namespace crowd {

/// @brief How a person reacts to a robot (RobotReactions), with the names of HuNavSim. REGULAR: the person gives way to
/// it. INDIFFERENT: the same; HuNavSim makes a difference.
enum class Reaction : std::uint8_t {
  REGULAR = 0,
  INDIFFERENT = 1,
  SURPRISED = 2,
  CURIOUS = 3,
  SCARED = 4,
  THREATENING = 5
};
inline constexpr EnumNames<Reaction, 6> REACTIONS{
    "reaction", {"regular", "indifferent", "surprised", "curious", "scared", "threatening"}};

}  // namespace crowd
