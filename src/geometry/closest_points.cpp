#include "geometry/closest_points.h"

#include "simd/segment_gaps.h"

namespace crowd {

ClosestPoints closestPoints(const Segment& first, const Segment& second) {
  const simd::NearestPair pair = simd::nearestPair({first.from.x(), first.from.y(), first.to.x(), first.to.y()},
                                                   {second.from.x(), second.from.y(), second.to.x(), second.to.y()});
  return {{pair.first_x, pair.first_y}, {pair.second_x, pair.second_y}};
}

}  // namespace crowd
