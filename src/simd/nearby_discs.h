#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief Discs as one array for each of their numbers. Up to PADDING numbers behind the last disc are read, whatever
/// they are.
struct DiscArrays {
  static constexpr std::size_t PADDING = 16;

  const double* xs;  ///< of the centres [m]
  const double* ys;
  const double* radii;              ///< [m]
  const std::uint32_t* neighbours;  ///< numbers of the bodies
};

/// @brief The discs begin .. end-1.
struct DiscRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/// @brief A circle in which discs are looked for.
struct Circle {
  double x;  ///< of the centre [m]
  double y;
  double radius;         ///< [m]
  std::uint32_t except;  ///< the body that is left out
};

/// @brief Where collected discs are written. There must be room for all discs of the range, and PADDING more.
struct CollectedDiscs {
  std::uint64_t* discs;  ///< their places in the arrays
  double* rims;          ///< distances of their rims from the circle's centre [m]; negative from within
};

/// @brief Writes down the discs of a range whose rim is in the circle, in their order, behind the first `count`.
/// @return how many there are now
using CollectNearby = std::size_t(const DiscArrays& arrays, DiscRange range, const Circle& circle, std::size_t count,
                                  const CollectedDiscs& collected);

}  // namespace crowd::simd
