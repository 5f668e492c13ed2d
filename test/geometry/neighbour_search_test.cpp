#include "geometry/neighbour_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/random.h"
#include "support/scenes.h"

namespace crowd::neighbour_search_test {
namespace {

using Disc = NeighbourGrid::Disc;
using Near = std::pair<double, std::uint32_t>;  // distance of the rim, body

constexpr std::uint32_t NO_BODY = std::numeric_limits<std::uint32_t>::max();

NeighbourGrid gridOf(const std::vector<Disc>& discs) {
  NeighbourGrid grid;
  for (const Disc& disc : discs) grid.add(disc.centre, disc.radius, disc.body);
  grid.build(2.0);
  return grid;
}

std::vector<Near> search(NeighbourSearch& search, const NeighbourGrid& grid, const Vector2& point, double distance,
                         std::size_t most, std::uint32_t except = NO_BODY) {
  std::vector<Near> found;
  for (const NearDisc& near : search.findNearest(grid, point, distance, most, except)) {
    found.emplace_back(near.rim_distance, grid.body(near.disc));
  }
  return found;
}

/// Reference: sorts all discs.
std::vector<Near> sortAll(const std::vector<Disc>& discs, const Vector2& point, double distance, std::size_t most,
                          std::uint32_t except = NO_BODY) {
  std::vector<Near> all;
  for (const Disc& disc : discs) {
    const double rim = (disc.centre - point).norm() - disc.radius;
    if (rim <= distance && disc.body != except) all.emplace_back(rim, disc.body);
  }
  std::sort(all.begin(), all.end());
  if (most > 0 && all.size() > most) all.resize(most);
  return all;
}

TEST(NeighbourSearch, ReturnsNeighboursNearestRimFirst) {
  const NeighbourGrid grid = gridOf({{{3.0, 0.0}, 0.5, 1}, {{0.0, 4.0}, 2.0, 2}, {{-1.0, 0.0}, 0.25, 3}});
  NeighbourSearch looking;
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 0), (std::vector<Near>{{0.75, 3}, {2.0, 2}, {2.5, 1}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 2), (std::vector<Near>{{0.75, 3}, {2.0, 2}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 2.0, 2, 3), (std::vector<Near>{{2.0, 2}}));
}

TEST(NeighbourSearch, OrdersEquallyNearNeighboursByNumber) {
  const NeighbourGrid grid =
      gridOf({{{0.0, 1.0}, 0.25, 9}, {{1.0, 0.0}, 0.25, 4}, {{0.0, -1.0}, 0.25, 7}, {{-2.0, 0.0}, 0.25, 1}});
  NeighbourSearch looking;
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 0), (std::vector<Near>{{0.75, 4}, {0.75, 7}, {0.75, 9}, {1.75, 1}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 2), (std::vector<Near>{{0.75, 4}, {0.75, 7}}));
}

TEST(NeighbourSearch, ReturnsNothingFromAnEmptyGrid) {
  const NeighbourGrid empty;
  NeighbourSearch looking;
  EXPECT_TRUE(search(looking, empty, {1.0, 2.0}, 6.0, 16).empty());
  EXPECT_TRUE(search(looking, empty, {1.0, 2.0}, 6.0, 0).empty());
}

/// Requires that consecutive searches from random points agree with the reference.
void compareWithAll(const std::vector<Disc>& discs, double extent, KeyedRandom& random) {
  const NeighbourGrid grid = gridOf(discs);
  NeighbourSearch looking;
  for (int i = 0; i < 100; ++i) {
    const Vector2 point = scenes::randomPoint(random, 1.2 * extent);
    const double distance = random.uniform(0.0, 10.0);
    const std::size_t most = random.below(20);
    const std::uint32_t except =
        random.below(2) == 0 ? NO_BODY : random.below(static_cast<std::uint32_t>(discs.size()) + 1);
    const std::vector<Near> expected = sortAll(discs, point, distance, most, except);
    ASSERT_EQ(search(looking, grid, point, distance, most, except), expected);
  }
}

TEST(NeighbourSearch, AgreesWithSortingAllDiscs) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<Disc> discs(random.below(seed % 4 == 0 ? 9 : seed % 4 == 1 ? 41 : 400));  // lists or cells
    const double extent = random.uniform(1.0, 40.0);
    for (std::uint32_t i = 0; i < discs.size(); ++i) {
      discs[i] = {scenes::randomPoint(random, extent), random.uniform(0.0, random.below(20) == 0 ? 5.0 : 0.4), i};
      // On a lattice, many discs have equal distances.
      if (seed % 3 == 0) discs[i].centre = (discs[i].centre * 2.0).array().round() / 2.0;
      if (seed % 3 == 0) discs[i].radius = 0.25;
    }
    ASSERT_NO_FATAL_FAILURE(compareWithAll(discs, extent, random));
  }
}

TEST(NeighbourSearch, AgreesWithSortingForClustersAndEqualPositions) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<Disc> discs(9 + random.below(seed % 4 == 0 ? 32 : 300));
    const double extent = random.uniform(1.0, 40.0);
    Vector2 cluster = Vector2::Zero();
    for (std::uint32_t i = 0; i < discs.size(); ++i) {
      if (random.below(seed % 2 == 0 ? 100 : 20) == 0) cluster = scenes::randomPoint(random, extent);
      const bool same_spot = i > 0 && random.below(10) == 0;
      discs[i] = {cluster + scenes::randomPoint(random, 1.0), random.uniform(0.2, 0.3), i};
      if (same_spot) discs[i] = {discs[i - 1].centre, discs[i - 1].radius, i};
    }
    ASSERT_NO_FATAL_FAILURE(compareWithAll(discs, extent, random));
  }
}

// Distances that differ in double precision but not in single precision.
TEST(NeighbourSearch, OrdersByDistancesInDoublePrecision) {
  std::vector<Disc> discs;
  for (std::uint32_t i = 0; i < 40; ++i) discs.push_back({{1.0, 1e-9 * ((7 * i) % 40)}, 0.25, i});
  const NeighbourGrid grid = gridOf(discs);
  NeighbourSearch looking;
  EXPECT_EQ(search(looking, grid, {0.0, -1.0}, 6.0, 16), sortAll(discs, {0.0, -1.0}, 6.0, 16));
  EXPECT_EQ(search(looking, grid, {0.0, -1.0}, 6.0, 0), sortAll(discs, {0.0, -1.0}, 6.0, 0));
}

// In order of the grid's cells, each search begins where the last one ended.
TEST(NeighbourSearch, AgreesWithSortingForEachAgentOfACrowdOfVaryingDensity) {
  for (const std::size_t most : {1U, 5U, 15U, 16U, 17U, 31U, 32U, 33U, 47U, 48U, 49U, 70U}) {
    SCOPED_TRACE(testing::Message() << "most " << most);
    KeyedRandom random(most, KeyedRandom::PLACEMENT, {});
    std::vector<Disc> discs;
    for (std::uint32_t i = 0; i < 600; ++i) {
      const double y = random.uniform(0.0, 1.0);
      discs.push_back({{random.uniform(-15.0, 15.0), 40.0 * y * y * y}, random.uniform(0.2, 0.3), i});
    }
    const NeighbourGrid grid = gridOf(discs);
    NeighbourSearch looking;
    for (std::size_t disc = 0; disc < grid.size(); ++disc) {
      const auto expected = sortAll(discs, grid.centre(disc), 6.0, most, grid.body(disc));
      ASSERT_EQ(search(looking, grid, grid.centre(disc), 6.0, most, grid.body(disc)), expected);
    }
  }
}

}  // namespace
}  // namespace crowd::neighbour_search_test
