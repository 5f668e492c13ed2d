#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "common/random.h"
#include "geometry/geometry.h"
#include "scenario/robot_sensors.h"

namespace crowd {

/// @brief Number of a body that a ray hits, chosen by the caller.
using BodyNumber = std::uint32_t;

/// @brief What a ray hits if it hits no body.
constexpr BodyNumber WALL_HIT = std::numeric_limits<BodyNumber>::max() - 1;
constexpr BodyNumber NO_HIT = std::numeric_limits<BodyNumber>::max();

/// @brief An exact scan: for each ray the distance [m], infinite without a hit within the range, and what it hits.
struct Scan {
  std::vector<double> distances;
  std::vector<BodyNumber> hits;
};

/// @brief Number of ticks between two scans, at least one: the period, rounded. @param tick_duration [s]
std::uint64_t scanTicks(const ScanSpec& spec, double tick_duration);

/// @brief Angle between two rays [rad].
double angleIncrement(const ScanSpec& spec);

/// @brief Writes the ranges that a sensor reports (REP 117): with noise; -inf below the least range, +inf beyond the
/// greatest one or without a hit, NaN for a ray that drops out.
/// @param key of the random numbers of this scan
void writeRanges(const Scan& scan, const ScanSpec& spec, const KeyedRandom& key, std::vector<float>& ranges);

/// @brief Marks the bodies that at least one ray hits. @param seen by body number; larger numbers are left out
void markVisible(const Scan& scan, std::vector<bool>& seen);

}  // namespace crowd
