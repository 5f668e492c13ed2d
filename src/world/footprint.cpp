#include "social_crowd/world/footprint.h"

#include <algorithm>

namespace crowd {

double Footprint::reach() const {
  if (isDisc()) return radius;
  double farthest = 0.0;
  for (const Vector2& corner : corners) farthest = std::max(farthest, corner.norm());
  return farthest;
}

}  // namespace crowd
