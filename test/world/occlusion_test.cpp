#include "world/occlusion.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/hidden_bodies.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::occlusion_test {
namespace {

using sceneries::BIG;
using sceneries::FAR;
using sceneries::hiding;
using sceneries::LARGE;
using sceneries::neighbour;
using sceneries::SIGHT;

TEST(OcclusionOfOthers, KeepsTheFirstEntriesOfTheLists) {
  // Without the limits, one of the first entries would be hidden and one partly hidden.
  std::vector<Neighbour> neighbours = {BIG, neighbour({9.0, 0.0}, 0.1),  neighbour(5.0 * SIGHT, 0.5),
                                       BIG, neighbour(5.0 * SIGHT, 0.5), neighbour({5.0, 0.0}, 0.1)};
  std::vector<Segment> walls = {{{7.0, -0.1}, {7.0, 0.1}}, {{8.0, -0.1}, {8.0, 0.1}}};
  Occlusion occlusion;
  occlusion.apply(neighbours, 3, walls, 1, FAR);
  ASSERT_EQ(neighbours.size(), 5U);
  EXPECT_EQ(neighbours[1].position, Vector2(9.0, 0.0));
  EXPECT_EQ(neighbours[2].position, Vector2(5.0 * SIGHT));
  EXPECT_EQ(neighbours[2].radius, 0.5);
  EXPECT_NEAR(neighbours[4].radius, 0.25, 1e-12);
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls[0].from, Vector2(7.0, -0.1));
}

TEST(OcclusionInTheWorld, AppliesOnlyOnRequest) {
  const Scene line = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({2.0, 0.0}),
                                    scenes::wanderer({4.0, 0.0}), scenes::wanderer({0.0, 5.0})},
                                   {}, {{{5.0, -0.2}, {5.0, 0.2}}, {{-3.0, -1.0}, {-3.0, 1.0}}});
  World world(line);
  Perceptions all;
  perceive(world, {6.0, 0, false}, all);
  EXPECT_EQ(all.agents[0].neighbour_count, 3U);
  EXPECT_EQ(all.agents[0].wall_count, 2U);
  Perceptions seen;
  perceive(world, {6.0, 0, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.neighbours.size(), 2U);  // (4, 0) is hidden
  EXPECT_EQ(first.neighbours[0].position, Vector2(2.0, 0.0));
  EXPECT_EQ(first.neighbours[1].position, Vector2(0.0, 5.0));
  ASSERT_EQ(first.walls.size(), 1U);
  EXPECT_EQ(first.walls[0].from, Vector2(-3.0, -1.0));
  EXPECT_EQ(Perception(seen, 1).neighbours.size(), 3U);  // the agent in the middle perceives both neighbours
  perceive(world, {6.0, 1, true}, seen);
  EXPECT_EQ(seen.agents[0].neighbour_count, 1U);
}

TEST(OcclusionInTheWorld, MaxNeighboursLimitsVisibleNeighbours) {
  World world(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({2.0, 0.0}), scenes::wanderer({4.0, 0.0}),
                             scenes::wanderer({0.0, 5.0})}));
  Perceptions seen;
  perceive(world, {6.0, 2, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.neighbours.size(), 2U);
  EXPECT_EQ(first.neighbours[1].position, Vector2(0.0, 5.0));
}

TEST(OcclusionInTheWorld, MaxNeighboursKeepsTheNearestVisibleParts) {
  Scene scene = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({0.0, 2.75})},
                              {scenes::pillar(LARGE.position, LARGE.radius)}, {hiding(-0.1, 0.25)});
  World world(scene);
  Perceptions seen;
  perceive(world, {6.0, 1, false}, seen);
  EXPECT_EQ(Perception(seen, 0).neighbours[0].position, LARGE.position);
  perceive(world, {6.0, 1, true}, seen);  // rim distances: 2.8 m of the visible part of the pillar, 2.5 m of the agent
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);
  EXPECT_EQ(Perception(seen, 0).neighbours[0].position, Vector2(0.0, 2.75));
}

}  // namespace
}  // namespace crowd::occlusion_test
