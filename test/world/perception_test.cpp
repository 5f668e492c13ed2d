#include "social_crowd/world/perception.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "support/perception_bits.h"
#include "support/scenes.h"

namespace crowd {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

void expectVector(const Vector2& v, double x, double y, double tolerance = 1e-12) {
  EXPECT_NEAR(v.x(), x, tolerance);
  EXPECT_NEAR(v.y(), y, tolerance);
}

Perceptions perceive(World& world, const Vision& vision = Vision()) {
  Perceptions perceptions;
  world.perceive(vision, perceptions);
  return perceptions;
}

Perceptions perceive(const Scene& scene, const Vision& vision = Vision()) {
  World world(scene);
  return perceive(world, vision);
}

/// How many bodies agent 0 of a scene perceives.
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

TEST(PerceptionFrame, VelocityOfWhoStopsIsZeroAgain) {
  World world(scene({wanderer({0.0, 0.0}), wanderer({3.0, 0.0})}));
  world.step({{0, {0.0, 1.0}}, {1, {0.0, 1.0}}});
  world.step({});
  const Perceptions seen = perceive(world);
  expectVector(seen.agents[0].velocity, 0.0, 0.0);
  expectVector(seen.neighbours[0].velocity, 0.0, 0.0);
}

TEST(PerceptionFrame, GoalIsTheNextOfSeveral) {
  AgentStart rounder = agent({0.0, 0.0}, {0.5, 0.0}, 1.0);
  rounder.goals.emplace_back(0.5, 7.0);
  World world(scenes::halfSeconds(scene({rounder})));
  expectVector(perceive(world).agents[0].goal, 0.5, 0.0);
  world.step({{0, {0.0, 1.0}}});
  expectVector(perceive(world).agents[0].goal, 0.0, 7.0);
}

TEST(PerceptionRange, ReachesToTheRim) {
  const auto count = [](double x, double radius) {
    return bodyCount(scene({wanderer({0.0, 0.0})}, {pillar({x, 0.0}, radius)}), 2.0);
  };
  EXPECT_EQ(count(2.25, 0.25), 1U);  // the rim is exactly at the limit
  EXPECT_EQ(count(2.2501, 0.25), 0U);
  EXPECT_EQ(count(-4.9, 3.0), 1U);
  EXPECT_EQ(count(-5.1, 3.0), 0U);
  EXPECT_EQ(count(0.1, 0.05), 1U);  // inside the own body
}

TEST(PerceptionRange, ZeroVisionStillPerceivesWhatOneStandsIn) {
  EXPECT_EQ(bodyCount(scene({wanderer({0.0, 0.0}), wanderer({0.2, 0.0}), wanderer({0.3, 0.0})}), 0.0), 1U);
}

TEST(PerceptionOrder, NearestRimFirst) {
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

TEST(PerceptionWalls, InTheFrameOfTheAgentWithinItsVision) {
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

TEST(PerceptionList, SaysWhenItIsAndReplacesWhatStoodThere) {
  World world(scenes::halfSeconds(scene({wanderer({0.0, 0.0}), wanderer({1.0, 0.0})})));
  Perceptions perceptions = perceive(scenes::randomScene(1));
  perceptions.episode = 17;
  perceptions.last = true;
  world.step({});
  world.perceive(Vision(), perceptions);
  EXPECT_EQ(perceptions.tick, 1U);
  EXPECT_EQ(perceptions.tick_duration, 0.5);
  EXPECT_EQ(Perception(perceptions, 1).tick_duration, 0.5);
  EXPECT_EQ(perceptions.agents.size(), 2U);
  EXPECT_EQ(perceptions.neighbours.size(), 2U);
  EXPECT_TRUE(perceptions.walls.empty());
  EXPECT_EQ(perceptions.episode, 17U);  // these two are not the world's to say
  EXPECT_TRUE(perceptions.last);
}

TEST(PerceptionList, LastPerceptionOfWhoArrivesTellsOfTheOthers) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {0.5, 0.0}, 1.0), wanderer({2.5, 0.0})})));
  world.step({{0, {0.0, 1.0}}});
  const Perceptions seen = perceive(world);
  ASSERT_EQ(seen.agents.size(), 2U);
  EXPECT_TRUE(seen.agents[0].arrived);
  EXPECT_TRUE(seen.agents[0].acted);
  ASSERT_EQ(seen.agents[0].neighbour_count, 1U);  // but the other one does not perceive it any more
  EXPECT_EQ(seen.agents[1].neighbour_count, 0U);
  expectVector(Perception(seen, 0).neighbours[0].position, 2.0, 0.0);
}

