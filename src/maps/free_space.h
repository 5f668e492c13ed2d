#pragma once

#include <cstdint>
#include <vector>

#include "common/random.h"
#include "maps/grid_components.h"
#include "maps/occupancy_map.h"

namespace crowd {

/// @brief The places of a map where an agent fits, and which of them are connected. Immutable.
class FreeSpace {
 public:
  /// @brief Component of places where the agent does not fit.
  static constexpr std::uint32_t NONE = GridComponents::NONE;

  /// @brief Free room around the body of an agent [m]: ways through narrower gaps may not be found.
  static constexpr double ROOM = 0.1;

  /// @brief Places are not drawn from components that are smaller than this share of the largest one: in maps made by
  /// robots there are pockets behind walls and in furniture.
  static constexpr double POCKET_SHARE = 0.01;

  /// @param map valid @param floor all walls, including those of the map, and obstacles at rest
  /// @param radius of the agent [m] @throws Stopped if `stop` is made
  FreeSpace(const OccupancyMap& map, const FloorPlan& floor, double radius, const StopRequest& stop = {});

  bool empty() const { return points_.empty(); }
  /// @brief Draws a place [m], `map`, uniformly from all components but pockets; empty() must not hold.
  Vector2 draw(KeyedRandom& random) const;
  /// @brief Number of the connected component that a place [m] is in, to within the spacing of the grid; or NONE.
  std::uint32_t component(const Vector2& place) const {
    const ClearanceGrid::Index point = clearance_.nearest(place);
    return point == ClearanceGrid::OUTSIDE ? NONE : components_[point];
  }

 private:
  ClearanceGrid clearance_;
  std::vector<std::uint32_t> components_;     // by grid point
  std::vector<ClearanceGrid::Index> points_;  // where the agent fits
};

}  // namespace crowd
