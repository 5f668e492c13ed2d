#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "common/agent_id.h"
#include "common/span.h"
#include "geometry/geometry.h"
#include "geometry/motion_limits.h"
#include "world/neighbours.h"

namespace crowd {

/// @brief Range and limits of an agent's perception.
struct Vision {
  double radius = 6.0;               ///< maximum distance from the agent's centre to the rim of a neighbour [m]
  std::uint32_t max_neighbours = 0;  ///< only the nearest of the visible neighbours are perceived; 0: no limit
  bool occlusion = false;            ///< nearer neighbours and walls hide others (see Occlusion)
  /// Maximum distance from the agent's rim to a wall, as far as that is within `radius` of its centre [m].
  double wall_distance = std::numeric_limits<double>::infinity();
  /// Of the agents, unless the scene has its own: each must know those of the others. Nothing if no model has said it.
  std::optional<MotionLimits> motion = std::nullopt;

  /// @brief Maximum distance from an agent's centre to a wall [m]. Walls that it could touch count, too.
  /// @param body_radius of the agent [m] @param reach the longest way until it stands again [m]
  double wallReach(double body_radius, double reach) const {
    return std::min(radius, body_radius + std::max(wall_distance, reach));
  }

  /// @brief Number of neighbours, nearest rim first, that are within these limits.
  template <typename Neighbours>
  std::size_t countOf(const Neighbours& neighbours) const {
    std::size_t count = neighbours.size();
    if (max_neighbours > 0) count = std::min<std::size_t>(max_neighbours, count);
    while (count > 0 && rimDistance(neighbours[count - 1]) > radius) --count;
    return count;
  }
};

/// @brief State of the perceiving agent at a tick.
struct AgentPerception {
  AgentId agent = 0;
  Pose pose;                           ///< in `map`
  Vector2 velocity = Vector2::Zero();  ///< of the last tick, agent frame [m/s]
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< of the body [m]
  Vector2 goal = Vector2::Zero();      ///< position of the goal, agent frame [m]
  std::uint32_t goal_number = 0;       ///< changes when the goal changes
  bool arrived = false;                ///< reached its last goal in the last tick: this is its last perception
  bool acted = false;                  ///< its action for the last tick was executed
  bool held = false;                   ///< it stands, or brakes, whatever its action
  std::uint32_t first_neighbour = 0;   ///< index of its first neighbour in `neighbours`
  std::uint32_t neighbour_count = 0;
  std::uint32_t first_wall = 0;  ///< its walls are walls[first_wall .. first_wall + wall_count)
  std::uint32_t wall_count = 0;
};

/// @brief Perceptions of all agents at the start of a tick. One list holds the neighbours of all agents and one the
/// walls, not in the order of the agents and possibly with gaps, so that a tick allocates no memory once the vectors
/// have grown.
struct Perceptions {
  std::uint64_t episode = 0;
  std::uint64_t tick = 0;
  std::uint32_t turn = 0;      ///< within the tick: the agent whose turn it is (Order::SEQUENTIAL), else 0
  double tick_duration = 0.0;  ///< [s]
  MotionLimits motion;         ///< of all agents
  bool last = false;           ///< the episode is over: no answers are expected
  std::vector<AgentPerception> agents;
  NeighbourList neighbours;    ///< of each agent, nearest rim first
  std::vector<Segment> walls;  ///< in the frame of the agent they belong to
};

/// @brief Perception of one agent at a tick: a view into Perceptions, valid as long as these are unchanged.
struct Perception {
  const AgentPerception& self;
  NeighbourSpan neighbours;
  Span<Segment> walls;
  std::uint64_t episode;  ///< its number
  double time;            ///< since the start of the episode [s]
  double tick_duration;   ///< [s]
  const MotionLimits& motion;

  Perception(const Perceptions& all, std::size_t index)
      : self(all.agents[index]),
        neighbours(all.neighbours, self.first_neighbour, self.neighbour_count),
        walls(all.walls.data() + self.first_wall, self.wall_count),
        episode(all.episode),
        time(static_cast<double>(all.tick) * all.tick_duration),
        tick_duration(all.tick_duration),
        motion(all.motion) {}

  /// @brief Whether it contains neither walls nor obstacles.
  bool isOfAgentsAlone() const { return walls.empty() && !neighbours.hasObstacles(); }
};

}  // namespace crowd
