#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/neighbour_grid.h"
#include "support/scenes.h"
#include "support/seeds.h"

/// Grids of discs for tests, and a search of all discs as a reference.
namespace crowd::neighbour_grids {

using Disc = NeighbourGrid::Disc;
using Found = std::vector<std::uint32_t>;

inline NeighbourGrid gridOf(const std::vector<Disc>& discs, double cell_size) {
  NeighbourGrid grid;
  for (const Disc& disc : discs) grid.add(disc.centre, disc.radius, disc.body);
  grid.build(cell_size);
  return grid;
}

inline Found find(const NeighbourGrid& grid, const Vector2& point, double distance) {
  Found found;
  grid.findNear(point, distance, found);
  return found;
}

inline Found sorted(Found found) {
  std::sort(found.begin(), found.end());
  return found;
}

/// Reference: a search of all discs.
inline Found lookAtAll(const std::vector<Disc>& discs, const Vector2& point, double distance) {
  Found found;
  for (const Disc& disc : discs) {
    const double rim = std::hypot(disc.centre.x() - point.x(), disc.centre.y() - point.y()) - disc.radius;
    if (rim <= distance) found.push_back(disc.body);
  }
  return found;
}

/// Random discs, some in clusters and some very far away; in a third of the cases at most 40, so that the grid may be a
/// list without cells. Bodies are numbered 7, 10, 13, ...
inline std::vector<Disc> randomDiscs(KeyedRandom& random, double extent) {
  std::vector<Disc> discs(random.below(random.below(3) == 0 ? 41 : 501));
  Vector2 cluster = Vector2::Zero();
  std::uint32_t body = 7;
  for (Disc& disc : discs) {
    if (random.below(20) == 0) cluster = scenes::randomPoint(random, extent);
    const std::uint32_t kind = random.below(10);
    const double spread = kind < 5 ? 1.0 : extent;
    disc.centre = scenes::randomPoint(random, spread);
    if (kind < 5) disc.centre += cluster;
    if (kind == 9) disc.centre *= 100.0;
    disc.radius = random.uniform(0.0, kind == 0 ? 3.0 : 0.5);
    disc.body = body;
    body += 3;
  }
  return discs;
}

/// Requires that searches from points among and outside the discs, near and far, agree with the reference.
inline void compareWithAll(const std::vector<Disc>& discs, double cell_size, double extent, KeyedRandom& random) {
  const NeighbourGrid grid = gridOf(discs, cell_size);
  const auto compare = [&](const Vector2& point, double distance) {
    SCOPED_TRACE(testing::Message() << "from " << point.x() << ", " << point.y() << " to " << distance);
    EXPECT_EQ(sorted(find(grid, point, distance)), lookAtAll(discs, point, distance));
  };
  for (int i = 0; i < 20; ++i) {
    compare(scenes::randomPoint(random, 2.0 * extent), random.uniform(0.0, extent));
    if (discs.empty()) continue;
    const Vector2 crowded = discs[random.below(static_cast<std::uint32_t>(discs.size()))].centre;
    compare(crowded + scenes::randomPoint(random, 1.0), random.uniform(0.0, 6.0));
  }
}

/// Calls check(discs, extent, random) for random discs of 60 seeds.
template <typename Check>
void checkManyPlaces(const Check& check) {
  forSeeds(60, KeyedRandom::PLACEMENT, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const double extent = random.uniform(1.0, 50.0);
    check(randomDiscs(random, extent), extent, random);
  });
}

}  // namespace crowd::neighbour_grids
