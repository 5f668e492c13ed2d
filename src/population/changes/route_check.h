#pragma once

#include <string>

#include "navigation/way_lengths.h"
#include "population/place_picker.h"
#include "scenario/population_spec.h"

namespace crowd {

/// @brief Checks that an agent can walk a route, from each waypoint to the next one.
///
/// Points count as goals do (WayLengths::requireWay()), a queue by its head. A region counts if there is any place in
/// it where the agent fits and that it can reach, {map: free} always. All alternatives of a ONE_OF must be in reach, of
/// the sinks of a NEAREST_SINK only one.
class RouteCheck {
 public:
  /// @param agent its text in messages, such as "agent 3" @param radius of the agent [m]
  RouteCheck(std::string agent, double radius, const PopulationDescription& population, const PlacePicker& places,
             WayLengths& ways, const World& world);

  /// @brief Does nothing if the agent can walk the route. @param from where it is [m]
  /// @throws InputError that names the waypoint that is in a wall or obstacle, or that it cannot reach
  void require(const RouteDescription& route, const Vector2& from);

 private:
  void requireWaypoint(const WaypointDescription& waypoint, const std::string& field);
  void requireRegion(const Region& region, const std::string& field);
  /// A place of the region that the agent can reach, or none.
  std::optional<Vector2> reachablePlace(const Region& region);

  std::string agent_;
  double radius_;
  const PopulationDescription* population_;
  const PlacePicker* places_;
  WayLengths* ways_;
  const World* world_;
  Vector2 from_ = Vector2::Zero();  // the last waypoint at a known place
};

}  // namespace crowd
