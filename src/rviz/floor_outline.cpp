#include "rviz/floor_outline.h"

#include <cmath>

namespace crowd {
namespace {

constexpr int CORNERS = 36;

}  // namespace

std::vector<Vector2> circleOutline(const Vector2& centre, double radius) {
  std::vector<Vector2> points;
  for (int i = 0; i <= CORNERS; ++i) {
    const double angle = 2.0 * M_PI * i / CORNERS;
    points.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

FloorOutline crossOutline(const Vector2& centre, double radius) {
  const Vector2 across(radius, 0.0);
  const Vector2 along(0.0, radius);
  return {{centre - across, centre + across}, {centre - along, centre + along}};
}

}  // namespace crowd
