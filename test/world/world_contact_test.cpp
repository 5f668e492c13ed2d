// Contacts of agents with each other, obstacles and walls.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/scenes.h"
#include "support/seeds.h"
#include "world/world.h"

namespace crowd::world_contact_test {
namespace {

using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

/// Whether the first agent of a scene is in contact after a tick without moves.
bool isInContact(const Scene& scene) {
  World world(scene);
  EXPECT_FALSE(world.agents()[0].in_contact);  // contacts are determined by ticks
  world.step({});
  EXPECT_EQ(world.agents()[0].touched, world.agents()[0].in_contact);
  return world.agents()[0].in_contact;
}

TEST(WorldContact, BeginsAtAnOverlapOfOneMillimetre) {
  const auto beside = [](double gap) -> Vector2 { return Vector2(3.0, 4.0) + (0.5 + gap) * unitVector(2.0); };
  const AgentStart standing = wanderer({3.0, 4.0});
  EXPECT_FALSE(isInContact(scene({standing, wanderer(beside(0.001))})));
  EXPECT_FALSE(isInContact(scene({standing, wanderer(beside(-0.00099))})));
  EXPECT_TRUE(isInContact(scene({standing, wanderer(beside(-0.00101))})));
  EXPECT_FALSE(isInContact(scene({standing}, {pillar(beside(-0.00099), 0.25)})));
  EXPECT_TRUE(isInContact(scene({standing}, {pillar(beside(-0.00101), 0.25)})));
}

TEST(WorldContact, IncludesWalls) {
  const auto wall = [](double x) { return std::vector<Segment>{{{x, -1.0}, {x, 1.0}}}; };
  EXPECT_FALSE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(0.24901))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(0.24899))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(-0.1))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.1, 1.2})}, {}, wall(0.0))));   // 0.22 m from the wall's end
  EXPECT_FALSE(isInContact(scene({wanderer({0.2, 1.2})}, {}, wall(0.0))));  // 0.28 m
}

TEST(WorldContact, IncludesLargeObstaclesWithDistantCentres) {
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {pillar({20.2, 0.0}, 20.0)})));
  EXPECT_FALSE(isInContact(scene({wanderer({0.0, 0.0})}, {pillar({20.3, 0.0}, 20.0)})));
}

TEST(WorldContact, MovingObstaclePassesThroughAnAgent) {
  // Centres are 1 - 0.1 k m apart after tick k, radii sum up to 0.5 m: contact from tick 6 to 14.
  World world(scene({wanderer({1.0, 0.0}, 1.0, 0.2)}, {moving_obstacle({0.0, 0.0}, {1.0, 0.0}, 0.3)}));
  for (int tick = 1; tick <= 20; ++tick) {
    world.step({});
    EXPECT_EQ(world.agents()[0].in_contact, tick >= 6 && tick <= 14) << "tick " << tick;
    EXPECT_EQ(world.agents()[0].touched, tick >= 6) << "tick " << tick;
  }
}

/// Whether an agent overlaps anything by more than a millimetre; checks all bodies and walls.
bool overlapsSomething(const World& world, const Agent& agent) {
  const Vector2& at = agent.pose.position;
  const auto overlaps = [&](const Vector2& centre, double radius) {
    return agent.radius + radius - std::hypot(centre.x() - at.x(), centre.y() - at.y()) > 0.001;
  };
  bool contact = false;
  for (const Agent& other : world.agents()) {
    const bool on_the_floor = other.isWalking() || other.arrival_tick == world.tick();
    contact = contact || (on_the_floor && other.id != agent.id && overlaps(other.pose.position, other.radius));
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    contact = contact || overlaps(obstacle.path.position(world.time()), obstacle.radius);
  }
  for (const Segment& wall : world.walls().list()) contact = contact || overlaps(nearestPoint(wall, at), 0.0);
  return contact;
}

TEST(WorldContact, AgreesWithASearchOfAllBodies) {
  std::size_t contacts = 0;
  std::size_t arrivals = 0;
  forSeeds(40, KeyedRandom::EXPLORATION, [&](std::uint64_t seed, KeyedRandom& random) {
    World world(scenes::randomScene(seed, 60));
    std::vector<bool> touched(world.agents().size(), false);
    for (int tick = 0; tick < 40; ++tick) {
      world.step(scenes::randomActions(world, random));
      for (const Agent& agent : world.agents()) {
        const bool arrives = agent.hasArrived() && agent.arrival_tick == world.tick();
        const bool contact = (agent.isWalking() || arrives) && overlapsSomething(world, agent);
        touched[agent.id] = touched[agent.id] || contact;
        ASSERT_EQ(agent.in_contact, contact) << "tick " << world.tick() << ", agent " << agent.id;
        ASSERT_EQ(agent.touched, touched[agent.id]) << "tick " << world.tick() << ", agent " << agent.id;
        contacts += contact ? 1 : 0;
        arrivals += arrives ? 1 : 0;
      }
    }
  });
  EXPECT_GT(contacts, 1000U);
  EXPECT_GT(arrivals, 5U);
}

}  // namespace
}  // namespace crowd::world_contact_test
