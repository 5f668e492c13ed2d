#pragma once

#include "common/text/enum_names.h"

namespace crowd {

/// @brief What sectors and moves of an agent are relative to: its heading, as in the thesis (3.2.2.2), or the x axis of
/// `map`.
enum class Directions { RELATIVE, ABSOLUTE };

/// @brief The key `directions` of a state set or an action set.
inline constexpr EnumNames<Directions, 2> DIRECTIONS{"directions", {"relative", "absolute"}};

}  // namespace crowd
