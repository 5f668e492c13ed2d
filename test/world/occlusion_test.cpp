#include "social_crowd/world/occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/sceneries.h"
#include "support/scenes.h"

namespace crowd {
namespace {

using sceneries::FAR;
using sceneries::find;
using sceneries::look;
using sceneries::neighbour;
using sceneries::numbered;
using sceneries::numberOf;
using sceneries::Scenery;

/// A line of sight three up for four ahead, and how to get to its left.
const Vector2 SIGHT(0.8, 0.6);
const Vector2 LEFT(-0.6, 0.8);
/// A disc that reaches up to that line, and down to its mirror image: 36.9 degrees to either side.
constexpr double BIG_DISTANCE = 2.0;
constexpr double BIG_RADIUS = 1.2;

const Neighbour BIG = neighbour({BIG_DISTANCE, 0.0}, BIG_RADIUS);

Vector2 turned(const Vector2& v, double angle) { return Rotation(angle).outOfFrame(v); }

Scenery turned(Scenery scenery, double angle) {
  for (Neighbour& neighbour : scenery.neighbours) neighbour.position = turned(neighbour.position, angle);
  for (Segment& wall : scenery.walls) wall = {turned(wall.from, angle), turned(wall.to, angle)};
  return scenery;
}

/// Whether the last body of a scenery is seen, whichever way the agent looks.
bool sees(const Scenery& scenery) {
  const auto seen_at = [&](double angle) {
    const Scenery seen = look(turned(numbered(scenery), angle));
    return find(seen, scenery.neighbours.size() - 1) != nullptr;
  };
  const bool seen = seen_at(0.0);
  for (int i = 1; i < 24; ++i) EXPECT_EQ(seen_at(i * PI / 12.0), seen) << "turned by " << 15 * i << " degrees";
  return seen;
}

/// Whichever way the agent looks, it perceives the last body of the scenery as that disc.
void expectLast(const Scenery& scenery, const Vector2& position, double radius) {
  for (int i = 0; i < 24; ++i) {
    SCOPED_TRACE("turned by " + std::to_string(15 * i) + " degrees");
    const Scenery seen = look(turned(numbered(scenery), i * PI / 12.0));
    const Neighbour* const last = find(seen, scenery.neighbours.size() - 1);
    ASSERT_NE(last, nullptr);
    EXPECT_LT((last->position - turned(position, i * PI / 12.0)).norm(), 1e-12);
    EXPECT_NEAR(last->radius, radius, 1e-12);
  }
}

void expectWalls(const Scenery& seen, const std::vector<Segment>& expected) {
  ASSERT_EQ(seen.walls.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((seen.walls[i].from - expected[i].from).norm(), 1e-9) << i;
    EXPECT_LT((seen.walls[i].to - expected[i].to).norm(), 1e-9) << i;
  }
}

TEST(OcclusionOfBodies, BehindABiggerOne) {
  EXPECT_FALSE(sees({{BIG, neighbour({5.0, 0.0}, 1.0)}, {}}));
  EXPECT_TRUE(sees({{neighbour({5.0, 0.0}, 1.0), BIG}, {}}));
  EXPECT_TRUE(sees({{BIG, neighbour({5.0, 0.0}, 4.0)}, {}}));  // reaches beyond it to either side
  EXPECT_TRUE(sees({{BIG, neighbour({-5.0, 0.0}, 1.0)}, {}}));
}

TEST(OcclusionOfBodies, EndsAtTheLineOfSightThatTouchesTheOther) {
  // 0.5 m to the right of that line.
  const Vector2 behind = 5.0 * SIGHT - 0.5 * LEFT;
  EXPECT_FALSE(sees({{BIG, neighbour(behind, 0.4999)}, {}}));
  EXPECT_TRUE(sees({{BIG, neighbour(behind, 0.5001)}, {}}));
}

TEST(OcclusionOfBodies, BehindAWall) {
  const Segment wall{{2.0, -1.0}, {2.0, 1.0}};  // hides all that is less than 1 m aside for 2 m ahead
  EXPECT_FALSE(sees({{neighbour({4.0, 0.0}, 0.5)}, {wall}}));
  EXPECT_FALSE(sees({{neighbour({4.0, 1.2}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{neighbour({4.0, 1.6}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{neighbour({1.0, 0.0}, 0.25)}, {wall}}));
  EXPECT_FALSE(sees({{neighbour({2.25, 0.0}, 0.25)}, {wall}}));  // it touches the wall from behind
  EXPECT_TRUE(sees({{neighbour({1.75, 0.0}, 0.25)}, {wall}}));   // and from before
}

TEST(OcclusionOfBodies, BehindTwoThatTouch) {
  const Neighbour left = neighbour({2.0, 0.25}, 0.25);
  const Neighbour right = neighbour({2.0, -0.25}, 0.25);
  EXPECT_TRUE(sees({{left, right}, {}}));
  EXPECT_TRUE(sees({{right, left}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, ThroughAGap) {
  // The gap of 0.1 m spans 1.4 degrees to either side.
  const Neighbour left = neighbour({2.0, 0.3}, 0.25);
  const Neighbour right = neighbour({2.0, -0.3}, 0.25);
  EXPECT_TRUE(sees({{left, right, neighbour({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_TRUE(sees({{left, right, neighbour({4.0, 0.25}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, neighbour({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, NearerRimIsNotAlwaysInFront) {
  // The rim of the large one is 2 m away, but where the small one stands, it recedes: 3.2 m along the line of sight
  // that touches it, 0.06 m aside.
  const Neighbour large = neighbour({5.0, 0.0}, 3.0);
  EXPECT_TRUE(sees({{large, neighbour(3.2 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
  EXPECT_FALSE(sees({{large, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
}

TEST(OcclusionOfBodies, TheFlankMayBeHiddenByOneWithAFurtherRim) {
  // The large one spans 36.9 degrees to either side. The near one hides it from -41.9 to 31.9 degrees; the one at its
  // flank, with its rim 2.28 m away, from 29.5 to 39.5.
  const Neighbour near = neighbour(unitVector(toRadians(-5.0)), 0.6);
  const Neighbour large = neighbour({5.0, 0.0}, 3.0);
  const Neighbour at_flank = neighbour(2.5 * unitVector(toRadians(34.5)), 0.22);
  EXPECT_FALSE(sees({{near, at_flank, large}, {}}));
  EXPECT_TRUE(sees({{near, large, at_flank}, {}}));
  EXPECT_EQ(look({{near, large, at_flank}, {}}).neighbours.size(), 2U);
  EXPECT_EQ(look({{near, large}, {}}).neighbours.size(), 2U);
}

TEST(OcclusionOfBodies, NobodyLooksFromInsideABody) {
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

/// The chord of this one stands 3.2 m ahead and reaches 2.4 m to either side.
const Neighbour LARGE = neighbour({5.0, 0.0}, 3.0);

/// A wall 1 m ahead that hides these shares of the chord, from the right.
Segment hiding(double from, double to) { return {{1.0, 0.75 * (2.0 * from - 1.0)}, {1.0, 0.75 * (2.0 * to - 1.0)}}; }

TEST(OcclusionOfParts, HalfBehindAnother) {
  // The line of sight that touches the big one goes through the centre: the left half is seen.
  expectLast({{BIG, neighbour(5.0 * SIGHT, 0.5)}, {}}, 5.0 * SIGHT + 0.25 * LEFT, 0.25);
}

TEST(OcclusionOfParts, BehindTheEndOfAWall) {
  expectLast({{LARGE}, {hiding(-0.1, 0.25)}}, {5.0, 0.75}, 2.25);
  expectLast({{LARGE}, {hiding(0.4, 1.1)}}, {5.0, -1.8}, 1.2);
  expectLast({{LARGE}, {hiding(-0.1, 0.2), hiding(0.6, 1.1)}}, {5.0, -0.6}, 1.2);
}

TEST(OcclusionOfParts, WholeWhereNeitherFlankIsHidden) {
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

TEST(OcclusionOfParts, JumpsToTheRestWithTheLastGlimpseBesideAPost) {
  expectLast({{LARGE}, {hiding(0.001, 0.4)}}, LARGE.position, LARGE.radius);
  expectLast({{LARGE}, {hiding(-0.001, 0.4)}}, {5.0, 1.2}, 1.8);
}

TEST(OcclusionOfParts, ShrinksToNothing) {
  expectLast({{LARGE}, {hiding(-0.1, 0.99)}}, {5.0, 2.97}, 0.03);
  expectLast({{LARGE}, {hiding(-0.1, 0.9999)}}, {5.0, 2.9997}, 0.0003);
  EXPECT_FALSE(sees({{LARGE}, {hiding(-0.1, 1.0001)}}));
}

TEST(OcclusionOfParts, HidesAsTheWholeBodyDoes) {
  // What is perceived of the large one ends 5 degrees before the line of sight that touches it; who is hidden there
  // touches that line.
  const Segment wall = hiding(-0.1, 0.9);
  EXPECT_TRUE(sees({{LARGE}, {wall}}));
  EXPECT_FALSE(sees({{LARGE, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.0599)}, {wall}}));
  EXPECT_TRUE(sees({{LARGE, neighbour(6.0 * SIGHT - 0.06 * LEFT, 0.0601)}, {wall}}));
}

TEST(OcclusionOfParts, BeyondTheRadiusOfVisionIsLeftOut) {
  const Scenery cut = {{LARGE}, {hiding(-0.1, 0.25)}};
  const double rim = std::hypot(5.0, 0.75) - 2.25;  // 2.8 m; of the whole body 2 m
  EXPECT_EQ(look(cut, rim + 1e-9).neighbours.size(), 1U);
  EXPECT_EQ(look(cut, rim - 1e-9).neighbours.size(), 0U);
  EXPECT_EQ(look({{LARGE}, {hiding(0.3, 0.6)}}, 2.0).neighbours.size(), 1U);
}

TEST(OcclusionOfParts, StandInOrderOfWhatIsSeen) {
  // The rim of the large one goes from 2 to 2.8 m.
  const Scenery seen = look(numbered({{neighbour({-1.5, 0.0}, 0.5), LARGE, neighbour({-2.0, -2.0}, 0.3),
                                       neighbour({0.0, 3.0}, 0.3), neighbour({0.0, -4.0}, 0.5)},
                                      {hiding(-0.1, 0.25)}}));
  std::vector<std::size_t> order;
  for (const Neighbour& neighbour : seen.neighbours) order.push_back(numberOf(neighbour));
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 2, 3, 1, 4}));
}

TEST(OcclusionOfParts, EqualOnesStayInOrder) {
  // Bodies in the same place do not hide each other.
  const Scenery seen = look(numbered({{LARGE, LARGE, LARGE}, {hiding(-0.1, 0.25)}}));
  ASSERT_EQ(seen.neighbours.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(numberOf(seen.neighbours[i]), i);
    EXPECT_EQ(seen.neighbours[i].position, seen.neighbours[0].position);
    EXPECT_LT(seen.neighbours[i].radius, 2.3);
  }
}

TEST(OcclusionOfWalls, CutByABody) {
  const Segment wall{{4.0, -6.0}, {4.0, 6.0}};
  expectWalls(look({{BIG}, {wall}}), {{{4.0, -6.0}, {4.0, -3.0}}, {{4.0, 3.0}, {4.0, 6.0}}});
  expectWalls(look({{BIG}, {{wall.to, wall.from}}}), {{{4.0, -3.0}, {4.0, -6.0}}, {{4.0, 6.0}, {4.0, 3.0}}});
  expectWalls(look({{BIG}, {{{4.0, -2.9}, {4.0, 2.9}}}}), {});
  expectWalls(look({{BIG}, {{{0.5, -6.0}, {0.5, 6.0}}}}), {{{0.5, -6.0}, {0.5, 6.0}}});  // it is in front
}

TEST(OcclusionOfWalls, CutBehindTheAgentToo) {
  const Scenery seen = look({{neighbour({-2.0, 0.0}, 1.2)}, {{{-4.0, -6.0}, {-4.0, 6.0}}}});
  expectWalls(seen, {{{-4.0, 3.0}, {-4.0, 6.0}}, {{-4.0, -6.0}, {-4.0, -3.0}}});
}

TEST(OcclusionOfWalls, CutByAWall) {
  const Segment front{{2.0, 0.0}, {2.0, 1.0}};
  const Segment back{{4.0, -2.0}, {4.0, 1.0}};
  expectWalls(look({{}, {front, back}}), {front, {{4.0, -2.0}, {4.0, 0.0}}});
}

TEST(OcclusionOfWalls, WallsThatCross) {
  // They cross straight ahead, at (3, 0). To the right the slanting one is in front, to the left the other.
  const Segment slanting{{2.0, -2.0}, {4.0, 2.0}};
  const Segment across{{3.0, -3.0}, {3.0, 3.0}};
  expectWalls(look({{}, {slanting, across}}), {{{2.0, -2.0}, {3.0, 0.0}}, {{3.0, 0.0}, {3.0, 3.0}}});
}

TEST(OcclusionOfWalls, CornersStayWhole) {
  const std::vector<Segment> corner = {{{2.0, -1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {-1.0, 1.0}}};
  expectWalls(look({{}, corner}), corner);
}

TEST(OcclusionOfWalls, TwiceTheSameWallIsSeenTwice) {
  const std::vector<Segment> twice = {{{2.0, -1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {2.0, -1.0}}};
  expectWalls(look({{}, twice}), twice);
}

TEST(OcclusionOfWalls, PartsBeyondTheRadiusOfVisionAreLeftOut) {
  // Of the wall beside the agent a disc hides what is near it, the rest is more than 2 m away.
  const Segment wall{{0.0, 1.0}, {8.0, 1.0}};
  const Neighbour hiding = neighbour({0.6, 0.7}, 0.28);
  const Scenery seen = look({{hiding}, {wall}});
  ASSERT_EQ(seen.walls.size(), 2U);
  EXPECT_LT(distanceTo(seen.walls[1], Vector2::Zero()), distanceTo(seen.walls[0], Vector2::Zero()));
  expectWalls(look({{hiding}, {wall}}, 1.2), {seen.walls[1]});
}

TEST(OcclusionOfOthers, StaysAsItIs) {
  // Of those before, one would be hidden and one partly.
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

TEST(OcclusionInTheWorld, OnlyOnRequest) {
  const Scene line = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({2.0, 0.0}),
                                    scenes::wanderer({4.0, 0.0}), scenes::wanderer({0.0, 5.0})},
                                   {}, {{{5.0, -0.2}, {5.0, 0.2}}, {{-3.0, -1.0}, {-3.0, 1.0}}});
  World world(line);
  Perceptions all;
  world.perceive({6.0, 0, false}, all);
  EXPECT_EQ(all.agents[0].neighbour_count, 3U);
  EXPECT_EQ(all.agents[0].wall_count, 2U);
  Perceptions seen;
  world.perceive({6.0, 0, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.neighbours.size(), 2U);  // (4, 0) is hidden
  EXPECT_EQ(first.neighbours[0].position, Vector2(2.0, 0.0));
  EXPECT_EQ(first.neighbours[1].position, Vector2(0.0, 5.0));
  ASSERT_EQ(first.walls.size(), 1U);
  EXPECT_EQ(first.walls[0].from, Vector2(-3.0, -1.0));
  EXPECT_EQ(Perception(seen, 1).neighbours.size(), 3U);  // who stands in the middle sees both
  world.perceive({6.0, 1, true}, seen);
  EXPECT_EQ(seen.agents[0].neighbour_count, 1U);
}

TEST(OcclusionInTheWorld, MaxNeighboursCountsThoseThatAreSeen) {
  World world(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({2.0, 0.0}), scenes::wanderer({4.0, 0.0}),
                             scenes::wanderer({0.0, 5.0})}));
  Perceptions seen;
  world.perceive({6.0, 2, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.neighbours.size(), 2U);
  EXPECT_EQ(first.neighbours[1].position, Vector2(0.0, 5.0));
}

TEST(OcclusionInTheWorld, MaxNeighboursCountsTheNearestPartsThatAreSeen) {
  Scene scene = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({0.0, 2.75})},
                              {scenes::pillar(LARGE.position, LARGE.radius)}, {hiding(-0.1, 0.25)});
  World world(scene);
  Perceptions seen;
  world.perceive({6.0, 1, false}, seen);
  EXPECT_EQ(Perception(seen, 0).neighbours[0].position, LARGE.position);
  world.perceive({6.0, 1, true}, seen);  // the rim that is left of the pillar is 2.8 m away, the agent's 2.5 m
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);
  EXPECT_EQ(Perception(seen, 0).neighbours[0].position, Vector2(0.0, 2.75));
}

}  // namespace
}  // namespace crowd
