#include "world/perception.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::perception_test {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

/// The number of bodies that agent 0 of a scene perceives.
std::size_t bodyCount(const Scene& scene, double vision_radius) {
  return perceive(scene, {vision_radius, 0}).agents.at(0).neighbour_count;
}

TEST(PerceptionFrame, PositionsAndGoalByHand) {
  AgentStart north = agent({1.0, 1.0}, {4.0, 2.0}, 1.5, 0.3);
  north.heading = PI / 2;
  const Perceptions seen = perceive(scene({north, wanderer({1.0, 3.0}, 1.0, 0.2)}, {pillar({0.0, 0.0}, 0.4)}));
  const AgentPerception& self = seen.agents.at(0);
  EXPECT_EQ(self.agent, 0U);
  expectVector(self.pose.position, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(self.pose.heading, PI / 2);
  EXPECT_EQ(self.max_speed, 1.5);
  EXPECT_EQ(self.radius, 0.3);
  expectVector(self.goal, 1.0, -3.0);  // 1 m ahead, 3 m to the right
  EXPECT_FALSE(self.arrived);
  EXPECT_FALSE(self.acted);

  const Perception perception(seen, 0);
  ASSERT_EQ(perception.neighbours.size(), 2U);
  expectVector(perception.neighbours[0].position, -1.0, 1.0);  // behind on the left, rim at 1.01 m
  EXPECT_EQ(perception.neighbours[0].radius, 0.4);
  EXPECT_EQ(perception.neighbours[0].kind, NeighbourKind::OBSTACLE);
  expectVector(perception.neighbours[1].position, 2.0, 0.0);  // ahead, rim at 1.8 m
  EXPECT_EQ(perception.neighbours[1].radius, 0.2);
  EXPECT_EQ(perception.neighbours[1].kind, NeighbourKind::AGENT);
}

TEST(PerceptionFrame, VelocitiesByHand) {
  // Agent 0 turns north and walks at 0.5 m/s, agent 1 walks west at 1 m/s, the obstacle goes north-east.
  World world(scene({wanderer({0.0, 0.0}, 1.0), wanderer({3.0, 0.0}, 1.0), wanderer({0.0, 4.0})},
                    {moving_obstacle({-2.0, 0.0}, {0.25, 0.5}, 0.5)}));
  world.step({{0, {PI / 2, 0.5}}, {1, {PI, 1.0}}});
  const Perceptions seen = perceive(world);
  const Perception perception(seen, 0);
  expectVector(perception.self.velocity, 0.5, 0.0);
  EXPECT_TRUE(perception.self.acted);
  ASSERT_EQ(perception.neighbours.size(), 3U);
  expectVector(perception.neighbours[0].position, 0.0, 1.975);  // the obstacle, 1.475 m to its rim
  expectVector(perception.neighbours[0].velocity, 0.5, -0.25);
  expectVector(perception.neighbours[1].position, -0.05, -2.9);
  expectVector(perception.neighbours[1].velocity, 0.0, 1.0);  // west is on the left
  expectVector(perception.neighbours[2].velocity, 0.0, 0.0);
  EXPECT_FALSE(seen.agents[2].acted);
}

TEST(PerceptionFrame, VelocityOfAStoppedAgentIsZero) {
  World world(scene({wanderer({0.0, 0.0}), wanderer({3.0, 0.0})}));
  world.step({{0, {0.0, 1.0}}, {1, {0.0, 1.0}}});
  world.step({});
  const Perceptions seen = perceive(world);
  expectVector(seen.agents[0].velocity, 0.0, 0.0);
  expectVector(seen.neighbours[0].velocity, 0.0, 0.0);
}

TEST(PerceptionFrame, GoalIsTheNextOfSeveralGoals) {
  AgentStart rounder = agent({0.0, 0.0}, {0.5, 0.0}, 1.0);
  rounder.goals.emplace_back(0.5, 7.0);
  World world(scenes::halfSeconds(scene({rounder})));
  expectVector(perceive(world).agents[0].goal, 0.5, 0.0);
  world.step({{0, {0.0, 1.0}}});
  expectVector(perceive(world).agents[0].goal, 0.0, 7.0);
}

TEST(PerceptionRange, IsMeasuredToTheRim) {
  const auto count = [](double x, double radius) {
    return bodyCount(scene({wanderer({0.0, 0.0})}, {pillar({x, 0.0}, radius)}), 2.0);
  };
  EXPECT_EQ(count(2.25, 0.25), 1U);  // the rim is exactly at the limit
  EXPECT_EQ(count(2.2501, 0.25), 0U);
  EXPECT_EQ(count(-4.9, 3.0), 1U);
  EXPECT_EQ(count(-5.1, 3.0), 0U);
  EXPECT_EQ(count(0.1, 0.05), 1U);  // inside the own body
}

TEST(PerceptionRange, ZeroVisionPerceivesOverlappingBodies) {
  EXPECT_EQ(bodyCount(scene({wanderer({0.0, 0.0}), wanderer({0.2, 0.0}), wanderer({0.3, 0.0})}), 0.0), 1U);
}

TEST(PerceptionOrder, SortsNeighboursByRimDistance) {
  // Centres at 3, 1.5, 5 and 2 m, rims at 2.9, 1.4, 0.5 and 1.75 m.
  const Perceptions seen =
      perceive(scene({wanderer({0.0, 0.0}), wanderer({0.0, 2.0})},
                     {pillar({3.0, 0.0}, 0.1), pillar({-1.5, 0.0}, 0.1), pillar({0.0, -5.0}, 4.5)}));
  const Perception perception(seen, 0);
  ASSERT_EQ(perception.neighbours.size(), 4U);
  expectVector(perception.neighbours[0].position, 0.0, -5.0);
  expectVector(perception.neighbours[1].position, -1.5, 0.0);
  expectVector(perception.neighbours[2].position, 0.0, 2.0);
  expectVector(perception.neighbours[3].position, 3.0, 0.0);
}

TEST(PerceptionOrder, MaxNeighboursKeepsTheNearestRims) {
  const Scene crowded = scene({wanderer({0.0, 0.0}), wanderer({0.0, 2.0})},
                              {pillar({3.0, 0.0}, 0.1), pillar({-1.5, 0.0}, 0.1), pillar({0.0, -5.0}, 4.5)});
  const Perceptions seen = perceive(crowded, {6.0, 2});
  const Perception perception(seen, 0);
  ASSERT_EQ(perception.neighbours.size(), 2U);
  expectVector(perception.neighbours[0].position, 0.0, -5.0);
  expectVector(perception.neighbours[1].position, -1.5, 0.0);
  EXPECT_EQ(perceive(crowded, {6.0, 4}).agents[0].neighbour_count, 4U);
  EXPECT_EQ(perceive(crowded, {6.0, 9}).agents[0].neighbour_count, 4U);
  EXPECT_EQ(perceive(crowded, {6.0, 0}).agents[0].neighbour_count, 4U);  // 0: no limit
}

TEST(PerceptionWalls, AreInTheFrameOfTheAgentAndWithinItsVision) {
  AgentStart north = wanderer({1.0, 1.0});
  north.heading = PI / 2;
  const std::vector<Segment> walls = {{{-1.0, 0.0}, {-1.0, 5.0}}, {{2.0, 8.0}, {4.0, 8.0}}, {{5.0, -9.0}, {5.0, 9.0}}};
  const Perceptions seen = perceive(scene({north}, {}, walls), {3.0, 0});
  const Perception perception(seen, 0);
  ASSERT_EQ(perception.walls.size(), 1U);  // the others are 7.1 and 4 m away
  expectVector(perception.walls[0].from, -1.0, 2.0);
  expectVector(perception.walls[0].to, 4.0, 2.0);
  EXPECT_EQ(perceive(scene({north}, {}, walls), {4.0, 0}).agents[0].wall_count, 2U);  // just reaches the third
  EXPECT_EQ(perceive(scene({north}, {}, walls), {7.2, 0}).agents[0].wall_count, 3U);
}

/// Walls ahead of agents of 0.25 m: up to the distance from the rim, or as far as a step reaches.
TEST(PerceptionWalls, AreWithinTheWallDistance) {
  Vision vision;
  vision.wall_distance = 0.6;
  const auto count = [&](double distance, double speed) {
    AgentStart agent = wanderer({0.0, 0.0});
    agent.radius = 0.25;
    agent.max_speed = speed;
    const Scene ahead = scenes::halfSeconds(scene({agent}, {}, {{{distance, -9.0}, {distance, 9.0}}}));
    return perceive(ahead, vision).agents[0].wall_count;
  };
  EXPECT_EQ(count(0.84, 1.0), 1U);
  EXPECT_EQ(count(0.86, 1.0), 0U);
  EXPECT_EQ(count(1.24, 2.0), 1U);  // a step of 1 m
  EXPECT_EQ(count(1.26, 2.0), 0U);
  vision.radius = 0.8;
  EXPECT_EQ(count(0.84, 1.0), 0U);
}

TEST(PerceptionList, SetsTheTimeAndReplacesOldPerceptions) {
  World world(scenes::halfSeconds(scene({wanderer({0.0, 0.0}), wanderer({1.0, 0.0})})));
  Perceptions perceptions = perceive(scenes::randomScene(1));
  perceptions.episode = 17;
  perceptions.last = true;
  world.step({});
  perceive(world, Vision(), perceptions);
  EXPECT_EQ(perceptions.tick, 1U);
  EXPECT_EQ(perceptions.tick_duration, 0.5);
  EXPECT_EQ(Perception(perceptions, 1).tick_duration, 0.5);
  EXPECT_EQ(perceptions.agents.size(), 2U);
  EXPECT_EQ(perceptions.neighbours.size(), 2U);
  EXPECT_TRUE(perceptions.walls.empty());
  EXPECT_EQ(perceptions.episode, 17U);  // the world does not set these two
  EXPECT_TRUE(perceptions.last);
}

TEST(PerceptionList, LastPerceptionOfAnArrivingAgentContainsItsNeighbours) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {0.5, 0.0}, 1.0), wanderer({2.5, 0.0})})));
  world.step({{0, {0.0, 1.0}}});
  const Perceptions seen = perceive(world);
  ASSERT_EQ(seen.agents.size(), 2U);
  EXPECT_TRUE(seen.agents[0].arrived);
  EXPECT_TRUE(seen.agents[0].acted);
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);  // the other agent does not perceive it any more
  EXPECT_EQ(seen.agents[1].neighbour_count, 0U);
  expectVector(Perception(seen, 0).neighbours[0].position, 2.0, 0.0);
}

}  // namespace
}  // namespace crowd::perception_test
