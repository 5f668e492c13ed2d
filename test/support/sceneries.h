#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/scenes.h"
#include "world/occlusion.h"

/// The surroundings of one agent in its frame, and their visible parts. Bodies are identified by their numbers, because
/// a partly hidden body is perceived at another position and smaller.
namespace crowd::sceneries {

constexpr double FAR = 100.0;  // radius of vision [m]

struct Scenery {
  std::vector<Neighbour> neighbours;
  std::vector<Segment> walls;
};

inline Neighbour neighbour(const Vector2& position, double radius) {
  Neighbour made;
  made.position = position;
  made.radius = radius;
  return made;
}

/// Stores the number in the velocity, which occlusion does not change.
inline void setNumber(Neighbour& neighbour, std::size_t number) {
  neighbour.velocity.x() = static_cast<double>(number);
}
inline std::size_t numberOf(const Neighbour& neighbour) { return static_cast<std::size_t>(neighbour.velocity.x()); }

/// The same with bodies numbered from 0 in their order.
inline Scenery numbered(Scenery scenery) {
  for (std::size_t i = 0; i < scenery.neighbours.size(); ++i) setNumber(scenery.neighbours[i], i);
  return scenery;
}

/// The body of that number, or null where it is not among them.
inline const Neighbour* find(const Scenery& scenery, std::size_t number) {
  const auto found = std::find_if(scenery.neighbours.begin(), scenery.neighbours.end(),
                                  [&](const Neighbour& neighbour) { return numberOf(neighbour) == number; });
  return found == scenery.neighbours.end() ? nullptr : &*found;
}

/// The visible parts.
inline Scenery look(Scenery scenery, double radius = FAR) {
  Occlusion occlusion;
  occlusion.apply(scenery.neighbours, 0, scenery.walls, 0, radius);
  return scenery;
}

inline void sortByRim(Scenery& scenery) {
  std::sort(scenery.neighbours.begin(), scenery.neighbours.end(),
            [](const Neighbour& a, const Neighbour& b) { return rimDistance(a) < rimDistance(b); });
}

inline bool overlap(const Neighbour& a, const Neighbour& b) {
  return (a.position - b.position).norm() < a.radius + b.radius;
}

/// Whether a body overlaps a wall or a body of the scenery other than the one of that number.
inline bool overlapsAny(const Neighbour& neighbour, const Scenery& scenery, std::size_t but) {
  return std::any_of(scenery.neighbours.begin(), scenery.neighbours.end(),
                     [&](const Neighbour& other) { return numberOf(other) != but && overlap(neighbour, other); }) ||
         std::any_of(scenery.walls.begin(), scenery.walls.end(),
                     [&](const Segment& wall) { return distanceTo(wall, neighbour.position) < neighbour.radius; });
}

/// Random bodies in order of their rims, and walls. With `apart`, bodies overlap neither each other nor walls, and no
/// rim is nearer than `clearance`.
inline Scenery randomScenery(std::uint64_t seed, bool apart, double clearance = 0.1) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  Scenery made;
  for (std::uint32_t i = random.below(4); i > 0; --i) {
    const Vector2 from = scenes::randomPoint(random, 6.0);
    made.walls.push_back({from, scenes::randomPoint(random, 6.0)});
  }
  for (std::uint32_t i = 2 + random.below(25); i > 0; --i) {
    Neighbour next = neighbour(scenes::randomPoint(random, 6.0), random.uniform(0.05, 1.0));
    setNumber(next, made.neighbours.size());
    const bool blocked = rimDistance(next) < clearance || overlapsAny(next, made, numberOf(next));
    if (!apart || !blocked) made.neighbours.push_back(next);
  }
  sortByRim(made);
  return numbered(made);
}

}  // namespace crowd::sceneries
