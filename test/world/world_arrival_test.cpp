// Arrival of agents at their goals.

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"

namespace crowd::world_arrival_test {
namespace {

using scenes::agent;
using scenes::scene;
using scenes::wanderer;

TEST(WorldArrival, IsWithinTheTolerance) {
  Scene line = scenes::halfSeconds(scene({agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}));
  line.goal_tolerance = 0.5;
  World world(line);
  EXPECT_EQ(world.activeCount(), 1U);
  for (int i = 0; i < 2; ++i) world.step({ahead(0)});
  EXPECT_TRUE(world.isActive(0));  // at x = 1
  world.step({ahead(0)});          // at x = 1.5, 0.5 m from the goal
  EXPECT_TRUE(world.agents()[0].hasArrived());
  EXPECT_EQ(world.agents()[0].arrival_tick, 3U);
  EXPECT_EQ(world.activeCount(), 0U);
  EXPECT_FALSE(world.isActive(0));
}

TEST(WorldArrival, IsNotOutsideTheTolerance) {
  Scene line = scenes::halfSeconds(scene({agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}));
  line.goal_tolerance = std::nextafter(0.5, 0.0);
  World world(line);
  for (int i = 0; i < 3; ++i) world.step({ahead(0)});
  EXPECT_TRUE(world.isActive(0));
}

TEST(WorldArrival, AtTheStartIsReportedAfterTheFirstTick) {
  World world(scene({agent({0.0, 0.0}, {0.1, 0.0}), wanderer({9.0, 9.0})}));
  EXPECT_TRUE(world.isActive(0));
  world.step({});
  EXPECT_EQ(world.agents()[0].arrival_tick, 1U);
}

TEST(WorldArrival, ReachesSeveralGoalsInOrder) {
  AgentStart rounder = agent({0.0, 0.0}, {2.0, 0.0}, 1.0);
  rounder.goals = {{2.0, 0.0}, {1.0, 0.0}, {3.0, 0.0}};
  World world(scenes::halfSeconds(scene({rounder})));
  const Agent& walker = world.agents()[0];
  for (int i = 0; i < 3; ++i) world.step({ahead(0)});
  expectVector(walker.goal(), 2.0, 0.0);  // it has passed (1, 0), which is not its present goal
  world.step({ahead(0)});
  expectVector(walker.goal(), 1.0, 0.0);
  world.step({{0, {PI, 1.0}}});
  expectVector(walker.goal(), 1.0, 0.0);
  world.step({ahead(0)});
  expectVector(walker.goal(), 3.0, 0.0);
  for (int i = 0; i < 3; ++i) world.step({{0, {i == 0 ? PI : 0.0, 1.0}}});
  EXPECT_TRUE(world.isActive(0));
  world.step({ahead(0)});
  EXPECT_TRUE(walker.hasArrived());
  EXPECT_EQ(walker.arrival_tick, 10U);
}

TEST(WorldArrival, ArrivedAgentsAreNeitherPerceivedNorTouched) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({-1.5, 0.0}, 1.0)})));
  for (int i = 0; i < 2; ++i) world.step({ahead(0), ahead(1)});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  const Perceptions after = lookAround(world);
  ASSERT_EQ(after.agents.size(), 2U);
  EXPECT_EQ(after.agents[1].neighbour_count, 0U);
  for (int i = 0; i < 4; ++i) {
    world.step({ahead(1)});  // through (1, 0), where agent 0 arrived
    EXPECT_FALSE(world.agents()[0].in_contact);
    EXPECT_FALSE(world.agents()[1].touched);
  }
  expectVector(world.agents()[1].pose.position, 1.5, 0.0);
}

TEST(WorldArrival, IsPerceivedExactlyOnce) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({0.0, 5.0})})));
  int arrivals = 0;
  for (int tick = 0; tick < 5; ++tick) {
    for (const AgentPerception& seen : lookAround(world).agents) {
      if (seen.agent != 0) continue;
      EXPECT_LE(world.tick(), 2U);
      EXPECT_EQ(seen.arrived, world.tick() == 2U);
      arrivals += seen.arrived ? 1 : 0;
    }
    world.step({ahead(0)});
  }
  EXPECT_EQ(arrivals, 1);
}

TEST(WorldArrival, ContactsAtTheEndOfTheArrivalTickCount) {
  // Agent 0 arrives at (0.5, 0), 0.4 m from agent 1: they overlap by 0.1 m.
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {0.5, 0.0}, 1.0), wanderer({0.9, 0.0})})));
  world.step({ahead(0)});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  EXPECT_TRUE(world.agents()[0].touched);
  EXPECT_TRUE(world.agents()[1].touched);
  world.step({});
  EXPECT_FALSE(world.agents()[1].in_contact);
  EXPECT_TRUE(world.agents()[1].touched);  // stays true
}

}  // namespace
}  // namespace crowd::world_arrival_test
