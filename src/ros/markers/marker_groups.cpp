#include "ros/markers/marker_groups.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "geometry/geometry.h"
#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_shapes.h"
#include "ros/markers/marker_style.h"

namespace crowd {
namespace {

/// Joins all places by the shortest lines (Prim's algorithm).
void joinPlaces(const std::vector<Vector2>& places, const marker_style::Colour& colour, LineMarker& marker) {
  std::vector<std::size_t> nearest(places.size(), 0);  // of the joined places, to each open one
  std::vector<std::size_t> open(places.size() - 1);
  std::iota(open.begin(), open.end(), std::size_t{1});
  const auto distance = [&](std::size_t place, std::size_t other) {
    return (places[place] - places[other]).squaredNorm();
  };
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end(), [&](std::size_t a, std::size_t b) {
      return distance(a, nearest[a]) < distance(b, nearest[b]);
    });
    const std::size_t joined = *next;
    open.erase(next);
    marker.addLine(places[nearest[joined]], places[joined], colour);
    for (const std::size_t place : open) {
      if (distance(place, joined) < distance(place, nearest[place])) nearest[place] = joined;
    }
  }
}

}  // namespace

visualization_msgs::Marker drawGroups(const social_crowd::AgentStates& states) {
  std::map<std::uint32_t, std::vector<Vector2>> places;  // by group
  for (const social_crowd::AgentState& agent : states.agents) {
    if (agent.group != 0 && isOnFloor(agent)) places[agent.group].emplace_back(agent.pose.x, agent.pose.y);
  }
  LineMarker marker(marker_style::GROUPS, 0, marker_style::Layer::GROUPS, marker_style::GROUP_WIDTH);
  for (const auto& [group, members] : places) joinPlaces(members, marker_style::ofGroup(), marker);
  return marker.finish();
}

}  // namespace crowd
