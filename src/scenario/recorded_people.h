#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief People of a recording who walk in a scenario as they did there, as an entry under `recorded` describes them.
struct RecordedPeople {
  static constexpr double DEFAULT_RADIUS = 0.25;  ///< [m], as that of people that are replayed without a scenario

  std::string file;                       ///< that the recording was read from
  std::optional<std::uint64_t> instance;  ///< of a CSV file; absent: the first
  std::optional<double> frame_rate;       ///< [Hz]; absent: that of the file, else a frame is a tick
  double from = 0.0;                      ///< begin of the part that is used [s], since frame 0
  std::optional<double> to;               ///< its end [s]; absent: that of the recording
  double offset = 0.0;                    ///< when it begins in the episode [s]; below 0: it has begun before
  std::vector<std::uint64_t> people;      ///< their numbers in the file; empty: all
  double radius = DEFAULT_RADIUS;         ///< [m]
  Vector2 shift = Vector2::Zero();        ///< of all places [m], `map`
};

}  // namespace crowd
