// Agents that move one after the other within a tick (thesis, algorithms 3.3 and 3.4).

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/impact.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::sequential_world_test {
namespace {

using scenes::moving_obstacle;
using scenes::scene;
using scenes::wanderer;

/// Agents of 1 m/s in ticks of 0.5 s.
Scene halfMetres(std::vector<AgentStart> agents, std::vector<Obstacle> obstacles = {}) {
  return scenes::halfSeconds(scene(std::move(agents), std::move(obstacles)));
}

Perceptions lookOf(World& world, AgentId id) {
  Perceptions perceptions;
  Viewers viewers;
  Perceiver().perceive(world, FAR_SIGHT, viewers.one(world, id), perceptions);
  return perceptions;
}

TEST(SequentialWorld, PerceptionContainsMovesOfEarlierTurns) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({2.0, 0.0}, 1.0)}));
  world.moveAgent(0, {ahead(0)});
  const Perceptions seen = lookOf(world, 1);
  ASSERT_EQ(seen.agents.size(), 1U);
  EXPECT_EQ(seen.agents[0].agent, 1U);
  EXPECT_EQ(seen.tick, 0U);
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);
  expectVector(seen.neighbours[0].position, -1.5, 0.0);  // 0.5 - 2
  expectVector(seen.neighbours[0].velocity, 1.0, 0.0);
}

TEST(SequentialWorld, PerceptionContainsThePreviousTickOfLaterTurns) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({2.0, 0.0}, 1.0)}));
  world.moveAgent(0, {ahead(0)});
  world.moveAgent(1, {{1, {PI, 1.0}}});
  world.endTick();
  EXPECT_EQ(world.tick(), 1U);
  const Perceptions seen = lookOf(world, 0);
  expectVector(seen.neighbours[0].position, 1.0, 0.0);  // 1.5 - 0.5
  expectVector(seen.neighbours[0].velocity, -1.0, 0.0);
}

TEST(SequentialWorld, ObstaclesMoveAtTheEndOfTheTick) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0)}, {moving_obstacle({3.0, 0.0}, {0.0, 1.0}, 0.2)}));
  world.moveAgent(0, {});
  expectVector(lookOf(world, 0).neighbours[0].position, 3.0, 0.0);
  world.endTick();
  expectVector(lookOf(world, 0).neighbours[0].position, 3.0, 0.5);
}

TEST(SequentialWorld, AnAgentThatStaysInItsTurnIsPerceivedWithoutVelocity) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({2.0, 0.0}, 1.0)}));
  world.step({ahead(0)});
  world.moveAgent(0, {});
  expectVector(lookOf(world, 1).neighbours[0].position, -1.5, 0.0);
  expectVector(lookOf(world, 1).neighbours[0].velocity, 0.0, 0.0);
}

TEST(SequentialWorld, AnAgentWithoutATurnStays) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({2.0, 0.0}, 1.0)}));
  world.step({ahead(0), ahead(1)});
  world.moveAgent(0, {ahead(0)});
  world.endTick();
  EXPECT_TRUE(world.agents()[0].acted);
  EXPECT_FALSE(world.agents()[1].acted);
  expectVector(world.agents()[1].pose.position, 2.5, 0.0);
  expectVector(world.agents()[1].velocity, 0.0, 0.0);
}

TEST(SequentialWorld, UsesOnlyTheActionOfTheAgent) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({2.0, 0.0}, 1.0)}));
  world.moveAgent(0, {ahead(1), ahead(0)});
  expectVector(world.agents()[0].pose.position, 0.5, 0.0);
  expectVector(world.agents()[1].pose.position, 2.0, 0.0);
}

TEST(SequentialWorld, RefusesAnInvalidActionBeforeAnythingMoves) {
  World world(halfMetres({wanderer({0.0, 0.0}, 1.0)}));
  EXPECT_TRUE(contains(errorOf<InputError>([&] {
                         world.moveAgent(0, {ahead(0), {0, {0.0, 2.0}}});
                       }),
                       "expected a finite rotation and a fraction of the maximum speed from 0 to 1"));
  expectVector(world.agents()[0].pose.position, 0.0, 0.0);
}

