#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rviz/panel_model.h"

/// Status messages and models for tests of the panel.
namespace crowd::panels {

using social_crowd::ControllerStatus;
using social_crowd::LearnerStatus;

inline constexpr const char* CONTROLLER = "/crowd_controller";
inline constexpr const char* MARKERS = "/crowd_markers";
inline constexpr double NOW = 0.0;  // of views without rates [s]

inline ControllerStatus walking() {
  ControllerStatus info;
  info.node = CONTROLLER;
  info.scenario = "circle6";
  info.agents = 6;
  info.real_time_factor = 1.0;
  return info;
}

inline ControllerStatus paused() {
  ControllerStatus info = walking();
  info.paused = 1;
  return info;
}

inline LearnerStatus learner(const std::string& node, std::vector<std::uint32_t> agents, bool own = false) {
  LearnerStatus info;
  info.node = node;
  info.mode = "demo";
  info.agents = std::move(agents);
  info.tables = own ? "own" : "shared";
  info.epsilon = 0.1;
  return info;
}

/// A panel whose controller and markers are there; its list of scenarios has been asked for.
inline PanelModel present() {
  PanelModel model(CONTROLLER, MARKERS);
  model.noteReachable(CONTROLLER, true);
  model.noteReachable(MARKERS, true);
  for (const PanelRequest& request : model.takeRequests()) model.noteDone(request, true, "");
  return model;
}

inline void addLearner(PanelModel& model, const LearnerStatus& info) {
  model.take(info);
  model.noteReachable(info.node, true);
}

inline std::vector<std::string> nodesOf(const std::vector<PanelRequest>& requests) {
  std::vector<std::string> nodes;
  for (const PanelRequest& request : requests) nodes.push_back(request.node);
  return nodes;
}

}  // namespace crowd::panels
