#pragma once

#include <cstdint>

#include "common/text/enum_names.h"

namespace crowd {

/// @brief What a person looks like in RViz. TROLLEY: an adult who pulls a suitcase.
enum class Figure : std::uint8_t { ADULT = 0, CHILD = 1, OLD = 2, WHEELCHAIR = 3, TROLLEY = 4 };
inline constexpr EnumNames<Figure, 5> FIGURES{"figure", {"adult", "child", "old", "wheelchair", "trolley"}};

}  // namespace crowd
