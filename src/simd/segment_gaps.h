#pragma once

#include <algorithm>
#include <cstddef>

namespace crowd::simd {

/// @brief A segment of the plane [m].
struct PlaneSegment {
  double from_x;
  double from_y;
  double to_x;
  double to_y;
};

/// @brief Points of two segments whose distance is the smallest [m].
struct NearestPair {
  double first_x;
  double first_y;
  double second_x;
  double second_y;
};

/// @brief Finds them; for segments that cross, their common point twice. Segments that do not cross are closest at an
/// end of one of them.
NearestPair nearestPair(const PlaneSegment& first, const PlaneSegment& second);

/// @brief The number of regions that a kernel is given is a multiple of it.
constexpr std::size_t REGIONS_AT_ONCE = 8;

/// @brief Regions that bodies may cover: discs that move along segments. Arrays of `count` elements.
struct RegionArrays {
  const double* from_xs;  ///< [m]
  const double* from_ys;
  const double* to_xs;
  const double* to_ys;
  const double* radii;  ///< [m]
  std::size_t count;    ///< a multiple of REGIONS_AT_ONCE
};

/// @brief Gaps between the region of an agent and those of others. Arrays of as many elements as there are others.
struct GapArrays {
  double* normal_xs;  ///< unit vector towards the other; 0 if the segments have a common point
  double* normal_ys;
  double* widths;  ///< negative: the regions overlap [m]
  double* alongs;  ///< component along the normal of the point of the agent's segment nearest to the other [m]
};

/// @brief Finds the gaps between the region of a disc that moves from the origin to a point, and other regions.
using FindGaps = void(double to_x, double to_y, double radius, const RegionArrays& others, const GapArrays& gaps);

}  // namespace crowd::simd
