// Collisions as the thesis defines them (4.1): a rim comes within the inner radius, 0.5 from the agent's centre.

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::collision_test {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

/// The world of an agent of radius 0.25 at the origin after a tick in which it stayed.
World afterATick(std::vector<Obstacle> obstacles, std::vector<Segment> walls = {}) {
  World world(scene({wanderer({0.0, 0.0})}, std::move(obstacles), std::move(walls)));
  world.step({});
  return world;
}

TEST(Collision, BeginsWhenARimIsWithinTheInnerRadius) {
  EXPECT_TRUE(afterATick({pillar({0.75, 0.0}, 0.25)}).agents()[0].in_collision);  // the rim is 0.5 away, exactly
  EXPECT_FALSE(afterATick({pillar({std::nextafter(0.75, 1.0), 0.0}, 0.25)}).agents()[0].in_collision);
  EXPECT_TRUE(afterATick({pillar({0.0, -0.8}, 0.4)}).agents()[0].in_collision);   // 0.4
  EXPECT_FALSE(afterATick({pillar({0.0, -0.8}, 0.2)}).agents()[0].in_collision);  // 0.6
}

TEST(Collision, DoesNotImplyAContact) {
  const World near = afterATick({pillar({0.7, 0.0}, 0.4)});  // the rim is 0.3 away, the bodies 0.05 apart
  EXPECT_TRUE(near.agents()[0].in_collision && near.agents()[0].collided);
  EXPECT_FALSE(near.agents()[0].in_contact || near.agents()[0].touched);
  const World overlapping = afterATick({pillar({0.6, 0.0}, 0.4)});
  EXPECT_TRUE(overlapping.agents()[0].in_collision && overlapping.agents()[0].in_contact);
}

TEST(Collision, IncludesOverlaps) { EXPECT_TRUE(afterATick({pillar({0.0, 1.0}, 3.0)}).agents()[0].in_collision); }

TEST(Collision, IncludesWalls) {
  EXPECT_TRUE(afterATick({}, {{{0.5, -1.0}, {0.5, 1.0}}}).agents()[0].in_collision);
  EXPECT_FALSE(afterATick({}, {{{0.51, -1.0}, {0.51, 1.0}}}).agents()[0].in_collision);
}

TEST(Collision, DependsOnTheRadiusOfTheOtherAgent) {
  World world(scene({wanderer({0.0, 0.0}, 1.0, 0.1), wanderer({0.7, 0.0}, 1.0, 0.3)}));
  world.step({});
  EXPECT_TRUE(world.agents()[0].in_collision);   // 0.7 - 0.3 = 0.4
  EXPECT_FALSE(world.agents()[1].in_collision);  // 0.7 - 0.1 = 0.6
}

TEST(Collision, AWideAgentCanBeInContactWithoutACollision) {
  World world(scene({wanderer({0.0, 0.0}, 1.0, 1.0)}, {pillar({1.0, 0.0}, 0.25)}));  // the rim is 0.75 away
  world.step({});
  EXPECT_FALSE(world.agents()[0].in_collision);
  EXPECT_TRUE(world.agents()[0].in_contact);
}

TEST(Collision, UsesTheRadiusOfTheScene) {
  Scene narrow = scene({wanderer({0.0, 0.0})}, {pillar({0.75, 0.0}, 0.25)});
  narrow.collision_radius = 0.4;
  World world(narrow);
  world.step({});
  EXPECT_FALSE(world.agents()[0].in_collision);
}

TEST(Collision, IsRecordedAfterItHasEnded) {
  // The obstacle passes at 5 m/s: its rim is 0.5 away after the first tick and 1 m after the second.
  World world(scene({wanderer({0.0, 0.0})}, {moving_obstacle({0.5, 0.75}, {-5.0, 0.0}, 0.25)}));
  EXPECT_FALSE(world.agents()[0].collided);
  world.step({});
  EXPECT_TRUE(world.agents()[0].in_collision && world.agents()[0].collided);
  world.step({});
  world.step({});
  EXPECT_FALSE(world.agents()[0].in_collision);
  EXPECT_TRUE(world.agents()[0].collided);
}

TEST(Collision, EndsWhenTheAgentHasArrived) {
  World world(scene({agent({0.0, 0.0}, {0.3, 0.0}, 1.0), wanderer({0.6, 0.0}, 1.0)}));
  world.step({ahead(0)});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  EXPECT_TRUE(world.agents()[0].in_collision);  // with the other, when it arrived
  world.step({});
  EXPECT_FALSE(world.agents()[0].in_collision);
  EXPECT_FALSE(world.agents()[1].in_collision);  // an agent that has arrived has left
  EXPECT_TRUE(world.agents()[0].collided && world.agents()[1].collided);
}

/// The definition, looked up agent by agent.
bool collides(const World& world, const Agent& agent) {
  for (const Agent& other : world.agents()) {
    const double rim = (other.pose.position - agent.pose.position).norm() - other.radius;
    const bool is_there = other.isWalking() || other.arrival_tick == world.tick();
    if (other.id != agent.id && is_there && rim <= 0.5) return true;
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    if ((obstacle.path.position(world.time()) - agent.pose.position).norm() - obstacle.radius <= 0.5) return true;
  }
  for (const Segment& wall : world.walls().list()) {
    if (distanceTo(wall, agent.pose.position) <= 0.5) return true;
  }
  return false;
}

TEST(Collision, AgreesWithItsDefinitionInRandomWorlds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    World world(scenes::randomScene(seed));
    std::vector<bool> ever(world.agents().size(), false);
    for (int tick = 0; tick < 20; ++tick) {
      world.step(scenes::purposefulActions(world, random));
      for (const Agent& agent : world.agents()) {
        if (!agent.isWalking()) continue;
        ASSERT_EQ(agent.in_collision, collides(world, agent)) << "agent " << agent.id << ", tick " << tick;
        ever[agent.id] = ever[agent.id] || agent.in_collision;
        ASSERT_EQ(agent.collided, ever[agent.id]);
      }
    }
  }
}

}  // namespace
}  // namespace crowd::collision_test
