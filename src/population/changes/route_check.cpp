#include "population/changes/route_check.h"

#include <algorithm>
#include <utility>

#include "scenario/region_geometry.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

constexpr double GRID_STEP = 0.2;  // between the places of a region that are tried [m]

}  // namespace

RouteCheck::RouteCheck(std::string agent, double radius, const PopulationDescription& population,
                       const PlacePicker& places, WayLengths& ways, const World& world)
    : agent_(std::move(agent)),
      radius_(radius),
      population_(&population),
      places_(&places),
      ways_(&ways),
      world_(&world) {}

void RouteCheck::require(const RouteDescription& route, const Vector2& from) {
  from_ = from;
  for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
    requireWaypoint(route.waypoints[i], "routes." + route.name + ".waypoints[" + std::to_string(i) + "]");
  }
}

void RouteCheck::requireWaypoint(const WaypointDescription& waypoint, const std::string& field) {
  const auto is_reachable = [this](const SinkDescription& sink) { return reachablePlace(sink.area).has_value(); };
  const auto& sinks = population_->sinks;
  switch (waypoint.kind) {
    case Kind::PLACE:
      return requireRegion(waypoint.place, field);
    case Kind::QUEUE: {
      Region head;
      head.first = population_->queues[waypoint.target].head;
      return requireRegion(head, field);
    }
    case Kind::SINK:
      return requireRegion(sinks[waypoint.target].area, field);
    case Kind::NEAREST_SINK:
      if (std::any_of(sinks.begin(), sinks.end(), is_reachable)) return;
      throw InputError(agent_ + ", " + field + ": no sink can be reached from " + placeText(from_));
    case Kind::ONE_OF:
      break;
  }
  const Vector2 from = from_;
  for (std::size_t i = 0; i < waypoint.alternatives.size(); ++i) {
    from_ = from;
    requireWaypoint(waypoint.alternatives[i], field + ".one_of[" + std::to_string(i) + "]");
  }
}

void RouteCheck::requireRegion(const Region& region, const std::string& field) {
  if (region.kind == Region::Kind::FREE) return;
  if (region.isFixed()) {
    ways_->requireWay(agent_ + ", " + field, *world_, from_, region.first, radius_);
    from_ = region.first;
    return;
  }
  const std::optional<Vector2> place = reachablePlace(region);
  if (!place) {
    throw InputError(agent_ + ", " + field + ": no place of the region that it fits in can be reached from " +
                     placeText(from_));
  }
  from_ = *place;
}

std::optional<Vector2> RouteCheck::reachablePlace(const Region& region) {
  const std::vector<Vector2> grid = gridPoints(region, GRID_STEP);
  const auto found = std::find_if(grid.begin(), grid.end(), [&](const Vector2& place) {
    return (region.isFixed() || places_->fits(place, radius_, *world_)) &&
           ways_->problemOf(*world_, from_, place, radius_).empty();
  });
  return found == grid.end() ? std::nullopt : std::optional<Vector2>(*found);
}

}  // namespace crowd
