// Which bodies are visible, and which are hidden completely.

#include <gtest/gtest.h>

#include "support/hidden_bodies.h"
#include "world/occlusion.h"

namespace crowd::occlusion_of_bodies_test {
namespace {

using sceneries::BIG;
using sceneries::expectWalls;
using sceneries::LEFT;
using sceneries::look;
using sceneries::neighbour;
using sceneries::Scenery;
using sceneries::sees;
using sceneries::SIGHT;

TEST(OcclusionOfBodies, LargerBodyHidesTheBodyBehindIt) {
  EXPECT_FALSE(sees({{BIG, neighbour({5.0, 0.0}, 1.0)}, {}}));
  EXPECT_TRUE(sees({{neighbour({5.0, 0.0}, 1.0), BIG}, {}}));
  EXPECT_TRUE(sees({{BIG, neighbour({5.0, 0.0}, 4.0)}, {}}));  // larger on both sides
  EXPECT_TRUE(sees({{BIG, neighbour({-5.0, 0.0}, 1.0)}, {}}));
}

TEST(OcclusionOfBodies, EndsAtTheTangentLineOfSight) {
  // 0.5 m to the right of the line of sight.
  const Vector2 behind = 5.0 * SIGHT - 0.5 * LEFT;
  EXPECT_FALSE(sees({{BIG, neighbour(behind, 0.4999)}, {}}));
  EXPECT_TRUE(sees({{BIG, neighbour(behind, 0.5001)}, {}}));
}

TEST(OcclusionOfBodies, WallHidesTheBodyBehindIt) {
  const Segment wall{{2.0, -1.0}, {2.0, 1.0}};  // spans 26.6 degrees to either side
  EXPECT_FALSE(sees({{neighbour({4.0, 0.0}, 0.5)}, {wall}}));
  EXPECT_FALSE(sees({{neighbour({4.0, 1.2}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{neighbour({4.0, 1.6}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{neighbour({1.0, 0.0}, 0.25)}, {wall}}));
  EXPECT_FALSE(sees({{neighbour({2.25, 0.0}, 0.25)}, {wall}}));  // touches the wall from behind
  EXPECT_TRUE(sees({{neighbour({1.75, 0.0}, 0.25)}, {wall}}));   // from the front
}

TEST(OcclusionOfBodies, TwoTouchingBodiesHideTheBodyBehindThem) {
  const Neighbour left = neighbour({2.0, 0.25}, 0.25);
  const Neighbour right = neighbour({2.0, -0.25}, 0.25);
  EXPECT_TRUE(sees({{left, right}, {}}));
  EXPECT_TRUE(sees({{right, left}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, BodyBehindAGapIsVisible) {
  // The gap of 0.1 m spans 1.4 degrees to either side.
  const Neighbour left = neighbour({2.0, 0.3}, 0.25);
  const Neighbour right = neighbour({2.0, -0.3}, 0.25);
  EXPECT_TRUE(sees({{left, right, neighbour({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_TRUE(sees({{left, right, neighbour({4.0, 0.25}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, BodyWithAFartherRimCanBeInFront) {
  // The rim of the large body is 2 m away straight ahead, but 3.2 m away at the small body, along the line of sight
  // that touches the large body.
  const Neighbour large = neighbour({5.0, 0.0}, 3.0);
  EXPECT_TRUE(sees({{large, neighbour(3.2 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
  EXPECT_FALSE(sees({{large, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
}

TEST(OcclusionOfBodies, BodyWithAFartherRimCanHideTheFlank) {
  // The large body spans 36.9 degrees to either side. The near one hides it from -41.9 to 31.9 degrees; the one at its
  // flank, with its rim 2.28 m away, from 29.5 to 39.5.
  const Neighbour near = neighbour(unitVector(toRadians(-5.0)), 0.6);
  const Neighbour large = neighbour({5.0, 0.0}, 3.0);
  const Neighbour at_flank = neighbour(2.5 * unitVector(toRadians(34.5)), 0.22);
  EXPECT_FALSE(sees({{near, at_flank, large}, {}}));
  EXPECT_TRUE(sees({{near, large, at_flank}, {}}));
  EXPECT_EQ(look({{near, large, at_flank}, {}}).neighbours.size(), 2U);
  EXPECT_EQ(look({{near, large}, {}}).neighbours.size(), 2U);
}

TEST(OcclusionOfBodies, OverlappingBodiesHideNothing) {
  EXPECT_TRUE(sees({{neighbour({0.1, 0.0}, 0.5), neighbour({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_TRUE(sees({{BIG, neighbour({0.1, 0.0}, 0.5)}, {}}));
  EXPECT_TRUE(sees({{neighbour({0.5, 0.0}, 0.1), neighbour({0.0, 0.0}, 2.0)}, {}}));
}

TEST(OcclusionOfBodies, WallsSeenEdgeOnHideNothing) {
  const Scenery seen = look({{neighbour({5.0, 0.0}, 0.2)}, {{{1.0, 0.0}, {3.0, 0.0}}}});
  EXPECT_EQ(seen.neighbours.size(), 1U);
  expectWalls(seen, {{{1.0, 0.0}, {3.0, 0.0}}});
  EXPECT_EQ(look({{neighbour({5.0, 0.0}, 0.2)}, {{{-1.0, 0.0}, {3.0, 0.0}}}}).neighbours.size(),
            1U);  // through the agent
}

}  // namespace
}  // namespace crowd::occlusion_of_bodies_test
