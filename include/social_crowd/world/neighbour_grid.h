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

  /// @brief Number of discs, in order of the cells.
  std::size_t size() const { return bodies_.size(); }
  Vector2 centre(std::size_t disc) const { return {xs_[disc], ys_[disc]}; }
  double radius(std::size_t disc) const { return radii_[disc]; }
  std::uint32_t body(std::size_t disc) const { return bodies_[disc]; }

  /// @brief Calls use(begin, end) for runs of discs that hold all whose rim is within `distance` [m] of the point, and
  /// others.
  template <typename Use>
  void forRunsNear(const Vector2& point, double distance, const Use& use) const;

  /// @brief Appends to `found` the discs whose rim is within `distance` [m] of the point, in an order that depends on
  /// the discs alone.
  void findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const;

 private:
  static constexpr std::size_t MAX_CELLS = 1U << 20U;
  static constexpr std::size_t FEW = 8;  // so few discs are looked at one by one, in one cell

  void layOut(double cell_size);
  void countCells();
  void place(const Disc& disc, std::size_t where);
  std::int64_t column(double x) const;
  std::int64_t row(double y) const;

  std::vector<Disc> added_;           // in order of add()
  std::vector<std::uint32_t> cells_;  // cell of each of them
  std::vector<std::uint32_t> first_;  // first_[c]: first disc of cell c
  // Discs cell by cell; a row of cells is one run of discs.
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> radii_;
  std::vector<std::uint32_t> bodies_;
  Vector2 origin_ = Vector2::Zero();
  double cell_size_ = 1.0;
  double max_radius_ = 0.0;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

template <typename Use>
void NeighbourGrid::forRunsNear(const Vector2& point, double distance, const Use& use) const {
  if (bodies_.size() <= FEW) {
    if (!bodies_.empty()) use(0U, static_cast<std::uint32_t>(bodies_.size()));
    return;
  }
  const double reach = distance + max_radius_;
  const std::int64_t left = column(point.x() - reach);
  const std::int64_t right = column(point.x() + reach);
  const std::int64_t top = row(point.y() + reach);
  for (std::int64_t r = row(point.y() - reach); r <= top; ++r) {
    const auto begin = first_[static_cast<std::size_t>(r * columns_ + left)];
    const auto end = first_[static_cast<std::size_t>(r * columns_ + right) + 1];
    if (begin < end) use(begin, end);
  }
}

}  // namespace crowd