/// A body as seen from outside: what an agent is to perceive.
struct Expected {
  double rim_distance = 0.0;
  Neighbour neighbour;
};

/// What an agent is to perceive, by looking at everything.
std::vector<Expected> lookAtAll(const World& world, const Agent& agent, double vision) {
  const Eigen::Rotation2Dd turn(-agent.pose.heading);
  std::vector<Expected> all;
  const auto look = [&](const Vector2& position, const Vector2& velocity, double radius, NeighbourKind kind) {
    const Vector2 to_other = position - agent.pose.position;
    const double rim_distance = to_other.norm() - radius;
    if (rim_distance <= vision) all.push_back({rim_distance, {turn * to_other, turn * velocity, radius, kind}});
  };
  for (const Agent& other : world.agents()) {
    if (!other.isWalking() || other.id == agent.id) continue;
    look(other.pose.position, other.velocity, other.radius, NeighbourKind::AGENT);
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    const double t = world.time();
    look(obstacle.path.position(t), obstacle.path.velocity(t), obstacle.radius, NeighbourKind::OBSTACLE);
  }
  std::sort(all.begin(), all.end(),
            [](const Expected& a, const Expected& b) { return a.rim_distance < b.rim_distance; });
  return all;
}

void expectSameNeighbour(const Neighbour& neighbour, const Neighbour& expected) {
  EXPECT_LT((neighbour.position - expected.position).norm(), 1e-9);
  EXPECT_LT((neighbour.velocity - expected.velocity).norm(), 1e-9);
  EXPECT_EQ(neighbour.radius, expected.radius);
  EXPECT_EQ(neighbour.kind, expected.kind);
}

TEST(PerceptionProperty, AgreesWithLookingAtEverything) {
  std::size_t neighbours = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(scenes::randomScene(seed, 60));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 10; ++tick) {
      world.step(scenes::randomActions(world, random));
      const Vision vision{random.uniform(0.5, 8.0), random.below(12)};
      const Perceptions seen = perceive(world, vision);
      for (std::size_t i = 0; i < seen.agents.size(); ++i) {
        SCOPED_TRACE("tick " + std::to_string(tick) + ", agent " + std::to_string(seen.agents[i].agent));
        const Perception perception(seen, i);
        std::vector<Expected> all = lookAtAll(world, world.agents()[seen.agents[i].agent], vision.radius);
        if (vision.max_neighbours > 0 && all.size() > vision.max_neighbours) all.resize(vision.max_neighbours);
        ASSERT_EQ(perception.neighbours.size(), all.size());
        for (std::size_t k = 0; k < all.size(); ++k) expectSameNeighbour(perception.neighbours[k], all[k].neighbour);
        neighbours += all.size();
      }
    }
  }
  EXPECT_GT(neighbours, 10000U);
}

