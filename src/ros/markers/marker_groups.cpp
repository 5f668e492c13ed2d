#include "ros/markers/marker_groups.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/geometry.h"
#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_shapes.h"
#include "ros/markers/marker_style.h"

namespace crowd {
namespace {

/// Joins all places by the shortest lines (Prim's algorithm). Changes the order of the places.
void joinPlaces(std::vector<Vector2>& places, const marker_style::Colour& colour, LineMarker& marker) {
  for (std::size_t joined = 1; joined < places.size(); ++joined) {
    std::size_t from = 0;
    std::size_t to = joined;
    const auto length = [&](std::size_t a, std::size_t b) { return (places[a] - places[b]).squaredNorm(); };
    for (std::size_t a = 0; a < joined; ++a) {
      for (std::size_t b = joined; b < places.size(); ++b) {
        if (length(a, b) < length(from, to)) std::tie(from, to) = std::pair(a, b);
      }
    }
    marker.addLine(places[from], places[to], colour);
    std::swap(places[joined], places[to]);
  }
}

}  // namespace

visualization_msgs::Marker drawGroups(const social_crowd::AgentStates& states) {
  std::map<std::uint32_t, std::vector<Vector2>> places;  // by group
  for (const social_crowd::AgentState& agent : states.agents) {
    if (agent.group != 0 && isOnFloor(agent)) places[agent.group].emplace_back(agent.pose.x, agent.pose.y);
  }
  LineMarker marker(marker_style::GROUPS, 0, marker_style::Layer::GROUPS, marker_style::GROUP_WIDTH);
  for (auto& [group, members] : places) joinPlaces(members, marker_style::ofGroup(), marker);
  return marker.finish();
}

}  // namespace crowd
