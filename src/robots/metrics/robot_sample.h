#pragma once

#include <cstdint>
#include <limits>

#include "geometry/geometry.h"
#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief What is measured of a robot at the end of one tick (docs/metrics.md, "Each tick"). NaN: there is no such
/// number, such as the distance to people without any.
struct RobotSample {
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  Pose pose;                                  ///< in `map`
  Vector2 velocity = Vector2::Zero();         ///< [m/s], `map`
  double speed = 0.0;                         ///< [m/s]
  double rotation = 0.0;                      ///< change of the heading in the tick, per second [rad/s]
  Vector2 velocity_change = Vector2::Zero();  ///< in the tick, per second; zero after an impact [m/s^2], `map`
  double acceleration = NONE;    ///< change of the velocity in the tick, per second; NaN after an impact [m/s^2]
  double jerk = NONE;            ///< [m/s^3]
  std::uint64_t goal = 0;        ///< number of the present goal in the tour
  double goal_distance = NONE;   ///< to the present goal [m]
  double goal_angle = NONE;      ///< between heading and direction to the present goal, 0 to pi [rad]
  std::uint64_t people = 0;      ///< number of people
  double nearest_person = NONE;  ///< distance to the nearest person's centre [m]
  double nearest_person_clearance = NONE;  ///< the same minus that person's radius [m]
  double nearest_person_speed = NONE;      ///< [m/s]
  double farthest_person = NONE;           ///< distance to the farthest person's centre [m]
  double people_clearance = NONE;          ///< least distance to a person's rim [m]
  double people_speed = NONE;              ///< sum of the speeds of all people [m/s]
  double group_distance = NONE;            ///< to the nearest space of a group [m]
  bool in_group = false;                   ///< it is between the members of a group
  double time_to_collision = NONE;         ///< with people, at constant velocities; NaN: never [s]
  double conflict_by_robot = 0.0;          ///< resolved by its change of velocity, see resolvedConflict() [m]
  double conflict_by_people = 0.0;         ///< resolved by people's changes of velocity [m]
  double obstacle_clearance = NONE;        ///< to the nearest wall or obstacle [m]
  std::uint64_t people_contacts = 0;       ///< number of people with whom it is in contact
  bool at_wall = false;                    ///< within 1 mm
  bool at_obstacle = false;
  bool at_robot = false;
  bool impact = false;                    ///< an impact or a jump changed its velocity
  bool jumped = false;                    ///< it was put elsewhere: it has no step and no rotation
  double social_force_on_robot = 0.0;     ///< [m/s^2]
  double social_force_on_agents = 0.0;    ///< [m/s^2]
  double social_work = 0.0;               ///< [m/s^2]
  double obstacle_force_on_robot = 0.0;   ///< [m/s^2]
  double obstacle_force_on_agents = 0.0;  ///< mean over the people [m/s^2]

  /// @brief Calls visit(name, value) for each column of a time series. `name` is a MetricName.
  template <typename Visit>
  static void visitFields(const Visit& visit, const RobotSample& sample) {
    visit(MetricName{"x", "m"}, sample.pose.position.x());
    visit(MetricName{"y", "m"}, sample.pose.position.y());
    visit(MetricName{"heading", "rad"}, sample.pose.heading);
    visit(MetricName{"vx", "m/s"}, sample.velocity.x());
    visit(MetricName{"vy", "m/s"}, sample.velocity.y());
    visit(MetricName{"speed", "m/s"}, sample.speed);
    visit(MetricName{"rotation", "rad/s"}, sample.rotation);
    visit(MetricName{"acceleration", "m/s^2"}, sample.acceleration);
    visit(MetricName{"jerk", "m/s^3"}, sample.jerk);
    visit(MetricName{"goal"}, sample.goal);
    visit(MetricName{"goal_distance", "m"}, sample.goal_distance);
    visit(MetricName{"goal_angle", "rad"}, sample.goal_angle);
    visit(MetricName{"people"}, sample.people);
    visit(MetricName{"nearest_person", "m"}, sample.nearest_person);
    visit(MetricName{"people_clearance", "m"}, sample.people_clearance);
    visit(MetricName{"group_distance", "m"}, sample.group_distance);
    visit(MetricName{"in_group"}, sample.in_group);
    visit(MetricName{"time_to_collision", "s"}, sample.time_to_collision);
    visit(MetricName{"conflict_by_robot", "m"}, sample.conflict_by_robot);
    visit(MetricName{"conflict_by_people", "m"}, sample.conflict_by_people);
    visit(MetricName{"obstacle_clearance", "m"}, sample.obstacle_clearance);
    visit(MetricName{"people_contacts"}, sample.people_contacts);
    visit(MetricName{"at_wall"}, sample.at_wall);
    visit(MetricName{"at_obstacle"}, sample.at_obstacle);
    visit(MetricName{"at_robot"}, sample.at_robot);
    visit(MetricName{"impact"}, sample.impact);
    visit(MetricName{"social_force_on_robot", "m/s^2"}, sample.social_force_on_robot);
    visit(MetricName{"social_force_on_agents", "m/s^2"}, sample.social_force_on_agents);
    visit(MetricName{"social_work", "m/s^2"}, sample.social_work);
    visit(MetricName{"obstacle_force_on_robot", "m/s^2"}, sample.obstacle_force_on_robot);
    visit(MetricName{"obstacle_force_on_agents", "m/s^2"}, sample.obstacle_force_on_agents);
  }
};

}  // namespace crowd
