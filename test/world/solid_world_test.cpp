// Worlds in which bodies stop where they touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "social_crowd/common/errors.h"
#include "social_crowd/world/world.h"
#include "support/error_of.h"
#include "support/scenes.h"

namespace crowd {
namespace {

using scenes::moving_obstacle;
using scenes::pillar;
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
  EXPECT_DOUBLE_EQ(walker.velocity.x(), 0.5);  // over ground: 0.25 m in 0.5 s
  EXPECT_TRUE(walker.acted);
  EXPECT_TRUE(walker.blocked);
  EXPECT_EQ(walker.blocked_moves, 1U);
  EXPECT_TRUE(walker.in_contact && walker.touched);
  EXPECT_FALSE(stander.blocked);
  EXPECT_EQ(stander.blocked_moves, 0U);
  EXPECT_TRUE(stander.in_contact && stander.touched);

  world.step({{0, {0.0, 1.0}}});  // it stays where it touches
  EXPECT_DOUBLE_EQ(walker.pose.position.x(), 0.25);
  EXPECT_EQ(walker.blocked_moves, 2U);

  world.step({{0, {PI / 2, 1.0}}});  // and is free to walk aside
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
  EXPECT_FALSE(world.agents()[0].blocked);  // it did not want to move
  EXPECT_FALSE(world.agents()[0].in_contact);
}

TEST(SolidWorld, ToTouchWithoutWalkingInIsNoContact) {
  World world(halfMetres({0.0, 0.0}, {1.0, 0.0}));
  world.step({{0, {0.0, 1.0}}});  // just up to the other
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 0.5);
  EXPECT_FALSE(world.agents()[0].touched || world.agents()[1].touched);
}

TEST(SolidWorld, WhoArrivesLeavesTheWay) {
  Scene line = halfMetres({0.0, 0.0}, {1.5, 0.0});
  line.agents[1].goals = {{1.5, 0.0}};
  World world(line);
  world.step({{0, {0.0, 1.0}}});
  ASSERT_TRUE(world.agents()[1].hasArrived());
  for (int i = 0; i < 3; ++i) world.step({{0, {0.0, 1.0}}});
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.position.x(), 2.0);
  EXPECT_FALSE(world.agents()[0].touched);
}

TEST(SolidWorld, MovingObstaclePushesAnAgentAlong) {
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

TEST(SolidWorld, TurningPointOfAMovingObstacleWithinATick) {
  // It walks 0.75 m to and 0.25 m fro in a tick of 1 m: half a metre nearer, and it ends where its path says.
  Scene scene = solid(scenes::halfSeconds(scenes::scene({wanderer({9.0, 9.0})})));
  scene.obstacles.push_back({ObstaclePath::toAndFro({{0.0, 0.0}, {0.75, 0.0}}, 2.0), 0.25});
  scene.agents.push_back(wanderer({0.9, 0.0}, 1.0, 0.25));
  World world(scene);
  world.step({});
  EXPECT_DOUBLE_EQ(world.agents()[1].pose.position.x(), 1.0);  // pushed by 0.1 m, to 0.5 m from it
}

TEST(SolidWorld, SpawnedBodiesMustNotOverlapAtAll) {
  World ghost(scene({wanderer({0.0, 0.0})}, {}, {{{-1.0, -2.0}, {1.0, -2.0}}}));
  World world(solid(scene({wanderer({0.0, 0.0})}, {}, {{{-1.0, -2.0}, {1.0, -2.0}}})));
  const AgentStart tight = wanderer({0.4995, 0.0});
  const AgentStart at_wall = wanderer({0.0, -1.7505});
  EXPECT_NO_THROW(ghost.spawnAgent(tight));
  EXPECT_NO_THROW(ghost.spawnAgent(at_wall));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { world.spawnAgent(tight); }), "agent 0"));
  EXPECT_TRUE(contains(errorOf<InputError>([&] { world.spawnAgent(at_wall); }), "wall"));
  EXPECT_EQ(world.spawnAgent(wanderer({0.5, 0.0})), 1U);
}

