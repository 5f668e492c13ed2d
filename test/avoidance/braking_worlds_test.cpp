#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "avoidance/braking_rule.h"
#include "geometry/impact.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::braking_worlds_test {
namespace {

constexpr double TICK = 0.1;  // [s]

/// Speeds up by up to 0.2 m/s in a tick, slows down by up to 0.3 m/s.
constexpr MotionLimits LIMITS{2.0, 3.0, INFINITE};

/// Runs a tick in which agents want to walk straight on at full speed.
void walkOn(World& world, GapSharing sharing) {
  const Perceptions seen = lookAround(world);
  std::vector<AgentAction> actions;
  for (std::size_t i = 0; i < seen.agents.size(); ++i) {
    const Perception perception(seen, i);
    const BrakingLimits limits = limitsOf(perception, sharing);
    actions.push_back(
        {perception.self.agent, BrakingRule(perception, limits).actionTowards({Vector2::UnitX(), 1.0, 1.0})});
  }
  world.step(actions);
}

/// Their ways, if both brake from now on, cross in the middle; their bodies are 0.54 m apart.
TEST(BrakingWorlds, StopsForAnAgentWhoseWayCrossesItsOwn) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    const Vector2 below(0.52, -0.52 - 0.25);
    World world(
        scenes::scene({scenes::wanderer({-0.25, 0.0}, 2.5, 0.1), scenes::agent(below, {0.52, 99.0}, 2.5, 0.1)}));
    world.step({ahead(0), ahead(1)});  // as if a wall had hidden each from the other until now
    world.setMotion(LIMITS);
    for (int tick = 0; tick < 20; ++tick) {
      walkOn(world, sharing);
      const Vector2 between = world.agents()[0].pose.position - world.agents()[1].pose.position;
      ASSERT_GE(between.norm(), 0.2 - TOUCH_TOLERANCE) << GAP_SHARINGS.nameOf(sharing) << ", tick " << tick;
    }
  }
}

TEST(BrakingWorlds, TurnsOnTheSpotBeforeItWalks) {
  World world(scenes::scene({{{0.0, 0.0}, 0.0, {9.0 * unitVector(toRadians(100.0))}, 1.3, 0.25}}));
  world.setMotion({2.0, 3.0, toRadians(90.0)});
  const auto actions = actionsOf("{type: goal_relative}");
  for (int tick = 1; tick <= 12; ++tick) {
    const Perceptions seen = lookAround(world);
    world.step({{0, relativeAction(*actions, {seen, 0}, 0)}});
    const Agent& agent = world.agents()[0];
    EXPECT_NEAR(toDegrees(agent.pose.heading), std::min(100.0, 9.0 * tick), 1e-6);
    EXPECT_NEAR(agent.velocity.norm(), tick < 12 ? 0.0 : 0.2, 1e-9) << "tick " << tick;
  }
}

/// Agents of up to 2.5 m/s who all go to the middle of a floor with pillars and walls.
Scene denseScene(std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {2});
  Scene scene = scenes::solidCrowd(seed, 40, 2.5);
  scene.contact = Contact::GHOST;
  for (AgentStart& agent : scene.agents) {
    agent.goals = {scenes::randomPoint(random, 1.0)};
    agent.leaves = false;
  }
  return scene;
}

/// The deepest overlap of any agent with anything at rest, or with another agent [m].
double deepestOverlap(const World& world) {
  double deepest = -1.0;
  for (const Agent& agent : world.agents()) {
    const auto meet = [&](const Vector2& place, double radius) {
      deepest = std::max(deepest, agent.radius + radius - (agent.pose.position - place).norm());
    };
    for (const Agent& other : world.agents()) {
      if (other.id > agent.id) meet(other.pose.position, other.radius);
    }
    for (const Obstacle& obstacle : world.obstacles()) meet(obstacle.path.position(0.0), obstacle.radius);
    for (const Segment& wall : world.walls().list()) meet(nearestPoint(wall, agent.pose.position), 0.0);
  }
  return deepest;
}

/// What a random walk of a dense crowd came to.
struct Worst {
  double overlap = -1.0;  // deepest [m]
  double change = 0.0;    // of a velocity in a tick [m/s]
  double turn = 0.0;      // of a heading in a tick [rad]
  double speed = 0.0;     // highest [m/s]
};

