#pragma once

#include "ros/node/parameters.h"

namespace crowd {

constexpr double DIAGNOSTIC_PERIOD = 1.0;  ///< default of ~diagnostic_period [s]

/// @brief Reads ~diagnostic_period, the wall-clock time between two diagnostics of a node [s].
inline double readDiagnosticPeriod(Parameters& parameters) {
  return parameters.number("diagnostic_period", DIAGNOSTIC_PERIOD, {0.1, 3600.0, "s"});
}

}  // namespace crowd
