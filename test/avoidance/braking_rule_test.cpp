#include "avoidance/braking_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "avoidance/separation_rule.h"
#include "geometry/impact.h"
#include "learning/actions/goal_relative_actions.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::braking_rule_test {
namespace {

constexpr double TICK = 0.1;     // [s]
constexpr double LOOKOUT = 1.5;  // [s]

/// Speeds up by up to 0.2 m/s in a tick, slows down by up to 0.3 m/s.
constexpr MotionLimits LIMITS{2.0, 3.0, INFINITE};

/// An agent of radius 0.25 m and of up to 1.2 m/s that walks ahead at a speed. At 0.6 m/s, the way of a tick and the
/// one until it stands afterwards are 0.06 m each.
PerceptionsBuilder walker(double speed) {
  return PerceptionsBuilder().motion(LIMITS).agent(0, {9.0, 0.0}).speed(1.2).walking({speed, 0.0});
}

/// The same with a wall ahead. @param gap between both [m]
PerceptionsBuilder beforeWall(double gap, double speed) {
  return walker(speed).wall({0.25 + gap, -1.0}, {0.25 + gap, 1.0});
}

/// The same with a body of radius 0.25 m ahead, of this speed towards the agent. @param gap between both [m]
PerceptionsBuilder facing(double gap, double speed, double other_speed = 0.0,
                          NeighbourKind kind = NeighbourKind::AGENT) {
  return walker(speed).neighbour({0.5 + gap, 0.0}, 0.25).kind(kind).velocity({speed, 0.0}, Vector2(-other_speed, 0.0));
}

PerceptionsBuilder beforeObstacle(double gap, double speed) { return facing(gap, speed, 0.0, NeighbourKind::OBSTACLE); }

/// The admissible fraction of a move at full speed.
double share(const PerceptionsBuilder& scene, GapSharing sharing = GapSharing::HALF,
             const Vector2& direction = Vector2::UnitX()) {
  return cut(SeparationRule(sharing, LOOKOUT), scene.perception(), {{direction, 1.0, 1.0}})[0].fraction;
}

/// The velocity of an action, agent frame [m/s].
Vector2 velocityOf(const RelativeAction& action, double max_speed) {
  return action.speed_fraction * max_speed * unitVector(action.rotation);
}

/// The velocity after a tick towards a wanted one at full speed, agent frame [m/s].
Vector2 towards(const PerceptionsBuilder& scene, const Vector2& direction = Vector2::UnitX(),
                GapSharing sharing = GapSharing::HALF) {
  const Perception seen = scene.perception();
  const RelativeAction action = SeparationRule(sharing, LOOKOUT).actionTowards(seen, {direction, 1.0, 1.0});
  return velocityOf(action, seen.self.max_speed);
}

void expectVector(const Vector2& v, double x, double y) {
  EXPECT_NEAR(v.x(), x, 1e-6);
  EXPECT_NEAR(v.y(), y, 1e-6);
}

TEST(BrakingRule, CutsToTheSpeedFromWhichItStopsBeforeTheGapEnds) {
  for (const double speed : {0.0, 0.3, 0.6}) {
    EXPECT_NEAR(share(beforeWall(0.12, speed)), 0.5, 1e-6) << speed;  // 0.6 m/s
    EXPECT_NEAR(share(beforeObstacle(0.12, speed)), 0.5, 1e-6) << speed;
  }
  EXPECT_NEAR(share(beforeWall(0.045, 0.3)), 0.25, 1e-6);  // 0.3 m/s: 0.03 m and 0.015 m
  EXPECT_EQ(share(beforeWall(0.361, 0.0)), 1.0);           // 1.2 m/s: 0.12 m and 0.24 m
  EXPECT_NEAR(share(beforeWall(0.36, 0.0)), 1.0, 1e-6);
  EXPECT_EQ(share(beforeWall(0.0, 0.0)), 0.0);
}

TEST(BrakingRule, HalfOfTheGapToAnAgentAtRest) {
  EXPECT_NEAR(share(facing(0.24, 0.0)), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.09, 0.0)), 0.25, 1e-6);
  EXPECT_NEAR(share(facing(0.5775, 0.0)), 0.875, 1e-6);  // 1.05 m/s: 0.105 m and 0.18375 m
  EXPECT_EQ(share(facing(0.0, 0.0)), 0.0);
  EXPECT_EQ(share(facing(0.001, 0.0), GapSharing::NONE), 1.0);
}

TEST(BrakingRule, SharesTheGapBetweenTheStoppingRegions) {
  // It stops after 0.06 m; 0.12 m are left, half of them are its own.
  EXPECT_NEAR(share(facing(0.18, 0.6)), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.24, 0.6, 0.6)), 0.5, 1e-6);
  // The other walks away and stops after 0.06 m: that is no gap yet.
  EXPECT_NEAR(share(facing(0.24, 0.0, -0.6)), 0.5, 1e-6);
}

