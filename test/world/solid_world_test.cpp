// Worlds in which bodies stop where they touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::solid_world_test {
namespace {

using scenes::moving_obstacle;
using scenes::scene;
using scenes::solid;
using scenes::wanderer;

/// Two agents of 1 m/s in ticks of 0.5 s: they walk 0.5 m at a time.
Scene halfMetres(const Vector2& first, const Vector2& second, std::vector<Segment> walls = {}) {
  return solid(scenes::halfSeconds(scene({wanderer(first, 1.0), wanderer(second, 1.0)}, {}, std::move(walls))));
}

TEST(SolidWorld, BlockedMoveByHand) {
  World world(halfMetres({0.0, 0.0}, {0.75, 0.0}));
  world.step({{0, {0.0, 1.0}}});
  const Agent& walker = world.agents()[0];
  const Agent& stander = world.agents()[1];
  EXPECT_DOUBLE_EQ(walker.pose.position.x(), 0.25);
  EXPECT_DOUBLE_EQ(walker.velocity.x(), 0.5);  // 0.25 m in 0.5 s
  EXPECT_TRUE(walker.acted);
  EXPECT_TRUE(walker.blocked);
  EXPECT_EQ(walker.blocked_moves, 1U);
  EXPECT_TRUE(walker.in_contact && walker.touched);
  EXPECT_FALSE(stander.blocked);
  EXPECT_EQ(stander.blocked_moves, 0U);
  EXPECT_TRUE(stander.in_contact && stander.touched);

  world.step({{0, {0.0, 1.0}}});  // it stays in contact
  EXPECT_DOUBLE_EQ(walker.pose.position.x(), 0.25);
  EXPECT_EQ(walker.blocked_moves, 2U);

  world.step({{0, {PI / 2, 1.0}}});  // it can walk aside
  EXPECT_DOUBLE_EQ(walker.pose.position.y(), 0.5);
  EXPECT_FALSE(walker.blocked || walker.in_contact || stander.in_contact);
  EXPECT_EQ(walker.blocked_moves, 2U);
  EXPECT_TRUE(walker.touched && stander.touched);
}

TEST(SolidWorld, TurningIsNeverBlocked) {
  World world(halfMetres({0.0, 0.0}, {0.5, 0.0}));
  world.step({{0, {0.5, 1.0}}});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.heading, 0.5);
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 0.0);
  world.step({{0, {-0.5, 0.0}}});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.heading, 0.0);
  EXPECT_FALSE(world.agents()[0].blocked);  // its action was to stay
  EXPECT_FALSE(world.agents()[0].in_contact);
}

TEST(SolidWorld, TouchingWithoutBlockingIsNoContact) {
  World world(halfMetres({0.0, 0.0}, {1.0, 0.0}));
  world.step({{0, {0.0, 1.0}}});  // up to the other agent
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 0.5);
  EXPECT_FALSE(world.agents()[0].touched || world.agents()[1].touched);
}

TEST(SolidWorld, ArrivedAgentsDoNotBlock) {
  Scene line = halfMetres({0.0, 0.0}, {1.5, 0.0});
  line.agents[1].goals = {{1.5, 0.0}};
  World world(line);
  world.step({{0, {0.0, 1.0}}});
  ASSERT_TRUE(world.agents()[1].hasArrived());
  for (int i = 0; i < 3; ++i) world.step({{0, {0.0, 1.0}}});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 2.0);
  EXPECT_FALSE(world.agents()[0].touched);
}

TEST(SolidWorld, MovingObstaclePushesAnAgent) {
  // From 1 m away at 0.5 m a tick; radii sum up to 0.5 m: it pushes from the second tick on.
  World world(
      solid(scenes::halfSeconds(scene({wanderer({1.0, 0.0})}, {moving_obstacle({0.0, 0.0}, {1.0, 0.0}, 0.25)}))));
  const Agent& pushed = world.agents()[0];
  for (int tick = 1; tick <= 6; ++tick) {
    world.step({});
    EXPECT_NEAR(pushed.pose.position.x(), std::max(1.0, 0.5 * tick + 0.5), 1e-12) << "tick " << tick;
    EXPECT_EQ(pushed.in_contact, tick >= 2) << "tick " << tick;
    EXPECT_EQ(pushed.velocity.x() > 0.9, tick >= 2) << "tick " << tick;
  }
  EXPECT_EQ(pushed.blocked_moves, 0U);  // it made no move
}

TEST(SolidWorld, MovingObstacleThatPassesOverAnAgentIsInContactWithIt) {
  World world(solid(scenes::halfSeconds(
      scene({wanderer({1.0, 0.0})}, {moving_obstacle({0.0, 0.0}, {1.0, 0.0}, 0.25)}, {{{1.25, -1.0}, {1.25, 1.0}}}))));
  for (int tick = 1; tick <= 2; ++tick) world.step({});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 1.0);  // at the wall
  EXPECT_TRUE(world.agents()[0].in_contact);
}

TEST(SolidWorld, MovingObstacleTurnsWithinATick) {
  // In one tick the obstacle moves 0.75 m forth and 0.25 m back: it ends 0.5 m nearer.
  Scene scene = solid(scenes::halfSeconds(scenes::scene({wanderer({9.0, 9.0})})));
  scene.obstacles.push_back({ObstaclePath::toAndFro({{0.0, 0.0}, {0.75, 0.0}}, 2.0), 0.25});
  scene.agents.push_back(wanderer({0.9, 0.0}, 1.0, 0.25));
  World world(scene);
  world.step({});
  EXPECT_DOUBLE_EQ(world.agents()[1].pose.position.x(), 1.0);  // pushed by 0.1 m, to 0.5 m from the obstacle
}

TEST(SolidWorld, RefusesSpawnedBodiesWithAnyOverlap) {
  World ghost(scene({wanderer({0.0, 0.0})}, {}, {{{-1.0, -2.0}, {1.0, -2.0}}}));
  World world(solid(scene({wanderer({0.0, 0.0})}, {}, {{{-1.0, -2.0}, {1.0, -2.0}}})));
  const AgentStart tight = wanderer({0.4995, 0.0});
  const AgentStart at_wall = wanderer({0.0, -1.7505});
  EXPECT_NO_THROW(WorldEditor(ghost).spawnAgent(tight));
  EXPECT_NO_THROW(WorldEditor(ghost).spawnAgent(at_wall));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { WorldEditor(world).spawnAgent(tight); }), "agent 0"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { WorldEditor(world).spawnAgent(at_wall); }), "wall"));
  EXPECT_EQ(WorldEditor(world).spawnAgent(wanderer({0.5, 0.0})), 1U);
}

}  // namespace
}  // namespace crowd::solid_world_test
