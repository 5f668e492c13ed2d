#include "social_crowd/world/neighbour_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/scenes.h"

namespace crowd {
namespace {

using Disc = NeighbourGrid::Disc;
using Found = std::vector<std::uint32_t>;

NeighbourGrid gridOf(const std::vector<Disc>& discs, double cell_size) {
  NeighbourGrid grid;
  for (const Disc& disc : discs) grid.add(disc.centre, disc.radius, disc.body);
  grid.build(cell_size);
  return grid;
}

Found find(const NeighbourGrid& grid, const Vector2& point, double distance) {
  Found found;
  grid.findNear(point, distance, found);
  return found;
}

Found sorted(Found found) {
  std::sort(found.begin(), found.end());
  return found;
}

/// What is to be found, by looking at every disc.
Found lookAtAll(const std::vector<Disc>& discs, const Vector2& point, double distance) {
  Found found;
  for (const Disc& disc : discs) {
    const double rim = std::hypot(disc.centre.x() - point.x(), disc.centre.y() - point.y()) - disc.radius;
    if (rim <= distance) found.push_back(disc.body);
  }
  return found;
}

/// Discs all over the place, in clusters, and some very far away, a third of the times no more than about as many as
/// make a list; bodies are numbered 7, 10, 13, ...
std::vector<Disc> randomDiscs(KeyedRandom& random, double extent) {
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

/// Looks from many points, in the middle of discs and outside of everything, near and far.
void compareWithAll(const std::vector<Disc>& discs, double cell_size, double extent, KeyedRandom& random) {
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

TEST(NeighbourGrid, EmptyFindsNothing) {
  EXPECT_TRUE(find(gridOf({}, 2.0), {0.0, 0.0}, 1e9).empty());
  EXPECT_TRUE(find(NeighbourGrid(), {0.0, 0.0}, 1e9).empty());
}

TEST(NeighbourGrid, RimCountsNotCentre) {
  const NeighbourGrid grid = gridOf({{{3.0, 4.0}, 1.0, 42}}, 2.0);
  EXPECT_EQ(find(grid, {0.0, 0.0}, 4.0), Found{42});
  EXPECT_TRUE(find(grid, {0.0, 0.0}, 3.999999).empty());
  EXPECT_EQ(find(grid, {3.5, 4.0}, 0.0), Found{42});  // inside
}

TEST(NeighbourGrid, NegativeDistanceMeansSoDeepInside) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.25, 42}}, 2.0);
  EXPECT_EQ(find(grid, {0.125, 0.0}, -0.125), Found{42});
  EXPECT_TRUE(find(grid, {0.126, 0.0}, -0.125).empty());
  EXPECT_TRUE(find(grid, {0.01, 0.0}, -0.3).empty());  // no point is as deep in this disc
}

TEST(NeighbourGrid, LargeDiscReachesFarBeyondItsCell) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.1, 1}, {{50.0, 50.0}, 60.0, 2}, {{99.0, 99.0}, 0.1, 3}}, 1.0);
  EXPECT_EQ(find(grid, {8.0, 8.0}, 1.0), Found{2});
  EXPECT_EQ(find(grid, {92.0, 8.0}, 1.0), Found{2});
  EXPECT_TRUE(find(grid, {5.0, 5.0}, 1.0).empty());  // 63.6 m from the centre
}

TEST(NeighbourGrid, AppendsToWhatIsThere) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.5, 5}}, 2.0);
  Found found = {9};
  grid.findNear({0.0, 0.0}, 1.0, found);
  EXPECT_EQ(found, (Found{9, 5}));
}

/// Calls check(discs, extent, random) for discs of many kinds of places.
template <typename Check>
void checkManyPlaces(const Check& check) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const double extent = random.uniform(1.0, 50.0);
    check(randomDiscs(random, extent), extent, random);
  }
}

TEST(NeighbourGrid, FindsWhatLookingAtAllFinds) {
  std::size_t found_discs = 0;
  checkManyPlaces([&](const std::vector<Disc>& discs, double extent, KeyedRandom& random) {
    compareWithAll(discs, random.uniform(0.1, 4.0), extent, random);
    found_discs += lookAtAll(discs, {0.0, 0.0}, extent).size();
  });
  EXPECT_GT(found_discs, 1000U);  // or there was nothing to compare
}

