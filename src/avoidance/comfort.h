#pragma once

#include <cstddef>

#include "avoidance/candidate_move.h"
#include "world/perception.h"

namespace crowd {

/// @brief The distance that an agent keeps from a robot now [m]: the robot's comfort, but at most a share of the room
/// between the agent and walls or obstacles on its side that is away from the robot.
double keptComfort(const Perception& seen, const Neighbour& robot);

/// @brief Limits how fast moves lead nearer to robots. An agent comes to 0.6 of keptComfort() at most, and within it
/// at a part of its maximum speed, the less the nearer it is: enough to walk round the robot. An agent with mass also
/// brakes in time. Standing, and moves that do not lead nearer, are not limited, so that the separation rule holds as
/// before.
void cutToComfort(const Perception& seen, MoveBlock* moves, std::size_t count);

}  // namespace crowd
