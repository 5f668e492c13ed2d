#pragma once

#include <cstdint>

#include "robots/metrics/statistic.h"

namespace crowd {

/// @brief The ticks in which a robot was measured.
struct MeasuredTime {
  double tick_duration = 0.0;  ///< [s]
  std::uint64_t ticks = 0;

  /// @brief The time that some ticks take [s].
  double seconds(std::uint64_t some) const { return static_cast<double>(some) * tick_duration; }
  /// @brief The time that all of them take [s].
  double seconds() const { return seconds(ticks); }
  /// @brief Mean over the ticks of something that was added up; NaN without ticks.
  double mean(double sum) const { return ratioOf(sum, static_cast<double>(ticks)); }
  /// @brief Some ticks in percent of all; NaN without ticks.
  double percent(std::uint64_t some) const { return mean(100.0 * static_cast<double>(some)); }
};

}  // namespace crowd
