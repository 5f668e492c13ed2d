#pragma once

#include <cstdint>

#include "robots/metrics/beginnings.h"
#include "robots/metrics/measured_time.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/statistic.h"
#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief How near a robot came to people in an episode, and what it cost them: distances, spaces, conflicts, forces.
class PeopleMeasures {
 public:
  /// @brief Adds a tick.
  void add(const RobotSample& sample) {
    nearest_person_.addNumber(sample.nearest_person);
    farthest_person_.addNumber(sample.farthest_person);
    nearest_clearance_.addNumber(sample.nearest_person_clearance);
    people_clearance_.addNumber(sample.people_clearance);
    time_to_collision_.addNumber(sample.time_to_collision);
    nearest_speed_.addNumber(sample.nearest_person_speed);
    conflicts_by_robot_ += sample.conflict_by_robot;
    conflicts_by_people_ += sample.conflict_by_people;
    speed_ += sample.people > 0 ? sample.people_speed : 0.0;
    people_ += sample.people;
    near_ticks_ += sample.nearest_person < COMPLIANT_DISTANCE ? 1 : 0;
    spaces_.add(sample.nearest_person);
    group_spaces_.add(sample.group_distance);
    in_group_.add(sample.in_group);
    force_on_robot_ += sample.social_force_on_robot;
    force_on_people_ += sample.social_force_on_agents;
    social_work_ += sample.social_work;
    obstacle_force_ += sample.obstacle_force_on_robot;
    obstacle_force_on_people_ += sample.obstacle_force_on_agents;
  }

  /// @brief Notes where the robot is in a tick that does not count: only what begins later is counted.
  void note(const RobotSample& sample) { in_group_.is_there = sample.in_group; }

  /// @brief Sum over the ticks of the number of people.
  std::uint64_t people() const { return people_; }

  void write(const MeasuredTime& time, RobotResult& result) const {
    result.minimum_distance_to_people = nearest_person_.least();
    result.maximum_distance_to_people = farthest_person_.greatest();
    result.avg_closest_person = nearest_clearance_.mean();
    result.minimum_clearance = people_clearance_.least();
    result.minimum_time_to_collision = time_to_collision_.least();
    result.responsibility = ratioOf(conflicts_by_robot_, conflicts_by_robot_ + conflicts_by_people_);
    result.space_compliance = time.mean(static_cast<double>(time.ticks - near_ticks_));
    result.intimate_space_time = time.seconds(spaces_.intimate);
    result.personal_space_time = time.seconds(spaces_.personal);
    result.intimate_space_intrusions = time.percent(spaces_.intimate);
    result.personal_space_intrusions = time.percent(spaces_.personal - spaces_.intimate);
    result.social_space_intrusions = time.percent(spaces_.social - spaces_.personal);
    result.group_intimate_space_intrusions = time.percent(group_spaces_.intimate);
    result.group_personal_space_intrusions = time.percent(group_spaces_.personal - group_spaces_.intimate);
    result.group_social_space_intrusions = time.percent(group_spaces_.social - group_spaces_.personal);
    result.group_intrusions = in_group_.count;
    result.avg_pedestrian_velocity = ratioOf(speed_, static_cast<double>(people_));
    result.avg_closest_pedestrian_velocity = nearest_speed_.mean();
    result.social_force_on_robot = force_on_robot_;
    result.social_force_on_agents = force_on_people_;
    result.social_work = social_work_;
    result.obstacle_force_on_robot = obstacle_force_;
    result.obstacle_force_on_agents = obstacle_force_on_people_;
  }

 private:
  static constexpr double INTIMATE_DISTANCE = 0.45;  // Hall's spaces [m]
  static constexpr double PERSONAL_DISTANCE = 1.2;
  static constexpr double SOCIAL_DISTANCE = 3.6;
  static constexpr double COMPLIANT_DISTANCE = 0.5;  // [m]

  /// Ticks in which a distance was below those of Hall's spaces, each with the ticks of the smaller ones.
  struct Spaces {
    std::uint64_t intimate = 0;
    std::uint64_t personal = 0;
    std::uint64_t social = 0;
    void add(double distance) {
      intimate += distance < INTIMATE_DISTANCE ? 1 : 0;
      personal += distance < PERSONAL_DISTANCE ? 1 : 0;
      social += distance < SOCIAL_DISTANCE ? 1 : 0;
    }
  };

  Statistic nearest_person_;
  Statistic farthest_person_;
  Statistic nearest_clearance_;
  Statistic people_clearance_;
  Statistic time_to_collision_;
  Statistic nearest_speed_;
  double conflicts_by_robot_ = 0.0;  // resolved [m]
  double conflicts_by_people_ = 0.0;
  double speed_ = 0.0;        // sum over people and ticks [m/s]
  std::uint64_t people_ = 0;  // the same of their numbers
  std::uint64_t near_ticks_ = 0;
  Spaces spaces_;
  Spaces group_spaces_;
  Beginnings in_group_;
  double force_on_robot_ = 0.0;  // sums over the ticks [m/s^2]
  double force_on_people_ = 0.0;
  double social_work_ = 0.0;
  double obstacle_force_ = 0.0;
  double obstacle_force_on_people_ = 0.0;
};

}  // namespace crowd
