#pragma once

#include <array>
#include <cstddef>

#include "avoidance/near_agents.h"
#include "geometry/geometry.h"
#include "simd/kernels.h"

namespace crowd {

/// @brief Gaps between the stopping region of an agent, what it covers if it brakes from now on, and up to MAX others.
///
/// Call contract: clear(), add() for each of the others, find(); then the gaps can be read by their numbers. An object
/// serves one decision on one thread.
class StoppingGaps {
 public:
  static constexpr std::size_t MAX = NEIGHBOURS_AT_ONCE;

  /// @param stop where the agent's centre stops, agent frame [m] @param radius of the agent [m]
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): find() writes what is read
  StoppingGaps(const Vector2& stop, double radius) : stop_(stop), radius_(radius) {}

  void clear() { count_ = 0; }
  /// @brief Adds the region that a disc of a radius covers on a way. @param way of its centre, agent frame [m]
  void add(const Segment& way, double radius) {
    from_xs_[count_] = way.from.x();
    from_ys_[count_] = way.from.y();
    to_xs_[count_] = way.to.x();
    to_ys_[count_] = way.to.y();
    radii_[count_++] = radius;
  }
  /// @brief Finds the gaps to all that were added.
  void find() {
    if (count_ == 0) return;
    const Segment last{{from_xs_[count_ - 1], from_ys_[count_ - 1]}, {to_xs_[count_ - 1], to_ys_[count_ - 1]}};
    const double last_radius = radii_[count_ - 1];
    while (count_ % simd::REGIONS_AT_ONCE != 0) add(last, last_radius);
    simd::kernels().find_gaps(stop_.x(), stop_.y(), radius_,
                              {from_xs_.data(), from_ys_.data(), to_xs_.data(), to_ys_.data(), radii_.data(), count_},
                              {normal_xs_.data(), normal_ys_.data(), widths_.data(), alongs_.data()});
  }

  /// @brief Whether the regions overlap, by more than rounding.
  bool overlaps(std::size_t number) const { return widths_[number] < -TOUCHING; }
  /// @brief Unit vector towards the other; 0 if the ways have a common point.
  Vector2 normal(std::size_t number) const { return {normal_xs_[number], normal_ys_[number]}; }
  /// @brief Width of a gap, negative if the regions overlap [m].
  double width(std::size_t number) const { return widths_[number]; }
  /// @brief Component along the normal of the point of the agent's way that is nearest to the other [m].
  double along(std::size_t number) const { return alongs_[number]; }

 private:
  static constexpr double TOUCHING = 1e-10;  // [m]
  static_assert(MAX % simd::REGIONS_AT_ONCE == 0, "room for the repeated last one");
  using Numbers = std::array<double, MAX>;

  Vector2 stop_;
  double radius_;
  std::size_t count_ = 0;
  // The first count_ are valid.
  alignas(64) Numbers from_xs_;
  alignas(64) Numbers from_ys_;
  alignas(64) Numbers to_xs_;
  alignas(64) Numbers to_ys_;
  alignas(64) Numbers radii_;
  alignas(64) Numbers normal_xs_;
  alignas(64) Numbers normal_ys_;
  alignas(64) Numbers widths_;
  alignas(64) Numbers alongs_;
};

}  // namespace crowd
