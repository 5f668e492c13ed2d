#pragma once

#include <limits>
#include <string>

namespace crowd {

/// @brief Permitted numbers by their sign. FRACTION: 0 to 1.
enum class NumberRule { ANY, NOT_NEGATIVE, POSITIVE, FRACTION };

/// @brief A rule, and the greatest magnitude that is permitted, with its unit.
struct NumberLimit {
  constexpr NumberLimit(NumberRule rule, double most, const char* unit) : rule(rule), most(most), unit(unit) {}
  /// @brief Any finite magnitude.
  constexpr NumberLimit(NumberRule rule)  // NOLINT(google-explicit-constructor): a rule alone is a limit
      : NumberLimit(rule, std::numeric_limits<double>::max(), "") {}

  NumberRule rule;
  double most;
  const char* unit;  ///< such as "m/s"
};

/// @brief What was expected in place of a number: "a number above 0", "at most 1000 m/s", "a number from -1000 to 1000
/// m"; empty if the limit permits the number.
std::string refusalOf(double value, const NumberLimit& limit);

}  // namespace crowd
