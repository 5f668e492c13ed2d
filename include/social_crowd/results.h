#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace crowd {

/// @brief Results of one agent in an episode. A new field also belongs in one of the functions below.
struct AgentResult {
  bool arrived = false;
  bool removed = false;             ///< was removed on its way; excluded from all metrics
  bool touched = false;             ///< in contact in any tick before it arrived
  bool collided = false;            ///< in collision in any tick before it arrived (thesis, 4.1), see World
  bool out_of_reach = false;        ///< on its way at the end, and no way leads to its goal
  bool endless = false;             ///< on a route that repeats: it never arrives, and has not failed
  std::uint64_t waypoints = 0;      ///< waypoints of routes that it has left behind
  std::uint64_t blocked_moves = 0;  ///< moves that were cut short by an impact; solid worlds only
  std::uint64_t appeared = 0;       ///< tick at which it was added to the world
  double start_x = 0.0;             ///< place where it was added [m], `map`
  double start_y = 0.0;
  std::uint64_t ticks = 0;       ///< from then on until its arrival, or until the end
  double heading = 0.0;          ///< at its arrival, or at the end [rad], `map`
  double path_length = 0.0;      ///< [m]
  double straight_length = 0.0;  ///< from the start via all goals, minus the goal tolerance [m]
  double path_ratio = 0.0;       ///< path_length / straight_length
  double time_ratio = 0.0;       ///< time * maximum speed / straight_length
  double turn_per_metre = 0.0;   ///< accumulated absolute change of direction of motion / path_length [rad/m]
  double max_speed_ratio = 0.0;  ///< highest speed in a tick / maximum speed
  double distance_gained = 0.0;  ///< decrease of the distance to the goal, summed over its goals [m]
  double gain_per_tick = 0.0;    ///< distance gained per step (thesis): distance_gained / ticks [m]
  double path_per_gain = 0.0;    ///< path_length / distance_gained; NaN if distance_gained is not positive

  /// @brief Calls visit(name, field...) for each field that records and AgentResult.msg have; with several objects,
  /// such as a result and its message, for the field of all.
  template <typename Visit, typename... Results>
  static void visitMeasures(const Visit& visit, Results&... results) {
    visit("arrived", results.arrived...);
    visit("touched", results.touched...);
    visit("collided", results.collided...);
    visit("blocked_moves", results.blocked_moves...);
    visit("ticks", results.ticks...);
    visit("path_length", results.path_length...);
    visit("path_ratio", results.path_ratio...);
    visit("time_ratio", results.time_ratio...);
    visit("turn_per_metre", results.turn_per_metre...);
    visit("distance_gained", results.distance_gained...);
    visit("gain_per_tick", results.gain_per_tick...);
    visit("path_per_gain", results.path_per_gain...);
  }

  /// @brief The same for all fields.
  template <typename Visit, typename AResult>
  static void visitFields(const Visit& visit, AResult& result) {
    visitMeasures(visit, result);
    visit("removed", result.removed);
    visit("out_of_reach", result.out_of_reach);
    visit("endless", result.endless);
    visit("waypoints", result.waypoints);
    visit("appeared", result.appeared);
    visit("start_x", result.start_x);
    visit("start_y", result.start_y);
    visit("heading", result.heading);
    visit("straight_length", result.straight_length);
    visit("max_speed_ratio", result.max_speed_ratio);
  }
};

/// @brief Commands and poses that a robot got from elsewhere in an episode. Headless controllers count none of them.
struct RobotInput {
  std::uint64_t commands_taken = 0;    ///< commands that were executed
  std::uint64_t commands_missed = 0;   ///< commands that did not come in time
  std::uint64_t commands_late = 0;     ///< commands that came after the end of the wait for them; they are taken, too
  std::uint64_t command_timeouts = 0;  ///< stops because no command came for RobotStart::cmd_timeout
  std::uint64_t commands_refused = 0;  ///< invalid commands and those of other publishers
  std::uint64_t poses_taken = 0;       ///< poses that were used
  std::uint64_t poses_refused = 0;     ///< invalid poses, those older than the last one, and those in unknown frames
  std::uint64_t pose_jumps = 0;        ///< of the pose
  std::uint64_t pose_gaps = 0;         ///< in the poses
  std::uint64_t pose_stale = 0;        ///< periods without a pose

