#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "social_crowd/evaluation.h"
#include "social_crowd/results.h"

/// Results as dicts by the names of their fields, so that new fields appear by themselves.
namespace crowd::python {

namespace py = pybind11;

/// @brief The fields that RobotResult.msg has, too, but the name.
inline py::dict toDict(const RobotResult& result) {
  py::dict fields;
  const auto put = [&](const char* name, const auto& value) { fields[name] = value; };
  RobotResult::visitMeasures(put, result);
  RobotInput::visitFields(put, result.input);
  py::list goals;
  for (const RobotGoalResult& goal : result.goals) {
    py::dict of_goal;
    RobotGoalResult::visitFields([&](const char* name, const auto& value) { of_goal[name] = value; }, goal);
    goals.append(of_goal);
  }
  fields["goals"] = goals;
  return fields;
}

/// @brief For each field an array with an element for each agent.
inline py::dict toDict(const std::vector<AgentResult>& agents) {
  py::dict lists;
  for (const AgentResult& agent : agents) {
    const auto put = [&](const char* name, const auto& value) {
      if (!lists.contains(name)) lists[name] = py::list();
      lists[name].cast<py::list>().append(value);
    };
    AgentResult::visitFields(put, agent);
  }
  py::dict arrays;
  for (const auto& [name, list] : lists) arrays[name] = py::array(list.cast<py::list>());
  return arrays;
}

/// @brief An episode without its agents: scenario, ticks, counts, and a dict for each robot with its name.
inline py::dict toDict(const library::EpisodeResult& result) {
  py::list robots;
  for (const RobotResult& robot : result.robots) {
    py::dict fields = toDict(robot);
    fields["name"] = robot.name;
    robots.append(fields);
  }
  py::dict fields;
  fields["scenario"] = result.scenario;
  fields["ticks"] = result.ticks;
  fields["agents"] = result.count.agents;
  fields["arrived"] = result.count.arrived;
  fields["expected"] = result.count.expected;
  fields["touched"] = result.count.touched;
  fields["collided"] = result.count.collided;
  fields["blocked_moves"] = result.count.blocked_moves;
  fields["robots"] = robots;
  fields["way_finding_problem"] = result.way_finding_problem;
  return fields;
}

inline py::dict toDict(const library::Means& means) {
  py::dict fields;
  fields["episodes"] = means.episodes;
  fields["success_percent"] = means.success_percent;
  fields["contact_percent"] = means.contact_percent;
  fields["collision_percent"] = means.collision_percent;
  fields["clean_percent"] = means.clean_percent;
  fields["path_ratio"] = means.path_ratio;
  fields["time_ratio"] = means.time_ratio;
  fields["turn_per_metre"] = means.turn_per_metre;
  fields["max_speed_ratio"] = means.max_speed_ratio;
  fields["blocked_moves"] = means.blocked_moves;
  return fields;
}

}  // namespace crowd::python
