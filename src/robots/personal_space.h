#pragma once

#include "geometry/geometry.h"

namespace crowd {

/// @brief Shape of the costs around people; the ideas are those of the proxemic layer of Lu, Hershberger and Smart,
/// *Layered costmaps for context-sensitive navigation* (IROS 2014).
struct PersonalSpaceSpec {
  double amplitude = 200.0;  ///< cost at the place of a person; above 0
  double cutoff = 10.0;      ///< lower costs are 0; above 0
  double spread = 0.4;       ///< standard deviation across the motion and behind the person [m]; above 0
  double stretch = 0.5;      ///< in front of the person it is (1 + stretch * speed) times as large [s/m]; at least 0
  double horizon = 0.5;      ///< the cost at the person's place holds along the way of this time [s]; at least 0

  bool operator==(const PersonalSpaceSpec& other) const;
  bool operator!=(const PersonalSpaceSpec& other) const { return !(*this == other); }
};

/// @brief An axis-aligned rectangle [m].
struct Bounds {
  Vector2 low;
  Vector2 high;
};

/// @brief Cost of the places around one person: Gaussian in the distance from the way that the person walks within the
/// horizon, in ellipses that are longer in front of it.
class PersonalSpace {
 public:
  /// @param place [m] @param velocity [m/s]; at rest the space is circular
  PersonalSpace(const PersonalSpaceSpec& spec, const Vector2& place, const Vector2& velocity);

  /// @brief Cost at a point: from `cutoff` to `amplitude`, or 0.
  double costAt(const Vector2& point) const;
  /// @brief A rectangle outside which the cost is 0; empty (low above high) if it is 0 everywhere.
  Bounds bounds() const;

 private:
  PersonalSpaceSpec spec_;
  Vector2 place_;
  Rotation frame_;
  double way_;           // length of the way within the horizon [m]
  double spread_ahead_;  // [m]
  double reach_;         // distance at which the cost falls below the cutoff, in standard deviations; negative: nowhere
};

}  // namespace crowd
