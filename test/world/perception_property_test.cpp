// Properties of perceptions in random worlds.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "support/perception_bits.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/perception.h"

namespace crowd::perception_property_test {
namespace {

/// A neighbour that an agent must perceive.
struct Expected {
  double rim_distance = 0.0;
  Neighbour neighbour;
};

/// Reference: the neighbours of an agent, from a search of all bodies.
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

TEST(PerceptionProperty, AgreesWithASearchOfAllBodies) {
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

TEST(PerceptionProperty, LimitedNeighboursAreTheFirstOfAllBitForBit) {
  std::size_t neighbours = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    World world(scenes::randomScene(seed, 60));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 10; ++tick) {
      world.step(scenes::randomActions(world, random));
      const double radius = random.uniform(0.5, 8.0);
      const Perceptions all = perceive(world, {radius, 0});
      for (const std::uint32_t most : {1U, 3U, 5U, 10U}) {  // kernels search with and without vector instructions
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

/// Rotates and translates a scene.
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

TEST(PerceptionProperty, IsInvariantUnderRotationAndTranslationOfTheWorld) {
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
}  // namespace crowd::perception_property_test
