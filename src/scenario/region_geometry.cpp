#include "scenario/region_geometry.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr double MAX_STEPS = 100.0;  // in each direction

}  // namespace

bool contains(const Region& region, const Vector2& point) {
  if (region.kind == Region::Kind::RING) {
    const double distance = (point - region.first).norm();
    return distance >= region.radius.low && distance <= region.radius.high;
  }
  const Vector2& high = region.kind == Region::Kind::BOX ? region.second : region.first;
  return (point.array() >= region.first.array()).all() && (point.array() <= high.array()).all();
}

Vector2 nearestPoint(const Region& region, const Vector2& point) {
  if (region.kind == Region::Kind::BOX) return point.cwiseMax(region.first).cwiseMin(region.second);
  if (region.kind != Region::Kind::RING) return region.first;
  const Vector2 offset = point - region.first;
  const double distance = offset.norm();
  const Vector2 outward = distance > 0.0 ? Vector2(offset / distance) : Vector2::UnitX();
  return region.first + std::clamp(distance, region.radius.low, region.radius.high) * outward;
}

Vector2 middleOf(const Region& region) {
  return region.kind == Region::Kind::BOX ? Vector2(0.5 * (region.first + region.second)) : region.first;
}

Region shrink(const Region& region, double margin) {
  Region inner = region;
  if (region.kind == Region::Kind::BOX) {
    const Vector2 cut = (0.5 * (region.second - region.first)).cwiseMin(margin);
    inner.first += cut;
    inner.second -= cut;
  } else if (region.kind == Region::Kind::RING) {
    const bool is_disc = region.radius.low == 0.0;
    const double width = region.radius.high - region.radius.low;
    const double cut = std::min(margin, is_disc ? width : 0.5 * width);
    inner.radius.high -= cut;
    if (!is_disc) inner.radius.low += cut;
  }
  return inner;
}

std::vector<Vector2> gridPoints(const Region& region, double spacing) {
  if (region.kind == Region::Kind::POINT) return {region.first};
  const Vector2 reach = Vector2::Constant(region.radius.high);
  const bool is_box = region.kind == Region::Kind::BOX;
  const Vector2 low = is_box ? region.first : Vector2(region.first - reach);
  const Vector2 high = is_box ? region.second : Vector2(region.first + reach);
  const auto steps = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0, MAX_STEPS));
  };
  const int columns = steps(high.x() - low.x());
  const int rows = steps(high.y() - low.y());
  std::vector<Vector2> points;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const Vector2 share(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      const Vector2 point = low + share.cwiseProduct(high - low);
      if (contains(region, point)) points.push_back(point);
    }
  }
  return points;
}

}  // namespace crowd
