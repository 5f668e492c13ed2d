#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/geometry.h"
#include "training/communicator.h"

namespace crowd {

/// @brief Division of the floor into parallel strips, one for each rank, whose outer ones have no end. A strip may be
/// narrow, or without any agent.
class FloorStrips {
 public:
  /// @brief Strips across the longer side of the area of these places, with about equal numbers of them.
  FloorStrips(const std::vector<Vector2>& places, int count);

  /// @brief Moves the borders so that the strips hold about equal numbers of the places of all ranks. Collective; the
  /// borders are the same on all ranks.
  void balance(const std::vector<Vector2>& places, Communicator& communicator);

  /// @brief Number of the strip that a place belongs to.
  int stripOf(const Vector2& place) const { return stripAt(along(place)); }
  /// @brief Distance of a place from a strip; 0 inside [m].
  double distanceTo(int strip, const Vector2& place) const;
  /// @brief First and last of the strips that are within a distance of a place [m].
  std::pair<int, int> stripsWithin(double distance, const Vector2& place) const {
    return {stripAt(along(place) - distance), stripAt(along(place) + distance)};
  }
  int count() const { return static_cast<int>(borders_.size()) + 1; }

 private:
  /// Numbers of places along the strips' axis.
  struct Histogram {
    double low = 0.0;   // [m]
    double high = 0.0;  // [m]
    std::vector<std::uint64_t> counts;
  };
  int stripAt(double coordinate) const;
  double along(const Vector2& place) const { return place[axis_]; }
  void count(const std::vector<Vector2>& places, Histogram& histogram) const;
  void divide(const Histogram& histogram);

  int axis_ = 0;                 // 0: x, 1: y
  std::vector<double> borders_;  // ascending [m]
};

}  // namespace crowd
