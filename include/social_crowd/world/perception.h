#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/neighbours.h"
#include "social_crowd/world/span.h"

namespace crowd {

using AgentId = std::uint32_t;

/// @brief A tick of so many agents takes less time than it takes other threads to wake up.
constexpr std::size_t FEW_AGENTS = 128;

/// @brief How far and how much an agent perceives.
struct Vision {
  double radius = 6.0;               ///< to the other's rim [m]
  std::uint32_t max_neighbours = 0;  ///< the nearest so many neighbours only, of those that are seen; 0: no limit
  bool occlusion = false;            ///< what nearer neighbours and walls hide is not perceived (see Occlusion)
};

/// @brief What an agent knows of itself at a tick.
struct AgentPerception {
  AgentId agent = 0;
  Pose pose;                           ///< in `map`
  Vector2 velocity = Vector2::Zero();  ///< of the last tick, agent frame [m/s]
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< of the body [m]
  Vector2 goal = Vector2::Zero();      ///< position of the goal, agent frame [m]
  std::uint32_t goal_number = 0;       ///< another number than in the tick before: another goal
  bool arrived = false;                ///< reached its last goal in the last tick: this is its last perception
  bool acted = false;                  ///< its answer to the last tick was carried out
  std::uint32_t first_neighbour = 0;   ///< index of the first of its neighbours in `neighbours`
  std::uint32_t neighbour_count = 0;
  std::uint32_t first_wall = 0;  ///< its walls are walls[first_wall .. first_wall + wall_count)
  std::uint32_t wall_count = 0;
};

/// @brief What all agents perceive at the start of a tick. Bodies and walls of all agents stand in one list each, in no
/// order of agents and perhaps with gaps, so that a tick allocates nothing once the vectors have grown.
struct Perceptions {
  std::uint64_t episode = 0;
  std::uint64_t tick = 0;
  std::uint32_t turn = 0;      ///< within the tick: the agent whose turn it is (Order::SEQUENTIAL), else 0
  double tick_duration = 0.0;  ///< [s]
  bool last = false;           ///< the episode ends here: nobody is to answer
  std::vector<AgentPerception> agents;
  NeighbourList neighbours;    ///< of each agent the nearest rim first
  std::vector<Segment> walls;  ///< in the frame of the agent they belong to
  /// Places of all agents, neighbours and what they perceive one after the other: the fastest way through large crowds.
  /// Empty where agents are few.
  std::vector<std::uint32_t> order;
};

/// @brief What one agent perceives at a tick: a view into Perceptions, valid as long as those are unchanged.
struct Perception {
  const AgentPerception& self;
  NeighbourSpan neighbours;
  Span<Segment> walls;
  double tick_duration;  ///< [s]

  Perception(const Perceptions& all, std::size_t index)
      : self(all.agents[index]),
        neighbours(all.neighbours, self.first_neighbour, self.neighbour_count),
        walls(all.walls.data() + self.first_wall, self.wall_count),
        tick_duration(all.tick_duration) {}

  /// @brief Whether there are neither walls nor obstacles.
  bool isOfAgentsAlone() const { return walls.empty() && !neighbours.hasObstacles(); }
};

}  // namespace crowd
