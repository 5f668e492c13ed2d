#include "population/place_ways.h"

#include "social_crowd/errors.h"

namespace crowd {

PlacePicker::Reach PlaceWays::reachIn(const World& world) {
  return [this, &world](const Vector2& from, const Vector2& to, double radius) {
    try {
      return !ways_ || ways_->connects(world, from, to, radius);
    } catch (const InputError&) {  // the floor is too large: the episode goes on without way-finding
      return true;
    }
  };
}

PlaceWays::Exit PlaceWays::nearestSink(const std::vector<SinkDescription>& sinks, const PlacePicker& places,
                                       const Vector2& from, double radius, const World& world) {
  Exit nearest{0, from};
  std::optional<WayLengths::Way> shortest;
  for (std::size_t sink = 0; sink < sinks.size(); ++sink) {
    const Vector2 place = places.nearestIn(sinks[sink].area, from, radius, world);
    const WayLengths::Way way = wayTo(place, from, radius, world);
    if (shortest && !(way < *shortest)) continue;
    shortest = way;
    nearest = {sink, place};
  }
  return nearest;
}

WayLengths::Way PlaceWays::wayTo(const Vector2& place, const Vector2& from, double radius, const World& world) {
  const WayLengths::Way straight{WayLengths::Kind::STRAIGHT, (place - from).norm()};
  if (!ways_) return straight;
  try {
    return ways_->find(world, from, place, radius).value_or(straight);
  } catch (const InputError&) {  // as above
    return straight;
  }
}

}  // namespace crowd
