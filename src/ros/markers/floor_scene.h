#pragma once

#include <string>

#include "scenario/scene.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief The scene that begins with what is on the floor now: agents on their way with the goals that are left,
/// obstacles, walls and robots at their present places. Agents that have arrived and stay are obstacles in it, because
/// an agent cannot start at its last goal. Agents that the scenario gave a route begin it again; agents of
/// sources keep their present goal. Gates, sources, sinks and queues are those of the scenario.
/// @param with_map_file whether the map of the scenario is in use; its walls are then left to its file, unless one of
/// them was removed
Scene sceneOnFloor(const Episode& episode, bool with_map_file);

/// @brief "3 agents, 1 obstacle, 2 walls, 1 robot".
std::string countsText(const Scene& scene);

}  // namespace crowd
