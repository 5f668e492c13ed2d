#pragma once

#include <string>

#include "scenario/scene.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief The scene that begins with what is on the floor now: agents on their way with the goals that are left,
/// obstacles, walls and robots at their present places. Agents that have arrived and stay are left out: an agent cannot
/// start at its last goal, and in place of it an obstacle could cover the goals of others. Agents that the scenario
/// gave a route begin it again; agents of sources keep their present goal. Gates, sources, sinks and queues are those
/// of the scenario.
/// @param with_map_file whether the map of the scenario is in use; its walls are then left to its file, unless one of
/// them was removed
Scene sceneOnFloor(const Episode& episode, bool with_map_file);

/// @brief ", without 2 agents at the last goal": those that stay, which a scene on the floor does not have; empty if
/// there are none.
std::string leftOutText(const World& world);

/// @brief "3 agents, 1 obstacle, 2 walls, 1 robot".
std::string countsText(const Scene& scene);

}  // namespace crowd