TEST(NeighbourGrid, AnyIsNearWhereSomeAreFound) {
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

TEST(NeighbourGrid, RunsHoldAllThatAreNearAndAreCounted) {
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

TEST(NeighbourGrid, TellsWhetherAnybodyIsNear) {
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

TEST(NeighbourGrid, DiscsMove) {
  NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.5, 5}, {{9.0, 0.0}, 0.5, 6}}, 2.0);
  grid.move(1, {-2.0, 1.0}, {0.5, -0.25});
  grid.update();
  EXPECT_EQ(find(grid, {-2.0, 3.0}, 1.5), Found{6});
  EXPECT_TRUE(find(grid, {9.0, 0.0}, 1.0).empty());
  EXPECT_EQ(find(grid, {0.0, 0.0}, 1.0), Found{5});
  EXPECT_EQ(grid.velocity(0), Vector2(0.0, 0.0));
  EXPECT_EQ(grid.velocity(1), Vector2(0.5, -0.25));
}

TEST(NeighbourGrid, ManyDiscsMoveOneAfterTheOther) {
  for (const std::uint32_t count : {32U, 33U, 100U}) {
    SCOPED_TRACE(count);
    std::vector<Disc> discs;
    for (std::uint32_t i = 0; i < count; ++i) discs.push_back({{1000.0 - 3.0 * i, 0.0}, 0.5, i});
    NeighbourGrid grid = gridOf(discs, 2.0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vector2 before = discs[i].centre;
      const Vector2 after(-3.0 * i, 50.0);
      EXPECT_TRUE(grid.isAnyNear(before, 0.1, UINT32_MAX));
      grid.move(i, after, Vector2::Zero());
      grid.update();
      EXPECT_FALSE(grid.isAnyNear(before, 0.1, UINT32_MAX));
      EXPECT_TRUE(grid.isAnyNear(after, 0.1, UINT32_MAX));
      EXPECT_FALSE(grid.isAnyNear(after, 0.1, i));
      EXPECT_EQ(find(grid, after, 0.1), Found{i});
    }
  }
}

TEST(NeighbourGrid, MovedDiscsAreFoundAsIfAddedThere) {
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

TEST(NeighbourGrid, DiscsStayWhatTheyAreWhereverTheyStand) {
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

TEST(NeighbourGrid, HugeExtentsNeitherCostMemoryNorLoseDiscs) {
  for (const double extent : {1e5, 1e7, 1e9}) {
    SCOPED_TRACE("extent " + std::to_string(extent));
    KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
    compareWithAll(randomDiscs(random, extent), 0.5, extent, random);
  }
}

TEST(NeighbourGrid, HugeExtentAlongOneAxisOnly) {
  for (const Vector2& unit : {Vector2(1.0, 0.0), Vector2(0.0, 1.0)}) {
    std::vector<Disc> discs;
    for (std::uint32_t i = 0; i < 40; ++i) discs.push_back({std::pow(10.0, i) * unit, 0.5, i});
    const NeighbourGrid grid = gridOf(discs, 2.0);
    EXPECT_EQ(sorted(find(grid, 0.5 * unit, 10.0)), (Found{0, 1}));
    EXPECT_EQ(find(grid, 1e19 * unit, 1e17), Found{19});
  }
}

TEST(NeighbourGrid, OutlierAtTheEndOfTheNumbers) {
  std::vector<Disc> discs(40, {{50.0, 50.0}, 0.5, 4});
  discs.insert(discs.end(), {{{0.0, 0.0}, 0.5, 1}, {{1.0, 0.0}, 0.5, 2}, {{1e300, -1e300}, 0.5, 3}});
  const NeighbourGrid grid = gridOf(discs, 2.0);
  EXPECT_EQ(sorted(find(grid, {0.0, 0.0}, 6.0)), (Found{1, 2}));
}

TEST(NeighbourGrid, EveryDiscOnTheSameSpot) {
  const std::vector<Disc> discs(100, {{1.0, 2.0}, 0.25, 4});
  EXPECT_EQ(find(gridOf(discs, 2.0), {1.0, 3.0}, 0.75), Found(100, 4));
  EXPECT_TRUE(find(gridOf(discs, 2.0), {1.0, 3.0}, 0.74).empty());
}

TEST(NeighbourGrid, OrderDependsOnTheDiscsAlone) {
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
      // Wherever one looks from, discs come in the order in which looking at everything finds them.
      Found expected;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [&](std::uint32_t body) { return std::find(near.begin(), near.end(), body) != near.end(); });
      EXPECT_EQ(near, expected);
    }
  }
}

TEST(NeighbourGrid, AfterClearItIsAsNew) {
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
}  // namespace crowd
