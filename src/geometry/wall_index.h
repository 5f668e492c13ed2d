#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/span.h"
#include "geometry/geometry.h"
#include "geometry/ray.h"

namespace crowd {

/// @brief Finds walls near points and paths with a uniform grid, so that a search costs only what is near.
///
/// It does not change after construction; any number of threads may search at the same time. Up to FEW walls are a
/// plain list. Memory is limited: there are at most 2^20 cells, and long walls that cross very many cells make cells
/// larger.
class WallIndex {
 public:
  static constexpr std::size_t FEW = 8;  ///< up to this number of walls, a list is fastest

  WallIndex() = default;
  /// @param walls finite segments [m]
  /// @param margin searches up to this distance look at one cell only, which takes more memory [m]
  explicit WallIndex(std::vector<Segment> walls, double margin = 0.0);

  /// @brief The walls in the order in which they were given; searches return indices into this list.
  const std::vector<Segment>& walls() const { return walls_; }

  /// @brief Appends to `found` the walls at most `distance` [m] from the point, each once, by ascending index.
  void findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const;

  /// @brief Whether any wall is at most `distance` [m] from the point.
  bool isAnyWithin(const Vector2& point, double distance) const {
    return !walls_.empty() && isAnyOfWallsWithin(point, distance);
  }

  /// @brief Distance from the point to the nearest wall [m], or `limit` if that is less; `limit` may be infinite.
  double nearestDistance(const Vector2& point, double limit) const;

  /// @brief Whether a disc that moves straight from one point to another overlaps no wall on the way. Walls that it
  /// only touches do not count, unless the radius is 0.
  /// @param radius of the disc [m]
  bool isClear(const Vector2& from, const Vector2& to, double radius) const;

  /// @brief Distance along the ray to the nearest wall [m], or `limit` if that is less; `limit` may be infinite.
  double firstHit(const Ray& ray, double limit) const;

  /// @brief Memory of the walls and the grid [bytes].
  std::size_t memory() const;

 private:
  /// Columns left .. right of the rows bottom .. top.
  struct Cells {
    std::int64_t left;
    std::int64_t right;
    std::int64_t bottom;
    std::int64_t top;
  };

  bool isList() const { return walls_.size() <= FEW; }
  bool isAnyOfWallsWithin(const Vector2& point, double distance) const;
  void layOut();
  void fillCells();
  /// The number of pairs of a wall and a cell that it crosses.
  std::size_t countEntries() const;
  std::int64_t column(double x) const { return cellOf(x - origin_.x(), columns_); }
  std::int64_t row(double y) const { return cellOf(y - origin_.y(), rows_); }
  /// The cell at this distance from the first cell's edge [m], or the nearest one.
  std::int64_t cellOf(double offset, std::int64_t cells) const;
  /// Cells that list all walls at most `distance` [m] from the point.
  Cells cellsNear(const Vector2& point, double distance) const;
  /// Calls visit(row, left, right) for rows of cells that contain all points at most `margin` [m] from the segment.
  template <typename Visit>
  bool visitRows(const Segment& segment, double margin, const Visit& visit) const;
  /// The walls in cells of a row, some of them several times.
  Span<std::uint32_t> wallsInRow(std::int64_t row, std::int64_t left, std::int64_t right) const;
  /// Calls test(wall) for the walls in cells near a point, some of them several times, until it returns true; returns
  /// whether it did.
  template <typename Test>
  bool isAnyNear(const Vector2& point, double distance, const Test& test) const;

  std::vector<Segment> walls_;
  double margin_ = 0.0;                 // [m]
  std::vector<std::uint32_t> first_;    // first_[c]: first entry of cell c
  std::vector<std::uint32_t> entries_;  // walls within the margin of all cells, in each cell in ascending order
  Vector2 origin_ = Vector2::Zero();
  double cells_per_metre_ = 1.0;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
};

}  // namespace crowd
