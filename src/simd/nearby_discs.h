#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief Discs as a structure of arrays. Kernels read up to PADDING unspecified elements behind the last disc.
struct DiscArrays {
  static constexpr std::size_t PADDING = 16;

  const double* xs;  ///< of the centres [m]
  const double* ys;
  const double* radii;              ///< [m]
  const std::uint32_t* neighbours;  ///< identifiers of the bodies
};

/// @brief The discs begin .. end - 1.
struct DiscRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/// @brief Query circle.
struct Circle {
  double x;  ///< of the centre [m]
  double y;
  double radius;         ///< [m]
  std::uint32_t except;  ///< body that is ignored
};

/// @brief Output of CollectNearby. Capacity: all discs of the range and PADDING more.
struct CollectedDiscs {
  std::uint64_t* discs;  ///< their indices in the arrays
  double* rims;          ///< distances from the centre of the circle to their rims [m]; negative if inside the disc
};

/// @brief Appends the discs of a range whose rim is within the circle, in their order, behind the first `count`.
/// @return the new count
using CollectNearby = std::size_t(const DiscArrays& arrays, DiscRange range, const Circle& circle, std::size_t count,
                                  const CollectedDiscs& collected);

/// @brief Whether the rim of any disc of a range is within the circle.
using IsAnyNearby = bool(const DiscArrays& arrays, DiscRange range, const Circle& circle);

}  // namespace crowd::simd
