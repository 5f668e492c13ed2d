#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace crowd {

/// @brief Name and unit of a number of a result. The unit is empty for ratios, counts and flags.
struct MetricName {
  const char* name = "";
  const char* unit = "";

  operator const char*() const { return name; }  // NOLINT(google-explicit-constructor): most visitors use the name only
  operator std::string() const { return name; }  // NOLINT(google-explicit-constructor)
};

/// @brief Commands and poses that a robot got from elsewhere in an episode. Headless controllers count none of them.
struct RobotInput {
  std::string navigation = "none";     ///< of its nodes: running, crashed (in this episode or before); none: unknown
  std::uint64_t commands_taken = 0;    ///< that it followed
  std::uint64_t commands_missed = 0;   ///< awaited in vain (lockstep)
  std::uint64_t commands_late = 0;     ///< that came after the deadline of their tick (lockstep)
  std::uint64_t command_timeouts = 0;  ///< stops because no command arrived within cmd_timeout
  std::uint64_t commands_refused = 0;  ///< invalid commands and those of other publishers
  std::uint64_t poses_taken = 0;       ///< poses that were used, of a robot that lives elsewhere
  std::uint64_t poses_refused = 0;     ///< invalid poses, those older than the last one, and those in unknown frames
  std::uint64_t pose_jumps = 0;  ///< poses farther from the last one than 0.1 m and 1.5 times the maximum speed explain
  std::uint64_t pose_gaps = 0;   ///< poses that came more than 0.5 s after the last one
  std::uint64_t pose_stale = 0;  ///< times at which no pose came for more than 0.5 s

  /// @brief Calls visit(name, field...) for each field; with several objects, for the field of all.
  template <typename Visit, typename... Inputs>
  static void visitFields(const Visit& visit, Inputs&... inputs) {
    visit(MetricName{"navigation"}, inputs.navigation...);
    visit(MetricName{"commands_taken"}, inputs.commands_taken...);
    visit(MetricName{"commands_missed"}, inputs.commands_missed...);
    visit(MetricName{"commands_late"}, inputs.commands_late...);
    visit(MetricName{"command_timeouts"}, inputs.command_timeouts...);
    visit(MetricName{"commands_refused"}, inputs.commands_refused...);
    visit(MetricName{"poses_taken"}, inputs.poses_taken...);
    visit(MetricName{"poses_refused"}, inputs.poses_refused...);
    visit(MetricName{"pose_jumps"}, inputs.pose_jumps...);
    visit(MetricName{"pose_gaps"}, inputs.pose_gaps...);
    visit(MetricName{"pose_stale"}, inputs.pose_stale...);
  }
};

/// @brief Result of a robot for one of its goals (docs/metrics.md, "Goals of a tour"). Its way begins where the robot
/// was when it got the goal: at its start, or where it reached the goal before. A number that nothing was measured for
/// is NaN.
struct RobotGoalResult {
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  double x = 0.0;                      ///< place of the goal, in `map` [m]
  double y = 0.0;                      ///< [m]
  bool success = false;                ///< it was reached
  double time_to_reach_goal = NONE;    ///< since the robot got the goal [s]
  double path_length = NONE;           ///< since then; NaN for a goal that it did not set out for [m]
  double shortest_path_length = NONE;  ///< from where it was then, minus the goal tolerance [m]
  double path_length_ratio = NONE;     ///< path_length / shortest_path_length
  double spl = NONE;                   ///< success weighted by path length

  /// @brief Calls visit(name, field...) for each field; with several objects, for the field of all.
  template <typename Visit, typename... Results>
  static void visitFields(const Visit& visit, Results&... results) {
    visit(MetricName{"x", "m"}, results.x...);
    visit(MetricName{"y", "m"}, results.y...);
    visit(MetricName{"success"}, results.success...);
    visit(MetricName{"time_to_reach_goal", "s"}, results.time_to_reach_goal...);
    visit(MetricName{"path_length", "m"}, results.path_length...);
    visit(MetricName{"shortest_path_length", "m"}, results.shortest_path_length...);
    visit(MetricName{"path_length_ratio"}, results.path_length_ratio...);
    visit(MetricName{"spl"}, results.spl...);
  }
};

