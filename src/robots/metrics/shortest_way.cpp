#include "robots/metrics/shortest_way.h"

#include <algorithm>
#include <cmath>

#include "navigation/walking_floor.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// Radius of the largest disc about the origin in a footprint [m]; 0 if the origin is outside.
double innerRadius(const Footprint& footprint) {
  return std::max(0.0, -distance(footprint, Pose(), Vector2(Vector2::Zero())));
}

/// Adds the changes of direction on the way from a place via corners. @param heading at the place, then at the end
double turnOn(const Vector2& from, const std::vector<Vector2>& corners, double& heading) {
  double turn = 0.0;
  Vector2 place = from;
  for (const Vector2& corner : corners) {
    if (corner == place) continue;
    const double course = bearingOf(corner - place);
    turn += std::abs(wrapAngle(course - heading));
    heading = course;
    place = corner;
  }
  return turn;
}

}  // namespace

ShortestWay::ShortestWay(const ObservedScene& scene, const std::vector<Segment>& gates, const Footprint& footprint)
    : floor_(floorOf(scene, gates)), outer_radius_(footprint.reach()), inner_radius_(innerRadius(footprint)) {
  floor_.bounds = FloorPlan::Bounds{Vector2::Constant(INFINITE), Vector2::Constant(-INFINITE)};
  for (const Segment& wall : floor_.walls) {
    includePoint(wall.from, *floor_.bounds);
    includePoint(wall.to, *floor_.bounds);
  }
  for (const FloorPlan::Disc& disc : floor_.obstacles) includePoint(disc.centre, *floor_.bounds);
}

ShortestWay::Way ShortestWay::via(const Pose& from, const std::vector<Vector2>& places) {
  Way way;
  double heading = from.heading;
  Vector2 begin = from.position;
  for (const Vector2& place : places) {
    const std::optional<Path> path = find(begin, place);
    if (!path) return {std::nan(""), std::nan("")};
    way.length += path->length;
    way.turn += turnOn(begin, path->corners, heading);
    begin = place;
  }
  return way;
}

std::optional<Path> ShortestWay::find(const Vector2& from, const Vector2& to) {
  if (!hasBarriers(floor_) || is_too_large_) return Path{{to}, (to - from).norm()};
  if (!contains(*floor_.bounds, from) || !contains(*floor_.bounds, to)) query_.reset();
  includePoint(from, *floor_.bounds);
  includePoint(to, *floor_.bounds);
  std::optional<Path> path = findFor(outer_radius_, from, to);
  if (!path && !is_too_large_ && inner_radius_ < outer_radius_ && inner_radius_ > 0.0) {
    path = findFor(inner_radius_, from, to);
  }
  return is_too_large_ ? Path{{to}, (to - from).norm()} : path;
}

std::optional<Path> ShortestWay::findFor(double radius, const Vector2& from, const Vector2& to) {
  try {
    if (!query_ || radius_ != radius) {
      data_ = navigationData(floor_, radius);
      query_.emplace(data_->tight);
      radius_ = radius;
    }
    return query_->findPath(from, to);
  } catch (const InputError&) {  // the floor is too large
    is_too_large_ = true;
    return std::nullopt;
  }
}

}  // namespace crowd
