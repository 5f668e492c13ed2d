// The results of a robot, from what was added up.

#include <algorithm>
#include <cmath>

#include "robots/metrics/robot_track.h"

namespace crowd {
namespace {

/// The greatest of some numbers; 0 without any.
double greatestOf(const Statistic& statistic) { return statistic.count() == 0 ? 0.0 : statistic.greatest(); }

/// What success counts for: its least amount of a quantity, such as time, divided by the amount that it took.
double weighted(bool success, double least, double taken) {
  if (std::isnan(least)) return success ? RobotResult::NONE : 0.0;
  if (!success) return 0.0;
  return taken > least ? least / taken : 1.0;
}

double ratioOf(double part, double whole) { return whole > 0.0 ? part / whole : RobotResult::NONE; }

}  // namespace

RobotResult RobotTrack::result() const {
  RobotResult result;
  result.name = name_;
  result.success = success_;
  result.timeout = !goals_.empty() && !success_;
  result.stuck = result.timeout && progress_.isStuck();
  result.failures_to_progress = progress_.failures();
  if (success_) result.time_to_reach_goal = seconds(ticks_);
  writeWay(result);
  writeMotion(result);
  writeContacts(result);
  writePeople(result);
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) result.goals.push_back(resultOf(goal));
  return result;
}

/// In percent of the time.
double RobotTrack::shareOf(std::uint64_t ticks) const {
  return ticks_ == 0 ? RobotResult::NONE : 100.0 * static_cast<double>(ticks) / static_cast<double>(ticks_);
}

void RobotTrack::writeWay(RobotResult& result) const {
  result.path_length = path_length_;
  if (goals_.empty()) return;
  const ShortestWay::Way way = shortest(stretches_, way_on_);
  const double length = way.length - goal_tolerance_;
  result.shortest_path_length = std::isnan(length) ? length : std::max(0.0, length);
  result.path_length_ratio = ratioOf(path_length_, length);
  if (success_ && path_length_ > 0.0) result.path_efficiency = result.shortest_path_length / path_length_;
  result.path_irregularity = std::isnan(way.turn) ? way.turn : std::max(0.0, rotation_ - way.turn);
  if (path_length_ > 0.0) result.avg_angle_to_goal = sum_of_angles_ / path_length_;
  result.spl = weighted(success_, result.shortest_path_length, path_length_);
  const double least_time = max_speed_ > 0.0 ? result.shortest_path_length / max_speed_ : RobotResult::NONE;
  result.stl = weighted(success_, least_time, seconds(ticks_));
  result.final_distance = final_distance_;
  result.minimum_distance_to_goal = last_goal_distance_.least();
}

void RobotTrack::writeMotion(RobotResult& result) const {
  result.stalled_time = seconds(stalled_ticks_);
  result.min_speed = speed_.least();
  result.avg_robot_linear_speed = speed_.mean();
  result.max_speed = greatestOf(speed_);
  if (ticks_ > 0) result.avg_robot_angular_speed = rotation_ / seconds(ticks_);
  result.min_acceleration = acceleration_.least();
  result.avg_acceleration = acceleration_.mean();
  result.max_acceleration = greatestOf(acceleration_);
  result.min_jerk = jerk_.least();
  result.avg_jerk = jerk_.mean();
  result.max_jerk = greatestOf(jerk_);
  result.cumulative_heading_changes = rotation_;
  result.time_not_moving = seconds(still_ticks_);
}

void RobotTrack::writeContacts(RobotResult& result) const {
  result.robot_on_person_collisions = by_robot_;
  result.person_on_robot_collisions = by_person_;
  result.mutual_collisions = mutual_;
  result.people_contacts = result.collisions();
  result.contact_time = seconds(contact_ticks_);
  result.wall_contacts = wall_.count;
  result.obstacle_contacts = obstacle_.count;
  result.robot_contacts = other_robot_.count;
  result.contacts = result.people_contacts + result.wall_contacts + result.obstacle_contacts + result.robot_contacts;
  result.minimum_obstacle_clearance = obstacle_clearance_.least();
  result.avg_obstacle_clearance = obstacle_clearance_.mean();
}

void RobotTrack::writePeople(RobotResult& result) const {
  result.minimum_distance_to_people = nearest_person_.least();
  result.maximum_distance_to_people = farthest_person_.greatest();
  result.avg_closest_person = nearest_clearance_.mean();
  result.minimum_clearance = people_clearance_.least();
  result.minimum_time_to_collision = time_to_collision_.least();
  result.responsibility = ratioOf(conflicts_by_robot_, conflicts_by_robot_ + conflicts_by_people_);
  if (ticks_ > 0) result.space_compliance = static_cast<double>(ticks_ - near_ticks_) / static_cast<double>(ticks_);
  result.intimate_space_time = seconds(spaces_.intimate);
  result.personal_space_time = seconds(spaces_.personal);
  result.intimate_space_intrusions = shareOf(spaces_.intimate);
  result.personal_space_intrusions = shareOf(spaces_.personal - spaces_.intimate);
  result.social_space_intrusions = shareOf(spaces_.social - spaces_.personal);
  result.group_intimate_space_intrusions = shareOf(group_spaces_.intimate);
  result.group_personal_space_intrusions = shareOf(group_spaces_.personal - group_spaces_.intimate);
  result.group_social_space_intrusions = shareOf(group_spaces_.social - group_spaces_.personal);
  result.group_intrusions = in_group_.count;
  if (people_ > 0) result.avg_pedestrian_velocity = people_speed_ / static_cast<double>(people_);
  result.avg_closest_pedestrian_velocity = nearest_speed_.mean();
  result.social_force_on_robot = force_on_robot_;
  result.social_force_on_agents = force_on_people_;
  result.social_work = social_work_;
  result.obstacle_force_on_robot = obstacle_force_;
  result.obstacle_force_on_agents = obstacle_force_on_people_;
}

double RobotTrack::meanPeople() const {
  return ticks_ > 0 ? static_cast<double>(people_) / static_cast<double>(ticks_) : RobotResult::NONE;
}

/// The shortest way on some stretches and a last one.
ShortestWay::Way RobotTrack::shortest(const std::vector<Stretch>& stretches, const Stretch& last) const {
  ShortestWay::Way sum = way_.via(last.begin, last.stops);
  for (const Stretch& stretch : stretches) {
    const ShortestWay::Way way = way_.via(stretch.begin, stretch.stops);
    sum.length += way.length;
    sum.turn += way.turn;
  }
  return sum;
}

RobotGoalResult RobotTrack::resultOf(std::size_t goal) const {
  RobotGoalResult result;
  result.x = goals_[goal].x();
  result.y = goals_[goal].y();
  if (goal >= legs_.size()) {
    result.spl = 0.0;
    return result;
  }
  const Leg& leg = legs_[goal];
  result.success = leg.is_reached;
  if (leg.is_reached) result.time_to_reach_goal = seconds(leg.ticks);
  result.path_length = leg.path_length;
  const double length = shortest(leg.stretches, {leg.begin, {goals_[goal]}}).length - goal_tolerance_;
  result.shortest_path_length = std::isnan(length) ? length : std::max(0.0, length);
  result.path_length_ratio = ratioOf(leg.path_length, length);
  result.spl = weighted(leg.is_reached, result.shortest_path_length, leg.path_length);
  return result;
}

}  // namespace crowd
