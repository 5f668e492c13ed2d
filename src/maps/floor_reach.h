#pragma once

#include <cstdint>

#include "maps/grid_components.h"

namespace crowd {

/// @brief Tells between which places of a floor agents can walk, on a grid: for drawing places, where a mesh would be
/// more than is needed. Immutable: any number of threads may use it at the same time.
class FloorReach {
 public:
  static constexpr double SPACING = 0.05;  ///< of the grid [m]
  /// @brief Free room around the body of an agent, with which gaps are as wide as for way-finding: TIGHT_MARGIN of the
  /// mesh, and half a cell [m].
  static constexpr double ROOM = 0.045;

  /// @brief Grid points of a floor. With ClearanceGrid::MAX_POINTS or more, about 40,000 m2, it is too large.
  static double pointsOf(const FloorPlan& floor);

  /// @param floor with at least one wall or obstacle, small @param radius of the agents [m]
  /// @throws Stopped if `stop` is made
  FloorReach(const FloorPlan& floor, double radius, const StopRequest& stop = {});

  /// @brief Whether two places are connected [m]. A place in a gap that is too narrow is connected with all others.
  bool connects(const Vector2& from, const Vector2& to) const;

 private:
  std::uint32_t component(const Vector2& place) const;

  double search_distance_;  // for a place where an agent fits [m]
  ClearanceGrid grid_;
  GridComponents components_;
};

}  // namespace crowd
