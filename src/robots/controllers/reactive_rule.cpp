#include "robots/controllers/reactive_rule.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"
#include "robots/controllers/steering.h"
#include "robots/scan.h"

namespace crowd {
namespace {

constexpr double MARGIN = 0.1;               // around the robot [m]
constexpr int HEADINGS = 72;                 // every 5 degrees
constexpr double LEAST_SPEED_SHARE = 0.1;    // near the goal
constexpr double LONGEST_FREE_LENGTH = 3.0;  // longer ones are not better [m]

/// The points that the rays hit, in the robot's frame.
std::vector<Vector2> hitPoints(const ScanSpec& scan, const std::vector<float>& ranges) {
  const Rotation frame(scan.mount.heading);
  const double increment = angleIncrement(scan);
  std::vector<Vector2> points;
  for (std::size_t ray = 0; ray < ranges.size(); ++ray) {
    const double range = ranges[ray];
    if (std::isnan(range) || (std::isinf(range) && range > 0.0)) continue;
    const double bearing = scan.first_angle + static_cast<double>(ray) * increment;
    const double length = std::max(range, scan.min_range);
    points.emplace_back(scan.mount.position + frame.outOfFrame(length * unitVector(bearing)));
  }
  return points;
}

/// Length that a disc at the origin can move in a direction before it touches a point [m]. Points in the disc limit
/// moves towards them only.
double freeLength(const std::vector<Vector2>& points, const Vector2& direction, double radius) {
  double free = LONGEST_FREE_LENGTH;
  for (const Vector2& point : points) {
    const double along = direction.dot(point);
    const double aside = cross(direction, point);
    if (along <= 0.0 || std::abs(aside) >= radius) continue;
    free = std::min(free, std::max(0.0, along - std::sqrt(radius * radius - aside * aside)));
  }
  return free;
}

/// A heading relative to the robot [rad], and the free length in its direction [m].
struct Way {
  double heading = 0.0;
  double free = 0.0;
};

Way bestWay(const std::vector<Vector2>& points, const Vector2& goal, double radius) {
  Way best;
  double best_score = 0.0;
  const double to_goal = bearingOf(goal);
  for (int i = 0; i < HEADINGS; ++i) {
    // From the heading of the goal on, to both sides.
    const int step = (i + 1) / 2;
    const double turn = (i % 2 == 0 ? 2.0 : -2.0) * PI * step / HEADINGS;
    const double heading = wrapAngle(to_goal + turn);
    const double free = std::min(freeLength(points, unitVector(heading), radius), goal.norm());
    const double score = portable::cos(turn) * free;
    if (score <= best_score) continue;
    best_score = score;
    best = {heading, free};
  }
  return best;
}

}  // namespace

Twist reactiveCommand(const RobotStart& robot, const Vector2& goal, const std::vector<float>& ranges) {
  const DriveLimits& limits = robot.limits;
  const Way way = bestWay(hitPoints(robot.scan, ranges), goal, robot.footprint.reach() + MARGIN);
  const double near_goal = std::clamp(goal.norm() / SLOW_DOWN_DISTANCE, LEAST_SPEED_SHARE, 1.0);
  const double speed = std::min(limits.max_speed * near_goal, std::sqrt(2.0 * limits.max_acceleration * way.free));
  return steer(robot.drive, way.heading, speed);
}

}  // namespace crowd
