#pragma once

#include <cstdint>
#include <limits>
#include <vector>

/// What agents perceive, and what they answer. Lengths are in metres, angles in radians and counterclockwise, times in
/// seconds. Frame `map` is that of the scenario; in the frame of an agent, it is at the origin and looks along x.
namespace crowd::library {

using AgentId = std::uint32_t;

struct Vector2 {
  double x = 0.0;
  double y = 0.0;
};

struct Pose {
  Vector2 position;
  double heading = 0.0;  ///< 0 along x
};

/// @brief A straight wall between two points.
struct Wall {
  Vector2 from;
  Vector2 to;
};

/// @brief How fast agents change their velocity; infinite: at once.
struct MotionLimits {
  double acceleration = std::numeric_limits<double>::infinity();  ///< when they speed up or swerve [m/s2]
  double braking = std::numeric_limits<double>::infinity();       ///< when they slow down [m/s2]
  double turn_rate = std::numeric_limits<double>::infinity();     ///< of the heading [rad/s]
};

/// @brief Range and limits of what agents perceive, see QTable::vision().
struct Vision {
  double radius = 6.0;               ///< maximum distance from the agent's centre to the rim of a neighbour [m]
  std::uint32_t max_neighbours = 0;  ///< only the nearest are perceived; 0: no limit
  bool occlusion = false;            ///< nearer neighbours and walls hide others
  double wall_distance = std::numeric_limits<double>::infinity();  ///< from its rim to a wall [m]
  MotionLimits motion;  ///< of all agents, unless the scenario has its own; unlimited: `human` has no mass and no gait
};

/// @brief Kind of a perceived body. UNYIELDED_ROBOT: a robot that agents see, but do not yield to.
enum class NeighbourKind : std::uint8_t { AGENT = 0, OBSTACLE = 1, ROBOT = 2, UNYIELDED_ROBOT = 3 };

/// @brief Another body, in the frame of the agent that perceives it.
struct Neighbour {
  Vector2 position;     ///< of its centre [m]
  Vector2 velocity;     ///< over ground, in the last tick [m/s]
  double radius = 0.0;  ///< [m]
  NeighbourKind kind = NeighbourKind::AGENT;
  double comfort = 0.0;  ///< of a robot: distance that people keep from it where there is room [m]
  Vector2 wanted;        ///< of a robot: velocity at which it will go on [m/s]
};

/// @brief What one agent perceives at the start of a tick.
struct Perception {
  AgentId agent = 0;
  Pose pose;                          ///< in `map`
  Vector2 velocity;                   ///< of the last tick, agent frame [m/s]
  double max_speed = 0.0;             ///< [m/s]
  double radius = 0.0;                ///< of its body [m]
  Vector2 goal;                       ///< or the next point on the way to it, agent frame [m]
  std::uint32_t goal_number = 0;      ///< changes when the goal changes
  bool arrived = false;               ///< reached its last goal in the last tick: this is its last perception
  bool acted = false;                 ///< its action of the last tick was executed
  bool held = false;                  ///< it stands, or brakes, whatever its action
  std::vector<Neighbour> neighbours;  ///< nearest rim first
  std::vector<Wall> walls;            ///< agent frame [m]
};

/// @brief What the agents whose turn it is perceive at the start of a tick.
struct Perceptions {
  std::uint64_t episode = 0;
  std::uint64_t tick = 0;
  std::uint32_t turn = 0;      ///< in scenarios with `order: sequential` the agent whose turn it is, else 0
  double tick_duration = 0.1;  ///< [s]
  MotionLimits motion;         ///< of all agents; unlimited: `human` has no mass and no gait
  bool last = false;           ///< the episode is over: no actions are expected
  std::vector<Perception> agents;
};

/// @brief What an agent does in a tick, in its own frame: it turns, then walks straight ahead.
struct Action {
  AgentId agent = 0;
  double rotation = 0.0;        ///< of the heading [rad]
  double speed_fraction = 0.0;  ///< of its maximum speed, 0 (stay) to 1
};

}  // namespace crowd::library
