#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scenario/scene.h"
#include "simulation/agent_mind.h"
#include "world/world.h"

/// What pages show of a world, as new arrays and dicts.
namespace crowd::python {

namespace py = pybind11;

inline py::array_t<std::uint64_t> idsOf(const Walls& walls) {
  const std::vector<std::uint64_t> ids(walls.ids().begin(), walls.ids().end());
  return py::array_t<std::uint64_t>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

/// @brief number, x, y, radius [m] of each obstacle that is there, `map`.
inline py::array_t<double> obstaclesOf(const World& world) {
  std::vector<double> rows;
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const Obstacle& obstacle = world.obstacles()[i];
    if (!world.isPresent(obstacle)) continue;
    const Vector2 place = obstacle.path.position(world.time());
    rows.insert(rows.end(), {static_cast<double>(i), place.x(), place.y(), obstacle.radius});
  }
  return py::array_t<double>({static_cast<py::ssize_t>(rows.size() / 4), py::ssize_t{4}}, rows.data());
}

/// @brief The map of a scene as nav_msgs/OccupancyGrid has it, or None.
inline py::object mapOf(const Scene& scene) {
  if (scene.map == nullptr) return py::none();
  const OccupancyMap& map = *scene.map;
  py::array_t<std::uint8_t> cells(static_cast<py::ssize_t>(map.cells.size()));
  std::uint8_t* to = cells.mutable_data();
  for (const CellState cell : map.cells) {
    *to++ = cell == CellState::FREE ? 0 : cell == CellState::OCCUPIED ? 100 : 255;
  }
  py::dict fields;
  fields["width"] = map.width;
  fields["height"] = map.height;
  fields["resolution"] = map.resolution;
  fields["origin"] = py::make_tuple(map.origin.position.x(), map.origin.position.y(), map.origin.heading);
  fields["cells"] = cells;
  return fields;
}

/// @brief Number of agents that have arrived so far.
inline std::size_t arrivedIn(const World& world) {
  std::size_t arrived = world.departed().arrived;
  for (const Agent& agent : world.agents()) arrived += agent.hasArrived() ? 1 : 0;
  return arrived;
}

inline py::dict toDict(const AgentMind& mind) {
  py::list actions;
  for (const ValuedMove& valued : mind.values.moves) {
    py::dict action;
    action["direction"] = bearingOf(valued.move.direction);
    action["speed"] = valued.move.wanted * mind.max_speed;
    action["value"] = valued.value;
    action["visits"] = valued.visits;
    actions.append(action);
  }
  py::list neighbours;
  for (const AgentId neighbour : mind.neighbours) neighbours.append(neighbour);
  py::dict fields;
  fields["actions"] = actions;
  fields["chosen"] = mind.values.chosen;
  fields["neighbours"] = neighbours;
  return fields;
}

}  // namespace crowd::python
