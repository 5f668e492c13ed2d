#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/agent_id.h"
#include "common/text/enum_names.h"
#include "geometry/drive.h"
#include "geometry/footprint.h"
#include "scenario/robot_sensors.h"

namespace crowd {

/// @brief Index of a robot in Scene::robots and World::robots().
using RobotId = std::uint32_t;

/// @brief The id of a robot where it is treated as an agent. No agent has it.
constexpr AgentId agentIdOf(RobotId robot) { return ~robot; }

/// @brief The side that gives way when agents and a robot meet. CROWD: the separation rule of the agents holds against
/// the robot. ROBOT: the robot stops in front of people. BOTH: both. NOBODY: neither.
enum class Yields : std::uint8_t { CROWD = 0, ROBOT = 1, BOTH = 2, NOBODY = 3 };
inline constexpr EnumNames<Yields, 4> YIELDS{"yields", {"crowd", "robot", "both", "nobody"}};

/// @brief Whether agents give way to the robot.
constexpr bool doesCrowdYield(Yields yields) { return yields == Yields::CROWD || yields == Yields::BOTH; }
/// @brief Whether the robot has the protective stop.
constexpr bool doesRobotYield(Yields yields) { return yields == Yields::ROBOT || yields == Yields::BOTH; }

/// @brief Time after which a robot without a command stops, by default [s].
constexpr double DEFAULT_COMMAND_TIMEOUT = 0.5;

/// @brief Distance that people keep from a robot where there is room, by default [m].
constexpr double DEFAULT_COMFORT = 0.3;

/// @brief Initial state, goals and properties of a robot.
struct RobotStart {
  std::string name;
  std::string name_space;              ///< of its topics and frames
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  double heading = 0.0;                ///< [rad], `map`
  std::vector<Vector2> goals;          ///< [m], `map`; visited in this order; empty: none
  Drive drive = Drive::DIFFERENTIAL;
  DriveLimits limits;
  Footprint footprint;
  double cmd_timeout = DEFAULT_COMMAND_TIMEOUT;  ///< it stops if there is no command for this time [s]
  bool perceived = true;                         ///< agents perceive it
  Yields yields = Yields::CROWD;
  double comfort = DEFAULT_COMFORT;  ///< distance that people keep from it where there is room [m]
  double goal_tolerance = 0.0;       ///< a goal is reached within this distance of its position [m]
  ScanSpec scan;
  OdometrySpec odometry;
  TrackSpec tracks;
  bool reads_tf = false;  ///< EXTERNAL: its pose comes from tf, else from `odom`
};

/// @brief DRIVING: on its way, or without a goal. ARRIVED: at its last goal, where it stays in the world.
enum class RobotStatus : std::uint8_t { DRIVING = 0, ARRIVED = 1 };

/// @brief Cause of a contact. ROBOT: the robot moved into the person. PERSON: the person moved into the robot. MUTUAL:
/// both moved.
enum class ContactCause : std::uint8_t { ROBOT = 0, PERSON = 1, MUTUAL = 2 };
inline constexpr EnumNames<ContactCause, 3> CONTACT_CAUSES{"cause", {"robot", "person", "mutual"}};

/// @brief A contact of a robot and a person in a tick.
struct RobotContact {
  AgentId agent = 0;  ///< of a recorded person: idOfRecorded()
  ContactCause cause = ContactCause::MUTUAL;
  bool begins = false;  ///< they were not in contact in the tick before
};

/// @brief A robot in the world.
struct Robot {
  RobotStart start;
  Pose pose;                           ///< in `map`
  Twist target;                        ///< command of the last tick
  Twist twist;                         ///< at the end of the last tick; zero if it was stopped by an impact
  Vector2 velocity = Vector2::Zero();  ///< at the end of the last tick, `map` [m/s]
  double perceived_radius = 0.0;       ///< of the disc that agents perceive [m]
  std::vector<Vector2> goals;          ///< [m], `map`
  std::size_t next_goal = 0;
  std::uint64_t goals_set = 0;  ///< number of times that it got other goals, or the same ones again
  RobotStatus status = RobotStatus::DRIVING;
  bool sent = false;                   ///< a user has given it a goal in this episode, see Robots::send()
  double waited = 0.0;                 ///< how long it waits() already [s]
  bool blocked = false;                ///< an impact changed its last move; solid worlds only
  bool teleported = false;             ///< since the last tick
  bool jumped = false;                 ///< it was teleported before its last move, or, EXTERNAL, this was a jump
  std::vector<RobotContact> contacts;  ///< with agents and recorded people, in the last tick

  bool hasArrived() const { return status == RobotStatus::ARRIVED; }
  bool hasGoal() const { return !goals.empty(); }
  /// @brief The present goal, or the last one after arrival [m], `map`; hasGoal() must hold.
  const Vector2& goal() const { return goals[next_goal]; }
  /// @brief The velocity at which people expect it to go on, `map` [m/s]: that of the last tick; of a robot that waits
  /// on its way to a goal, as commanded in the last tick, or ahead, at the speed of one that starts.
  Vector2 wantedVelocity() const {
    constexpr double STARTS = 0.3;  // our choice [m/s]
    if (!waits()) return velocity;
    const double commanded = target.linear.norm();
    const Vector2 direction = commanded > 0.0 ? Vector2(target.linear / commanded) : Vector2::UnitX();
    return Rotation(pose.heading).outOfFrame(STARTS * direction);
  }
  /// @brief Whether it stands, or nearly so, on its way to a goal.
  bool waits() const {
    constexpr double STANDS = 0.1;  // [m/s]
    return start.drive != Drive::EXTERNAL && hasGoal() && !hasArrived() && velocity.norm() < STANDS;
  }
  /// @brief Length of the straight lines from here via all goals that are left [m]; 0 without goals.
  double remainingDistance() const {
    double length = 0.0;
    Vector2 from = pose.position;
    for (std::size_t i = next_goal; i < goals.size(); from = goals[i++]) length += (goals[i] - from).norm();
    return length;
  }
};

}  // namespace crowd
