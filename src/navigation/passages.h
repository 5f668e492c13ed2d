#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "maps/clearance_grid.h"

namespace crowd {

/// @brief One end of a passage.
struct Mouth {
  Vector2 centre = Vector2::Zero();    ///< [m], `map`
  Vector2 outward = Vector2::UnitX();  ///< unit vector out of the passage
};

/// @brief A part of the floor that is too narrow for two agents to pass each other: a door, a gap, a narrow corridor.
struct Passage {
  std::vector<Mouth> mouths;  ///< two, or more where narrow corridors meet
  double width = 0.0;         ///< of its narrowest point [m]
};

/// @brief The passages of a floor. A throat is a point whose clearance is below half of `max_width`, falls towards two
/// sides, and does not fall in the two directions between them. The discs around the throats, as large as their
/// clearance, form the passages: each connected component from which two or more wide places can be reached.
///
/// Immutable: any number of threads may use it at the same time.
class Passages {
 public:
  static constexpr std::uint16_t NONE = 0xFFFF;
  /// @brief Distance between grid points [m].
  static constexpr double SPACING = 0.05;

  /// @param radius radius of the agents [m] @param max_width passages are narrower than this [m]
  /// @throws Stopped if `stop` is made
  Passages(const FloorPlan& floor, double radius, double max_width, const StopRequest& stop = {});

  std::size_t size() const { return passages_.size(); }
  const Passage& operator[](std::size_t passage) const { return passages_[passage]; }
  /// @brief Memory that it occupies, without that of the mouths [bytes].
  std::size_t bytes() const {
    return clearance_.bytes() + labels_.capacity() * sizeof(std::uint16_t) + steps_.capacity();
  }
  /// @brief Whether the centre of a disc can be at a place [m], `map`, to within the grid's spacing; beyond the grid
  /// there is nothing in the way.
  bool fits(const Vector2& place, double radius) const {
    const ClearanceGrid::Index point = clearance_.nearest(place);
    return point == ClearanceGrid::OUTSIDE || clearance_[point] >= radius + SPACING;
  }
  /// @brief The passage at a place [m], `map`; NONE if there is none.
  std::uint16_t at(const Vector2& place) const {
    const ClearanceGrid::Index point = clearance_.nearest(place);
    return point == ClearanceGrid::OUTSIDE ? NONE : labels_[point];
  }
  /// @brief A lower bound of the distance from a place to the nearest passage [m]; 0 if it is not known.
  double distanceFrom(const Vector2& place) const {
    const Vector2 offset = (place - block_origin_) / block_side_;
    const bool inside =
        offset.x() >= 0.0 && offset.y() >= 0.0 && offset.x() < block_columns_ && offset.y() < block_rows_;
    if (!inside) return 0.0;
    const Index block = static_cast<Index>(offset.y()) * block_columns_ + static_cast<Index>(offset.x());
    return std::max(0, steps_[block] - 1) * block_side_;
  }

 private:
  using Index = ClearanceGrid::Index;
  enum class Width : std::uint8_t { BLOCKED, NARROW, WIDE };
  /// Distances are stored for blocks of BLOCK x BLOCK grid points, so that they fit into the processor's cache.
  static constexpr Index BLOCK = 4;

  std::vector<Width> classify(double radius, double max_width, const StopRequest& stop) const;
  bool isThroat(Index point) const;
  void measureSteps();
  void addPassage(const std::vector<Index>& narrow, const std::vector<Width>& widths);
  double widthBetween(const std::vector<std::vector<Index>>& mouths, std::vector<Index> narrow) const;
  Mouth mouthAt(const std::vector<Index>& rim, const std::vector<Index>& narrow) const;

  ClearanceGrid clearance_;
  std::vector<std::uint16_t> labels_;  // by grid point
  Vector2 block_origin_ = Vector2::Zero();
  double block_side_ = 1.0;  // [m]
  Index block_columns_ = 0;
  Index block_rows_ = 0;
  std::vector<std::uint8_t> steps_;  // to the nearest block with a passage, also diagonal ones, at most 255; by block
  std::vector<Passage> passages_;
};

}  // namespace crowd