/// Compares the agents that answered, of which some are held, with those of the tick before.
void note(const std::vector<Agent>& before, const std::vector<AgentAction>& answers, const World& world, Worst& worst) {
  worst.overlap = std::max(worst.overlap, deepestOverlap(world));
  for (const AgentAction& answer : answers) {
    const Agent& was = before[answer.agent];
    const Agent& agent = world.agents()[answer.agent];
    worst.speed = std::max(worst.speed, agent.velocity.norm());
    worst.change = std::max(worst.change, (agent.velocity - was.velocity).norm());
    worst.turn = std::max(worst.turn, std::abs(wrapAngle(agent.pose.heading - was.pose.heading)));
  }
}

/// How the agents of a dense crowd decide.
struct Walk {
  GapSharing sharing = GapSharing::HALF;
  MotionLimits limits;
  double missing = 0.0;  // share of the answers that are left out
  double held = 0.0;     // share of the agents that are held, for some ticks
};

/// Half of the actions are straight to the goal, where the crowd is dense; the others are random.
Worst walk(const Walk& how, std::uint64_t seed) {
  const auto goal_relative = actionsOf("{type: goal_relative, gap_sharing: " + GAP_SHARINGS.nameOf(how.sharing) + "}");
  World world(denseScene(seed));
  world.setMotion(how.limits);
  Worst worst;
  for (std::uint64_t tick = 0; tick < 100; ++tick) {
    const Perceptions seen = perceive(world);
    std::vector<AgentAction> actions;
    for (std::size_t i = 0; i < seen.agents.size(); ++i) {
      const AgentId id = seen.agents[i].agent;
      world.walkingAgent(id).setHeld(Hold::ROUTE,
                                     KeyedRandom(seed, KeyedRandom::TIES, {tick / 8, id}).uniform() < how.held);
      KeyedRandom random(seed, KeyedRandom::EXPLORATION, {tick, id});
      const Action action = random.uniform() < 0.5 ? 0 : random.below(goal_relative->size());
      if (random.uniform() < how.missing) continue;
      actions.push_back({id, relativeAction(*goal_relative, {seen, i}, action)});
    }
    const std::vector<Agent> before(world.agents().begin(), world.agents().end());
    world.step(actions);
    note(before, actions, world, worst);
  }
  return worst;
}

const std::vector<MotionLimits> ALL_LIMITS = {{2.0, 3.0, INFINITE},        {3.0, 3.0, INFINITE},
                                              {1.0, 6.0, INFINITE},        {6.0, 2.0, INFINITE},
                                              {2.0, 3.0, toRadians(90.0)}, {3.0, 3.0, toRadians(360.0)}};

/// Walks with several limits and 20 seeds; expects no contacts, and changes of velocity within the limits.
void expectSafe(Walk how, const std::vector<MotionLimits>& several) {
  double top_speed = 0.0;
  for (const MotionLimits& limits : several) {
    how.limits = limits;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(std::string(GAP_SHARINGS.nameOf(how.sharing)) + ", " + toText(limits) + ", seed " +
                   std::to_string(seed));
      const Worst worst = walk(how, seed);
      EXPECT_LE(worst.overlap, TOUCH_TOLERANCE);
      EXPECT_LE(worst.change, std::max(limits.acceleration, limits.braking) * TICK + 1e-9);
      EXPECT_LE(worst.turn, limits.turn_rate * TICK + 1e-9);
      top_speed = std::max(top_speed, worst.speed);
    }
  }
  EXPECT_GT(top_speed, 1.5);
}

TEST(BrakingWorlds, PreventsAllContactsWithinTheLimits) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING})
    expectSafe({sharing, {}, 0.0, 0.0}, ALL_LIMITS);
}

TEST(BrakingWorlds, DoesSoIfSomeAreHeldAndSomeDoNotAnswer) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    expectSafe({sharing, {}, 0.05, 0.2}, {{2.0, 3.0, INFINITE}, {1.0, 6.0, INFINITE}, {2.0, 3.0, 1.5}});
  }
}

TEST(BrakingWorlds, TheSameCrowdHasContactsWithoutIt) {
  EXPECT_GT(walk({GapSharing::NONE, {2.0, 3.0, INFINITE}, 0.0, 0.0}, 1).overlap, 0.05);
}

