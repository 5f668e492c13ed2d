#include "geometry/robot_sweep.h"

#include <algorithm>
#include <cmath>

#include "geometry/impact.h"

namespace crowd {
namespace {

/// Smallest step of the search, as a share of a tick.
constexpr double STEP = 1e-3;
/// Accuracy of the time of a touch, as a share of a tick.
constexpr double ACCURACY = 1e-12;

/// Distance at which a polygon touches what it would cut [m]. Its distance to a wall is 0 wherever it cuts the wall, so
/// that only a distance from 0 to this one shows that it comes nearer; it is larger than LEAST_APPROACH.
constexpr double SKIN = 1e-9;

double skinOf(const Footprint& footprint) { return footprint.isDisc() ? 0.0 : SKIN; }

/// The last time at which a distance is above 0, from one at which it is to one at which it is not.
template <typename Distance>
double lastBefore(const Distance& distance_at, double time, double end) {
  while (end - time > ACCURACY) {
    const double middle = 0.5 * (time + end);
    (distance_at(middle) > 0.0 ? time : end) = middle;
  }
  return time;
}

/// Time at which a distance that changes by at most `speed` in a tick first becomes 0, see firstTouch().
template <typename Distance>
double firstZero(const Distance& distance_at, double speed, double from) {
  double time = from;
  double distance = distance_at(time);
  if (distance > speed * (1.0 - from)) return NO_IMPACT;
  while (time < 1.0) {
    double end = std::min(1.0, time + std::max(STEP, distance / speed));
    double next = distance_at(end);
    if (next > 0.0 || next >= distance - LEAST_APPROACH) {
      time = end;
      distance = next;
      continue;
    }
    if (distance <= 0.0) return time;
    return lastBefore(distance_at, time, end);
  }
  return NO_IMPACT;
}

}  // namespace

RobotSweep::RobotSweep(const Footprint& footprint, const Pose& from, const Pose& to)
    : footprint_(&footprint),
      start_(from),
      is_straight_(true),
      way_(to.position - from.position),
      turn_(wrapAngle(to.heading - from.heading)) {}

Pose RobotSweep::at(double share) const {
  const double time = std::max(0.0, std::min(share, stopped_at_) - since_);
  if (is_straight_) return {start_.position + time * way_, start_.heading + time * turn_};
  return drivePose(start_, twist_, time * tick_duration_);
}

double RobotSweep::pointSpeed(double from) const {
  if (stopped_at_ <= from) return 0.0;
  const double reach = footprint_->isDisc() ? 0.0 : footprint_->reach();  // a disc does not move by turning
  if (is_straight_) return way_.norm() + std::abs(turn_) * reach;
  return (twist_.linear.norm() + std::abs(twist_.rotation) * reach) * tick_duration_;
}

double RobotSweep::slidingSpeed(const WallSliding& sliding) const {
  const double rotation = std::max(std::abs(twist_.rotation), sliding.max_rotation);
  const double turned = footprint_->isDisc() ? 0.0 : 2.0 * rotation * footprint_->reach();  // also by the margin
  return (twist_.linear.norm() + turned * (1.0 + rotation * tick_duration_)) * tick_duration_;
}

BodyMotion RobotSweep::motionAt(double share) const {
  const bool has_stopped = stopped_at_ < 1.0 && stopped_at_ <= share;
  if (has_stopped || tick_duration_ <= 0.0) return {};
  if (is_straight_) return {way_ / tick_duration_, turn_ / tick_duration_};
  return {Rotation(at(share).heading).outOfFrame(twist_.linear), twist_.rotation};
}

void RobotSweep::slideAt(double share, const std::vector<WallContact>& contacts, const WallSliding& sliding) {
  const double rest = (1.0 - share) * tick_duration_;
  const BodyMotion motion = slideAlongWalls(*footprint_, contacts, motionAt(share), sliding, rest);
  start_ = at(share);
  since_ = share;
  is_straight_ = true;
  way_ = tick_duration_ * motion.velocity;
  turn_ = tick_duration_ * motion.rotation;
  has_slid_ = true;
}

void RobotSweep::stopAt(double share) { stopped_at_ = std::min(stopped_at_, share); }

double firstTouch(const RobotSweep& sweep, const Vector2& position, const Vector2& way, double radius, double from) {
  const double speed = sweep.pointSpeed(from) + way.norm();
  if (speed <= 0.0) return NO_IMPACT;
  const Footprint& footprint = sweep.footprint();
  const double apart = (position - sweep.at(from).position).norm() - footprint.reach() - radius;
  if (apart > speed * (1.0 - from)) return NO_IMPACT;
  const auto distance_at = [&](double time) {
    return distance(footprint, sweep.at(time), Vector2(position + (time - from) * way)) - radius;
  };
  return firstZero(distance_at, speed, from);
}

double firstTouch(const RobotSweep& sweep, const Segment& segment, double from) {
  const double speed = sweep.pointSpeed(from);
  if (speed <= 0.0) return NO_IMPACT;
  const Footprint& footprint = sweep.footprint();
  const double skin = skinOf(footprint);
  const double apart = distanceTo(segment, sweep.at(from).position) - footprint.reach() - skin;
  if (apart > speed * (1.0 - from)) return NO_IMPACT;
  const auto distance_at = [&](double time) { return distance(footprint, sweep.at(time), segment) - skin; };
  return firstZero(distance_at, speed, from);
}

double touchUntil(const RobotSweep& sweep, const Segment& segment, double from, double to) {
  const double skin = skinOf(sweep.footprint());
  const auto distance_at = [&](double time) { return distance(sweep.footprint(), sweep.at(time), segment) - skin; };
  return distance_at(from) > 0.0 && distance_at(to) < -LEAST_APPROACH ? lastBefore(distance_at, from, to) : to;
}

double firstTouch(const RobotSweep& first, const RobotSweep& second, double from) {
  const double speed = first.pointSpeed(from) + second.pointSpeed(from);
  if (speed <= 0.0) return NO_IMPACT;
  const double skin = std::min(skinOf(first.footprint()), skinOf(second.footprint()));
  const double apart = (first.at(from).position - second.at(from).position).norm() - first.footprint().reach() -
                       second.footprint().reach() - skin;
  if (apart > speed * (1.0 - from)) return NO_IMPACT;
  const auto distance_at = [&](double time) {
    return distance(first.footprint(), first.at(time), second.footprint(), second.at(time)) - skin;
  };
  return firstZero(distance_at, speed, from);
}

}  // namespace crowd
