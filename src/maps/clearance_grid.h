#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/stop_request.h"
#include "maps/floor_plan.h"

namespace crowd {

/// @brief Distances from the points of a square grid to the nearest wall or obstacle at rest. Immutable: any number of
/// threads may use it at the same time.
class ClearanceGrid {
 public:
  using Index = std::uint32_t;
  static constexpr Index OUTSIDE = ~Index{0};
  /// @brief Greatest number of grid points; larger floors get a larger spacing.
  static constexpr std::size_t MAX_POINTS = 16'000'000;

  /// @brief Covers walls and obstacles and a margin around them of more than twice the limit.
  /// @param spacing distance between neighbouring grid points [m]; it grows for floors of more than MAX_POINTS
  /// @param limit larger distances are not needed and stored as `limit` [m]
  /// @throws Stopped if `stop` is made
  ClearanceGrid(const FloorPlan& floor, double spacing, double limit, const StopRequest& stop = {});

  Index columns() const { return columns_; }
  Index rows() const { return rows_; }
  std::size_t size() const { return distances_.size(); }
  double spacing() const { return spacing_; }
  /// @brief Memory that it occupies [bytes].
  std::size_t bytes() const { return sizeof(*this) + distances_.capacity() * sizeof(float); }
  /// @brief Distance from a grid point to the nearest wall or rim [m], at most the limit; negative inside an obstacle.
  double operator[](Index point) const { return distances_[point]; }
  /// @brief The place of a grid point [m], `map`.
  Vector2 place(Index point) const {
    const Index row = point / columns_;
    return origin_ + spacing_ * Vector2(static_cast<double>(point % columns_), static_cast<double>(row));
  }
  /// @brief The grid point nearest to a place [m], `map`; OUTSIDE if the place is more than half a cell off the grid.
  Index nearest(const Vector2& place) const { return pointAt(toCells(place)); }
  /// @brief Column and row of a place, plus 0.5, so that their integer parts are those of the nearest grid point.
  Vector2 toCells(const Vector2& place) const { return points_per_metre_ * (place - origin_) + Vector2(0.5, 0.5); }
  /// @brief Distance at toCells() of a place, as at its nearest grid point [m]; infinite off the grid.
  double at(const Vector2& cells) const {
    const Index point = pointAt(cells);
    return point == OUTSIDE ? INFINITE : distances_[point];
  }

  /// @brief The grid point that is this number of columns and rows away; OUTSIDE if there is none.
  Index offset(Index point, int columns, int rows) const {
    const std::int64_t column = static_cast<std::int64_t>(point % columns_) + columns;
    const std::int64_t row = static_cast<std::int64_t>(point / columns_) + rows;
    const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
    return inside ? static_cast<Index>(row * columns_ + column) : OUTSIDE;
  }

  /// @brief Calls visit(other) for all grid points within a distance [m] of one.
  template <typename Visit>
  void forPointsWithin(double distance, Index point, const Visit& visit) const {
    const auto reach = static_cast<int>(distance / spacing_);
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const Index at = offset(point, dx, dy);
        if (at != OUTSIDE && spacing_ * std::sqrt(dx * dx + dy * dy) <= distance) visit(at);
      }
    }
  }

  /// @brief Calls visit(neighbour) for the up to eight neighbours of a grid point.
  template <typename Visit>
  void forNeighbours(Index point, const Visit& visit) const {
    const Index column = point % columns_;
    const Index row = point / columns_;
    for (Index r = row > 0 ? row - 1 : 0; r <= row + 1 && r < rows_; ++r) {
      for (Index c = column > 0 ? column - 1 : 0; c <= column + 1 && c < columns_; ++c) {
        if (c != column || r != row) visit(r * columns_ + c);
      }
    }
  }

 private:
  template <typename Distance>
  void lower(const Vector2& low, const Vector2& high, const Distance& distance);

  Index pointAt(const Vector2& cells) const {
    const bool inside = cells.x() >= 0.0 && cells.y() >= 0.0 && cells.x() < columns_ && cells.y() < rows_;
    return inside ? static_cast<Index>(cells.y()) * columns_ + static_cast<Index>(cells.x()) : OUTSIDE;
  }

  Vector2 origin_ = Vector2::Zero();
  double spacing_;
  double points_per_metre_;
  double limit_;
  Index columns_ = 0;
  Index rows_ = 0;
  std::vector<float> distances_;
};

}  // namespace crowd
