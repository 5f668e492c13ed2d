#include "ros/messages/vision.h"

#include <algorithm>
#include <limits>

#include "common/text/numbers.h"

namespace crowd {
namespace {

constexpr double ALL_WALLS = std::numeric_limits<double>::infinity();

}  // namespace

Vision widest(const Vision& a, const Vision& b) {
  Vision wide;
  wide.radius = std::max(a.radius, b.radius);
  wide.occlusion = a.occlusion && b.occlusion && a.radius == b.radius;
  const bool must_add_occlusion = (a.occlusion || b.occlusion) && !wide.occlusion;
  const bool is_unlimited = a.max_neighbours == 0 || b.max_neighbours == 0 || must_add_occlusion;
  wide.max_neighbours = is_unlimited ? 0 : std::max(a.max_neighbours, b.max_neighbours);
  wide.wall_distance = std::max(a.wall_distance, b.wall_distance);
  wide.motion = a.motion && b.motion ? widest(*a.motion, *b.motion) : a.motion ? a.motion : b.motion;
  return wide;
}

bool covers(const Vision& vision, const Vision& needed) {
  Vision known = vision;
  const bool needs_limits = needed.motion && needed.motion->areOn();
  if (!known.motion && !needs_limits) known.motion = needed.motion;  // motion is unlimited until a model limits it
  return areEqual(widest(known, needed), known);
}

bool areEqual(const Vision& a, const Vision& b) {
  return a.radius == b.radius && a.max_neighbours == b.max_neighbours && a.occlusion == b.occlusion &&
         a.wall_distance == b.wall_distance && a.motion == b.motion;
}

std::string toText(const Vision& vision) {
  return "radius " + toText(vision.radius) + " m, " +
         (vision.max_neighbours == 0 ? "any number of" : "at most " + std::to_string(vision.max_neighbours)) +
         " neighbours, " + (vision.occlusion ? "with" : "without") + " occlusion, " +
         (vision.wall_distance == ALL_WALLS ? "all walls" : "walls up to " + toText(vision.wall_distance) + " m") +
         (vision.motion ? ", motion " + toText(*vision.motion) : "");
}

double wallDistanceField(const Vision& vision) {
  return vision.wall_distance == ALL_WALLS ? 0.0 : vision.wall_distance;
}

double wallDistanceOf(double field) { return field == 0.0 ? ALL_WALLS : field; }

}  // namespace crowd