TEST(SequentialWorld, SolidAgentsStopAtThePresentPositionsOfOthers) {
  // Their rims are 0.25 m apart. The first agent walks up to the second, which then walks away.
  World world(scenes::solid(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({0.75, 0.0}, 1.0)})));
  world.moveAgent(0, {ahead(0)});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 0.25);
  world.moveAgent(1, {ahead(1)});
  EXPECT_DOUBLE_EQ(world.agents()[1].pose.position.x(), 1.25);
  world.endTick();
  EXPECT_TRUE(world.agents()[0].blocked);
  EXPECT_FALSE(world.agents()[1].blocked);
  EXPECT_TRUE(world.agents()[0].in_contact && world.agents()[1].in_contact);  // the first walked into the second
  world.endTick();
  EXPECT_FALSE(world.agents()[0].in_contact || world.agents()[1].in_contact);
  // In a simultaneous step they keep their distance.
  World together(scenes::solid(halfMetres({wanderer({0.0, 0.0}, 1.0), wanderer({0.75, 0.0}, 1.0)})));
  together.step({ahead(0), ahead(1)});
  EXPECT_FALSE(together.agents()[0].blocked);
}

TEST(SequentialWorld, SolidObstaclesPushAtTheEndOfTheTick) {
  // The obstacle approaches at 1 m/s; after the agent's turn their rims are 0.25 m apart.
  World world(
      scenes::solid(halfMetres({wanderer({0.0, 0.0}, 1.0)}, {moving_obstacle({0.75, 0.0}, {-1.0, 0.0}, 0.25)})));
  world.moveAgent(0, {{0, {PI / 2, 0.0}}});
  world.endTick();
  EXPECT_NEAR(world.agents()[0].pose.position.x(), -0.25, 1e-12);
  EXPECT_NEAR(world.agents()[0].velocity.x(), -0.5, 1e-12);  // 0.25 m in 0.5 s
  EXPECT_FALSE(world.agents()[0].blocked);
  EXPECT_TRUE(world.agents()[0].in_contact);
}

/// A tick with a turn for each agent.
void walkOneByOne(World& world, const std::vector<AgentAction>& actions) {
  for (AgentId id = 0; id < world.agents().size(); ++id) {
    if (world.isPerceiving(world.agents()[id])) world.moveAgent(id, actions);
  }
  world.endTick();
}

TEST(SequentialWorld, GhostsWithGivenActionsMoveAsInASimultaneousWorld) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = seed % 4 == 3 ? scenes::randomCrowd(seed) : scenes::randomScene(seed);
    World together(scene);
    World one_by_one(scene);
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 8; ++tick) {
      const std::vector<AgentAction> actions = scenes::purposefulActions(together, random);
      together.step(actions);
      walkOneByOne(one_by_one, actions);
      ASSERT_EQ(stateOf(one_by_one), stateOf(together)) << "tick " << tick;
      Perceptions expected;
      Perceptions seen;
      perceive(together, Vision(), expected);
      perceive(one_by_one, Vision(), seen);
      ASSERT_EQ(seen.neighbours.size(), expected.neighbours.size());
      for (std::size_t i = 0; i < seen.neighbours.size(); ++i) {
        ASSERT_EQ(seen.neighbours[i].position, expected.neighbours[i].position);
        ASSERT_EQ(seen.neighbours[i].velocity, expected.neighbours[i].velocity);
      }
    }
  }
}

TEST(SequentialWorld, SolidBodiesNeverOverlap) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(scenes::solidCrowd(seed, 24, 2.0));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 20; ++tick) {
      walkOneByOne(world, scenes::randomActions(world, random));
      for (const Agent& agent : world.agents()) {
        for (const Agent& other : world.agents()) {
          const double distance = (agent.pose.position - other.pose.position).norm();
          ASSERT_TRUE(agent.id == other.id || distance > agent.radius + other.radius - TOUCH_TOLERANCE);
        }
      }
    }
  }
}

}  // namespace
}  // namespace crowd::sequential_world_test
