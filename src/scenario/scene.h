#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/text/enum_names.h"
#include "geometry/geometry.h"
#include "geometry/motion_limits.h"
#include "geometry/obstacle_path.h"
#include "maps/free_space.h"
#include "scenario/figure.h"
#include "scenario/reaction.h"
#include "scenario/recorded_people.h"
#include "scenario/robot.h"
#include "scenario/robot_metric_options.h"

namespace crowd {

/// @brief Default duration of a tick [s].
constexpr double DEFAULT_TICK_DURATION = 0.1;

/// @brief Contact model. GHOST: bodies pass through each other. SOLID: agents stop where they touch something.
enum class Contact : std::uint8_t { GHOST = 0, SOLID = 1 };
inline constexpr EnumNames<Contact, 2> CONTACTS{"contact", {"ghost", "solid"}};

/// @brief Order of moves within a tick. SIMULTANEOUS: all agents perceive the world at the start of the tick, then all
/// move. SEQUENTIAL (thesis, algorithms 3.3 and 3.4): in the order of their ids, each agent perceives the world as the
/// agents before it left it, decides and moves.
enum class Order : std::uint8_t { SIMULTANEOUS = 0, SEQUENTIAL = 1 };
inline constexpr EnumNames<Order, 2> ORDERS{"order", {"simultaneous", "sequential"}};

/// @brief When an episode is over, at the latest after its duration. ALL: all agents have arrived, and all robots that
/// have goals. ROBOTS: all robots that have goals have arrived.
enum class Ends : std::uint8_t { ALL = 0, ROBOTS = 1 };
inline constexpr EnumNames<Ends, 2> ENDS{"ends", {"all", "robots"}};

/// @brief What agents of the scenario do that have arrived at their last goals. LEAVE: they leave the world. STAY: they
/// keep their places as bodies at rest, and decide no more (thesis, algorithm 3.3 skips them).
enum class Arrived : std::uint8_t { LEAVE = 0, STAY = 1 };
inline constexpr EnumNames<Arrived, 2> ARRIVALS{"arrived", {"leave", "stay"}};

/// @brief Inner radius (thesis, 4.1) [m], see Scene::collision_radius.
constexpr double DEFAULT_COLLISION_RADIUS = 0.5;

/// @brief The number of a group of agents that walk together: that of its leader, or else of its first member.
using GroupId = std::uint32_t;
/// @brief The group of agents that walk alone.
constexpr GroupId NO_GROUP = ~GroupId{0};

/// @brief Whom an agent follows, instead of goals of its own.
struct Leader {
  enum class Kind : std::uint8_t { AGENT, ROBOT };
  Kind kind = Kind::AGENT;
  std::uint32_t number = 0;  ///< id of the agent or the robot
};

/// @brief The group of those who follow a leader.
constexpr GroupId groupOf(const Leader& leader) {
  return leader.kind == Leader::Kind::AGENT ? leader.number : agentIdOf(leader.number) - 1;
}
/// @brief Of agents without a kind.
constexpr std::int32_t NO_KIND = -1;

/// @brief Initial state and goals of an agent.
struct AgentStart {
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  double heading = 0.0;                ///< [rad], `map`
  std::vector<Vector2> goals;          ///< [m], `map`; visited in this order, at least one
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< of the body [m]
  Vector2 velocity = Vector2::Zero();  ///< [m/s], `map`
  std::int32_t kind = NO_KIND;         ///< index of its kind of people
  Figure figure = Figure::ADULT;
  Reaction reaction = Reaction::REGULAR;  ///< to robots
  bool leaves = true;  ///< arrives at its last goal; else it goes on to decide there, until it gets another goal
  bool keeps_heading = false;  ///< starts with its heading at the end of the previous episode, see keepHeadings()
  std::optional<std::size_t> route = std::nullopt;  ///< index of its route; `goals` are not used then
  std::optional<Leader> leader = std::nullopt;      ///< `goals` are not used then
  GroupId group = NO_GROUP;                         ///< walks with the others of this group
  double reaction_time = 0.0;                       ///< it stands until this time has passed since it appeared [s]
  bool faces_goal = false;                          ///< with a route: `heading` is to be towards the first goal
  double hurry = 1.0;                               ///< factor of `max_speed`, see walkingSpeed()
  bool stays = false;                               ///< stays in the world when it has arrived, see Arrived

  /// @brief The maximum speed at the start [m/s].
  double walkingSpeed() const { return max_speed * hurry; }
};

/// @brief A disc that follows its path and never yields.
struct Obstacle {
  ObstaclePath path;
  double radius = 0.0;                                 ///< [m]
  std::optional<std::uint64_t> person = std::nullopt;  ///< number in its recording of a recorded person, else absent
};

/// @brief The id of a recorded person among people, by the number of the obstacle that it is. No agent has it.
constexpr AgentId idOfRecorded(std::size_t obstacle) { return ~static_cast<AgentId>(obstacle); }

struct PopulationDescription;

/// @brief Initial state and settings of one episode. The ids of the agents are their indices.
struct Scene {
  std::string name;
  double tick_duration = DEFAULT_TICK_DURATION;  ///< [s]
  std::uint64_t max_ticks = 0;                   ///< the episode ends then; agents still on their way have failed
  double goal_tolerance = 0.0;                   ///< a goal is reached within this distance of the agent's centre [m]
  /// An agent is in collision if a rim or wall is within this distance of its centre (thesis, 4.1) [m]. Collisions are
  /// measured only; they do not affect the motion.
  double collision_radius = DEFAULT_COLLISION_RADIUS;
  Contact contact = Contact::GHOST;
  Order order = Order::SIMULTANEOUS;
  std::optional<MotionLimits> motion;  ///< of all agents; without a value that of the Q-table
  std::vector<AgentStart> agents;
  std::vector<Obstacle> obstacles;       ///< the recorded people after the others
  std::vector<RecordedPeople> recorded;  ///< where these come from
  std::vector<RobotStart> robots;
  RobotMetricOptions robot_metrics;
  Ends ends = Ends::ALL;
  Arrived arrived = Arrived::LEAVE;
  std::vector<Segment> walls;  ///< those of the scenario file, then those of the map
  std::size_t own_walls = 0;   ///< number of walls of the scenario file
  /// Agents whose goal is hidden by walls or obstacles at rest perceive a waypoint on the way to it instead.
  bool way_finding = true;
  std::shared_ptr<const OccupancyMap> map;                  ///< the map that some of the walls come from; null: none
  std::string map_file;                                     ///< see Scenario
  std::shared_ptr<const FreeSpace> free_space;              ///< see Scenario
  double free_radius = 0.0;                                 ///< see Scenario
  std::shared_ptr<const PopulationDescription> population;  ///< see Scenario
  std::uint64_t seed = 0;                                   ///< see Scenario
  std::uint64_t population_seed = 0;                        ///< for everything that is drawn during the episode
};

/// @brief Sets the heading of each agent with `keeps_heading` to last[id], its heading at the end of the previous
/// episode [rad]. Agents without an entry in `last` keep the heading of the scene.
void keepHeadings(const std::vector<double>& last, Scene& scene);

/// @brief The name of an obstacle of that number in messages: "obstacle 3", "recorded person 12".
std::string nameOf(const Obstacle& obstacle, std::size_t number);

/// @brief "FIRST and SECOND overlap by DEPTH m". @param depth [m]
std::string overlapText(const std::string& first, const std::string& second, double depth);

}  // namespace crowd