/// How deep the deepest agent overlaps another one, a wall or an obstacle at rest, by looking at everything [m].
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
    for (const Segment& wall : world.walls()) deepest = std::max(deepest, agent.radius - distanceTo(wall, at));
  }
  return deepest;
}

/// Moves that press together: towards a point of the crowd's that changes every few ticks, or anywhere.
std::vector<AgentAction> pressingActions(const World& world, KeyedRandom& random, const Vector2& towards) {
  std::vector<AgentAction> actions = scenes::randomActions(world, random);
  for (AgentAction& given : actions) {
    const Agent& agent = world.agents()[given.agent];
    if (random.below(3) == 0) continue;
    given.action = {bearingOf(towards - agent.pose.position) - agent.pose.heading, 1.0};
  }
  return actions;
}

TEST(SolidWorldProperty, NobodyEverOverlaps) {
  std::uint64_t blocked = 0;
  std::uint64_t moves = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(scenes::solidCrowd(seed, 5 + 2 * seed, seed % 3 == 0 ? 20.0 : 2.0, seed % 4));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    Vector2 towards = Vector2::Zero();
    for (int tick = 0; tick < 60; ++tick) {
      if (tick % 15 == 0) towards = scenes::randomPoint(random, 3.0);
      world.step(pressingActions(world, random, towards));
      ASSERT_LE(deepestOverlap(world), 1e-9) << "tick " << world.tick();
    }
    for (const Agent& agent : world.agents()) blocked += agent.blocked_moves;
    moves += 60 * world.agents().size();
  }
  EXPECT_GT(blocked, moves / 10);
  EXPECT_LT(blocked, moves * 9 / 10);
}

/// Where a body is within a tick: it walks its way at a steady speed and stops where it is stopped.
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

/// Whether something touches the agent from ahead at an instant.
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
  return std::any_of(world.walls().begin(), world.walls().end(),
                     [&](const Segment& wall) { return holds(nearestPoint(wall, at), walks[agent].radius); });
}

void expectNoOverlapOnTheWay(const World& world, const std::vector<Walk>& walks, double time) {
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const Vector2 at = walks[i].at(time);
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_GT((walks[k].at(time) - at).norm(), walks[i].radius + walks[k].radius - 1e-9) << i << " and " << k;
    }
    for (const Segment& wall : world.walls()) ASSERT_GT(distanceTo(wall, at), walks[i].radius - 1e-9) << i;
  }
}

TEST(SolidWorldProperty, EverybodyWalksUpToWhatStopsItAndThroughNothing) {
  constexpr int INSTANTS = 40;
  int blocked = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(scenes::solidCrowd(seed, 25, seed % 2 == 0 ? 20.0 : 2.0));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
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
  }
  EXPECT_GT(blocked, 500);
}

TEST(SolidWorldProperty, OrderOfAgentsAndActionsDoesNotMatter) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene crowd = scenes::solidCrowd(seed, 30, seed % 2 == 0 ? 20.0 : 2.0, seed % 4);
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
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
  }
}

TEST(SolidWorldProperty, WhereNothingTouchesItIsAGhostWorldBitForBit) {
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

TEST(SolidWorldProperty, SameMovesGiveTheSameWorldBitForBit) {
  const Scene crowd = scenes::solidCrowd(3, 40, 5.0, 3);
  World world(crowd);
  World again(crowd);
  KeyedRandom random(3, KeyedRandom::EXPLORATION, {});
  for (int tick = 0; tick < 40; ++tick) {
    const std::vector<AgentAction> actions = pressingActions(world, random, Vector2::Zero());
    world.step(actions);
    again.step(actions);
    World copy = again;  // what a world has been through before does not matter, only how it stands
    again = copy;
  }
  for (const Agent& agent : world.agents()) {
    EXPECT_EQ(agent.pose.position, again.agents()[agent.id].pose.position);
    EXPECT_EQ(agent.blocked_moves, again.agents()[agent.id].blocked_moves);
  }
}

}  // namespace
}  // namespace crowd
