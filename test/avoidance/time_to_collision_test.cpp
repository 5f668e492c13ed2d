#include "avoidance/time_to_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/random.h"
#include "support/perceptions.h"

namespace crowd::time_to_collision_test {
namespace {

TEST(TimeToCollision, OfTwoDiscs) {
  EXPECT_DOUBLE_EQ(timeToCollision(Vector2(5.0, 0.0), {2.0, 0.0}, 1.0), 2.0);  // 4 m at 2 m/s
  EXPECT_DOUBLE_EQ(timeToCollision(Vector2(4.0, 0.6), {1.0, 0.0}, 1.0),
                   3.2);                                                   // contact 0.8 m before the closest approach
  EXPECT_EQ(timeToCollision(Vector2(4.0, 1.01), {1.0, 0.0}, 1.0), NEVER);  // passes without contact
  EXPECT_EQ(timeToCollision(Vector2(5.0, 0.0), {-2.0, 0.0}, 1.0), NEVER);  // moves away
  EXPECT_EQ(timeToCollision(Vector2(5.0, 0.0), {0.0, 0.0}, 1.0), NEVER);
  EXPECT_EQ(timeToCollision(Vector2(0.5, 0.0), {1.0, 0.0}, 1.0), 0.0);     // overlaps and approaches
  EXPECT_EQ(timeToCollision(Vector2(0.5, 0.0), {-1.0, 0.0}, 1.0), NEVER);  // overlaps and moves away
}

TEST(TimeToCollision, OfADiscAndAWall) {
  const Segment wall{{3.0, -1.0}, {3.0, 1.0}};
  EXPECT_DOUBLE_EQ(timeToCollision(wall, {2.0, 0.0}, 1.0), 1.0);
  EXPECT_EQ(timeToCollision(wall, {-2.0, 0.0}, 1.0), NEVER);
  EXPECT_EQ(timeToCollision(wall, {0.0, 1.0}, 1.0), NEVER);  // along it
  const Segment beside{{3.0, 0.6}, {3.0, 5.0}};
  EXPECT_DOUBLE_EQ(timeToCollision(beside, {1.0, 0.0}, 1.0),
                   2.2);  // its end, 0.6 m aside: contact 0.8 m before the closest approach
  const Segment further{{3.0, 1.5}, {3.0, 5.0}};
  EXPECT_EQ(timeToCollision(further, {1.0, 0.0}, 1.0), NEVER);
}

/// Reference: moves in small steps until contact.
double walked(const Segment& wall, const Vector2& velocity, double radius) {
  for (int i = 0; i < 10000; ++i) {
    if (distanceTo(wall, 0.001 * i * velocity) <= radius) return 0.001 * i;
  }
  return NEVER;
}

TEST(TimeToCollision, OfAWallAgreesWithASimulatedWalk) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Segment wall{{random.uniform(-4, 4), random.uniform(-4, 4)}, {random.uniform(-4, 4), random.uniform(-4, 4)}};
    const Vector2 velocity = polar(random.uniform(-180, 180), random.uniform(0.5, 2.0));
    if (distanceTo(wall, Vector2::Zero()) <= 0.31) continue;
    const double expected = walked(wall, velocity, 0.3);
    const double time = timeToCollision(wall, velocity, 0.3);
    if (expected == NEVER && time < 9.9) {  // a graze between two steps
      EXPECT_NEAR(distanceTo(wall, time * velocity), 0.3, 1e-9) << "case " << i;
      continue;
    }
    if (expected == NEVER) continue;
    ++met;
    EXPECT_NEAR(time, expected, 0.0011) << "case " << i;
  }
  EXPECT_GT(met, 50);
}

TEST(TimeToCollision, OfAPerceptionIsTheEarliestOfAllBodiesAndWalls) {
  auto scene = PerceptionsBuilder().agent(0, {9.0, 0.0}).neighbour({4.5, 0.0}, 0.25).wall({2.25, -1.0}, {2.25, 1.0});
  EXPECT_DOUBLE_EQ(timeToCollision(scene.perception(), {1.0, 0.0}), 2.0);
  EXPECT_EQ(timeToCollision(scene.perception(), {-1.0, 0.0}), NEVER);
}

constexpr std::size_t MIDDLE = 1;  // of three agents

/// An agent with neighbours at random places, a few of which overlap it, between two agents whose neighbours all
/// overlap them: data of the others in the list must not be used.
PerceptionsBuilder sceneOf(std::size_t neighbours, KeyedRandom& random) {
  PerceptionsBuilder scene;
  addTouchedAgent(0, scene);
  scene.agent(MIDDLE, {9.0, 0.0});
  for (std::size_t i = 0; i < neighbours; ++i) {
    scene.neighbour(polar(random.uniform(-180, 180), random.uniform(0.5, 6.0)), random.uniform(0.1, 0.4));
    scene.velocity(Vector2::Zero(), polar(random.uniform(-180, 180), random.uniform(0.0, 1.5)));
  }
  addTouchedAgent(2, scene);
  return scene;
}

TEST(TimeToCollision, OfManyBodiesEqualsTheMinimumOverTheBodies) {
  std::size_t never = 0;
  std::size_t at_once = 0;
  std::array<std::size_t, 3> met_first{};  // how often it is among the first 16 neighbours, the next 16, the rest
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    for (std::size_t count = 0; count <= 40; ++count) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(count) + " bodies");
      const PerceptionsBuilder scene = sceneOf(count, random);
      const Perception seen = scene.perception(MIDDLE);
      const Vector2 velocity = polar(random.uniform(-180, 180), random.uniform(0.0, 1.5));
      std::vector<double> times;
      for (const Neighbour& neighbour : seen.neighbours) {
        times.push_back(
            timeToCollision(neighbour.position, velocity - neighbour.velocity, seen.self.radius + neighbour.radius));
      }
      const auto first = std::min_element(times.begin(), times.end());
      const double expected = first == times.end() ? NEVER : *first;
      EXPECT_EQ(timeToCollision(seen, velocity), expected);
      never += expected == NEVER ? 1 : 0;
      at_once += expected == 0.0 ? 1 : 0;
      if (expected < NEVER) ++met_first[static_cast<std::size_t>(first - times.begin()) / 16];
    }
  }
  EXPECT_GT(never, 50U);
  EXPECT_GT(at_once, 50U);
  for (const std::size_t times : met_first) EXPECT_GT(times, 20U);
}

}  // namespace
}  // namespace crowd::time_to_collision_test
