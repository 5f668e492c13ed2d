// The motion limits of a world and of an episode, and how agents that are held brake.

#include <gtest/gtest.h>

#include "simulation/episode.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"

namespace crowd::world_motion_test {
namespace {

constexpr MotionLimits LIMITS{2.0, 3.0, INFINITE};

/// One agent of 1.3 m/s.
Scene alone() { return scenes::scene({scenes::wanderer({0.0, 0.0})}); }

/// A world with an agent that walks at 1.3 m/s and is then held.
World holding(const Scene& scene, const MotionLimits& limits) {
  World world(scene);
  world.step({ahead(0)});
  world.setMotion(limits);
  world.walkingAgent(0).setHeld(Hold::ROUTE, true);
  return world;
}

TEST(WorldMotion, HeldAgentsBrake) {
  for (const Scene& scene : {alone(), scenes::solid(alone())}) {
    World world = holding(scene, LIMITS);
    double x = 0.13;
    for (const double speed : {1.0, 0.7, 0.4, 0.1, 0.0, 0.0}) {
      world.step({ahead(0)});
      x += 0.1 * speed;
      expectVector(world.agents()[0].velocity, speed, 0.0);
      expectVector(world.agents()[0].pose.position, x, 0.0);
      EXPECT_FALSE(world.agents()[0].acted);
    }
  }
}

TEST(WorldMotion, SoDoAgentsThatYield) {
  World world = holding(alone(), LIMITS);
  world.walkingAgent(0).setHeld(Hold::ROUTE, false);
  world.walkingAgent(0).yielding = true;
  world.step({ahead(0)});
  expectVector(world.agents()[0].velocity, 1.0, 0.0);
}

TEST(WorldMotion, HeldAgentsKeepTheirDirectionWhileTheyBrake) {
  World world = holding(alone(), LIMITS);
  world.step({{0, {0.5 * PI, 1.0}}});
  expectVector(world.agents()[0].velocity, 1.0, 0.0);
  EXPECT_EQ(world.agents()[0].pose.heading, 0.0);
}

TEST(WorldMotion, HeldAgentsStandAtOnceWithoutLimits) {
  for (const Scene& scene : {alone(), scenes::solid(alone())}) {
    World world = holding(scene, MotionLimits());
    world.step({ahead(0)});
    EXPECT_EQ(world.agents()[0].velocity, Vector2(0.0, 0.0));
    expectVector(world.agents()[0].pose.position, 0.13, 0.0);
  }
}

TEST(WorldMotion, AgentsWithoutAnActionStandAtOnce) {
  World world = holding(alone(), LIMITS);
  world.step({});
  EXPECT_EQ(world.agents()[0].velocity, Vector2(0.0, 0.0));
  expectVector(world.agents()[0].pose.position, 0.13, 0.0);
}

TEST(WorldMotion, HeldAgentsBrakeInTheirTurn) {
  for (const Scene& scene : {alone(), scenes::solid(alone())}) {
    World world = holding(scene, LIMITS);
    world.moveAgent(0, {ahead(0)});
    world.endTick();
    expectVector(world.agents()[0].velocity, 1.0, 0.0);
    expectVector(world.agents()[0].pose.position, 0.23, 0.0);  // as far as its velocity says
  }
}

TEST(WorldMotion, ABrakingAgentStopsAtAnotherInASolidWorld) {
  // Their rims are 0.05 m apart when the first is held.
  World world =
      holding(scenes::solid(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({0.68, 0.0})})), LIMITS);
  world.step({ahead(0)});
  EXPECT_NEAR(world.agents()[0].pose.position.x(), 0.18, 1e-6);
  EXPECT_TRUE(world.agents()[0].in_contact);
}

TEST(WorldMotion, IsPerceived) {
  World world(alone());
  EXPECT_EQ(perceive(world).motion, MotionLimits());
  world.setMotion(LIMITS);
  EXPECT_EQ(perceive(world).motion, LIMITS);
}

/// At 1.5 m/s the way of a tick and the one until it stands are 0.525 m.
TEST(WorldMotion, WallsWithinTheStoppingWayArePerceived) {
  Vision vision;
  vision.wall_distance = 0.0;
  const auto count = [&](double distance, const MotionLimits& limits) {
    const Segment wall{{0.25 + distance, -1.0}, {0.25 + distance, 1.0}};
    World world(scenes::scene({scenes::wanderer({0.0, 0.0}, 1.5)}, {}, {wall}));
    world.setMotion(limits);
    return perceive(world, vision).walls.size();
  };
  EXPECT_EQ(count(0.52, LIMITS), 1U);
  EXPECT_EQ(count(0.53, LIMITS), 0U);
  EXPECT_EQ(count(0.16, MotionLimits()), 0U);
}

Vision visionOf(const MotionLimits& limits) {
  Vision vision;
  vision.motion = limits;
  return vision;
}

TEST(EpisodeMotion, IsThatOfTheVision) {
  Episode episode(alone(), 1, Vision());
  EXPECT_EQ(episode.perceptions().motion, MotionLimits());
  episode.setVision(visionOf(LIMITS));
  EXPECT_EQ(episode.perceptions().motion, LIMITS);
  EXPECT_EQ(episode.world().motion(), LIMITS);
  episode.setVision(Vision());
  EXPECT_EQ(episode.perceptions().motion, MotionLimits());
  EXPECT_EQ(Episode(alone(), 1, visionOf(LIMITS)).perceptions().motion, LIMITS);
}

TEST(EpisodeMotion, IsThatOfTheSceneIfItHasOne) {
  const MotionLimits own{1.0, 6.0, 2.0};
  Scene scene = alone();
  scene.motion = own;
  Episode episode(scene, 1, Vision());
  EXPECT_EQ(episode.perceptions().motion, own);
  episode.setVision(visionOf(LIMITS));
  EXPECT_EQ(episode.perceptions().motion, own);
  scene.motion = MotionLimits();  // unlimited
  EXPECT_EQ(Episode(scene, 1, visionOf(LIMITS)).perceptions().motion, MotionLimits());
}

}  // namespace
}  // namespace crowd::world_motion_test
