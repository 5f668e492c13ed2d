#include "robots/ring_scan.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"
#include "geometry/ray.h"
#include "robots/scan.h"

namespace crowd {
namespace {

/// Where a vertical plane of rays crosses a solid: from one distance to another [m], up to a height [m].
struct Crossing {
  double from = 0.0;
  double to = 0.0;
  double height = 0.0;
  double reflection = 0.0;
  double facing = 1.0;  // cosine of the angle between the plane and the normal of the side that is met
};

/// What a ray meets: at a horizontal distance [m]; infinite: nothing.
struct Meeting {
  double distance = INFINITE;
  double intensity = 0.0;
};

/// @param slope tangent of the elevation
void meet(const Crossing& crossing, double sensor_height, double slope, Meeting& nearest) {
  const double level = 1.0 / std::sqrt(1.0 + slope * slope);  // cosine of the elevation
  const double entry = sensor_height + crossing.from * slope;
  if (crossing.from < nearest.distance && entry >= 0.0 && entry <= crossing.height) {
    nearest = {crossing.from, crossing.reflection * crossing.facing * level};
    return;
  }
  if (slope >= 0.0 || entry <= crossing.height) return;
  const double top = (crossing.height - sensor_height) / slope;  // on it from above
  if (top <= crossing.to && top < nearest.distance) nearest = {top, crossing.reflection * -slope * level};
}

class RingScan {
 public:
  RingScan(const ScanSpec& spec, const Pose& sensor, const Span<Column>& columns, const Span<Panel>& panels,
           const WallIndex& walls)
      : spec_(spec), frame_(sensor.heading), origin_(sensor.position), walls_(walls) {
    for (const Column& column : columns) {
      if ((column.centre - origin_).norm() - column.radius < spec.max_range) columns_.push_back(column);
    }
    for (const Panel& panel : panels) {
      if (distanceTo(panel.base, origin_) < spec.max_range) panels_.push_back(panel);
    }
  }

  /// The solids that a vertical plane of rays crosses. @param unit of the rays, sensor frame
  const std::vector<Crossing>& crossingsAt(const Vector2& unit) {
    const Ray ray{origin_, frame_.outOfFrame(unit)};
    crossings_.clear();
    for (const Column& column : columns_) {
      const double from = distanceAlong(ray, column.centre, column.radius);
      if (from > spec_.max_range) continue;
      const double aside = cross(ray.unit, column.centre - origin_) / column.radius;
      const double facing = std::sqrt(std::max(0.0, 1.0 - aside * aside));
      crossings_.push_back({from, from + 2.0 * facing * column.radius, column.height, column.reflection, facing});
    }
    for (const Panel& panel : panels_) addSide(ray, panel.base, distanceAlong(ray, panel.base), panel);
    const double wall = walls_.firstHit(ray, spec_.max_range);
    if (wall < spec_.max_range) {
      crossings_.push_back({wall, wall, solids::WALL_HEIGHT, solids::WALL_REFLECTION, facingOf(ray, wall)});
    }
    return crossings_;
  }

 private:
  void addSide(const Ray& ray, const Segment& side, double distance, const Panel& panel) {
    if (distance > spec_.max_range) return;
    const Vector2 along = (side.to - side.from).normalized();
    crossings_.push_back({distance, distance, panel.height, panel.reflection, std::abs(cross(ray.unit, along))});
  }

  /// Of the wall that a ray meets at a distance.
  double facingOf(const Ray& ray, double distance) {
    const Vector2 place = ray.origin + distance * ray.unit;
    near_.clear();
    constexpr double ROUNDING = 1e-6;  // [m]
    walls_.findNear(place, ROUNDING, near_);
    double facing = 0.0;
    for (const std::uint32_t wall : near_) {
      const Segment& met = walls_.walls()[wall];
      facing = std::max(facing, std::abs(cross(ray.unit, (met.to - met.from).normalized())));
    }
    return facing;
  }

  const ScanSpec& spec_;
  Rotation frame_;
  Vector2 origin_;
  const WallIndex& walls_;
  std::vector<Column> columns_;
  std::vector<Panel> panels_;
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> near_;
};

}  // namespace

double heightOf(Figure figure) {
  if (figure == Figure::CHILD) return solids::CHILD_HEIGHT;
  return figure == Figure::WHEELCHAIR ? solids::SITTING_HEIGHT : solids::ADULT_HEIGHT;
}

double elevationOf(const ScanSpec& spec, std::uint32_t ring) {
  if (spec.rings < 2) return spec.lowest_ring;
  return spec.lowest_ring + (spec.highest_ring - spec.lowest_ring) * ring / (spec.rings - 1.0);
}

std::vector<ScanPoint> scanRings(const ScanSpec& spec, const Pose& sensor, const Span<Column>& columns,
                                 const Span<Panel>& panels, const WallIndex& walls, const KeyedRandom& key) {
  RingScan scan(spec, sensor, columns, panels, walls);
  const double increment = angleIncrement(spec);
  const bool is_random = spec.noise > 0.0 || spec.dropout > 0.0;
  std::vector<ScanPoint> points;
  for (std::uint32_t i = 0; i < spec.rays; ++i) {
    const Vector2 unit = unitVector(spec.first_angle + i * increment);
    const std::vector<Crossing>& crossings = scan.crossingsAt(unit);
    for (std::uint32_t ring = 0; ring < spec.rings; ++ring) {
      const double slope = portable::tan(elevationOf(spec, ring));
      const double stretch = std::sqrt(1.0 + slope * slope);  // of a horizontal distance
      Meeting nearest;
      if (slope < 0.0) nearest = {-spec.height / slope, solids::FLOOR_REFLECTION * -slope / stretch};
      for (const Crossing& crossing : crossings) meet(crossing, spec.height, slope, nearest);
      double range = nearest.distance * stretch;
      if (is_random) {
        KeyedRandom random = key.with(std::uint64_t{spec.rays} * (ring + 1) + i);  // not those of the flat scan
        range += spec.noise * random.normal();
        if (random.uniform() < spec.dropout) continue;
      }
      if (range < spec.min_range || range > spec.max_range) continue;
      const double level = range / stretch;
      points.push_back({static_cast<float>(level * unit.x()), static_cast<float>(level * unit.y()),
                        static_cast<float>(level * slope), static_cast<float>(nearest.intensity),
                        static_cast<std::uint16_t>(ring)});
    }
  }
  return points;
}

}  // namespace crowd
