#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/span.h"

namespace crowd {

/// @brief Finds discs near a point: a uniform grid over the discs' centres, rebuilt each tick in O(n).
class NeighbourGrid {
 public:
  /// @brief A disc in the grid; `body` is whatever number the caller knows it by.
  struct Disc {
    Vector2 centre = Vector2::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]
    std::uint32_t body = 0;
    Vector2 velocity = Vector2::Zero();  ///< [m/s]; means nothing to the grid
  };

  /// @brief Takes everything out.
  void clear();
  /// @brief Adds a disc (see Disc), which is found once build() was called.
  void add(const Vector2& centre, double radius, std::uint32_t body, const Vector2& velocity = Vector2::Zero());
  /// @brief Sorts what was added into cells of about this size [m]; to be called after the last add().
  void build(double cell_size);

  /// @brief Whether there are so few discs that they are kept in order of add(), and may move().
  bool isList() const { return size() <= LIST; }
  /// @brief Whether they are even so few that it is best to look at them one by one.
  bool isShort() const { return size() <= SHORT; }
  /// @brief Puts a disc of a list in another place [m], with another velocity [m/s].
  void move(std::size_t disc, const Vector2& centre, const Vector2& velocity) {
    xs_[disc] = centre.x();
    ys_[disc] = centre.y();
    motions_[disc] = {centre.x(), centre.y(), velocity.x(), velocity.y()};
  }

  /// @brief Number of discs, in order of the cells.
  std::size_t size() const { return motions_.size(); }
  Vector2 centre(std::size_t disc) const { return {xs_[disc], ys_[disc]}; }
  /// @brief Behind the last disc so many more of these numbers may be read, whatever they are.
  static constexpr std::size_t PADDING = 16;
  /// @brief The numbers of all discs, for loops over runs of discs.
  const double* xs() const { return xs_.data(); }
  const double* ys() const { return ys_.data(); }
  const double* radii() const { return radii_.data(); }
  const std::uint32_t* bodies() const { return bodies_.data(); }
  double radius(std::size_t disc) const { return radii_[disc]; }
  std::uint32_t body(std::size_t disc) const { return bodies_[disc]; }
  Vector2 velocity(std::size_t disc) const { return {motions_[disc].vx, motions_[disc].vy}; }

  /// @brief Place and velocity of a disc once more, so that one read takes both.
  struct Motion {
    double x;  ///< [m]
    double y;
    double vx;  ///< [m/s]
    double vy;
  };
  /// @brief Of all discs, in order of the cells.
  const Motion* motions() const { return motions_.data(); }

  /// @brief Discs begin .. end-1, in order of the cells.
  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
  };
  using Runs = std::vector<Run>;
  /// @brief Some runs, and how many discs they hold.
  struct RunsNear {
    Span<Run> runs;
    std::size_t discs;
  };

  /// @brief Runs of discs, some of them empty, that hold all whose rim is within `distance` [m] of the point, and
  /// others. @param space where they are written; it only grows
  RunsNear findRunsNear(const Vector2& point, double distance, Runs& space) const;

  /// @brief Appends to `found` the discs whose rim is within `distance` [m] of the point, in an order that depends on
  /// the discs alone.
  void findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const;

  /// @brief Whether there is a disc whose rim is within `distance` [m] of the point. @param except a body not counted
  bool isAnyNear(const Vector2& point, double distance, std::uint32_t except) const {
    return isShort() ? isAnyInShortList(point, distance, except) : isAnyInRuns(point, distance, except);
  }

 private:
  static constexpr std::size_t MAX_CELLS = 1U << 20U;
  static constexpr std::size_t SHORT = 8;
  static constexpr std::size_t LIST = 32;  // so few discs are one run

  /// A rectangle of cells; a row of cells is one run of discs.
  struct Cells {
    std::int64_t left;
    std::int64_t right;
    std::int64_t bottom;
    std::int64_t top;
  };
  /// Where discs are whose rim may be within the distance.
  Cells cellsNear(const Vector2& point, double distance) const {
    const double reach = std::max(0.0, distance + max_radius_);
    return {column(point.x() - reach), column(point.x() + reach), row(point.y() - reach), row(point.y() + reach)};
  }
  Run runOf(const Cells& cells, std::int64_t row) const {
    const std::int64_t first = row * columns_;
    return {first_[static_cast<std::size_t>(first + cells.left)],
            first_[static_cast<std::size_t>(first + cells.right) + 1]};
  }
  Run all() const { return {0, static_cast<std::uint32_t>(size())}; }
  bool isAnyInShortList(const Vector2& point, double distance, std::uint32_t except) const {
    // One is often the body that asks, and the others are soon told from each other: branches are guessed well here.
    for (std::size_t i = 0; i < size(); ++i) {
      const double limit = distance + radii_[i];
      if (limit < 0.0 || bodies_[i] == except) continue;
      if ((centre(i) - point).squaredNorm() <= limit * limit) return true;
    }
    return false;
  }
  bool isAnyInRuns(const Vector2& point, double distance, std::uint32_t except) const;
  void layOut(double cell_size);
  void countCells();
  void place(const Disc& disc, std::size_t where);
  std::int64_t column(double x) const { return cellOf(x - origin_.x(), columns_); }
  std::int64_t row(double y) const { return cellOf(y - origin_.y(), rows_); }
  std::int64_t cellOf(double offset, std::int64_t cells) const {
    // Cutting off the fraction rounds towards 0, where what lies before the first cell goes in any case.
    return static_cast<std::int64_t>(std::clamp(offset * cells_per_metre_, 0.0, static_cast<double>(cells - 1)));
  }

  std::vector<Disc> added_;           // in order of add()
  std::vector<std::uint32_t> cells_;  // cell of each of them
  std::vector<std::uint32_t> first_;  // first_[c]: first disc of cell c
  // Discs cell by cell.
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> radii_;
  std::vector<std::uint32_t> bodies_;
  std::vector<Motion> motions_;
  Vector2 origin_ = Vector2::Zero();
  double cells_per_metre_ = 1.0;
  double max_radius_ = 0.0;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace crowd
