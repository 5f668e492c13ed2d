// Properties of random worlds in which bodies stop where they touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/scenes.h"
#include "support/seeds.h"
#include "world/world.h"

namespace crowd::solid_world_property_test {
namespace {

using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::solid;
using scenes::wanderer;

/// The deepest overlap of an agent with another one, a wall or a static obstacle [m]; checks all pairs.
double deepestOverlap(const World& world) {
  double deepest = 0.0;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    const Vector2& at = agent.pose.position;
    for (const Agent& other : world.agents()) {
      if (other.id == agent.id || !other.isWalking()) continue;
      deepest = std::max(deepest, agent.radius + other.radius - (other.pose.position - at).norm());
    }
    for (const Obstacle& obstacle : world.obstacles()) {
      if (obstacle.path.moves()) continue;
      deepest = std::max(deepest, agent.radius + obstacle.radius - (obstacle.path.position(0.0) - at).norm());
    }
    for (const Segment& wall : world.walls().list()) deepest = std::max(deepest, agent.radius - distanceTo(wall, at));
  }
  return deepest;
}

/// Actions of a dense crowd: two thirds of them towards a common point, the others random.
std::vector<AgentAction> pressingActions(const World& world, KeyedRandom& random, const Vector2& towards) {
  std::vector<AgentAction> actions = scenes::randomActions(world, random);
  for (AgentAction& given : actions) {
    const Agent& agent = world.agents()[given.agent];
    if (random.below(3) == 0) continue;
    given.action = {bearingOf(towards - agent.pose.position) - agent.pose.heading, 1.0};
  }
  return actions;
}

TEST(SolidWorldProperty, AgentsNeverOverlap) {
  std::uint64_t blocked = 0;
  std::uint64_t moves = 0;
  forSeeds(30, KeyedRandom::EXPLORATION, [&](std::uint64_t seed, KeyedRandom& random) {
    World world(scenes::solidCrowd(seed, 5 + 2 * seed, seed % 3 == 0 ? 20.0 : 2.0, seed % 4));
    Vector2 towards = Vector2::Zero();
    for (int tick = 0; tick < 60; ++tick) {
      if (tick % 15 == 0) towards = scenes::randomPoint(random, 3.0);
      world.step(pressingActions(world, random, towards));
      ASSERT_LE(deepestOverlap(world), 1e-9) << "tick " << world.tick();
    }
    for (const Agent& agent : world.agents()) blocked += agent.blocked_moves;
    moves += 60 * world.agents().size();
  });
  EXPECT_GT(blocked, moves / 10);
  EXPECT_LT(blocked, moves * 9 / 10);
}

/// The motion of a body within a tick: constant velocity until it is stopped.
struct Walk {
  Vector2 from = Vector2::Zero();
  Vector2 to = Vector2::Zero();
  Vector2 way = Vector2::Zero();  // wanted
  double radius = 0.0;

  double stop() const { return way.isZero(0.0) ? 1.0 : (to - from).norm() / way.norm(); }
  Vector2 at(double time) const { return from + std::min(time, stop()) * way; }
};

std::vector<Walk> walksOf(const World& before, const World& after, const std::vector<AgentAction>& actions) {
  std::vector<Walk> walks;
  for (const Agent& agent : after.agents()) {
    const Vector2 from = before.agents()[agent.id].pose.position;
    walks.push_back({from, agent.pose.position, Vector2::Zero(), agent.radius});
  }
  for (const AgentAction& given : actions) {
    const Agent& agent = after.agents()[given.agent];
    const double length = given.action.speed_fraction * agent.max_speed * after.tickDuration();
    walks[given.agent].way = length * unitVector(agent.pose.heading);
  }
  return walks;
}

/// Whether something touches the agent from ahead at this time (fraction of the tick).
bool isHeldUp(const World& world, const std::vector<Walk>& walks, std::size_t agent, double time) {
  const Vector2 at = walks[agent].at(time);
  const auto holds = [&](const Vector2& nearest, double reach) {
    return (nearest - at).norm() < reach + 1e-9 && walks[agent].way.dot(nearest - at) > 0.0;
  };
  for (std::size_t i = 0; i < walks.size(); ++i) {
    if (i != agent && holds(walks[i].at(time), walks[i].radius + walks[agent].radius)) return true;
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    if (holds(obstacle.path.position(0.0), obstacle.radius + walks[agent].radius)) return true;
  }
  return std::any_of(world.walls().list().begin(), world.walls().list().end(),
                     [&](const Segment& wall) { return holds(nearestPoint(wall, at), walks[agent].radius); });
}

void expectNoOverlapOnTheWay(const World& world, const std::vector<Walk>& walks, double time) {
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const Vector2 at = walks[i].at(time);
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_GT((walks[k].at(time) - at).norm(), walks[i].radius + walks[k].radius - 1e-9) << i << " and " << k;
    }
    for (const Segment& wall : world.walls().list()) ASSERT_GT(distanceTo(wall, at), walks[i].radius - 1e-9) << i;
  }
}

