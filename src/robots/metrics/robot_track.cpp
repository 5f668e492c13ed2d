#include "robots/metrics/robot_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crowd {
namespace {

constexpr double STILL_SPEED = 0.001;       // [m/s]
constexpr double STILL_ROTATION = 0.01;     // [rad/s]
constexpr double INTIMATE_DISTANCE = 0.45;  // Hall's spaces [m]
constexpr double PERSONAL_DISTANCE = 1.2;
constexpr double SOCIAL_DISTANCE = 3.6;
constexpr double COMPLIANT_DISTANCE = 0.5;  // [m]

void addNumber(double value, Statistic& statistic) {
  if (!std::isnan(value)) statistic.add(value);
}

}  // namespace

RobotTrack::RobotTrack(const RobotMetricOptions& options, double tick_duration, const Robot& robot,
                       const RobotSample& start)
    : options_(options),
      tick_duration_(tick_duration),
      name_(robot.start.name),
      max_speed_(robot.start.limits.max_speed),
      goal_tolerance_(robot.start.goal_tolerance),
      start_(robot.pose),
      last_(start),
      progress_(options, tick_duration) {}

void RobotTrack::setGoals(const Robot& robot, ShortestWay way) {
  success_ = false;
  goals_ = robot.goals;
  next_goal_ = 0;
  way_ = std::move(way);
  stops_.clear();
  legs_.clear();
  if (goals_.empty()) return;
  if (ticks_ > 0) stops_.push_back(last_.pose.position);
  stops_.insert(stops_.end(), goals_.begin(), goals_.end());
  legs_.push_back({last_.pose});
  progress_.beginGoal((goals_[next_goal_] - last_.pose.position).norm());
}

void RobotTrack::add(const ObservedRobot& observed, const RobotSample& sample) {
  ++ticks_;
  const double step = (sample.pose.position - last_.pose.position).norm();
  addContacts(*observed.contacts, sample);
  addPeople(sample);
  path_length_ += step;
  addMotion(sample);
  last_ = sample;
  addProgress(*observed.robot, sample, step);
  success_ = observed.robot->hasArrived();
}

void RobotTrack::addMotion(const RobotSample& sample) {
  const double turn = std::abs(wrapAngle(sample.pose.heading - last_.pose.heading));
  rotation_ += turn;
  speed_.add(sample.speed);
  addNumber(sample.acceleration, acceleration_);
  addNumber(sample.jerk, jerk_);
  const bool is_still = sample.speed < STILL_SPEED && turn < STILL_ROTATION * tick_duration_;
  still_ticks_ += is_still ? 1 : 0;
  stalled_ticks_ += sample.speed < options_.stalled_speed ? 1 : 0;
}

void RobotTrack::addContacts(const std::vector<RobotContact>& contacts, const RobotSample& sample) {
  wall_.add(sample.at_wall);
  obstacle_.add(sample.at_obstacle);
  other_robot_.add(sample.at_robot);
  addNumber(sample.obstacle_clearance, obstacle_clearance_);
  contact_ticks_ += contacts.empty() ? 0 : 1;
  for (const RobotContact& contact : contacts) {
    if (!contact.begins) continue;
    by_robot_ += contact.cause == ContactCause::ROBOT ? 1 : 0;
    by_person_ += contact.cause == ContactCause::PERSON ? 1 : 0;
    mutual_ += contact.cause == ContactCause::MUTUAL ? 1 : 0;
  }
}

void RobotTrack::addPeople(const RobotSample& sample) {
  addNumber(sample.nearest_person, nearest_person_);
  addNumber(sample.farthest_person, farthest_person_);
  addNumber(sample.nearest_person_clearance, nearest_clearance_);
  addNumber(sample.people_clearance, people_clearance_);
  addNumber(sample.time_to_collision, time_to_collision_);
  addNumber(sample.nearest_person_speed, nearest_speed_);
  people_speed_ += sample.people > 0 ? sample.people_speed : 0.0;
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

void RobotTrack::Spaces::add(double distance) {
  intimate += distance < INTIMATE_DISTANCE ? 1 : 0;
  personal += distance < PERSONAL_DISTANCE ? 1 : 0;
  social += distance < SOCIAL_DISTANCE ? 1 : 0;
}

void RobotTrack::addProgress(const Robot& robot, const RobotSample& sample, double step) {
  progress_.add(sample.pose.position, sample.goal_distance);
  if (goals_.empty()) return;
  sum_of_angles_ += step * sample.goal_angle;
  final_distance_ = (goals_.back() - sample.pose.position).norm();
  last_goal_distance_.add(final_distance_);
  Leg& leg = legs_.back();
  leg.path_length += step;
  ++leg.ticks;
  leg.is_reached = robot.hasArrived() || robot.next_goal > next_goal_;
  if (robot.next_goal == next_goal_) return;
  next_goal_ = robot.next_goal;
  legs_.push_back({sample.pose});
  progress_.beginGoal((goals_[next_goal_] - sample.pose.position).norm());
}

}  // namespace crowd
