// Properties of the grid with random discs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/neighbour_grid.h"
#include "support/neighbour_grids.h"
#include "support/scenes.h"

namespace crowd::neighbour_grid_property_test {
namespace {

using neighbour_grids::checkManyPlaces;
using neighbour_grids::compareWithAll;
using neighbour_grids::Disc;
using neighbour_grids::find;
using neighbour_grids::Found;
using neighbour_grids::gridOf;
using neighbour_grids::lookAtAll;
using neighbour_grids::randomDiscs;
using neighbour_grids::sorted;

TEST(NeighbourGrid, FindsTheSameAsASearchOfAllDiscs) {
  std::size_t found_discs = 0;
  checkManyPlaces([&](const std::vector<Disc>& discs, double extent, KeyedRandom& random) {
    compareWithAll(discs, random.uniform(0.1, 4.0), extent, random);
    found_discs += lookAtAll(discs, {0.0, 0.0}, extent).size();
  });
  EXPECT_GT(found_discs, 1000U);  // or there was nothing to compare
}

TEST(NeighbourGrid, IsAnyNearAgreesWithFindNear) {
  std::size_t times = 0;
  checkManyPlaces([&](const std::vector<Disc>& discs, double /*extent*/, KeyedRandom& random) {
    const NeighbourGrid grid = gridOf(discs, random.uniform(0.1, 4.0));
    for (int i = 0; i < 50 && !discs.empty(); ++i) {
      const Disc& disc = discs[random.below(static_cast<std::uint32_t>(discs.size()))];
      const double distance = random.uniform(-0.5, random.below(4) == 0 ? 10.0 : 0.5);
      Found others = find(grid, disc.centre, distance);
      others.erase(std::remove(others.begin(), others.end(), disc.body), others.end());
      EXPECT_EQ(grid.isAnyNear(disc.centre, distance, disc.body), !others.empty());
      times += others.empty() ? 0 : 1;
    }
  });
  EXPECT_GT(times, 300U);   // or none was ever near
  EXPECT_LT(times, 2700U);  // or always
}

TEST(NeighbourGrid, RunsContainAllNearDiscsAndCountThem) {
  std::size_t lists = 0;
  checkManyPlaces([&](const std::vector<Disc>& discs, double extent, KeyedRandom& random) {
    const NeighbourGrid grid = gridOf(discs, random.uniform(0.1, 4.0));
    lists += grid.size() <= 32 ? 1 : 0;
    NeighbourGrid::Runs space;
    for (int i = 0; i < 50 && !discs.empty(); ++i) {
      const Vector2 point = scenes::randomPoint(random, extent);
      const double distance = random.uniform(0.0, 5.0);
      const NeighbourGrid::RunsNear near = grid.findRunsNear(point, distance, space);
      Found held;
      for (const NeighbourGrid::Run& run : near.runs) {
        for (std::uint32_t disc = run.begin; disc < run.end; ++disc) held.push_back(grid.body(disc));
      }
      EXPECT_EQ(near.discs, held.size());
      held = sorted(held);
      const Found found = sorted(find(grid, point, distance));
      EXPECT_TRUE(std::includes(held.begin(), held.end(), found.begin(), found.end()));
    }
  });
  EXPECT_GT(lists, 0U);
  EXPECT_LT(lists, 60U);
}

TEST(NeighbourGrid, IsAnyNearAgreesWithASearchOfAllDiscs) {
  std::size_t times = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<Disc> discs(1 + random.below(60));
    for (Disc& disc : discs) disc = {scenes::randomPoint(random, 8.0), random.uniform(0.0, 0.5), random.below(20)};
    const NeighbourGrid grid = gridOf(discs, 2.0);
    const Vector2 point = scenes::randomPoint(random, 8.0);
    const double distance = random.uniform(-0.5, 1.5);
    const std::uint32_t except = random.below(20);
    bool expected = false;
    for (const Disc& disc : discs) {
      const double rim = (disc.centre - point).norm() - disc.radius;
      expected = expected || (rim <= distance && disc.body != except);
    }
    EXPECT_EQ(grid.isAnyNear(point, distance, except), expected);
    times += expected ? 1 : 0;
  }
  EXPECT_GT(times, 200U);   // or none was ever near
  EXPECT_LT(times, 1800U);  // or always
}

TEST(NeighbourGrid, FindsMovedDiscsAsIfAddedThere) {
  checkManyPlaces([](const std::vector<Disc>& discs, double extent, KeyedRandom& random) {
    NeighbourGrid moved = gridOf(discs, 2.0);
    std::vector<Disc> after = discs;
    for (std::size_t i = 0; i < after.size(); ++i) {
      after[i].centre = scenes::randomPoint(random, extent);
      moved.move(i, after[i].centre, after[i].velocity);
    }
    moved.update();
    const NeighbourGrid fresh = gridOf(after, 2.0);
    EXPECT_EQ(find(moved, {0.0, 0.0}, 4.0 * extent), find(fresh, {0.0, 0.0}, 4.0 * extent));
    for (int i = 0; i < 20; ++i) {
      const Vector2 point = scenes::randomPoint(random, extent);
      EXPECT_EQ(find(moved, point, 3.0), find(fresh, point, 3.0));
    }
  });
}

TEST(NeighbourGrid, KeepsTheDataOfEachDisc) {
  checkManyPlaces([](std::vector<Disc> discs, double /*extent*/, KeyedRandom& random) {
    NeighbourGrid grid;
    for (Disc& disc : discs) {
      disc.velocity = scenes::randomPoint(random, 2.0);
      grid.add(disc.centre, disc.radius, disc.body, disc.velocity);
    }
    grid.build(2.0);
    ASSERT_EQ(grid.size(), discs.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Disc& disc = discs.at((grid.body(i) - 7) / 3);  // as randomDiscs() numbers them
      EXPECT_EQ(grid.body(i), disc.body);
      EXPECT_EQ(grid.centre(i), disc.centre);
      EXPECT_EQ(grid.radius(i), disc.radius);
      EXPECT_EQ(grid.velocity(i), disc.velocity);
    }
  });
}

TEST(NeighbourGrid, FindsAllDiscsInHugeExtents) {
  for (const double extent : {1e5, 1e7, 1e9}) {
    SCOPED_TRACE("extent " + std::to_string(extent));
    KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
    compareWithAll(randomDiscs(random, extent), 0.5, extent, random);
  }
}

TEST(NeighbourGrid, OrderDependsOnlyOnTheDiscs) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const std::vector<Disc> discs = randomDiscs(random, 20.0);
    const NeighbourGrid grid = gridOf(discs, 2.0);
    const Found all = find(grid, {0.0, 0.0}, 1e6);
    ASSERT_EQ(all.size(), discs.size());
    for (int i = 0; i < 10; ++i) {
      const Vector2 point = scenes::randomPoint(random, 20.0);
      const Found near = find(grid, point, 5.0);
      // Discs are in the same order as in the list of all discs.
      Found expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [&](std::uint32_t body) { return std::find(near.begin(), near.end(), body) != near.end(); });
      EXPECT_EQ(near, expected);
    }
  }
}

TEST(NeighbourGrid, EqualsANewGridAfterClear) {
  KeyedRandom random(3, KeyedRandom::PLACEMENT, {});
  const std::vector<Disc> before = randomDiscs(random, 1e6);
  const std::vector<Disc> after = randomDiscs(random, 10.0);
  ASSERT_FALSE(before.empty());
  ASSERT_FALSE(after.empty());
  NeighbourGrid used = gridOf(before, 2.0);
  used.clear();
  EXPECT_TRUE(find(used, {0.0, 0.0}, 1e9).empty());
  for (const Disc& disc : after) used.add(disc.centre, disc.radius, disc.body);
  used.build(1.0);
  const NeighbourGrid fresh = gridOf(after, 1.0);
  for (int i = 0; i < 50; ++i) {
    const Vector2 point = scenes::randomPoint(random, 12.0);
    EXPECT_EQ(find(used, point, 3.0), find(fresh, point, 3.0));
  }
  EXPECT_EQ(find(used, {0.0, 0.0}, 1e6), find(fresh, {0.0, 0.0}, 1e6));
}

}  // namespace
}  // namespace crowd::neighbour_grid_property_test