TEST(SolidWorldProperty, AgentsStopOnlyAtContactsAndPassThroughNothing) {
  constexpr int INSTANTS = 40;
  int blocked = 0;
  forSeeds(12, KeyedRandom::EXPLORATION, [&](std::uint64_t seed, KeyedRandom& random) {
    World world(scenes::solidCrowd(seed, 25, seed % 2 == 0 ? 20.0 : 2.0));
    for (int tick = 0; tick < 20; ++tick) {
      SCOPED_TRACE("tick " + std::to_string(tick));
      const World before = world;
      const std::vector<AgentAction> actions = pressingActions(world, random, Vector2::Zero());
      world.step(actions);
      const std::vector<Walk> walks = walksOf(before, world, actions);
      for (const Agent& agent : world.agents()) {
        const Walk& walk = walks[agent.id];
        ASSERT_LT((walk.at(1.0) - walk.to).norm(), 1e-9) << agent.id << " left its way";
        ASSERT_EQ(agent.blocked, !walk.way.isZero(0.0) && walk.stop() < 1.0 - 1e-12) << agent.id;
        if (!agent.blocked) continue;
        ASSERT_TRUE(isHeldUp(world, walks, agent.id, walk.stop())) << agent.id << " stopped for nothing";
        ++blocked;
      }
      for (int i = 0; i <= INSTANTS; ++i) expectNoOverlapOnTheWay(world, walks, static_cast<double>(i) / INSTANTS);
      if (HasFatalFailure()) return;
    }
  });
  EXPECT_GT(blocked, 500);
}

TEST(SolidWorldProperty, OrderOfAgentsAndActionsDoesNotMatter) {
  forSeeds(20, KeyedRandom::EXPLORATION, [](std::uint64_t seed, KeyedRandom& random) {
    const Scene crowd = scenes::solidCrowd(seed, 30, seed % 2 == 0 ? 20.0 : 2.0, seed % 4);
    std::vector<AgentId> new_id(crowd.agents.size());
    for (AgentId i = 0; i < new_id.size(); ++i) new_id[i] = i;
    for (std::uint32_t i = 29; i > 0; --i) std::swap(new_id[i], new_id[random.below(i + 1)]);
    Scene shuffled = crowd;
    for (AgentId i = 0; i < new_id.size(); ++i) shuffled.agents[new_id[i]] = crowd.agents[i];
    std::reverse(shuffled.walls.begin(), shuffled.walls.end());
    std::reverse(shuffled.obstacles.begin(), shuffled.obstacles.end());
    World world(crowd);
    World other_world(shuffled);
    for (int tick = 0; tick < 40; ++tick) {
      const std::vector<AgentAction> actions = pressingActions(world, random, Vector2::Zero());
      std::vector<AgentAction> other_actions(actions.rbegin(), actions.rend());
      for (AgentAction& given : other_actions) given.agent = new_id[given.agent];
      world.step(actions);
      other_world.step(other_actions);
      for (const Agent& agent : world.agents()) {
        const Agent& other = other_world.agents()[new_id[agent.id]];
        ASSERT_EQ(agent.pose.position, other.pose.position) << "tick " << tick << ", agent " << agent.id;
        ASSERT_EQ(agent.velocity, other.velocity);
        ASSERT_EQ(agent.in_contact, other.in_contact);
        ASSERT_EQ(agent.blocked_moves, other.blocked_moves);
      }
    }
  });
}

TEST(SolidWorldProperty, WithoutContactsEqualsAGhostWorldBitForBit) {
  Scene ghosts = scene({}, {pillar({50.0, 50.0}, 0.5), moving_obstacle({-50.0, 50.0}, {0.3, 0.1}, 0.5)},
                       {{{-50.0, -50.0}, {50.0, -50.0}}});
  for (int i = 0; i < 20; ++i) ghosts.agents.push_back(wanderer({10.0 * i, 0.37 * i}, 0.7 + 0.03 * i));
  World ghost_world(ghosts);
  World world(solid(ghosts));
  KeyedRandom random(1, KeyedRandom::EXPLORATION, {});
  for (int tick = 0; tick < 30; ++tick) {
    const std::vector<AgentAction> actions = scenes::randomActions(world, random);
    world.step(actions);
    ghost_world.step(actions);
    for (const Agent& agent : world.agents()) {
      EXPECT_EQ(agent.pose.position, ghost_world.agents()[agent.id].pose.position);
      EXPECT_EQ(agent.velocity, ghost_world.agents()[agent.id].velocity);
      EXPECT_FALSE(agent.touched);
    }
  }
}

TEST(SolidWorldProperty, EqualActionsGiveEqualWorldsBitForBit) {
  const Scene crowd = scenes::solidCrowd(3, 40, 5.0, 3);
  World world(crowd);
  World again(crowd);
  KeyedRandom random(3, KeyedRandom::EXPLORATION, {});
  for (int tick = 0; tick < 40; ++tick) {
    const std::vector<AgentAction> actions = pressingActions(world, random, Vector2::Zero());
    world.step(actions);
    again.step(actions);
    World copy = again;  // a copy continues like its original
    again = copy;
  }
  for (const Agent& agent : world.agents()) {
    EXPECT_EQ(agent.pose.position, again.agents()[agent.id].pose.position);
    EXPECT_EQ(agent.blocked_moves, again.agents()[agent.id].blocked_moves);
  }
}

}  // namespace
}  // namespace crowd::solid_world_property_test
