#include "ros/markers/marker_figures.h"

#include <array>
#include <string>

#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_style.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "scenario/figure.h"

namespace crowd {
namespace {

using marker_style::FigurePart;
using social_crowd::AgentState;
using social_crowd::AgentStates;
using visualization_msgs::Marker;

constexpr std::array<const char*, 2> BUILDS = {"broad", "slim"};
constexpr std::array<const char*, 3> BODY_PARTS = {"head", "shirt", "dark"};
// By Figure: the mesh of the belongings, and the radius of a body of the meshes' width [m].
constexpr std::array<const char*, 5> BELONGINGS = {"", "", "stick", "wheelchair", "trolley"};
constexpr std::array<double, 5> BODY_RADII = {0.25, 0.25, 0.25, 0.4, 0.35};

Marker markerOf(std::uint32_t agent, std::size_t part, WalkingFigures::Of people) {
  const bool is_body = part < BODY_PARTS.size();
  const char* const figures =
      people == WalkingFigures::Of::AGENTS ? marker_style::FIGURES : marker_style::RECORDED_FIGURES;
  Marker marker;
  marker.header.frame_id = names::MAP_FRAME;
  marker.ns = is_body ? figures : marker_style::BELONGINGS;
  marker.id = static_cast<int>(is_body ? agent * BODY_PARTS.size() + part : agent);
  return marker;
}

/// A figure that this program does not know is an adult.
Figure figureOf(const AgentState& agent) {
  return agent.figure < BODY_RADII.size() ? static_cast<Figure>(agent.figure) : Figure::ADULT;
}

/// The name of a mesh; empty if the figure has no such part.
std::string meshOf(const AgentState& agent, std::size_t part, int frame) {
  const Figure figure = figureOf(agent);
  if (part >= BODY_PARTS.size()) return BELONGINGS[static_cast<std::size_t>(figure)];
  if (figure == Figure::WHEELCHAIR) return std::string("sitting_") + BODY_PARTS[part];
  const std::string mesh = std::string(BUILDS[agent.agent % BUILDS.size()]) + "_" + BODY_PARTS[part];
  return static_cast<FigurePart>(part) == FigurePart::HEAD ? mesh : mesh + "_" + std::to_string(frame);
}

Marker drawPart(const AgentState& agent, std::size_t part, const std::string& mesh, WalkingFigures::Of people) {
  const Figure figure = figureOf(agent);
  Marker marker = markerOf(agent.agent, part, people);
  marker.type = Marker::MESH_RESOURCE;
  marker.mesh_resource = "package://social_crowd/meshes/" + mesh + ".stl";
  marker.pose.position = toPoint({agent.pose.x, agent.pose.y});
  marker.pose.orientation = toQuaternion(agent.pose.theta);
  marker.scale.x = marker.scale.y = agent.radius / BODY_RADII[static_cast<std::size_t>(figure)];
  marker.scale.z = marker_style::figureHeight(figure, agent.agent);
  const bool is_dressed = people == WalkingFigures::Of::AGENTS || static_cast<FigurePart>(part) == FigurePart::HEAD;
  marker.color = is_dressed ? marker_style::ofFigure(static_cast<FigurePart>(part), figure, agent.agent)
                            : marker_style::ofRecorded();
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
    const int frame = cycles_.frameOf(agent.agent);
    for (std::size_t part = 0; part < marker_style::FIGURE_PARTS; ++part) {
      const std::string mesh = meshOf(agent, part, frame);
      if (mesh.empty()) continue;
      leaving_.erase({agent.agent, part});
      shown_.insert({agent.agent, part});
      array.markers.push_back(drawPart(agent, part, mesh, people_));
    }
  }
  for (const auto& [agent, part] : leaving_) {
    array.markers.push_back(markerOf(agent, part, people_));
    array.markers.back().action = Marker::DELETE;
  }
  if (whole) leaving_.clear();
}

}  // namespace crowd
