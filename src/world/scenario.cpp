#include "social_crowd/world/scenario.h"

#include <cmath>

#include "social_crowd/common/errors.h"

namespace crowd {

Vector2 Region::draw(KeyedRandom& random) const {
  if (kind == Kind::BOX) {
    const double x = random.uniform(first.x(), second.x());
    return {x, random.uniform(first.y(), second.y())};
  }
  if (kind == Kind::RING) {
    const double bearing = random.uniform(-PI, PI);
    // Evenly over the area: the square of the distance is what is uniform.
    const double squared = random.uniform(radius.low * radius.low, radius.high * radius.high);
    return first + (radius.isFixed() ? radius.low : std::sqrt(squared)) * unitVector(bearing);
  }
  return first;
}

Scene ScenarioList::scene(std::uint64_t run_seed, std::uint64_t episode) const {
  if (scenarios_.empty()) {
    throw InputError("there is no scenario to play");
  }
  return scenarios_[episode % scenarios_.size()].instantiate(run_seed, episode);
}

}  // namespace crowd
