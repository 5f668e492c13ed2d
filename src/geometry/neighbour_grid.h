#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/span.h"
#include "geometry/geometry.h"

namespace crowd {

/// @brief Finds discs near a point with a uniform grid over the centres of the discs, updated each tick in O(n).
///
/// The owner calls clear(), add() for each disc, then build(); when discs have moved, move() for each of them, then
/// update(). Afterwards any number of threads may call the const functions at the same time.
class NeighbourGrid {
 public:
  /// @brief A disc in the grid; `body` is an identifier chosen by the caller.
  struct Disc {
    Vector2 centre = Vector2::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]
    std::uint32_t body = 0;
    Vector2 velocity = Vector2::Zero();  ///< [m/s]; not used by the grid
  };

  /// @brief Removes all discs.
  void clear();
  /// @brief Adds a disc (see Disc); searches find it after the next build().
  void add(const Vector2& centre, double radius, std::uint32_t body, const Vector2& velocity = Vector2::Zero());
  /// @brief Sorts the added discs into cells of about this size [m]; call it after the last add().
  void build(double cell_size);
  /// @brief Sets position [m] and velocity [m/s] of a disc; searches find it there after the next update().
  /// @param number of the disc, from 0 in the order of add()
  void move(std::size_t number, const Vector2& centre, const Vector2& velocity) {
    added_[number].centre = centre;
    added_[number].velocity = velocity;
    if (isList()) setMotion(number, added_[number]);
  }
  /// @brief Sorts the moved discs into the cells; call it after the last move().
  void update() {
    if (!isList()) sortIntoCells();
  }

  /// @brief Number of discs. Disc indices follow the order of the cells.
  std::size_t size() const { return motions_.size(); }
  Vector2 centre(std::size_t disc) const { return {xs_[disc], ys_[disc]}; }
  /// @brief Number of unspecified but readable elements behind the last disc in each array.
  static constexpr std::size_t PADDING = 16;
  /// @brief Arrays over all discs, for loops over runs of discs.
  const double* xs() const { return xs_.data(); }
  const double* ys() const { return ys_.data(); }
  const double* radii() const { return radii_.data(); }
  const std::uint32_t* bodies() const { return bodies_.data(); }
  double radius(std::size_t disc) const { return radii_[disc]; }
  std::uint32_t body(std::size_t disc) const { return bodies_[disc]; }
  Vector2 velocity(std::size_t disc) const { return {motions_[disc].vx, motions_[disc].vy}; }

  /// @brief Interleaved copy of position and velocity of a disc.
  struct Motion {
    double x;  ///< [m]
    double y;
    double vx;  ///< [m/s]
    double vy;
  };
  /// @brief Motions of all discs, in the order of the cells.
  const Motion* motions() const { return motions_.data(); }

  /// @brief The discs begin .. end - 1.
  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
  };
  using Runs = std::vector<Run>;
  /// @brief Runs, and the total number of their discs.
  struct RunsNear {
    Span<Run> runs;
    std::size_t discs;
  };

  /// @brief Returns runs, some of them empty, that contain at least all discs whose rim is within `distance` [m] of the
  /// point. @param space storage of the runs; it only grows
  RunsNear findRunsNear(const Vector2& point, double distance, Runs& space) const;

  /// @brief Appends to `found` the bodies whose rim is within `distance` [m] of the point, in an order that depends
  /// only on the discs.
  void findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const;

  /// @brief Whether the rim of any disc is within `distance` [m] of the point. @param except body that is ignored
  bool isAnyNear(const Vector2& point, double distance, std::uint32_t except) const {
    return size() <= SHORT ? isAnyInShortList(point, distance, except) : isAnyInRuns(point, distance, except);
  }

 private:
  static constexpr std::size_t MAX_CELLS = 1U << 20U;
  static constexpr double ROUNDING = 1e-6;  // of differences of coordinates [m]
  static constexpr std::size_t SHORT = 8;   // up to this number of discs, branches cost less than vector instructions
  static constexpr std::size_t LIST = 32;   // up to this number, all discs form one run, in the order of add()

  /// A rectangle of cells; the discs of each of its rows form one run.
  struct Cells {
    std::int64_t left;
    std::int64_t right;
    std::int64_t bottom;
    std::int64_t top;
  };
  /// The cells of all discs whose rim may be within the distance. With a margin for rounding, so that what is found
  /// does not depend on where the cells begin.
  Cells cellsNear(const Vector2& point, double distance) const {
    const double reach = std::max(0.0, distance + max_radius_) + ROUNDING;
    return {column(point.x() - reach), column(point.x() + reach), row(point.y() - reach), row(point.y() + reach)};
  }
  Run runOf(const Cells& cells, std::int64_t row) const {
    const std::int64_t first = row * columns_;
    return {first_[static_cast<std::size_t>(first + cells.left)],
            first_[static_cast<std::size_t>(first + cells.right) + 1]};
  }
  bool isList() const { return size() <= LIST; }
  Run all() const { return {0, static_cast<std::uint32_t>(size())}; }
  bool isAnyInShortList(const Vector2& point, double distance, std::uint32_t except) const {
    // One disc is often the excluded body and most others are far: branches are predicted well.
    for (std::size_t i = 0; i < size(); ++i) {
      const double limit = distance + radii_[i];
      if (limit < 0.0 || bodies_[i] == except) continue;
      if ((centre(i) - point).squaredNorm() <= limit * limit) return true;
    }
    return false;
  }
  bool isAnyInRuns(const Vector2& point, double distance, std::uint32_t except) const;
  void sortIntoCells();
  void layOut();
  void countCells();
  void place(const Disc& disc, std::size_t where);
  void setMotion(std::size_t where, const Disc& disc) {
    xs_[where] = disc.centre.x();
    ys_[where] = disc.centre.y();
    motions_[where] = {disc.centre.x(), disc.centre.y(), disc.velocity.x(), disc.velocity.y()};
  }
  std::int64_t column(double x) const { return cellOf(x - origin_.x(), columns_); }
  std::int64_t row(double y) const { return cellOf(y - origin_.y(), rows_); }
  std::int64_t cellOf(double offset, std::int64_t cells) const {
    // Truncation rounds towards 0; offsets before the first cell are clamped to it anyway.
    return static_cast<std::int64_t>(std::clamp(offset * cells_per_metre_, 0.0, static_cast<double>(cells - 1)));
  }

  std::vector<Disc> added_;           // in order of add()
  std::vector<std::uint32_t> cells_;  // cell of each added disc
  std::vector<std::uint32_t> first_;  // first_[c]: first disc of cell c
  // In the order of the cells.
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> radii_;
  std::vector<std::uint32_t> bodies_;
  std::vector<Motion> motions_;
  Vector2 origin_ = Vector2::Zero();
  double cell_size_ = 1.0;
  double cells_per_metre_ = 1.0;
  double max_radius_ = 0.0;
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace crowd
