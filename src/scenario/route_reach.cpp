#include "scenario/route_reach.h"

#include <algorithm>

#include "scenario/region_geometry.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

class Reach {
 public:
  Reach(const FreeSpace& free_space, const PopulationDescription& population, const Vector2& from)
      : free_space_(free_space), population_(population), home_(free_space.component(from)) {}

  bool includes(const WaypointDescription& waypoint) const {
    const auto includes_it = [this](const WaypointDescription& other) { return includes(other); };
    const auto includes_sink = [this](const SinkDescription& sink) { return includes(sink.area); };
    switch (waypoint.kind) {
      case Kind::PLACE:
        return includes(waypoint.place);
      case Kind::QUEUE:
        return includes(population_.queues[waypoint.target].head);
      case Kind::SINK:
        return includes(population_.sinks[waypoint.target].area);
      case Kind::NEAREST_SINK:
        return std::any_of(population_.sinks.begin(), population_.sinks.end(), includes_sink);
      case Kind::ONE_OF:
        break;
    }
    return std::all_of(waypoint.alternatives.begin(), waypoint.alternatives.end(), includes_it);
  }

 private:
  bool includes(const Vector2& place) const {
    const std::uint32_t component = free_space_.component(place);
    return component == FreeSpace::NONE || component == home_;
  }
  bool includes(const Region& region) const {
    if (region.kind == Region::Kind::FREE) return true;
    return includes(middleOf(region));
  }

  const FreeSpace& free_space_;
  const PopulationDescription& population_;
  std::uint32_t home_;
};

}  // namespace

bool connectsRoute(const FreeSpace& free_space, const PopulationDescription& population, std::size_t route,
                   const Vector2& from) {
  const Reach reach(free_space, population, from);
  const auto& waypoints = population.routes[route].waypoints;
  return std::all_of(waypoints.begin(), waypoints.end(),
                     [&](const WaypointDescription& waypoint) { return reach.includes(waypoint); });
}

}  // namespace crowd
