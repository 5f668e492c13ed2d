#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief What a log of robots (docs/metrics.md, "Logs") says of an episode before its ticks.
struct RobotLogHeader {
  std::string scenario;
  std::uint64_t episode = 0;
  std::string map;                          ///< file of the map that walls were made of; empty: none
  double tick_duration = 0.0;               ///< [s]
  std::vector<Segment> walls;               ///< [m], `map`
  std::vector<Segment> gates;               ///< those of the walls, or of later ones, that gates are
  std::vector<ObservedObstacle> obstacles;  ///< at rest
  /// Name, footprint, goals, goal tolerance and maximum speed (0: unknown) of each robot.
  std::vector<RobotStart> robots;
};

/// @brief A robot at the end of a tick.
struct LoggedRobot {
  Pose pose;                        ///< in `map`
  std::optional<Vector2> velocity;  ///< [m/s], `map`; absent: that of the way in the tick, at the start unknown
  std::optional<bool> impact;       ///< an impact changed its velocity; absent: if a contact began
  std::optional<std::vector<RobotContact>> contacts;  ///< with people in the tick; absent: those of the ways
  bool jump = false;                                  ///< it did not drive there, but was put there
};

/// @brief A person at the end of a tick. What is absent is as it was; the first time there are defaults.
struct LoggedPerson {
  AgentId id = 0;
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  std::optional<double> heading;       ///< [rad], `map`; absent: that of the motion
  std::optional<Vector2> velocity;     ///< [m/s], `map`; absent: that of the way in the tick
  std::optional<double> radius;        ///< [m]
  std::optional<GroupId> group;
  std::optional<Vector2> goal;  ///< [m], `map`; for other programs only
  std::optional<bool> endless;  ///< is not to arrive, such as on a route that repeats
};

/// @brief The end of a tick; the first one of an episode is its start.
struct RobotLogTick {
  std::uint64_t tick = 0;
  std::vector<LoggedRobot> robots;  ///< in the order of the header
  std::vector<LoggedPerson> people;
  std::vector<AgentId> arrived;               ///< people who arrived in this tick
  std::vector<ObservedObstacle> obstacles;    ///< those that move, where they are
  std::optional<std::vector<Segment>> walls;  ///< all walls from now on; absent: as before
  std::uint64_t line = 0;                     ///< in the file, for messages
};

/// @brief Radius of a person whose radius is nowhere given [m].
constexpr double DEFAULT_LOGGED_RADIUS = 0.25;

}  // namespace crowd
