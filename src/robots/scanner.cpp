#include "robots/scanner.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

/// The angle [rad] in [0, 2 pi].
double positiveAngle(double angle) {
  const double wrapped = wrapAngle(angle);
  return wrapped < 0.0 ? wrapped + 2.0 * PI : wrapped;
}

}  // namespace

Scanner::Scanner(const ScanSpec& spec) : spec_(spec), increment_(angleIncrement(spec)), rays_(spec.rays) {
  units_.reserve(spec.rays);
  for (std::uint32_t i = 0; i < spec.rays; ++i) {
    units_.push_back(unitVector(spec.first_angle + static_cast<double>(i) * increment_));
  }
}

const Scan& Scanner::scan(const Pose& sensor, const Span<ScanTarget>& targets, const Span<ScanEdge>& edges,
                          const WallIndex& walls) {
  const Rotation frame(sensor.heading);
  for (std::size_t i = 0; i < rays_.size(); ++i) rays_[i] = {sensor.position, frame.outOfFrame(units_[i])};
  first_bearing_ = sensor.heading + spec_.first_angle;
  scan_.distances.assign(rays_.size(), INFINITE);
  scan_.hits.assign(rays_.size(), NO_HIT);
  for (const ScanTarget& target : targets) castAt(target);
  for (const ScanEdge& edge : edges) castAt(edge);
  castAt(walls);
  return scan_;
}

bool Scanner::reaches(const Vector2& point) const {
  const Vector2 offset = point - rays_.front().origin;
  const double distance = offset.norm();
  const double bearing = positiveAngle(bearingOf(offset) - first_bearing_);
  const bool is_before_first = 2.0 * PI - bearing < 0.5 * increment_;
  const std::size_t ray = is_before_first ? 0 : static_cast<std::size_t>(std::round(bearing / increment_));
  return ray < rays_.size() && distance <= spec_.max_range && distance < scan_.distances[ray];
}

template <typename Test>
void Scanner::forEachBetween(double low, double high, const Test& test) const {
  // The interval may lie one turn before or after the rays. Its ends are widened by one ray against rounding.
  const auto last = static_cast<std::int64_t>(rays_.size()) - 1;
  for (const double turn : {-2.0 * PI, 0.0, 2.0 * PI}) {
    const auto begin = static_cast<std::int64_t>(std::floor((low + turn) / increment_)) - 1;
    const auto end = static_cast<std::int64_t>(std::ceil((high + turn) / increment_)) + 1;
    for (std::int64_t i = std::max<std::int64_t>(0, begin); i <= std::min(last, end); ++i) {
      test(static_cast<std::size_t>(i));
    }
  }
}

void Scanner::castAt(const ScanTarget& target) {
  const Vector2 offset = target.centre - rays_.front().origin;
  const double reach = spec_.max_range + target.radius;
  if (!(offset.squaredNorm() <= reach * reach)) return;
  const double distance = offset.norm();
  const double bearing = positiveAngle(bearingOf(offset) - first_bearing_);
  const double half = distance > target.radius ? portable::asin(target.radius / distance) : PI;
  forEachBetween(bearing - half, bearing + half,
                 [&](std::size_t i) { note(i, distanceAlong(rays_[i], target.centre, target.radius), target.body); });
}

void Scanner::castAt(const WallIndex& walls) {
  // Few walls take less time each for the rays between its ends than all of them for each ray.
  if (walls.walls().size() <= WallIndex::FEW) {
    for (const Segment& wall : walls.walls()) castAt(ScanEdge{wall, WALL_HIT});
    return;
  }
  const double limit = std::nextafter(spec_.max_range, INFINITE);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    note(i, walls.firstHit(rays_[i], std::min(scan_.distances[i], limit)), WALL_HIT);
  }
}

void Scanner::castAt(const ScanEdge& edge) {
  constexpr double AT_SCANNER = 1e-6;  // [m]: its bearings are not certain any more
  const Vector2& origin = rays_.front().origin;
  const double apart = distanceTo(edge.edge, origin);
  if (apart > spec_.max_range + AT_SCANNER) return;
  if (apart < AT_SCANNER) {
    for (std::size_t i = 0; i < rays_.size(); ++i) note(i, distanceAlong(rays_[i], edge.edge), edge.body);
    return;
  }
  const double from = bearingOf(edge.edge.from - origin);
  const double turn = wrapAngle(bearingOf(edge.edge.to - origin) - from);
  const double begin = positiveAngle((turn < 0.0 ? from + turn : from) - first_bearing_);
  forEachBetween(begin, begin + std::abs(turn),
                 [&](std::size_t i) { note(i, distanceAlong(rays_[i], edge.edge), edge.body); });
}

void Scanner::note(std::size_t ray, double distance, BodyNumber body) {
  if (distance > spec_.max_range) return;
  double& nearest = scan_.distances[ray];
  BodyNumber& hit = scan_.hits[ray];
  if (distance > nearest || (distance == nearest && body >= hit)) return;
  nearest = distance;
  hit = body;
}

}  // namespace crowd