TEST(PerceptionProperty, FewerBodiesAreTheFirstOfMoreBitForBit) {
  std::size_t neighbours = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    World world(scenes::randomScene(seed, 60));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 10; ++tick) {
      world.step(scenes::randomActions(world, random));
      const double radius = random.uniform(0.5, 8.0);
      const Perceptions all = perceive(world, {radius, 0});
      for (const std::uint32_t most : {1U, 3U, 5U, 10U}) {  // one by one, four at a time, or both
        const Perceptions some = perceive(world, {radius, most});
        ASSERT_EQ(some.agents.size(), all.agents.size());
        for (std::size_t i = 0; i < all.agents.size(); ++i) {
          const Perception fewer(some, i);
          Perception first(all, i);
          ASSERT_EQ(fewer.neighbours.size(), std::min<std::size_t>(most, first.neighbours.size()));
          first.neighbours = first.neighbours.front(fewer.neighbours.size());
          EXPECT_EQ(bitsOf(fewer), bitsOf(first)) << "seed " << seed << ", tick " << tick << ", most " << most;
          neighbours += fewer.neighbours.size();
        }
      }
    }
  }
  EXPECT_GT(neighbours, 10000U);
}

/// Turns and moves a whole scene.
class Motion {
 public:
  Motion(double angle, const Vector2& shift) : angle_(angle), turn_(angle), shift_(shift) {}

  Vector2 operator()(const Vector2& point) const { return turn_ * point + shift_; }
  Scene operator()(Scene scene) const {
    for (AgentStart& start : scene.agents) {
      start.position = (*this)(start.position);
      start.heading += angle_;
      for (Vector2& goal : start.goals) goal = (*this)(goal);
    }
    for (Obstacle& obstacle : scene.obstacles) {
      const Vector2 position = (*this)(obstacle.path.position(0.0));
      obstacle.path = ObstaclePath::straight(position, turn_ * obstacle.path.velocity(0.0));
    }
    for (Segment& wall : scene.walls) wall = {(*this)(wall.from), (*this)(wall.to)};
    return scene;
  }

 private:
  double angle_;
  Eigen::Rotation2Dd turn_;
  Vector2 shift_;
};

void expectSamePerceptions(const Perceptions& seen, const Perceptions& expected) {
  ASSERT_EQ(seen.agents.size(), expected.agents.size());
  ASSERT_EQ(seen.neighbours.size(), expected.neighbours.size());
  ASSERT_EQ(seen.walls.size(), expected.walls.size());
  for (std::size_t i = 0; i < seen.agents.size(); ++i) {
    EXPECT_EQ(seen.agents[i].agent, expected.agents[i].agent);
    EXPECT_EQ(seen.agents[i].arrived, expected.agents[i].arrived);
    EXPECT_EQ(seen.agents[i].neighbour_count, expected.agents[i].neighbour_count);
    EXPECT_EQ(seen.agents[i].wall_count, expected.agents[i].wall_count);
    EXPECT_LT((seen.agents[i].velocity - expected.agents[i].velocity).norm(), 1e-9);
    EXPECT_LT((seen.agents[i].goal - expected.agents[i].goal).norm(), 1e-9);
    const Perception one(seen, i);
    const Perception other(expected, i);
    for (std::size_t k = 0; k < one.neighbours.size(); ++k) expectSameNeighbour(one.neighbours[k], other.neighbours[k]);
    for (std::size_t k = 0; k < one.walls.size(); ++k) {
      EXPECT_LT((one.walls[k].from - other.walls[k].from).norm(), 1e-9);
      EXPECT_LT((one.walls[k].to - other.walls[k].to).norm(), 1e-9);
    }
  }
}

TEST(PerceptionProperty, TurningAndMovingTheWholeWorldChangesNothing) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene crowd = scenes::randomScene(seed);
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    const double angle = random.uniform(-PI, PI);
    World world(crowd);
    World moved_world(Motion(angle, scenes::randomPoint(random, 100.0))(crowd));
    for (int tick = 0; tick < 20; ++tick) {
      SCOPED_TRACE("tick " + std::to_string(tick));
      expectSamePerceptions(perceive(moved_world, {3.0, 5}), perceive(world, {3.0, 5}));
      if (HasFailure()) return;
      const std::vector<AgentAction> actions = scenes::randomActions(world, random);
      world.step(actions);
      moved_world.step(actions);
    }
  }
}

}  // namespace
}  // namespace crowd
