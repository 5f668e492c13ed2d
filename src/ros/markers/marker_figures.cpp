#include "ros/markers/marker_figures.h"

#include <array>
#include <string>

#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_style.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

using marker_style::FigurePart;
using social_crowd::AgentState;
using social_crowd::AgentStates;
using visualization_msgs::Marker;

constexpr std::array<const char*, 2> BUILDS = {"broad", "slim"};
constexpr std::array<const char*, marker_style::FIGURE_PARTS> PARTS = {"head", "shirt", "dark"};
constexpr double BODY_RADIUS = 0.25;  // of a person of the meshes' width [m]

Marker markerOf(std::uint32_t agent, std::size_t part, WalkingFigures::Of people) {
  Marker marker;
  marker.header.frame_id = names::MAP_FRAME;
  marker.ns = people == WalkingFigures::Of::AGENTS ? marker_style::FIGURES : marker_style::RECORDED_FIGURES;
  marker.id = static_cast<int>(agent * PARTS.size() + part);
  return marker;
}

std::string meshOf(std::uint32_t agent, std::size_t part, int frame) {
  std::string mesh = std::string("package://social_crowd/meshes/") + BUILDS[agent % BUILDS.size()] + '_' + PARTS[part];
  if (static_cast<FigurePart>(part) != FigurePart::HEAD) mesh += '_' + std::to_string(frame);
  return mesh + ".stl";
}

Marker drawPart(const AgentState& agent, std::size_t part, int frame, WalkingFigures::Of people) {
  Marker marker = markerOf(agent.agent, part, people);
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = meshOf(agent.agent, part, frame);
  marker.pose.position = toPoint({agent.pose.x, agent.pose.y});
  marker.pose.orientation = toQuaternion(agent.pose.theta);
  marker.scale.x = marker.scale.y = agent.radius / BODY_RADIUS;
  marker.scale.z = marker_style::figureHeight(agent.agent);
  const bool is_dressed = people == WalkingFigures::Of::AGENTS || static_cast<FigurePart>(part) == FigurePart::HEAD;
  marker.color =
      is_dressed ? marker_style::ofFigure(static_cast<FigurePart>(part), agent.agent) : marker_style::ofRecorded();
  return marker;
}

}  // namespace

void WalkingFigures::take(const AgentStates& states) {
  for (const AgentState& agent : states.agents) {
    if (isOnFloor(agent)) cycles_.walk(agent.agent, {{agent.pose.x, agent.pose.y}, agent.pose.theta});
  }
  if (cycles_.size() <= states.agents.size()) return;
  std::set<std::uint32_t> present;
  for (const AgentState& agent : states.agents) present.insert(agent.agent);
  cycles_.keepOnly(present);
}

void WalkingFigures::draw(const AgentStates& states, bool shown, bool whole, visualization_msgs::MarkerArray& array) {
  leaving_.merge(shown_);
  shown_.clear();
  for (const AgentState& agent : states.agents) {
    if (!shown || !isOnFloor(agent)) continue;
    leaving_.erase(agent.agent);
    shown_.insert(agent.agent);
    const int frame = cycles_.frameOf(agent.agent);
    for (std::size_t part = 0; part < PARTS.size(); ++part)
      array.markers.push_back(drawPart(agent, part, frame, people_));
  }
  for (const std::uint32_t agent : leaving_) {
    for (std::size_t part = 0; part < PARTS.size(); ++part) {
      array.markers.push_back(markerOf(agent, part, people_));
      array.markers.back().action = Marker::DELETE;
    }
  }
  if (whole) leaving_.clear();
}

}  // namespace crowd
