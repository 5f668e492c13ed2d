#include "social_crowd/world/neighbour_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "social_crowd/common/random.h"
#include "support/scenes.h"

namespace crowd {
namespace {

using Runs = NeighbourGrid::Runs;
using Candidate = std::tuple<std::uint32_t, double, double, double>;  // disc, radius, square, rim

constexpr std::uint32_t NOBODY = std::numeric_limits<std::uint32_t>::max();

std::vector<Candidate> gather(Gather collect, const NeighbourGrid& grid, const Runs& runs, const Vector2& point,
                              double distance, std::uint32_t except) {
  NeighbourCandidates candidates;
  std::size_t most = 0;
  for (const NeighbourGrid::Run& run : runs) most += run.end - run.begin;
  candidates.makeRoom(most);
  collect(grid, {runs.data(), runs.size()}, point, distance, except, candidates);
  candidates.findRims();
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < candidates.count; ++i) {
    found.emplace_back(candidates.discs[i], candidates.radii[i], candidates.squares[i], candidates.rims[i]);
  }
  return found;
}

std::vector<Candidate> lookAtAll(const NeighbourGrid& grid, const Runs& runs, const Vector2& point, double distance,
                                 std::uint32_t except) {
  std::vector<Candidate> found;
  for (const NeighbourGrid::Run& run : runs) {
    for (std::uint32_t disc = run.begin; disc < run.end; ++disc) {
      const double square = (grid.centre(disc) - point).squaredNorm();
      const double limit = distance + grid.radius(disc);
      if (square > limit * limit || grid.body(disc) == except) continue;
      found.emplace_back(disc, grid.radius(disc), square, std::sqrt(square) - grid.radius(disc));
    }
  }
  return found;
}

/// Some on the same spot, most bodies in one disc, some in several.
NeighbourGrid randomGrid(KeyedRandom& random, double extent) {
  NeighbourGrid grid;
  const std::uint32_t count = 9 + random.below(200);  // more than a list
  Vector2 last = Vector2::Zero();
  for (std::uint32_t i = 0; i < count; ++i) {
    if (random.below(8) > 0) last = scenes::randomPoint(random, extent);
    grid.add(last, random.uniform(0.0, 0.5), random.below(count));
  }
  grid.build(2.0);
  return grid;
}

/// Empty ones, and from a single disc to several vectors' worth; the last one ends with the grid.
Runs randomRuns(KeyedRandom& random, const NeighbourGrid& grid) {
  Runs runs;
  const auto end = static_cast<std::uint32_t>(grid.size());
  for (std::uint32_t begin = 0; begin < end;) {
    const std::uint32_t length = random.below(random.below(4) == 0 ? 60 : 10);
    runs.push_back({begin, std::min(end, begin + length)});
    begin += length + random.below(3);
  }
  return runs;
}

TEST(NeighbourCandidates, EveryWayOfGatheringGivesTheSameBits) {
  std::size_t gathered = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const NeighbourGrid grid = randomGrid(random, random.uniform(0.1, 10.0));
    const Runs runs = randomRuns(random, grid);
    const std::uint32_t one = random.below(static_cast<std::uint32_t>(grid.size()));
    const Vector2 point = random.below(2) == 0 ? grid.centre(one) : scenes::randomPoint(random, 10.0);
    const std::uint32_t except = random.below(2) == 0 ? grid.body(one) : NOBODY;
    const double distance = random.uniform(0.0, 8.0);
    const std::vector<Candidate> expected = lookAtAll(grid, runs, point, distance, except);
    ASSERT_EQ(gather(gatherAnywhere, grid, runs, point, distance, except), expected);
    ASSERT_EQ(gather(fastestGather(), grid, runs, point, distance, except), expected);
    gathered += expected.size();
  }
  EXPECT_GT(gathered, 10000U);  // or there was nothing to compare
}

TEST(NeighbourCandidates, RimOnTheLimitCounts) {
  NeighbourGrid grid;
  for (std::uint32_t i = 0; i < 9; ++i) grid.add({3.0, 4.0}, 1.0, i);
  grid.build(2.0);
  for (Gather collect : {gatherAnywhere, fastestGather()}) {
    EXPECT_EQ(gather(collect, grid, {{0, 9}}, {0.0, 0.0}, 4.0, NOBODY).size(), 9U);
    EXPECT_EQ(gather(collect, grid, {{0, 9}}, {0.0, 0.0}, 4.0, 8).size(), 8U);
    EXPECT_TRUE(gather(collect, grid, {{0, 9}}, {0.0, 0.0}, 3.999999, NOBODY).empty());
    EXPECT_EQ(gather(collect, grid, {{2, 3}}, {0.0, 0.0}, 4.0, NOBODY), (std::vector<Candidate>{{2, 1.0, 25.0, 4.0}}));
  }
}

TEST(NeighbourCandidates, NothingInNoRuns) {
  const NeighbourGrid grid;
  for (Gather collect : {gatherAnywhere, fastestGather()}) {
    EXPECT_TRUE(gather(collect, grid, {}, {0.0, 0.0}, 4.0, NOBODY).empty());
    EXPECT_TRUE(gather(collect, grid, {{0, 0}}, {0.0, 0.0}, 4.0, NOBODY).empty());
  }
}

}  // namespace
}  // namespace crowd
