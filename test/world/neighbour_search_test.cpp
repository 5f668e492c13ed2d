#include "social_crowd/world/neighbour_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "social_crowd/common/random.h"
#include "support/scenes.h"

namespace crowd {
namespace {

using Disc = NeighbourGrid::Disc;
using Near = std::pair<double, std::uint32_t>;  // distance of the rim, body

constexpr std::uint32_t NOBODY = std::numeric_limits<std::uint32_t>::max();

NeighbourGrid gridOf(const std::vector<Disc>& discs) {
  NeighbourGrid grid;
  for (const Disc& disc : discs) grid.add(disc.centre, disc.radius, disc.body);
  grid.build(2.0);
  return grid;
}

std::vector<Near> search(NeighbourSearch& search, const NeighbourGrid& grid, const Vector2& point, double distance,
                         std::size_t most, std::uint32_t except = NOBODY) {
  std::vector<Near> found;
  for (const NearDisc& near : search.findNearest(grid, point, distance, most, except)) {
    found.emplace_back(near.rim_distance, grid.body(near.disc));
  }
  return found;
}

/// What is to be found, by sorting all.
std::vector<Near> sortAll(const std::vector<Disc>& discs, const Vector2& point, double distance, std::size_t most,
                          std::uint32_t except = NOBODY) {
  std::vector<Near> all;
  for (const Disc& disc : discs) {
    const double rim = (disc.centre - point).norm() - disc.radius;
    if (rim <= distance && disc.body != except) all.emplace_back(rim, disc.body);
  }
  std::sort(all.begin(), all.end());
  if (most > 0 && all.size() > most) all.resize(most);
  return all;
}

TEST(NeighbourSearch, NearestRimFirst) {
  const NeighbourGrid grid = gridOf({{{3.0, 0.0}, 0.5, 1}, {{0.0, 4.0}, 2.0, 2}, {{-1.0, 0.0}, 0.25, 3}});
  NeighbourSearch looking;
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 0), (std::vector<Near>{{0.75, 3}, {2.0, 2}, {2.5, 1}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 2), (std::vector<Near>{{0.75, 3}, {2.0, 2}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 2.0, 2, 3), (std::vector<Near>{{2.0, 2}}));
}

TEST(NeighbourSearch, EquallyNearOnesByTheirNumbers) {
  const NeighbourGrid grid =
      gridOf({{{0.0, 1.0}, 0.25, 9}, {{1.0, 0.0}, 0.25, 4}, {{0.0, -1.0}, 0.25, 7}, {{-2.0, 0.0}, 0.25, 1}});
  NeighbourSearch looking;
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 0), (std::vector<Near>{{0.75, 4}, {0.75, 7}, {0.75, 9}, {1.75, 1}}));
  EXPECT_EQ(search(looking, grid, {0.0, 0.0}, 6.0, 2), (std::vector<Near>{{0.75, 4}, {0.75, 7}}));
}

TEST(NeighbourSearch, NobodyThere) {
  const NeighbourGrid empty;
  NeighbourSearch looking;
  EXPECT_TRUE(search(looking, empty, {1.0, 2.0}, 6.0, 16).empty());
  EXPECT_TRUE(search(looking, empty, {1.0, 2.0}, 6.0, 0).empty());
}

TEST(NeighbourSearch, FindsTheFirstOfAllSorted) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<Disc> discs(random.below(seed % 4 == 0 ? 9 : 400));  // now and then a mere list
    const double extent = random.uniform(1.0, 40.0);
    for (std::uint32_t i = 0; i < discs.size(); ++i) {
      discs[i] = {scenes::randomPoint(random, extent), random.uniform(0.0, random.below(20) == 0 ? 5.0 : 0.4), i};
      // On a lattice many are equally far.
      if (seed % 3 == 0) discs[i].centre = (discs[i].centre * 2.0).array().round() / 2.0;
      if (seed % 3 == 0) discs[i].radius = 0.25;
    }
    const NeighbourGrid grid = gridOf(discs);
    NeighbourSearch looking;
    for (int i = 0; i < 100; ++i) {
      const Vector2 point = scenes::randomPoint(random, 1.2 * extent);
      const double distance = random.uniform(0.0, 10.0);
      const std::size_t most = random.below(20);
      const std::uint32_t except =
          random.below(2) == 0 ? NOBODY : random.below(static_cast<std::uint32_t>(discs.size()) + 1);
      ASSERT_EQ(search(looking, grid, point, distance, most, except), sortAll(discs, point, distance, most, except));
    }
  }
}

}  // namespace
}  // namespace crowd
