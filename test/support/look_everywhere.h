#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "support/sceneries.h"

/// Reference for the visible parts of a scenery without overlaps: lines of sight between all critical bearings.
namespace crowd::sceneries {

constexpr double NO_HIT = std::numeric_limits<double>::infinity();

/// The distance at which a line of sight meets the body [m].
inline double sightTo(const Neighbour& neighbour, const Vector2& sight) {
  const double along = neighbour.position.dot(sight);
  const double aside = cross(sight, neighbour.position);
  if (along < 0.0 || std::abs(aside) > neighbour.radius) return NO_HIT;
  return along - std::sqrt(neighbour.radius * neighbour.radius - aside * aside);
}

inline double sightTo(const Segment& wall, const Vector2& sight) {
  const Vector2 along = wall.to - wall.from;
  const double share = cross(wall.from, sight) / cross(sight, along);
  const double distance = cross(wall.from, along) / cross(sight, along);
  return share >= 0.0 && share <= 1.0 && distance > 0.0 ? distance : NO_HIT;
}

/// The bearings at which anything begins, ends or crosses, in order.
inline std::vector<double> criticalBearings(const Scenery& scenery) {
  std::vector<double> bearings = {-PI, PI};
  for (const Neighbour& neighbour : scenery.neighbours) {
    const double half = std::asin(neighbour.radius / neighbour.position.norm());
    bearings.push_back(wrapAngle(bearingOf(neighbour.position) - half));
    bearings.push_back(wrapAngle(bearingOf(neighbour.position) + half));
  }
  for (const Segment& wall : scenery.walls) {
    bearings.push_back(bearingOf(wall.from));
    bearings.push_back(bearingOf(wall.to));
    for (const Segment& other : scenery.walls) {
      const Vector2 along = wall.to - wall.from;
      const double share = cross(other.from - wall.from, other.to - other.from) / cross(along, other.to - other.from);
      if (share > 0.0 && share < 1.0) bearings.push_back(bearingOf(wall.from + share * along));
    }
  }
  std::sort(bearings.begin(), bearings.end());
  return bearings;
}

/// A range of bearings from right to left, relative to the bearing of a body's centre.
struct Range {
  double from;
  double to;
};

/// The visible parts, from lines of sight in the middle between critical bearings: of each body the ranges in
/// which it is in front, from the right, and the total length of the visible parts of walls [m].
struct Seen {
  std::vector<std::vector<Range>> neighbours;
  double wall_length = 0.0;
};

/// Narrower ranges may be rounding errors.
constexpr double NARROW = 1e-7;

/// The same ranges from the right; adjacent ones are joined.
inline std::vector<Range> joined(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.from < b.from; });
  std::vector<Range> made;
  for (const Range& range : ranges) {
    if (made.empty() || range.from > made.back().to + 2.0 * NARROW) {
      made.push_back(range);
    } else {
      made.back().to = range.to;
    }
  }
  return made;
}

/// The length of wall between two lines of sight that meet it [m].
inline double lengthBetween(const Segment& wall, double right, double left) {
  const auto meet = [&](double bearing) -> Vector2 {
    const Vector2 along = wall.to - wall.from;
    const double share = cross(wall.from, unitVector(bearing)) / cross(unitVector(bearing), along);
    return wall.from + std::clamp(share, 0.0, 1.0) * along;
  };
  return (meet(left) - meet(right)).norm();
}

/// The body or wall that a line of sight meets first, or null.
template <typename Thing>
const Thing* firstMet(const std::vector<Thing>& things, const Vector2& sight, double& nearest) {
  const Thing* first = nullptr;
  for (const Thing& thing : things) {
    const double distance = sightTo(thing, sight);
    if (distance >= nearest) continue;
    nearest = distance;
    first = &thing;
  }
  return first;
}

/// The visible parts of a scenery with numbered bodies.
inline Seen lookEverywhere(const Scenery& scenery) {
  Seen seen;
  seen.neighbours.resize(scenery.neighbours.size());
  const std::vector<double> bearings = criticalBearings(scenery);
  for (std::size_t i = 1; i < bearings.size(); ++i) {
    const double half = 0.5 * (bearings[i] - bearings[i - 1]);
    const double middle = bearings[i - 1] + half;
    if (2.0 * half < NARROW) continue;
    double nearest = NO_HIT;
    const Neighbour* neighbour = firstMet(scenery.neighbours, unitVector(middle), nearest);
    const Segment* wall = firstMet(scenery.walls, unitVector(middle), nearest);
    if (wall != nullptr) {
      seen.wall_length += lengthBetween(*wall, bearings[i - 1], bearings[i]);
    } else if (neighbour != nullptr) {
      const double aside = wrapAngle(middle - bearingOf(neighbour->position));
      seen.neighbours[numberOf(*neighbour)].push_back({aside - half, aside + half});
    }
  }
  for (std::vector<Range>& ranges : seen.neighbours) ranges = joined(ranges);
  return seen;
}

}  // namespace crowd::sceneries
