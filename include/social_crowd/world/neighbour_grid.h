#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Finds discs near a point: a uniform grid over the discs' centres, rebuilt each tick in O(n).
class NeighbourGrid {
 public:
  /// @brief A disc in the grid; `body` is whatever number the caller knows it by.
  struct Disc {
    Vector2 centre = Vector2::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]
    std::uint32_t body = 0;
  };

  void clear();
  void add(const Vector2& centre, double radius, std::uint32_t body);
  /// @brief Sorts what was added into cells of about this size [m]; to be called after the last add().
  void build(double cell_size);

  /// @brief Appends to `found` the discs whose rim is within `distance` [m] of the point, in an order that depends on
  /// the discs alone.
  void findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const;

 private:
  static constexpr std::size_t MAX_CELLS = 1U << 20U;

  std::int64_t column(double x) const;
  std::int64_t row(double y) const;

  std::vector<Disc> discs_;           // in order of add()
  std::vector<std::uint32_t> cells_;  // cell of each disc
  std::vector<std::uint32_t> first_;  // first entry of each cell in order_
  std::vector<Disc> sorted_;          // discs cell by cell
  Vector2 origin_ = Vector2::Zero();
  double cell_size_ = 1.0;
  double max_radius_ = 0.0;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace crowd
