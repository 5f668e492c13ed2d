#include "social_crowd/world/occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "support/scenes.h"

namespace crowd {
namespace {

constexpr double FAR = 100.0;  // radius of vision [m]

/// A line of sight three up for four ahead, and how to get to its left.
const Vector2 SIGHT(0.8, 0.6);
const Vector2 LEFT(-0.6, 0.8);
/// A disc that reaches up to that line, and down to its mirror image: 36.9 degrees to either side.
constexpr double BIG_DISTANCE = 2.0;
constexpr double BIG_RADIUS = 1.2;

PerceivedBody body(const Vector2& position, double radius) {
  PerceivedBody made;
  made.position = position;
  made.radius = radius;
  return made;
}

const PerceivedBody BIG = body({BIG_DISTANCE, 0.0}, BIG_RADIUS);

struct Scenery {
  std::vector<PerceivedBody> bodies;
  std::vector<Segment> walls;
};

/// What is left to be seen.
Scenery look(Scenery scenery, double radius = FAR) {
  Occlusion occlusion;
  occlusion.apply(scenery.bodies, 0, scenery.walls, 0, radius);
  return scenery;
}

Vector2 turned(const Vector2& v, double angle) { return Rotation(angle).outOfFrame(v); }

Scenery turned(Scenery scenery, double angle) {
  for (PerceivedBody& body : scenery.bodies) body.position = turned(body.position, angle);
  for (Segment& wall : scenery.walls) wall = {turned(wall.from, angle), turned(wall.to, angle)};
  return scenery;
}

/// Whether the last body of a scenery is seen, whichever way the agent looks.
bool sees(const Scenery& scenery) {
  const Vector2 last = scenery.bodies.back().position;
  const auto seen_at = [&](double angle) {
    const Scenery seen = look(turned(scenery, angle));
    return std::any_of(seen.bodies.begin(), seen.bodies.end(), [&](const PerceivedBody& body) {
      return (body.position - turned(last, angle)).norm() < 1e-9 && body.radius == scenery.bodies.back().radius;
    });
  };
  const bool seen = seen_at(0.0);
  for (int i = 1; i < 24; ++i) EXPECT_EQ(seen_at(i * PI / 12.0), seen) << "turned by " << 15 * i << " degrees";
  return seen;
}

void expectWalls(const Scenery& seen, const std::vector<Segment>& expected) {
  ASSERT_EQ(seen.walls.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((seen.walls[i].from - expected[i].from).norm(), 1e-9) << i;
    EXPECT_LT((seen.walls[i].to - expected[i].to).norm(), 1e-9) << i;
  }
}

TEST(OcclusionOfBodies, BehindABiggerOne) {
  EXPECT_FALSE(sees({{BIG, body({5.0, 0.0}, 1.0)}, {}}));
  EXPECT_TRUE(sees({{body({5.0, 0.0}, 1.0), BIG}, {}}));
  EXPECT_TRUE(sees({{BIG, body({5.0, 0.0}, 4.0)}, {}}));  // reaches beyond it to either side
  EXPECT_TRUE(sees({{BIG, body({-5.0, 0.0}, 1.0)}, {}}));
}

TEST(OcclusionOfBodies, EndsAtTheLineOfSightThatTouchesTheOther) {
  // 0.5 m to the right of that line.
  const Vector2 behind = 5.0 * SIGHT - 0.5 * LEFT;
  EXPECT_FALSE(sees({{BIG, body(behind, 0.4999)}, {}}));
  EXPECT_TRUE(sees({{BIG, body(behind, 0.5001)}, {}}));
}

TEST(OcclusionOfBodies, HalfHiddenIsPerceivedWhole) {
  const Scenery seen = look({{BIG, body(5.0 * SIGHT, 0.5)}, {}});
  ASSERT_EQ(seen.bodies.size(), 2U);
  EXPECT_EQ(seen.bodies[1].position, Vector2(4.0, 3.0));
  EXPECT_EQ(seen.bodies[1].radius, 0.5);
}

TEST(OcclusionOfBodies, BehindAWall) {
  const Segment wall{{2.0, -1.0}, {2.0, 1.0}};  // hides all that is less than 1 m aside for 2 m ahead
  EXPECT_FALSE(sees({{body({4.0, 0.0}, 0.5)}, {wall}}));
  EXPECT_FALSE(sees({{body({4.0, 1.2}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{body({4.0, 1.6}, 0.5)}, {wall}}));
  EXPECT_TRUE(sees({{body({1.0, 0.0}, 0.25)}, {wall}}));
  EXPECT_FALSE(sees({{body({2.25, 0.0}, 0.25)}, {wall}}));  // it touches the wall from behind
  EXPECT_TRUE(sees({{body({1.75, 0.0}, 0.25)}, {wall}}));   // and from before
}

TEST(OcclusionOfBodies, BehindTwoThatTouch) {
  const PerceivedBody left = body({2.0, 0.25}, 0.25);
  const PerceivedBody right = body({2.0, -0.25}, 0.25);
  EXPECT_TRUE(sees({{left, right}, {}}));
  EXPECT_TRUE(sees({{right, left}, {}}));
  EXPECT_FALSE(sees({{left, right, body({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, body({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, ThroughAGap) {
  // The gap of 0.1 m spans 1.4 degrees to either side.
  const PerceivedBody left = body({2.0, 0.3}, 0.25);
  const PerceivedBody right = body({2.0, -0.3}, 0.25);
  EXPECT_TRUE(sees({{left, right, body({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_TRUE(sees({{left, right, body({4.0, 0.25}, 0.2)}, {}}));
  EXPECT_FALSE(sees({{left, right, body({4.0, 0.4}, 0.2)}, {}}));
}

TEST(OcclusionOfBodies, NearerRimIsNotAlwaysInFront) {
  // The rim of the large one is 2 m away, but where the small one stands, it recedes: 3.2 m along the line of sight
  // that touches it, 0.06 m aside.
  const PerceivedBody large = body({5.0, 0.0}, 3.0);
  EXPECT_TRUE(sees({{large, body(3.2 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
  EXPECT_FALSE(sees({{large, body(6.0 * SIGHT - 0.06 * LEFT, 0.04)}, {}}));
}

TEST(OcclusionOfBodies, TheFlankMayBeHiddenByOneWithAFurtherRim) {
  // The large one spans 36.9 degrees to either side. The near one hides it from -41.9 to 31.9 degrees; the one at its
  // flank, with its rim 2.28 m away, from 29.5 to 39.5.
  const PerceivedBody near = body(unitVector(toRadians(-5.0)), 0.6);
  const PerceivedBody large = body({5.0, 0.0}, 3.0);
  const PerceivedBody at_flank = body(2.5 * unitVector(toRadians(34.5)), 0.22);
  const Scenery seen = look({{near, large, at_flank}, {}});
  ASSERT_EQ(seen.bodies.size(), 2U);
  EXPECT_EQ(seen.bodies[1].position, at_flank.position);
  EXPECT_EQ(look({{near, large}, {}}).bodies.size(), 2U);
}

TEST(OcclusionOfBodies, NobodyLooksFromInsideABody) {
  EXPECT_TRUE(sees({{body({0.1, 0.0}, 0.5), body({4.0, 0.0}, 0.2)}, {}}));
  EXPECT_TRUE(sees({{BIG, body({0.1, 0.0}, 0.5)}, {}}));
  EXPECT_TRUE(sees({{body({0.5, 0.0}, 0.1), body({0.0, 0.0}, 2.0)}, {}}));
}

TEST(OcclusionOfBodies, WallsSeenEdgeOnHideNothing) {
  const Scenery seen = look({{body({5.0, 0.0}, 0.2)}, {{{1.0, 0.0}, {3.0, 0.0}}}});
  EXPECT_EQ(seen.bodies.size(), 1U);
  expectWalls(seen, {{{1.0, 0.0}, {3.0, 0.0}}});
  EXPECT_EQ(look({{body({5.0, 0.0}, 0.2)}, {{{-1.0, 0.0}, {3.0, 0.0}}}}).bodies.size(), 1U);  // through the agent
}

TEST(OcclusionOfWalls, CutByABody) {
  const Segment wall{{4.0, -6.0}, {4.0, 6.0}};
  expectWalls(look({{BIG}, {wall}}), {{{4.0, -6.0}, {4.0, -3.0}}, {{4.0, 3.0}, {4.0, 6.0}}});
  expectWalls(look({{BIG}, {{wall.to, wall.from}}}), {{{4.0, -3.0}, {4.0, -6.0}}, {{4.0, 6.0}, {4.0, 3.0}}});
  expectWalls(look({{BIG}, {{{4.0, -2.9}, {4.0, 2.9}}}}), {});
  expectWalls(look({{BIG}, {{{0.5, -6.0}, {0.5, 6.0}}}}), {{{0.5, -6.0}, {0.5, 6.0}}});  // it is in front
}

TEST(OcclusionOfWalls, CutBehindTheAgentToo) {
  const Scenery seen = look({{body({-2.0, 0.0}, 1.2)}, {{{-4.0, -6.0}, {-4.0, 6.0}}}});
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
  const PerceivedBody hiding = body({0.6, 0.7}, 0.28);
  const Scenery seen = look({{hiding}, {wall}});
  ASSERT_EQ(seen.walls.size(), 2U);
  EXPECT_LT(distanceTo(seen.walls[1], Vector2::Zero()), distanceTo(seen.walls[0], Vector2::Zero()));
  expectWalls(look({{hiding}, {wall}}, 1.2), {seen.walls[1]});
}

TEST(OcclusionOfOthers, StaysAsItIs) {
  std::vector<PerceivedBody> bodies = {BIG, body({9.0, 0.0}, 0.1), BIG, body({5.0, 0.0}, 0.1)};
  std::vector<Segment> walls = {{{7.0, -0.1}, {7.0, 0.1}}, {{8.0, -0.1}, {8.0, 0.1}}};
  Occlusion occlusion;
  occlusion.apply(bodies, 2, walls, 1, FAR);
  ASSERT_EQ(bodies.size(), 3U);
  EXPECT_EQ(bodies[1].position, Vector2(9.0, 0.0));
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
  EXPECT_EQ(all.agents[0].body_count, 3U);
  EXPECT_EQ(all.agents[0].wall_count, 2U);
  Perceptions seen;
  world.perceive({6.0, 0, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.bodies.size(), 2U);  // (4, 0) is hidden
  EXPECT_EQ(first.bodies[0].position, Vector2(2.0, 0.0));
  EXPECT_EQ(first.bodies[1].position, Vector2(0.0, 5.0));
  ASSERT_EQ(first.walls.size(), 1U);
  EXPECT_EQ(first.walls[0].from, Vector2(-3.0, -1.0));
  EXPECT_EQ(Perception(seen, 1).bodies.size(), 3U);  // who stands in the middle sees both
  world.perceive({6.0, 1, true}, seen);
  EXPECT_EQ(seen.agents[0].body_count, 1U);
}

TEST(OcclusionInTheWorld, MaxBodiesCountsThoseThatAreSeen) {
  World world(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({2.0, 0.0}), scenes::wanderer({4.0, 0.0}),
                             scenes::wanderer({0.0, 5.0})}));
  Perceptions seen;
  world.perceive({6.0, 2, true}, seen);
  const Perception first(seen, 0);
  ASSERT_EQ(first.bodies.size(), 2U);
  EXPECT_EQ(first.bodies[1].position, Vector2(0.0, 5.0));
}

/// Random bodies in order of their rims, and walls; on request none of them overlap, but for walls that cross.
Scenery randomScenery(std::uint64_t seed, bool apart) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  Scenery made;
  for (std::uint32_t i = random.below(4); i > 0; --i) {
    const Vector2 from = scenes::randomPoint(random, 6.0);
    made.walls.push_back({from, scenes::randomPoint(random, 6.0)});
  }
  for (std::uint32_t i = 2 + random.below(25); i > 0; --i) {
    const PerceivedBody next = body(scenes::randomPoint(random, 6.0), random.uniform(0.05, 1.0));
    const auto overlaps = [&](const PerceivedBody& other) {
      return (other.position - next.position).norm() < other.radius + next.radius;
    };
    const auto crosses = [&](const Segment& wall) { return distanceTo(wall, next.position) < next.radius; };
    const bool blocked = next.position.norm() < next.radius + 0.1 ||
                         std::any_of(made.bodies.begin(), made.bodies.end(), overlaps) ||
                         std::any_of(made.walls.begin(), made.walls.end(), crosses);
    if (!apart || !blocked) made.bodies.push_back(next);
  }
  std::sort(made.bodies.begin(), made.bodies.end(), [](const PerceivedBody& a, const PerceivedBody& b) {
    return a.position.norm() - a.radius < b.position.norm() - b.radius;
  });
  return made;
}

bool contains(const Scenery& scenery, const PerceivedBody& body) {
  return std::any_of(scenery.bodies.begin(), scenery.bodies.end(),
                     [&](const PerceivedBody& other) { return other.position == body.position; });
}

constexpr double NO_HIT = std::numeric_limits<double>::infinity();

/// How far a line of sight goes until it meets the body [m].
double sightTo(const PerceivedBody& body, const Vector2& sight) {
  const double along = body.position.dot(sight);
  const double aside = cross(sight, body.position);
  if (along < 0.0 || std::abs(aside) > body.radius) return NO_HIT;
  return along - std::sqrt(body.radius * body.radius - aside * aside);
}

double sightTo(const Segment& wall, const Vector2& sight) {
  const Vector2 along = wall.to - wall.from;
  const double share = cross(wall.from, sight) / cross(sight, along);
  const double distance = cross(wall.from, along) / cross(sight, along);
  return share >= 0.0 && share <= 1.0 && distance > 0.0 ? distance : NO_HIT;
}

/// The bearings at which anything begins, ends or crosses, in order.
std::vector<double> criticalBearings(const Scenery& scenery) {
  std::vector<double> bearings = {-PI, PI};
  for (const PerceivedBody& body : scenery.bodies) {
    const double half = std::asin(body.radius / body.position.norm());
    bearings.push_back(wrapAngle(bearingOf(body.position) - half));
    bearings.push_back(wrapAngle(bearingOf(body.position) + half));
  }
  for (const Segment& wall : scenery.walls) {
    bearings.push_back(bearingOf(wall.from));
    bearings.push_back(bearingOf(wall.to));
    for (const Segment& other : scenery.walls) {
      const Vector2 along = wall.to - wall.from;
      const double share = cross(other.from - wall.from, other.to - other.from) / cross(along, other.to - other.from);
      if (share > 0.0 && share < 1.0) bearings.push_back(bearingOf(wall.from + share * along));
    }
  }
  std::sort(bearings.begin(), bearings.end());
  return bearings;
}

/// What is seen, by looking in the middle between all bearings at which anything changes: which bodies, and how long
/// the seen parts of the walls are together [m].
struct Seen {
  std::vector<bool> bodies;
  double wall_length = 0.0;
};

Seen lookEverywhere(const Scenery& scenery) {
  Seen seen;
  seen.bodies.resize(scenery.bodies.size());
  const std::vector<double> bearings = criticalBearings(scenery);
  for (std::size_t i = 1; i < bearings.size(); ++i) {
    const Vector2 sight = unitVector(0.5 * (bearings[i - 1] + bearings[i]));
    double nearest = NO_HIT;
    std::size_t body = scenery.bodies.size();
    const Segment* wall = nullptr;
    for (std::size_t k = 0; k < scenery.bodies.size(); ++k) {
      const double distance = sightTo(scenery.bodies[k], sight);
      if (distance < nearest) {
        nearest = distance;
        body = k;
      }
    }
    for (const Segment& candidate : scenery.walls) {
      const double distance = sightTo(candidate, sight);
      if (distance < nearest) {
        nearest = distance;
        wall = &candidate;
      }
    }
    if (bearings[i] - bearings[i - 1] < 1e-7) continue;
    if (wall == nullptr && body < seen.bodies.size()) seen.bodies[body] = true;
    if (wall == nullptr) continue;
    const auto meet = [&](double bearing) -> Vector2 {
      const Vector2 along = wall->to - wall->from;
      const double share = cross(wall->from, unitVector(bearing)) / cross(unitVector(bearing), along);
      return wall->from + std::clamp(share, 0.0, 1.0) * along;
    };
    seen.wall_length += (meet(bearings[i]) - meet(bearings[i - 1])).norm();
  }
  return seen;
}

TEST(OcclusionProperty, AgreesWithLookingEverywhere) {
  std::size_t hidden = 0;
  std::size_t in_sight = 0;
  double hidden_length = 0.0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scenery scenery = randomScenery(seed, true);
    const Scenery seen = look(scenery);
    const Seen expected = lookEverywhere(scenery);
    for (std::size_t i = 0; i < scenery.bodies.size(); ++i) {
      EXPECT_EQ(contains(seen, scenery.bodies[i]), expected.bodies[i]) << "body " << i;
      ++(expected.bodies[i] ? in_sight : hidden);
    }
    double length = 0.0;
    for (const Segment& wall : seen.walls) length += (wall.to - wall.from).norm();
    EXPECT_NEAR(length, expected.wall_length, 1e-4);
    for (const Segment& wall : scenery.walls) hidden_length += (wall.to - wall.from).norm();
    hidden_length -= length;
  }
  EXPECT_GT(hidden, 500U);
  EXPECT_GT(in_sight, 500U);
  EXPECT_GT(hidden_length, 500.0);
}

TEST(OcclusionProperty, TakingSomethingAwayHidesNobody) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scenery scenery = randomScenery(seed, seed % 2 == 0);
    const Scenery seen = look(scenery);
    for (std::size_t i = 0; i < scenery.bodies.size() + scenery.walls.size(); ++i) {
      Scenery less = scenery;
      if (i < less.bodies.size()) {
        less.bodies.erase(less.bodies.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        less.walls.erase(less.walls.begin() + static_cast<std::ptrdiff_t>(i - less.bodies.size()));
      }
      const Scenery seen_then = look(less);
      for (const PerceivedBody& body : seen.bodies) {
        EXPECT_EQ(contains(seen_then, body), contains(less, body)) << "without " << i;
      }
    }
  }
}

TEST(OcclusionProperty, NearestBodyIsAlwaysSeenAndOrderIsKept) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scenery scenery = randomScenery(seed, true);
    scenery.walls.clear();
    if (scenery.bodies.empty()) continue;
    const Scenery seen = look(scenery);
    ASSERT_FALSE(seen.bodies.empty());
    EXPECT_EQ(seen.bodies[0].position, scenery.bodies[0].position);
    std::size_t last = 0;
    for (const PerceivedBody& body : seen.bodies) {
      std::size_t place = last;
      while (place < scenery.bodies.size() && scenery.bodies[place].position != body.position) ++place;
      ASSERT_LT(place, scenery.bodies.size());
      last = place;
    }
  }
}

TEST(OcclusionProperty, WhatIsHiddenHidesNothing) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scenery seen = look(randomScenery(seed, true));
    EXPECT_EQ(look(seen).bodies.size(), seen.bodies.size());
  }
}

}  // namespace
}  // namespace crowd
