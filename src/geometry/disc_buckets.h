#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Discs that are added one after the other, and searched in between. Few are a list; many are sorted into
/// square cells, so that placing a million bodies takes seconds.
class DiscBuckets {
 public:
  struct Disc {
    Vector2 centre;  ///< [m]
    double radius;   ///< [m]
  };

  /// @brief Adds a disc; discs have the numbers 0, 1, 2 ...
  void add(const Vector2& centre, double radius);
  const Disc& operator[](std::size_t number) const { return discs_[number]; }
  std::size_t size() const { return discs_.size(); }

  /// @brief Whether matches(number) holds for any disc that may be within `distance` of a point [m], and perhaps for
  /// others that are asked, too.
  template <typename Matches>
  bool isAnyNear(const Vector2& point, double distance, const Matches& matches) const {
    return findFirst(point, distance, matches) != NONE;
  }

  /// @brief The lowest number of a disc for which matches(number) holds, among those whose rim may be within `distance`
  /// of a point [m]; or NONE.
  template <typename Matches>
  std::size_t findFirst(const Vector2& point, double distance, const Matches& matches) const {
    const double reach = std::max(0.0, distance) + LARGE + ROUNDING;
    const std::int64_t left = cellOf(point.x() - reach);
    const std::int64_t right = cellOf(point.x() + reach);
    const std::int64_t bottom = cellOf(point.y() - reach);
    const std::int64_t top = cellOf(point.y() + reach);
    if (cells_.empty() || static_cast<double>(right - left) * static_cast<double>(top - bottom) > MOST_CELLS) {
      return firstOf(all(), matches);
    }
    std::size_t first = firstOf(large_, matches);
    for (std::int64_t x = left; x <= right; ++x) {
      for (std::int64_t y = bottom; y <= top; ++y) {
        const auto cell = cells_.find(keyOf(x, y));
        if (cell != cells_.end()) first = std::min(first, firstOf(cell->second, matches));
      }
    }
    return first;
  }
  static constexpr std::size_t NONE = SIZE_MAX;

 private:
  using Numbers = std::vector<std::uint32_t>;  // ascending
  static constexpr std::size_t FEW = 64;       // up to this number of discs there are no cells
  static constexpr double CELL_SIZE = 2.0;     // [m]
  static constexpr double LARGE = 1.0;         // larger discs are not in the cells [m]
  static constexpr double ROUNDING = 1e-6;     // [m]
  static constexpr double FARTHEST = 1e9;      // number of the last cell in each direction, which has all beyond it
  static constexpr double MOST_CELLS = 1e4;    // of a search; larger ones look at all discs

  /// The numbers 0 .. size() - 1.
  struct All {
    std::uint32_t count;
  };
  All all() const { return {static_cast<std::uint32_t>(discs_.size())}; }

  template <typename Matches>
  static std::size_t firstOf(const Numbers& numbers, const Matches& matches) {
    const auto found = std::find_if(numbers.begin(), numbers.end(), matches);
    return found == numbers.end() ? NONE : *found;
  }
  template <typename Matches>
  static std::size_t firstOf(All all, const Matches& matches) {
    std::uint32_t number = 0;
    while (number < all.count && !matches(number)) ++number;
    return number < all.count ? number : NONE;
  }
  static std::int64_t cellOf(double coordinate) {
    return static_cast<std::int64_t>(std::clamp(std::floor(coordinate / CELL_SIZE), -FARTHEST, FARTHEST));
  }
  static std::uint64_t keyOf(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x) << 32U) ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFFU);
  }
  void sortIn(std::uint32_t number);

  std::vector<Disc> discs_;
  std::unordered_map<std::uint64_t, Numbers> cells_;
  Numbers large_;
};

inline void DiscBuckets::add(const Vector2& centre, double radius) {
  discs_.push_back({centre, radius});
  if (discs_.size() <= FEW) return;
  for (auto number = static_cast<std::uint32_t>(discs_.size() == FEW + 1 ? 0 : discs_.size() - 1);
       number < discs_.size(); ++number) {
    sortIn(number);
  }
}

inline void DiscBuckets::sortIn(std::uint32_t number) {
  const Disc& disc = discs_[number];
  Numbers& numbers = disc.radius > LARGE ? large_ : cells_[keyOf(cellOf(disc.centre.x()), cellOf(disc.centre.y()))];
  numbers.push_back(number);
}

}  // namespace crowd
