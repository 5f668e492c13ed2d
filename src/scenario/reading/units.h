#pragma once

#include "geometry/limits.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Conversion from the units of a scenario document (thesis: per tick, ticks) to SI.
struct Units {
  bool thesis = false;
  double tick_duration = DEFAULT_TICK_DURATION;

  double speed(double value) const { return thesis ? value / tick_duration : value; }
  Range speed(const Range& range) const { return {speed(range.low), speed(range.high)}; }
  /// @brief A limit of speeds, in the units of the document.
  NumberLimit limit(const NumberLimit& speeds) const {
    return thesis ? NumberLimit{speeds.rule, speeds.most * tick_duration, "m/tick"} : speeds;
  }
};

}  // namespace crowd