TEST(BrakingRule, MovingSharesFollowTheLine) {
  // Both walk ahead at 0.6 m/s: the gap is 0.12 m between the own stop and the other; half of it, and 0.06 m more.
  // The way left is 0.06 + 0.06 + 0.06 m: v T + v^2 / 6 = 0.18.
  const double speed = -0.3 + std::sqrt(0.09 + 6.0 * 0.18);
  EXPECT_NEAR(share(facing(0.18, 0.6, -0.6), GapSharing::MOVING), speed / 1.2, 1e-6);
  EXPECT_NEAR(share(facing(0.18, 0.6, -0.6), GapSharing::HALF), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.24, 0.6, 0.6), GapSharing::MOVING), 0.5, 1e-6);  // the mean velocity is 0
}

TEST(BrakingRule, LimitsTheComponentTowardsTheWall) {
  const Vector2 aside = unitVector(toRadians(60.0));
  EXPECT_NEAR(share(beforeWall(0.06, 0.0), GapSharing::HALF, aside), 0.5, 1e-6);  // half of 0.12 m
  EXPECT_EQ(share(beforeWall(0.0, 0.0), GapSharing::HALF, Vector2::UnitY()), 1.0);
  EXPECT_EQ(share(beforeWall(0.0, 0.0), GapSharing::HALF, -Vector2::UnitX()), 1.0);
}

TEST(BrakingRule, ActionsKeepTheLimits) {
  expectVector(towards(walker(0.0)), 0.2, 0.0);
  expectVector(towards(walker(0.6)), 0.8, 0.0);
  expectVector(towards(walker(1.1)), 1.2, 0.0);
  expectVector(towards(walker(0.6), -Vector2::UnitX()), 0.3, 0.0);
  expectVector(towards(walker(0.6), -Vector2::UnitX(), GapSharing::NONE), 0.3, 0.0);
  expectVector(towards(walker(0.3), -Vector2::UnitX()), 0.0, 0.0);
}

TEST(BrakingRule, StayingBrakesAndKeepsTheHeading) {
  const auto stay = [](const PerceptionsBuilder& scene) {
    return SeparationRule(GapSharing::HALF, LOOKOUT).actionTowards(scene.perception(), {Vector2::UnitY(), 0.0, 0.0});
  };
  expectVector(velocityOf(stay(walker(0.6)), 1.2), 0.3, 0.0);
  EXPECT_EQ(stay(walker(0.6)).rotation, 0.0);
  EXPECT_EQ(stay(walker(0.2)).speed_fraction, 0.0);
  EXPECT_EQ(stay(walker(0.2)).rotation, 0.0);
}

TEST(BrakingRule, BrakesAsHardAsItCanWhereOnlyTheStoppingWayIsLeft) {
  // The stopping way is 0.24 m at 1.2 m/s, 0.375 m at 1.5 m/s.
  expectVector(towards(beforeWall(0.24, 1.2)), 0.9, 0.0);
  expectVector(towards(beforeWall(0.375, 1.5).speed(1.5)), 1.2, 0.0);
  expectVector(towards(beforeObstacle(0.24, 1.2)), 0.9, 0.0);
  expectVector(towards(facing(0.24, 1.2)), 0.9, 0.0);
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    expectVector(towards(facing(0.48, 1.2, 1.2), Vector2::UnitX(), sharing), 0.9, 0.0);
    expectVector(towards(facing(0.24 + 0.06, 1.2, 0.6), Vector2::UnitX(), sharing), 0.9, 0.0);
  }
  EXPECT_EQ(towards(beforeWall(0.015, 0.3)), Vector2(0.0, 0.0));
}

TEST(BrakingRule, ActionsGoOnAsFarAsTheGapAllows) {
  // 0.36 m at 1.2 m/s; 0.3234 m at three quarters of the way from the braked speed, 0.9 m/s, to that.
  expectVector(towards(beforeWall(0.3601, 1.2)), 1.2, 0.0);
  expectVector(towards(beforeWall(0.3599, 1.2)), 1.125, 0.0);
  expectVector(towards(beforeWall(0.3235, 1.2)), 1.125, 0.0);  // 0.1125 m and 0.2109 m
  expectVector(towards(beforeWall(0.3233, 1.2)), 1.05, 0.0);
  expectVector(towards(beforeWall(0.25, 1.2)), 0.9, 0.0);  // 0.2559 m at 0.975 m/s
}

/// A fast agent that somebody was placed in front of, so that it cannot stop in time.
TEST(BrakingRule, StopsFasterThanItCanBeforeSomebodyWhoAppears) {
  expectVector(towards(facing(0.1, 1.2)), 0.5, 0.0);       // half of the gap in a tick
  expectVector(towards(facing(0.1, 1.2, 1.2)), 0.5, 0.0);  // so does the other
  expectVector(towards(beforeWall(0.05, 1.2)), 0.5, 0.0);  // the whole gap
  expectVector(towards(beforeObstacle(0.05, 1.2)), 0.5, 0.0);
  EXPECT_LT(towards(facing(0.0, 1.2)).x(), 1e-6);
  EXPECT_NEAR(share(facing(0.1, 1.2)), 0.5 / 1.2, 1e-6);
}