/// Places an agent in front of another, at a gap [m].
void teleportInFront(World& world, AgentId id, AgentId walker, double gap) {
  const Agent& agent = world.agents()[walker];
  const double distance = agent.radius + world.agents()[id].radius + gap;
  WorldEditor(world).teleport(id, {agent.pose.position + distance * agent.ahead, PI});
}

TEST(BrakingWorlds, HasNoContactWithSomebodyWhoIsPlacedInFrontOfAFastAgent) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    for (const double gap : {0.001, 0.05, 0.2, 0.6, 1.0}) {
      SCOPED_TRACE(std::string(GAP_SHARINGS.nameOf(sharing)) + ", gap " + std::to_string(gap));
      World world(scenes::scene({scenes::wanderer({0.0, 0.0}, 2.5), scenes::wanderer({0.0, 9.0}, 2.5)}));
      world.step({ahead(0)});
      world.setMotion(LIMITS);
      teleportInFront(world, 1, 0, gap);
      double hardest = 0.0;
      for (int tick = 0; tick < 30; ++tick) {
        const double speed = world.agents()[0].velocity.norm();
        walkOn(world, sharing);
        hardest = std::max(hardest, speed - world.agents()[0].velocity.norm());
        ASSERT_LE(deepestOverlap(world), TOUCH_TOLERANCE) << "tick " << tick;
      }
      EXPECT_GT(hardest, LIMITS.braking * TICK + 1e-6);  // the stopping way is 1.04 m
    }
  }
}

TEST(BrakingWorlds, HasNoContactIfTheFastAgentIsHeld) {
  for (const double gap : {0.001, 0.05, 0.2, 0.6}) {
    World world(scenes::scene({scenes::wanderer({0.0, 0.0}, 2.5), scenes::wanderer({0.0, 9.0}, 2.5)}));
    world.step({ahead(0)});
    world.setMotion(LIMITS);
    teleportInFront(world, 1, 0, gap);
    world.walkingAgent(0).setHeld(Hold::ROUTE, true);
    const auto goal_relative = actionsOf("{type: goal_relative}");
    for (int tick = 0; tick < 30; ++tick) {
      const Perceptions seen = perceive(world);
      EXPECT_TRUE(seen.agents[0].held);
      world.step({{0, relativeAction(*goal_relative, {seen, 0}, 0)}});
      ASSERT_LE(deepestOverlap(world), TOUCH_TOLERANCE) << "gap " << gap << ", tick " << tick;
    }
    EXPECT_EQ(world.agents()[0].velocity, Vector2(0.0, 0.0));
  }
}

/// Somebody is placed in front of another in a dense crowd, again and again.
TEST(BrakingWorlds, HasNoContactsInACrowdWhereSomeAppear) {
  const auto goal_relative = actionsOf("{type: goal_relative}");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    World world(denseScene(seed));
    world.setMotion(LIMITS);
    double worst = -1.0;
    int placed = 0;
    for (std::uint64_t tick = 0; tick < 100; ++tick) {
      KeyedRandom random(seed, KeyedRandom::EXPLORATION, {tick});
      const AgentId id = random.below(40);
      const Agent& walker = world.agents()[random.below(40)];
      const double distance = walker.radius + world.agents()[id].radius + random.uniform(0.001, 0.5);
      const Vector2 place = walker.pose.position + distance * walker.ahead;
      if (world.blockerAt(place, world.agents()[id].radius, false, id).empty()) {
        WorldEditor(world).teleport(id, {place, random.uniform(-PI, PI)});
        ++placed;
      }
      const Perceptions seen = perceive(world);
      std::vector<AgentAction> actions;
      for (std::size_t i = 0; i < seen.agents.size(); ++i) {
        actions.push_back({seen.agents[i].agent, relativeAction(*goal_relative, {seen, i}, 0)});
      }
      const double before = deepestOverlap(world);  // blockerAt() ignores small overlaps
      world.step(actions);
      if (before <= 0.0) worst = std::max(worst, deepestOverlap(world));
    }
    EXPECT_LE(worst, TOUCH_TOLERANCE) << "seed " << seed;
    EXPECT_GT(placed, 3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace crowd::braking_worlds_test