/// @brief Results of a robot in an episode. docs/metrics.md defines them, with formulas and sources; names are those of
/// HuNavSim where it has the metric. They are measured until the robot arrives, or until the end. A number that nothing
/// was measured for is NaN.
///
/// The distance to a person is that from the person's centre to the robot's footprint; people are the agents on
/// their way, those who stay, and recorded people. 0.5 m, 10 s and 0.05 m/s are defaults of RobotMetricOptions.
///
/// scripts/generate writes the lists that visit the fields, the message, and the units and new rows of
/// docs/metrics.md, from the comments here.
struct RobotResult {
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  std::string name;
  bool success = false;                     ///< it arrived
  bool timeout = false;                     ///< it has a goal and did not arrive
  bool stuck = false;                       ///< timeout, and it moved by less than 0.5 m in the last 10 s
  std::uint64_t failures_to_progress = 0;   ///< times that it did not come 0.5 m nearer to its goal in 10 s
  double stalled_time = 0.0;                ///< slower than 0.05 m/s [s]
  double time_to_reach_goal = NONE;         ///< [s]
  double path_length = 0.0;                 ///< [m]
  double shortest_path_length = NONE;       ///< of the searched way via all goals, minus the goal tolerance [m]
  double path_length_ratio = NONE;          ///< path_length / shortest_path_length
  double path_efficiency = NONE;            ///< shortest_path_length / path_length, if it arrived
  double path_irregularity = NONE;          ///< rotation beyond that of the shortest way [rad]
  double avg_angle_to_goal = NONE;          ///< between heading and direction to the goal, mean over the path [rad]
  double spl = NONE;                        ///< success weighted by path length
  double stl = NONE;                        ///< success weighted by time length
  double final_distance = NONE;             ///< to the last goal [m]
  double minimum_distance_to_goal = NONE;   ///< to the last goal [m]
  double min_speed = NONE;                  ///< [m/s]
  double avg_robot_linear_speed = NONE;     ///< [m/s]
  double max_speed = 0.0;                   ///< [m/s]
  double avg_robot_angular_speed = NONE;    ///< [rad/s]
  double min_acceleration = NONE;           ///< without those of impacts and jumps, as the next five [m/s^2]
  double avg_acceleration = NONE;           ///< [m/s^2]
  double max_acceleration = 0.0;            ///< [m/s^2]
  double min_jerk = NONE;                   ///< [m/s^3]
  double avg_jerk = NONE;                   ///< [m/s^3]
  double max_jerk = 0.0;                    ///< [m/s^3]
  double cumulative_heading_changes = 0.0;  ///< [rad]
  double time_not_moving = 0.0;             ///< below 0.001 m/s and 0.01 rad/s [s]
  std::uint64_t contacts = 0;               ///< with people, walls, obstacles and other robots
  std::uint64_t people_contacts = 0;        ///< sum of the next three
  std::uint64_t robot_on_person_collisions = 0;  ///< contacts: the robot moved into a person
  std::uint64_t person_on_robot_collisions = 0;  ///< contacts: a person moved into the robot
  std::uint64_t mutual_collisions = 0;           ///< contacts: both, or neither
  double contact_time = 0.0;                     ///< with people [s]
  std::uint64_t wall_contacts = 0;               ///< times that it came within 1 mm of walls
  std::uint64_t obstacle_contacts = 0;           ///< times that it came within 1 mm of obstacles
  std::uint64_t robot_contacts = 0;              ///< times that it came within 1 mm of other robots
  double minimum_obstacle_clearance = NONE;      ///< to the nearest wall or obstacle [m]
  double avg_obstacle_clearance = NONE;          ///< mean over time of the same [m]
  double minimum_distance_to_people = NONE;      ///< from the footprint to the centre of a person [m]
  double maximum_distance_to_people = NONE;      ///< the same of the farthest person [m]
  double avg_closest_person = NONE;  ///< mean of the distance to the nearest person minus that person's radius [m]
  double minimum_clearance = NONE;   ///< least distance to a person minus that person's radius [m]
  double minimum_time_to_collision = NONE;        ///< with people, at constant velocities [s]
  double responsibility = NONE;                   ///< share of the robot in resolving conflicts with people, 0 to 1
  double space_compliance = NONE;                 ///< share of the time with all people beyond 0.5 m
  double intimate_space_time = 0.0;               ///< nearest person nearer than 0.45 m [s]
  double personal_space_time = 0.0;               ///< nearest person nearer than 1.2 m [s]
  double intimate_space_intrusions = NONE;        ///< share of the time below 0.45 m [%]
  double personal_space_intrusions = NONE;        ///< share of the time from 0.45 m to 1.2 m [%]
  double social_space_intrusions = NONE;          ///< share of the time from 1.2 m to 3.6 m [%]
  double group_intimate_space_intrusions = NONE;  ///< the same with the space in front of groups [%]
  double group_personal_space_intrusions = NONE;  ///< [%]
  double group_social_space_intrusions = NONE;    ///< [%]
  std::uint64_t group_intrusions = 0;             ///< times that it came between the members of a group
  double people_density = NONE;                   ///< mean number of people / walkable area [1/m^2]
  double avg_pedestrian_velocity = NONE;          ///< mean speed of people [m/s]
  double avg_closest_pedestrian_velocity = NONE;  ///< mean speed of the nearest person [m/s]
  double social_force_on_robot = 0.0;             ///< sums over the ticks, as the next four [m/s^2]
  double social_force_on_agents = 0.0;            ///< [m/s^2]
  double social_work = 0.0;                       ///< [m/s^2]
  double obstacle_force_on_robot = 0.0;           ///< [m/s^2]
  double obstacle_force_on_agents = 0.0;          ///< [m/s^2]
  double aggregated_time = NONE;  ///< until all robots and people had arrived; the same for each robot [s]
  /// Effect of all robots of the scenario on people, see docs/metrics.md; the same for each robot.
  std::uint64_t people_compared = 0;
  double people_delay = NONE;   ///< [s]
  double people_detour = NONE;  ///< [m]
  RobotInput input;
  std::vector<RobotGoalResult> goals;  ///< those of a tour, in their order

