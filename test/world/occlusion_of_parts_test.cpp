// The visible part of a body that is partly hidden.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/hidden_bodies.h"
#include "world/occlusion.h"

namespace crowd::occlusion_of_parts_test {
namespace {

using sceneries::BIG;
using sceneries::expectLast;
using sceneries::hiding;
using sceneries::LARGE;
using sceneries::LEFT;
using sceneries::look;
using sceneries::neighbour;
using sceneries::numbered;
using sceneries::numberOf;
using sceneries::Scenery;
using sceneries::sees;
using sceneries::SIGHT;

TEST(OcclusionOfParts, ReducesAHalfHiddenBodyToItsVisibleHalf) {
  // The line of sight that touches the first body passes through the centre of the second: its left half is visible.
  expectLast({{BIG, neighbour(5.0 * SIGHT, 0.5)}, {}}, 5.0 * SIGHT + 0.25 * LEFT, 0.25);
}

TEST(OcclusionOfParts, ReducesABodyBehindTheEndOfAWall) {
  expectLast({{LARGE}, {hiding(-0.1, 0.25)}}, {5.0, 0.75}, 2.25);
  expectLast({{LARGE}, {hiding(0.4, 1.1)}}, {5.0, -1.8}, 1.2);
  expectLast({{LARGE}, {hiding(-0.1, 0.2), hiding(0.6, 1.1)}}, {5.0, -0.6}, 1.2);
}

TEST(OcclusionOfParts, KeepsABodyWithBothFlanksVisible) {
  const std::vector<Scenery> sceneries = {{{LARGE}, {hiding(0.3, 0.6)}},
                                          {{LARGE}, {hiding(0.001, 0.4), hiding(0.5, 0.999)}},
                                          {{neighbour({1.0, 0.0}, 0.1), LARGE}, {}},  // a narrow post
                                          {{LARGE}, {hiding(-1.0, -0.1)}},
                                          {{LARGE}, {}}};
  for (std::size_t i = 0; i < sceneries.size(); ++i) {
    const Neighbour seen = look(sceneries[i]).neighbours.back();
    EXPECT_EQ(seen.position, LARGE.position) << i;
    EXPECT_EQ(seen.radius, LARGE.radius) << i;
  }
}

TEST(OcclusionOfParts, ChangesStepwiseWhenAFlankBecomesHidden) {
  expectLast({{LARGE}, {hiding(0.001, 0.4)}}, LARGE.position, LARGE.radius);
  expectLast({{LARGE}, {hiding(-0.001, 0.4)}}, {5.0, 1.2}, 1.8);
}

TEST(OcclusionOfParts, ShrinksToZeroAsTheBodyBecomesHidden) {
  expectLast({{LARGE}, {hiding(-0.1, 0.99)}}, {5.0, 2.97}, 0.03);
  expectLast({{LARGE}, {hiding(-0.1, 0.9999)}}, {5.0, 2.9997}, 0.0003);
  EXPECT_FALSE(sees({{LARGE}, {hiding(-0.1, 1.0001)}}));
}

TEST(OcclusionOfParts, PartlyHiddenBodyHidesAsMuchAsTheWholeOne) {
  // The perceived part of the large body ends 5 degrees before the line of sight that touches it; the hidden body
  // touches this line.
  const Segment wall = hiding(-0.1, 0.9);
  EXPECT_TRUE(sees({{LARGE}, {wall}}));
  EXPECT_FALSE(sees({{LARGE, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.0599)}, {wall}}));
  EXPECT_TRUE(sees({{LARGE, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.0601)}, {wall}}));
}

TEST(OcclusionOfParts, OmitsPartsBeyondTheRadiusOfVision) {
  const Scenery cut = {{LARGE}, {hiding(-0.1, 0.25)}};
  const double rim = std::hypot(5.0, 0.75) - 2.25;  // 2.8 m; the whole body has 2 m
  EXPECT_EQ(look(cut, rim + 1e-9).neighbours.size(), 1U);
  EXPECT_EQ(look(cut, rim - 1e-9).neighbours.size(), 0U);
  EXPECT_EQ(look({{LARGE}, {hiding(0.3, 0.6)}}, 2.0).neighbours.size(), 1U);
}

TEST(OcclusionOfParts, OrdersBodiesByTheirVisibleParts) {
  // Occlusion increases the rim distance of the large body from 2 m to 2.8 m.
  const Scenery seen = look(numbered({{neighbour({-1.5, 0.0}, 0.5), LARGE, neighbour({-2.0, -2.0}, 0.3),
                                       neighbour({0.0, 3.0}, 0.3), neighbour({0.0, -4.0}, 0.5)},
                                      {hiding(-0.1, 0.25)}}));
  std::vector<std::size_t> order;
  for (const Neighbour& neighbour : seen.neighbours) order.push_back(numberOf(neighbour));
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 2, 3, 1, 4}));
}

TEST(OcclusionOfParts, KeepsTheOrderOfEqualBodies) {
  // Bodies at the same position do not hide each other.
  const Scenery seen = look(numbered({{LARGE, LARGE, LARGE}, {hiding(-0.1, 0.25)}}));
  ASSERT_EQ(seen.neighbours.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(numberOf(seen.neighbours[i]), i);
    EXPECT_EQ(seen.neighbours[i].position, seen.neighbours[0].position);
    EXPECT_LT(seen.neighbours[i].radius, 2.3);
  }
}

}  // namespace
}  // namespace crowd::occlusion_of_parts_test
