#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace crowd {

/// @brief Permitted range of a number, with its unit. The limits belong to the range unless they are open.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const char* unit = "";   ///< such as "s"
  bool above_low = false;  ///< the lower limit is open
  bool below_high = false;

  /// @brief Whether a number is finite and within the range.
  bool contains(double value) const {
    const bool above = above_low ? value > low : value >= low;
    const bool below = below_high ? value < high : value <= high;
    return std::isfinite(value) && above && below;
  }
};

/// @brief Describes a number of the range for messages: "a number from 0 to 3600 s", "a number above 0, at most 1", "a
/// number from 0 to below 1", "a number of at least 0", "a number".
std::string toText(const NumberRange& range);

}  // namespace crowd