  std::uint64_t collisions() const {
    return robot_on_person_collisions + person_on_robot_collisions + mutual_collisions;
  }
  /// @brief Whether it arrived without a contact with people.
  bool isClean() const { return success && collisions() == 0; }

  /// @brief Calls visit(name, field...) for each field that RobotResult.msg has, too, but those of `input` and `goals`;
  /// with several objects, such as a result and its message, for the field of all. `name` is a MetricName.
  template <typename Visit, typename... Results>
  static void visitMeasures(const Visit& visit, Results&... results) {
    visit(MetricName{"success"}, results.success...);
    visit(MetricName{"timeout"}, results.timeout...);
    visit(MetricName{"stuck"}, results.stuck...);
    visit(MetricName{"failures_to_progress"}, results.failures_to_progress...);
    visit(MetricName{"stalled_time", "s"}, results.stalled_time...);
    visit(MetricName{"time_to_reach_goal", "s"}, results.time_to_reach_goal...);
    visit(MetricName{"path_length", "m"}, results.path_length...);
    visit(MetricName{"shortest_path_length", "m"}, results.shortest_path_length...);
    visit(MetricName{"path_length_ratio"}, results.path_length_ratio...);
    visit(MetricName{"path_efficiency"}, results.path_efficiency...);
    visit(MetricName{"path_irregularity", "rad"}, results.path_irregularity...);
    visit(MetricName{"avg_angle_to_goal", "rad"}, results.avg_angle_to_goal...);
    visit(MetricName{"spl"}, results.spl...);
    visit(MetricName{"stl"}, results.stl...);
    visit(MetricName{"final_distance", "m"}, results.final_distance...);
    visit(MetricName{"minimum_distance_to_goal", "m"}, results.minimum_distance_to_goal...);
    visit(MetricName{"min_speed", "m/s"}, results.min_speed...);
    visit(MetricName{"avg_robot_linear_speed", "m/s"}, results.avg_robot_linear_speed...);
    visit(MetricName{"max_speed", "m/s"}, results.max_speed...);
    visit(MetricName{"avg_robot_angular_speed", "rad/s"}, results.avg_robot_angular_speed...);
    visit(MetricName{"min_acceleration", "m/s^2"}, results.min_acceleration...);
    visit(MetricName{"avg_acceleration", "m/s^2"}, results.avg_acceleration...);
    visit(MetricName{"max_acceleration", "m/s^2"}, results.max_acceleration...);
    visit(MetricName{"min_jerk", "m/s^3"}, results.min_jerk...);
    visit(MetricName{"avg_jerk", "m/s^3"}, results.avg_jerk...);
    visit(MetricName{"max_jerk", "m/s^3"}, results.max_jerk...);
    visit(MetricName{"cumulative_heading_changes", "rad"}, results.cumulative_heading_changes...);
    visit(MetricName{"time_not_moving", "s"}, results.time_not_moving...);
    visit(MetricName{"contacts"}, results.contacts...);
    visit(MetricName{"people_contacts"}, results.people_contacts...);
    visit(MetricName{"robot_on_person_collisions"}, results.robot_on_person_collisions...);
    visit(MetricName{"person_on_robot_collisions"}, results.person_on_robot_collisions...);
    visit(MetricName{"mutual_collisions"}, results.mutual_collisions...);
    visit(MetricName{"contact_time", "s"}, results.contact_time...);
    visit(MetricName{"wall_contacts"}, results.wall_contacts...);
    visit(MetricName{"obstacle_contacts"}, results.obstacle_contacts...);
    visit(MetricName{"robot_contacts"}, results.robot_contacts...);
    visit(MetricName{"minimum_obstacle_clearance", "m"}, results.minimum_obstacle_clearance...);
    visit(MetricName{"avg_obstacle_clearance", "m"}, results.avg_obstacle_clearance...);
    visit(MetricName{"minimum_distance_to_people", "m"}, results.minimum_distance_to_people...);
    visit(MetricName{"maximum_distance_to_people", "m"}, results.maximum_distance_to_people...);
    visit(MetricName{"avg_closest_person", "m"}, results.avg_closest_person...);
    visit(MetricName{"minimum_clearance", "m"}, results.minimum_clearance...);
    visit(MetricName{"minimum_time_to_collision", "s"}, results.minimum_time_to_collision...);
    visit(MetricName{"responsibility"}, results.responsibility...);
    visit(MetricName{"space_compliance"}, results.space_compliance...);
    visit(MetricName{"intimate_space_time", "s"}, results.intimate_space_time...);
    visit(MetricName{"personal_space_time", "s"}, results.personal_space_time...);
    visit(MetricName{"intimate_space_intrusions", "%"}, results.intimate_space_intrusions...);
    visit(MetricName{"personal_space_intrusions", "%"}, results.personal_space_intrusions...);
    visit(MetricName{"social_space_intrusions", "%"}, results.social_space_intrusions...);
    visit(MetricName{"group_intimate_space_intrusions", "%"}, results.group_intimate_space_intrusions...);
    visit(MetricName{"group_personal_space_intrusions", "%"}, results.group_personal_space_intrusions...);
    visit(MetricName{"group_social_space_intrusions", "%"}, results.group_social_space_intrusions...);
    visit(MetricName{"group_intrusions"}, results.group_intrusions...);
    visit(MetricName{"people_density", "1/m^2"}, results.people_density...);
    visit(MetricName{"avg_pedestrian_velocity", "m/s"}, results.avg_pedestrian_velocity...);
    visit(MetricName{"avg_closest_pedestrian_velocity", "m/s"}, results.avg_closest_pedestrian_velocity...);
    visit(MetricName{"social_force_on_robot", "m/s^2"}, results.social_force_on_robot...);
    visit(MetricName{"social_force_on_agents", "m/s^2"}, results.social_force_on_agents...);
    visit(MetricName{"social_work", "m/s^2"}, results.social_work...);
    visit(MetricName{"obstacle_force_on_robot", "m/s^2"}, results.obstacle_force_on_robot...);
    visit(MetricName{"obstacle_force_on_agents", "m/s^2"}, results.obstacle_force_on_agents...);
    visit(MetricName{"aggregated_time", "s"}, results.aggregated_time...);
  }

  /// @brief The same for each field but the name and the goals, for records and transfers.
  template <typename Visit, typename AResult>
  static void visitFields(const Visit& visit, AResult& result) {
    visitMeasures(visit, result);
    visit(MetricName{"people_compared"}, result.people_compared);
    visit(MetricName{"people_delay", "s"}, result.people_delay);
    visit(MetricName{"people_detour", "m"}, result.people_detour);
    RobotInput::visitFields(visit, result.input);
  }
};

}  // namespace crowd
