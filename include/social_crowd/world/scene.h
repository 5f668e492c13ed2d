#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/obstacle_path.h"

namespace crowd {

/// @brief Decision period unless a scenario says otherwise [s].
constexpr double DEFAULT_TICK_DURATION = 0.1;

/// @brief What happens where bodies meet: GHOST, they walk through each other, or SOLID, they stop where they touch.
enum class Contact : std::uint8_t { GHOST = 0, SOLID = 1 };

/// @brief How the agents of a tick take their turns. SIMULTANEOUS: all perceive the world as it is at the start of the
/// tick, then all move. SEQUENTIAL (thesis, algorithms 3.3 and 3.4): one agent after the other, in order of their
/// numbers, perceives the world as it is then, decides and moves.
enum class Order : std::uint8_t { SIMULTANEOUS = 0, SEQUENTIAL = 1 };

/// @brief Inner radius of the thesis (4.1) [m], see Scene::collision_radius.
constexpr double DEFAULT_COLLISION_RADIUS = 0.5;

/// @brief How an agent begins an episode and where it is to go.
struct AgentStart {
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  double heading = 0.0;                ///< [rad], `map`
  std::vector<Vector2> goals;          ///< [m], `map`; reached one after the other, at least one
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< of the body [m]
  bool keeps_heading = false;  ///< begins with the heading it had when the last episode ended, see keepHeadings()
};

/// @brief A disc that yields to nobody.
struct Obstacle {
  ObstaclePath path;
  double radius = 0.0;  ///< [m]
};

/// @brief Everything one episode begins with, in numbers; agents are numbered in this order.
struct Scene {
  std::string name;
  double tick_duration = DEFAULT_TICK_DURATION;  ///< [s]
  std::uint64_t max_ticks = 0;                   ///< the episode fails for whoever has not arrived by then
  double goal_tolerance = 0.0;                   ///< arrived when the centre is this near the goal [m]
  /// A rim that is no farther than this from an agent's centre is a collision (thesis, 4.1) [m]. Only measured: it has
  /// no effect on anybody.
  double collision_radius = DEFAULT_COLLISION_RADIUS;
  Contact contact = Contact::GHOST;
  Order order = Order::SIMULTANEOUS;
  std::vector<AgentStart> agents;
  std::vector<Obstacle> obstacles;
  std::vector<Segment> walls;
};

/// @brief Gives the agents that keep their heading the one that the agent of the same number had at the end of the last
/// episode [rad]. Agents that were not there then keep the heading of the scene.
void keepHeadings(const std::vector<double>& last, Scene& scene);

/// @brief Bodies that overlap by no more than this merely touch [m]; rounding is not an overlap.
constexpr double TOUCH_TOLERANCE = 1e-9;

/// @brief Says which agent overlaps what at the start ("agents[1] and obstacles[0] overlap by 0.12 m"); empty
/// if none. Obstacles and walls are fixtures and may overlap each other.
std::string findOverlap(const Scene& scene);

/// @brief "FIRST and SECOND overlap by 0.12 m".
std::string overlapText(const std::string& first, const std::string& second, double depth);

}  // namespace crowd
