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
      last_(start),
      goals_set_(robot.goals_set),
      way_on_({robot.pose, {}}),
      progress_(options, tick_duration) {
  noteStates(start);
}

void RobotTrack::setGoals(const Robot& robot, ShortestWay way) {
  if (std::exchange(success_, false)) {
    addStretch({way_on_.begin, {arrival_}}, stretches_);
    way_on_ = {last_.pose, {}};
  }
  goals_ = robot.goals;
  goals_set_ = robot.goals_set;
  next_goal_ = 0;
  way_ = std::move(way);
  way_on_.stops.clear();
  legs_.clear();
  final_distance_ = RobotResult::NONE;
  last_goal_distance_ = Statistic();
  if (goals_.empty()) return;
  if (way_on_.begin.position != last_.pose.position) way_on_.stops.push_back(last_.pose.position);
  way_on_.stops.insert(way_on_.stops.end(), goals_.begin(), goals_.end());
  legs_.push_back({last_.pose, {}});
  progress_.beginGoal((goals_[next_goal_] - last_.pose.position).norm());
}

void RobotTrack::add(const ObservedRobot& observed, const RobotSample& sample) {
  if (sample.jumped) noteJump(sample);
  ++ticks_;
  const double step = sample.jumped ? 0.0 : (sample.pose.position - last_.pose.position).norm();
  addContacts(*observed.contacts, sample);
  addPeople(sample);
  path_length_ += step;
  addMotion(sample);
  last_ = sample;
  addProgress(*observed.robot, sample, step);
  success_ = observed.robot->hasArrived();
  if (success_) arrival_ = sample.pose.position;
}

void RobotTrack::follow(const RobotSample& sample) {
  last_ = sample;
  noteStates(sample);
}

/// Notes what the robot is at: only what begins later is counted.
void RobotTrack::noteStates(const RobotSample& sample) {
  wall_.is_there = sample.at_wall;
  obstacle_.is_there = sample.at_obstacle;
  other_robot_.is_there = sample.at_robot;
  in_group_.is_there = sample.in_group;
}

/// Adds a stretch unless the robot stayed where it was.
void RobotTrack::addStretch(Stretch stretch, std::vector<Stretch>& stretches) {
  const auto is_begin = [&](const Vector2& stop) { return stop == stretch.begin.position; };
  if (std::all_of(stretch.stops.begin(), stretch.stops.end(), is_begin)) return;
  stretches.push_back(std::move(stretch));
}

/// The shortest ways lead up to the place before the jump, and on from that after it.
void RobotTrack::noteJump(const RobotSample& sample) {
  const auto left = static_cast<std::ptrdiff_t>(goals_.size() - next_goal_);
  std::vector<Vector2> stops(way_on_.stops.begin(), way_on_.stops.end() - left);
  stops.push_back(last_.pose.position);
  addStretch({way_on_.begin, std::move(stops)}, stretches_);
  way_on_ = {sample.pose, {goals_.end() - left, goals_.end()}};
  if (goals_.empty()) return;
  Leg& leg = legs_.back();
  addStretch({leg.begin, {last_.pose.position}}, leg.stretches);
  leg.begin = sample.pose;
  progress_.beginGoal(sample.goal_distance);
}

void RobotTrack::addMotion(const RobotSample& sample) {
  const double turn = sample.jumped ? 0.0 : std::abs(wrapAngle(sample.pose.heading - last_.pose.heading));
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
  conflicts_by_robot_ += sample.conflict_by_robot;
  conflicts_by_people_ += sample.conflict_by_people;
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
  legs_.push_back({sample.pose, {}});
  progress_.beginGoal((goals_[next_goal_] - sample.pose.position).norm());
}

}  // namespace crowd