  /// @brief Calls visit(name, field...) for each field, all of which RobotResult.msg has, too; with several objects,
  /// for the field of all.
  template <typename Visit, typename... Inputs>
  static void visitFields(const Visit& visit, Inputs&... inputs) {
    visit("commands_taken", inputs.commands_taken...);
    visit("commands_missed", inputs.commands_missed...);
    visit("commands_late", inputs.commands_late...);
    visit("command_timeouts", inputs.command_timeouts...);
    visit("commands_refused", inputs.commands_refused...);
    visit("poses_taken", inputs.poses_taken...);
    visit("poses_refused", inputs.poses_refused...);
    visit("pose_jumps", inputs.pose_jumps...);
    visit("pose_gaps", inputs.pose_gaps...);
    visit("pose_stale", inputs.pose_stale...);
  }
};

/// @brief Results of a robot in an episode (docs/robot_metrics.md). Names are those of HuNavSim where it has the
/// metric. They are measured until the robot arrives, or until the end. A number that nothing was measured for is NaN.
///
/// The distance to a person is that from the person's centre to the robot's footprint; people are the agents on their
/// way. A new field also belongs in visitMeasures().
struct RobotResult {
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  std::string name;
  bool success = false;                     ///< it arrived
  bool timeout = false;                     ///< it has a goal and did not arrive
  bool stuck = false;                       ///< timeout, and it moved by less than 0.5 m in the last 10 s
  double time_to_reach_goal = NONE;         ///< [s]
  double path_length = 0.0;                 ///< [m]
  double path_length_ratio = NONE;          ///< path_length / straight length from the start via all goals
  double final_distance = NONE;             ///< to the goal [m]
  double minimum_distance_to_goal = NONE;   ///< [m]
  double avg_robot_linear_speed = NONE;     ///< [m/s]
  double max_speed = 0.0;                   ///< [m/s]
  double avg_acceleration = NONE;           ///< [m/s^2]
  double max_acceleration = 0.0;            ///< [m/s^2]
  double avg_jerk = NONE;                   ///< [m/s^3]
  double max_jerk = 0.0;                    ///< [m/s^3]
  double cumulative_heading_changes = 0.0;  ///< [rad]
  double time_not_moving = 0.0;             ///< below 0.001 m/s and 0.01 rad/s [s]
  std::uint64_t robot_on_person_collisions = 0;
  std::uint64_t person_on_robot_collisions = 0;
  std::uint64_t mutual_collisions = 0;
  double contact_time = 0.0;                 ///< with people [s]
  std::uint64_t wall_contacts = 0;           ///< times that it came within 1 mm of walls
  std::uint64_t robot_contacts = 0;          ///< times that it came within 1 mm of other robots
  double minimum_distance_to_people = NONE;  ///< [m]
  double avg_closest_person = NONE;  ///< mean of the distance to the nearest person minus that person's radius [m]
  double minimum_clearance = NONE;   ///< minimum of the distance to a person minus that person's radius [m]
  double intimate_space_time = 0.0;  ///< nearest person nearer than 0.45 m [s]
  double personal_space_time = 0.0;  ///< nearest person nearer than 1.2 m [s]
  double intimate_space_intrusions = NONE;  ///< share of the time below 0.45 m [%]
  double personal_space_intrusions = NONE;  ///< share of the time from 0.45 m to 1.2 m [%]
  /// Effect of all robots of the scenario on people, see docs/robot_metrics.md; the same for each robot.
  std::uint64_t people_compared = 0;
  double people_delay = NONE;   ///< [s]
  double people_detour = NONE;  ///< [m]
  RobotInput input;

