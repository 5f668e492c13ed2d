// Impacts of robots.

#include "geometry/impact.h"
#include "geometry/solid_motion.h"

namespace crowd {
namespace {

/// Time after which two bodies must have come closer for one of them to move towards the other, as a share of a tick.
constexpr double PROBE = 1e-3;

}  // namespace

double SolidMotion::touchOfRobot(const Body& first, const Body& second, double now) const {
  const Body& robot = first.isRobot() ? first : second;
  const Body& other = first.isRobot() ? second : first;
  const RobotSweep& sweep = sweeps_[robot.sweep];
  // A robot that has stopped stays where it is, also if an obstacle moves over it.
  const bool has_stopped = sweep.stoppedAt() <= now;
  if (!other.is_agent && has_stopped) return NO_IMPACT;
  if (other.isRobot()) return firstTouch(sweep, sweeps_[other.sweep], now);
  return firstTouch(sweep, other.at(now), other.way, other.radius, now);
}

double SolidMotion::distanceBetween(const Body& first, double first_time, const Body& second,
                                    double second_time) const {
  if (!first.isRobot()) return distanceBetween(second, second_time, first, first_time);
  const RobotSweep& sweep = sweeps_[first.sweep];
  const Pose pose = sweep.at(first_time);
  if (!second.isRobot()) return distance(sweep.footprint(), pose, second.at(second_time)) - second.radius;
  const RobotSweep& other = sweeps_[second.sweep];
  return distance(sweep.footprint(), pose, other.footprint(), other.at(second_time));
}

void SolidMotion::judgeRobot(const Impact& impact) {
  Body& body = bodies_[impact.agent];
  Body& other = bodies_[impact.other];
  const double now = impact.time;
  if (other.is_agent || other.isRobot()) other.touched = true;
  if (body.isRobot() != other.isRobot()) {
    touches_.push_back(body.isRobot() ? Touch{impact.other, impact.agent} : Touch{impact.agent, impact.other});
  }
  const bool is_obstacle = !other.is_agent && !other.isRobot();
  if (is_obstacle) return stop(impact.agent);
  const double apart = distanceBetween(body, now, other, now) - LEAST_APPROACH;
  const bool body_moves_in = distanceBetween(body, now + PROBE, other, now) < apart;
  const bool other_moves_in = distanceBetween(body, now, other, now + PROBE) < apart;
  if (!other.is_agent) {
    if (body_moves_in) stop(impact.agent);
    return;
  }
  if (body_moves_in || !other_moves_in) stop(impact.agent);
  if (other_moves_in || !body_moves_in) stop(impact.other);
}

}  // namespace crowd