/// Runs a tick in which agents want to walk straight on at full speed.
void walkOn(World& world, GapSharing sharing) {
  const SeparationRule rule(sharing, LOOKOUT);
  const Perceptions seen = lookAround(world);
  std::vector<AgentAction> actions;
  for (std::size_t i = 0; i < seen.agents.size(); ++i) {
    actions.push_back({seen.agents[i].agent, rule.actionTowards({seen, i}, {Vector2::UnitX(), 1.0, 1.0})});
  }
  world.step(actions);
}

/// Their ways, if both brake from now on, cross in the middle; their bodies are 0.54 m apart.
TEST(BrakingRule, StopsForAnAgentWhoseWayCrossesItsOwn) {
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

TEST(BrakingRule, TurnsOnTheSpotBeforeItWalks) {
  World world(scenes::scene({{{0.0, 0.0}, 0.0, {9.0 * unitVector(toRadians(100.0))}, 1.3, 0.25}}));
  world.setMotion({2.0, 3.0, toRadians(90.0)});
  const GoalRelativeActions actions;
  for (int tick = 1; tick <= 12; ++tick) {
    const Perceptions seen = lookAround(world);
    world.step({{0, relativeAction(actions, {seen, 0}, 0)}});
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
  GoalRelativeActions::Parameters parameters;
  parameters.gap_sharing = how.sharing;
  const GoalRelativeActions goal_relative(parameters);
  World world(denseScene(seed));
  world.setMotion(how.limits);
  Worst worst;
  for (std::uint64_t tick = 0; tick < 100; ++tick) {
    const Perceptions seen = perceive(world);
    std::vector<AgentAction> actions;
    for (std::size_t i = 0; i < seen.agents.size(); ++i) {
      const AgentId id = seen.agents[i].agent;
      world.walkingAgent(id).held = KeyedRandom(seed, KeyedRandom::TIES, {tick / 8, id}).uniform() < how.held;
      KeyedRandom random(seed, KeyedRandom::EXPLORATION, {tick, id});
      const Action action = random.uniform() < 0.5 ? 0 : random.below(goal_relative.size());
      if (random.uniform() < how.missing) continue;
      actions.push_back({id, relativeAction(goal_relative, {seen, i}, action)});
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

TEST(BrakingRule, PreventsAllContactsWithinTheLimits) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING})
    expectSafe({sharing, {}, 0.0, 0.0}, ALL_LIMITS);
}

TEST(BrakingRule, DoesSoIfSomeAreHeldAndSomeDoNotAnswer) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    expectSafe({sharing, {}, 0.05, 0.2}, {{2.0, 3.0, INFINITE}, {1.0, 6.0, INFINITE}, {2.0, 3.0, 1.5}});
  }
}

TEST(BrakingRule, TheSameCrowdHasContactsWithoutIt) {
  EXPECT_GT(walk({GapSharing::NONE, {2.0, 3.0, INFINITE}, 0.0, 0.0}, 1).overlap, 0.05);
}

/// Places an agent in front of another, at a gap [m].
void teleportInFront(World& world, AgentId id, AgentId walker, double gap) {
  const Agent& agent = world.agents()[walker];
  const double distance = agent.radius + world.agents()[id].radius + gap;
  WorldEditor(world).teleport(id, {agent.pose.position + distance * agent.ahead, PI});
}

TEST(BrakingRule, HasNoContactWithSomebodyWhoIsPlacedInFrontOfAFastAgent) {
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

TEST(BrakingRule, HasNoContactIfTheFastAgentIsHeld) {
  for (const double gap : {0.001, 0.05, 0.2, 0.6}) {
    World world(scenes::scene({scenes::wanderer({0.0, 0.0}, 2.5), scenes::wanderer({0.0, 9.0}, 2.5)}));
    world.step({ahead(0)});
    world.setMotion(LIMITS);
    teleportInFront(world, 1, 0, gap);
    world.walkingAgent(0).held = true;
    const GoalRelativeActions goal_relative;
    for (int tick = 0; tick < 30; ++tick) {
      const Perceptions seen = perceive(world);
      EXPECT_TRUE(seen.agents[0].held);
      world.step({{0, relativeAction(goal_relative, {seen, 0}, 0)}});
      ASSERT_LE(deepestOverlap(world), TOUCH_TOLERANCE) << "gap " << gap << ", tick " << tick;
    }
    EXPECT_EQ(world.agents()[0].velocity, Vector2(0.0, 0.0));
  }
}

/// Somebody is placed in front of another in a dense crowd, again and again.
TEST(BrakingRule, HasNoContactsInACrowdWhereSomeAppear) {
  const GoalRelativeActions goal_relative;
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
        actions.push_back({seen.agents[i].agent, relativeAction(goal_relative, {seen, i}, 0)});
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
}  // namespace crowd::braking_rule_test
