#include "robots/metrics/robot_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crowd {
namespace {

/// What success counts for: its least amount of a quantity, such as time, divided by the amount that it took.
double weighted(bool success, double least, double taken) {
  if (std::isnan(least)) return success ? RobotResult::NONE : 0.0;
  if (!success) return 0.0;
  return taken > least ? least / taken : 1.0;
}

}  // namespace

RobotTrack::RobotTrack(const RobotMetricOptions& options, double tick_duration, const Robot& robot,
                       const RobotSample& start)
    : stalled_speed_(options.stalled_speed),
      name_(robot.start.name),
      max_speed_(robot.start.limits.max_speed),
      goal_tolerance_(robot.start.goal_tolerance),
      last_(start),
      goals_set_(robot.goals_set),
      way_on_({robot.pose, {}}),
      progress_(options, tick_duration),
      time_{tick_duration} {
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
  ++time_.ticks;
  const double step = sample.jumped ? 0.0 : (sample.pose.position - last_.pose.position).norm();
  contacts_.add(*observed.contacts, sample);
  people_.add(sample);
  motion_.add(sample, last_, stalled_speed_, time_.tick_duration);
  path_length_ += step;
  last_ = sample;
  addProgress(*observed.robot, sample, step);
  success_ = observed.robot->hasArrived();
  if (success_) arrival_ = sample.pose.position;
}

void RobotTrack::follow(const RobotSample& sample) {
  last_ = sample;
  noteStates(sample);
}

void RobotTrack::noteStates(const RobotSample& sample) {
  contacts_.note(sample);
  people_.note(sample);
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

RobotResult RobotTrack::result() const {
  RobotResult result;
  result.name = name_;
  result.success = success_;
  result.timeout = !goals_.empty() && !success_;
  result.stuck = result.timeout && progress_.isStuck();
  result.failures_to_progress = progress_.failures();
  if (success_) result.time_to_reach_goal = time_.seconds();
  writeWay(result);
  motion_.write(time_, result);
  contacts_.write(time_, result);
  people_.write(time_, result);
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) result.goals.push_back(resultOf(goal));
  return result;
}

void RobotTrack::writeWay(RobotResult& result) const {
  result.path_length = path_length_;
  if (goals_.empty()) return;
  const ShortestWay::Way way = shortest(stretches_, way_on_);
  const double length = way.length - goal_tolerance_;
  result.shortest_path_length = std::isnan(length) ? length : std::max(0.0, length);
  result.path_length_ratio = ratioOf(path_length_, length);
  if (success_ && path_length_ > 0.0) result.path_efficiency = result.shortest_path_length / path_length_;
  result.path_irregularity = std::isnan(way.turn) ? way.turn : std::max(0.0, motion_.rotation() - way.turn);
  if (path_length_ > 0.0) result.avg_angle_to_goal = sum_of_angles_ / path_length_;
  result.spl = weighted(success_, result.shortest_path_length, path_length_);
  const double least_time = max_speed_ > 0.0 ? result.shortest_path_length / max_speed_ : RobotResult::NONE;
  result.stl = weighted(success_, least_time, time_.seconds());
  result.final_distance = final_distance_;
  result.minimum_distance_to_goal = last_goal_distance_.least();
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
  if (leg.is_reached) result.time_to_reach_goal = time_.seconds(leg.ticks);
  result.path_length = leg.path_length;
  const double length = shortest(leg.stretches, {leg.begin, {goals_[goal]}}).length - goal_tolerance_;
  result.shortest_path_length = std::isnan(length) ? length : std::max(0.0, length);
  result.path_length_ratio = ratioOf(leg.path_length, length);
  result.spl = weighted(leg.is_reached, result.shortest_path_length, leg.path_length);
  return result;
}

}  // namespace crowd
