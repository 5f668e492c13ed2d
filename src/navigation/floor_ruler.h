#pragma once

#include "maps/clearance_grid.h"

namespace crowd {

/// @brief Free floor to both sides of a place, for the centre of a disc [m].
struct FloorWidth {
  double left = 0.0;
  double right = 0.0;
  double total() const { return left + right; }
};

/// @brief Measures how wide a floor is across a direction. Immutable: any number of threads may use it at the same
/// time.
class FloorRuler {
 public:
  /// @brief Distance between the points of its grid [m].
  static constexpr double SPACING = 0.05;

  /// @param clearance the largest one that hasClearance() is asked for [m] @throws Stopped if `stop` is made
  FloorRuler(const FloorPlan& floor, double clearance, const StopRequest& stop = {})
      : grid_(floor, SPACING, clearance + SPACING, stop) {}

  /// @brief The free floor on the line through a place and across a direction, in steps of 0.1 m.
  /// @param place [m] @param forward unit vector @param radius of the disc [m] @param limit of the total; a wider floor
  /// is not measured to its end [m]
  FloorWidth widthAt(const Vector2& place, const Vector2& forward, double radius, double limit) const {
    const Vector2 right(forward.y(), -forward.x());
    const double left = roomTo(-right, place, radius, limit);
    return {left, roomTo(right, place, radius, limit + STEP - left)};
  }
  /// @brief Whether walls and obstacles are this far away from a place; beyond the grid there are none [m].
  bool hasClearance(const Vector2& place, double clearance) const {
    return grid_.at(grid_.toCells(place)) >= clearance;
  }
  /// @brief Memory that it occupies [bytes].
  std::size_t bytes() const { return grid_.bytes(); }

 private:
  static constexpr double STEP = 0.1;  // [m]

  double roomTo(const Vector2& side, const Vector2& place, double radius, double limit) const {
    const Vector2 step = STEP / grid_.spacing() * side;
    double width = 0.0;
    for (Vector2 cell = grid_.toCells(place) + step; width < limit && grid_.at(cell) >= radius; cell += step)
      width += STEP;
    return width;
  }

  ClearanceGrid grid_;
};

}  // namespace crowd