  std::uint64_t collisions() const {
    return robot_on_person_collisions + person_on_robot_collisions + mutual_collisions;
  }
  /// @brief Whether it arrived without a contact with people.
  bool isClean() const { return success && collisions() == 0; }

  /// @brief Calls visit(name, field...) for each field that RobotResult.msg has, too; with several objects, such as a
  /// result and its message, for the field of all.
  template <typename Visit, typename... Results>
  static void visitMeasures(const Visit& visit, Results&... results) {
    visit("success", results.success...);
    visit("timeout", results.timeout...);
    visit("stuck", results.stuck...);
    visit("time_to_reach_goal", results.time_to_reach_goal...);
    visit("path_length", results.path_length...);
    visit("path_length_ratio", results.path_length_ratio...);
    visit("final_distance", results.final_distance...);
    visit("minimum_distance_to_goal", results.minimum_distance_to_goal...);
    visit("avg_robot_linear_speed", results.avg_robot_linear_speed...);
    visit("max_speed", results.max_speed...);
    visit("avg_acceleration", results.avg_acceleration...);
    visit("max_acceleration", results.max_acceleration...);
    visit("avg_jerk", results.avg_jerk...);
    visit("max_jerk", results.max_jerk...);
    visit("cumulative_heading_changes", results.cumulative_heading_changes...);
    visit("time_not_moving", results.time_not_moving...);
    visit("robot_on_person_collisions", results.robot_on_person_collisions...);
    visit("person_on_robot_collisions", results.person_on_robot_collisions...);
    visit("mutual_collisions", results.mutual_collisions...);
    visit("contact_time", results.contact_time...);
    visit("wall_contacts", results.wall_contacts...);
    visit("robot_contacts", results.robot_contacts...);
    visit("minimum_distance_to_people", results.minimum_distance_to_people...);
    visit("avg_closest_person", results.avg_closest_person...);
    visit("minimum_clearance", results.minimum_clearance...);
    visit("intimate_space_time", results.intimate_space_time...);
    visit("personal_space_time", results.personal_space_time...);
    visit("intimate_space_intrusions", results.intimate_space_intrusions...);
    visit("personal_space_intrusions", results.personal_space_intrusions...);
  }

  /// @brief The same for each field but the name, for records and transfers.
  template <typename Visit, typename AResult>
  static void visitFields(const Visit& visit, AResult& result) {
    visitMeasures(visit, result);
    visit("people_compared", result.people_compared);
    visit("people_delay", result.people_delay);
    visit("people_detour", result.people_detour);
    RobotInput::visitFields(visit, result.input);
  }
};

/// @brief Numbers of the agents of an episode that were not removed; metrics are about these.
struct EpisodeCounts {
  std::size_t agents = 0;
  std::size_t arrived = 0;
  std::size_t expected = 0;  ///< to arrive: without agents on routes that repeat
  std::size_t touched = 0;
  std::size_t collided = 0;
  std::uint64_t blocked_moves = 0;  ///< sum of all of them
  /// @brief Whether all expected agents arrived, and none was in contact.
  bool isClean() const { return arrived == expected && touched == 0; }
};

namespace library {

using crowd::AgentResult;
using crowd::EpisodeCounts;
using crowd::RobotInput;
using crowd::RobotResult;

/// @brief Results of an episode, or of the part of it that has been walked.
struct EpisodeResult {
  std::string scenario;
  std::uint64_t ticks = 0;
  EpisodeCounts count;
  std::vector<AgentResult> agents;  ///< by id
  std::vector<RobotResult> robots;  ///< in the order of the scenario
  std::string way_finding_problem;  ///< why way-finding was left out from some tick on; empty: it was not
};

}  // namespace library
}  // namespace crowd
