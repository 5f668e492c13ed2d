// Agents that stay in the world when they have arrived.

#include <gtest/gtest.h>

#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::world_staying_test {
namespace {

using scenes::agent;
using scenes::scene;
using scenes::wanderer;

/// Agent 0 walks 1 m in two ticks, and stays there; agent 1 walks towards it, 1.5 m behind it.
Scene line() {
  Scene made = scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({-1.5, 0.0}, 1.0)}));
  made.agents[0].stays = true;
  return made;
}

World walked(const Scene& scene, int ticks) {
  World world(scene);
  for (int i = 0; i < ticks; ++i) world.step({ahead(0), ahead(1)});
  return world;
}

TEST(Staying, AnAgentKeepsItsPlaceWhatItsActions) {
  World world = walked(line(), 2);
  const Agent& agent = world.agents()[0];
  EXPECT_EQ(agent.status, AgentStatus::STAYING);
  EXPECT_TRUE(agent.hasArrived());
  EXPECT_TRUE(agent.isPresent());
  EXPECT_FALSE(world.isActive(0));
  EXPECT_EQ(world.activeCount(), 1U);
  EXPECT_EQ(agent.arrival_tick, 2U);
  for (int i = 0; i < 6; ++i) {
    world.step({{0, {1.0, 1.0}}, ahead(1)});
    expectVector(agent.pose.position, 1.0, 0.0);
    expectVector(agent.velocity, 0.0, 0.0);
    EXPECT_EQ(agent.pose.heading, 0.0);
  }
  EXPECT_EQ(agent.arrival_tick, 2U);
  EXPECT_EQ(world.activeCount(), 1U);
}

/// What agent 1 perceives of agent 0.
Neighbour seenOf(const World& world) {
  const Perceptions seen = lookAround(world);
  const AgentPerception& self = seen.agents.back();
  EXPECT_EQ(self.agent, 1U);
  EXPECT_EQ(self.neighbour_count, 1U);
  return seen.neighbours[self.first_neighbour];
}

/// Also in the tick of its arrival, in which it has walked 0.5 m.
TEST(Staying, StandsFromItsArrivalOn) {
  World world = walked(line(), 1);
  expectVector(seenOf(world).velocity, 1.0, 0.0);
  world.step({ahead(0), ahead(1)});
  ASSERT_EQ(world.agents()[0].status, AgentStatus::STAYING);
  expectVector(world.agents()[0].velocity, 0.0, 0.0);
  expectVector(seenOf(world).velocity, 0.0, 0.0);
  World ended = walked(line(), 1);
  WorldEditor(ended).arrive(0);  // at (0.5, 0), as at the end of a route
  ASSERT_EQ(ended.agents()[0].status, AgentStatus::STAYING);
  expectVector(ended.agents()[0].velocity, 0.0, 0.0);
  expectVector(seenOf(ended).velocity, 0.0, 0.0);
}

TEST(Staying, IsPerceivedByOthersAndPerceivesNoMore) {
  World world = walked(line(), 2);
  Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.agents.size(), 2U);  // once more, to learn from its arrival
  EXPECT_TRUE(seen.agents[0].arrived);
  EXPECT_EQ(seen.agents[0].neighbour_count, 1U);
  ASSERT_EQ(seen.agents[1].neighbour_count, 1U);
  world.step({ahead(1)});
  seen = lookAround(world);
  ASSERT_EQ(seen.agents.size(), 1U);
  EXPECT_EQ(seen.agents[0].agent, 1U);
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);
  const Neighbour neighbour = seen.neighbours[seen.agents[0].first_neighbour];
  expectVector(neighbour.position, 1.0, 0.0);  // agent 1 is at (0, 0)
  expectVector(neighbour.velocity, 0.0, 0.0);
  EXPECT_EQ(neighbour.radius, scenes::RADIUS);
  EXPECT_EQ(neighbour.kind, NeighbourKind::AGENT);
  Viewers viewers;
  ASSERT_EQ(viewers.among(world, 0, world.grid().size()).size(), 1U);
  EXPECT_EQ(viewers[0].agent->id, 1U);
}

TEST(Staying, GhostsThatWalkThroughItAreInContact) {
  World world = walked(line(), 4);  // agent 1 at (0.5, 0): it touches, without an overlap
  EXPECT_FALSE(world.agents()[1].touched);
  EXPECT_TRUE(world.agents()[1].in_collision);
  world.step({ahead(1)});
  EXPECT_TRUE(world.agents()[1].in_contact);
  // Contacts and collisions of an agent count until it arrives.
  EXPECT_FALSE(world.agents()[0].in_contact);
  EXPECT_FALSE(world.agents()[0].touched);
  EXPECT_FALSE(world.agents()[0].collided);
}

TEST(Staying, StopsOthersInASolidWorld) {
  World world = walked(scenes::solid(line()), 8);
  expectVector(world.agents()[0].pose.position, 1.0, 0.0);
  EXPECT_NEAR(world.agents()[1].pose.position.x(), 0.5, 1e-6);
  EXPECT_GT(world.agents()[1].blocked_moves, 0U);
  EXPECT_TRUE(world.agents()[1].touched);
}

TEST(Staying, HasNoTurnsInASequentialWorld) {
  World world(line());
  for (int tick = 0; tick < 4; ++tick) {
    for (const AgentId id : {0U, 1U}) world.moveAgent(id, {ahead(0), ahead(1)});
    world.endTick();
  }
  expectVector(world.agents()[0].pose.position, 1.0, 0.0);
  expectVector(world.agents()[1].pose.position, 0.5, 0.0);
  const Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.agents.size(), 1U);
  EXPECT_EQ(seen.agents[0].neighbour_count, 1U);
}

TEST(Staying, TakesItsPlace) {
  const World world = walked(line(), 3);
  EXPECT_EQ(world.blockerAt({1.3, 0.0}, 0.25), "agent 0");
  EXPECT_EQ(world.blockerAt({1.6, 0.0}, 0.25), "");
}

}  // namespace
}  // namespace crowd::world_staying_test
