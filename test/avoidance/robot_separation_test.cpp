// The separation rule against robots (docs/separation_rule.md, Robots).

#include <gtest/gtest.h>

#include <string>

#include "avoidance/braking_rule.h"
#include "avoidance/separation_rule.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/robots.h"
#include "support/seeds.h"
#include "support/worlds.h"

namespace crowd::robot_separation_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]

/// An agent of 0.25 m and 10 m/s, 1 m per tick, that faces a robot with a gap in between [m], which moves along x
/// [m/s].
PerceptionsBuilder facing(double gap, double robot_speed) {
  PerceptionsBuilder scene;
  scene.agent(0, {5.0, 0.0}).speed(10.0);
  return scene.neighbour({0.55 + gap, 0.0}, 0.3).kind(NeighbourKind::ROBOT).velocity({0.0, 0.0}, {robot_speed, 0.0});
}

/// The admissible advance towards the robot [m].
double advance(const PerceptionsBuilder& scene) {
  return cut(SeparationRule(GapSharing::HALF, 0.0), scene.perception(), {{Vector2::UnitX(), 1.0, 1.0}})[0].fraction;
}

TEST(RobotSeparation, KeepsOutOfWhereTheRobotMayStopOrGo) {
  EXPECT_NEAR(advance(facing(0.1, 0.0)), 0.1, 1e-8);
  EXPECT_NEAR(advance(facing(0.1, -0.5)), 0.05, 1e-8);
  EXPECT_NEAR(advance(facing(0.1, 0.7)), 0.1, 1e-8);  // it may brake
  EXPECT_EQ(advance(facing(0.1, -2.0)), 0.0);
  EXPECT_EQ(advance(facing(-0.01, 0.0)), 0.0);
}

TEST(RobotSeparation, DoesNotStepInFrontOfARobot) {
  // Within the tick the robot comes from (-0.3, 0.59) to (0.1, 0.59) m, past an agent that stands: 0.59 m are more than
  // the 0.55 m of both radii. The first move leads away from where the robot is, but below 0.55 m of where it goes.
  PerceptionsBuilder scene;
  scene.agent(0, {5.0, 0.0}).speed(1.0);
  scene.neighbour({-0.3, 0.59}, 0.3).kind(NeighbourKind::ROBOT).velocity({0.0, 0.0}, {4.0, 0.0});
  const Vector2 sideways = Vector2(0.89, 0.45).normalized();
  EXPECT_LT(sideways.dot(Vector2(-0.3, 0.59)), 0.0);
  const auto moves = cut(SeparationRule(GapSharing::HALF, 0.0), scene.perception(),
                         {{sideways, 1.0, 1.0}, {Vector2::UnitX(), 1.0, 1.0}, {-Vector2::UnitY(), 1.0, 1.0}});
  EXPECT_EQ(moves[0].fraction, 0.0);
  EXPECT_EQ(moves[1].fraction, 1.0);
  EXPECT_EQ(moves[2].fraction, 1.0);
}

TEST(RobotSeparation, IgnoresRobotsThatAreNotYieldedTo) {
  EXPECT_EQ(advance(facing(0.1, 0.0).kind(NeighbourKind::UNYIELDED_ROBOT)), 1.0);
  PerceptionsBuilder scene = facing(0.3, -2.0);
  scene.kind(NeighbourKind::UNYIELDED_ROBOT);
  const auto moves = cut(SeparationRule(GapSharing::HALF, LOOKOUT), scene.perception(), {{Vector2::UnitX(), 0.0, 0.0}});
  EXPECT_EQ(moves[0].fraction, 0.0);
}

TEST(RobotSeparation, WithoutTheRuleNothingIsLimited) {
  const auto moves =
      cut(SeparationRule(GapSharing::NONE, LOOKOUT), facing(0.1, -1.0).perception(), {{Vector2::UnitX(), 1.0, 1.0}});
  EXPECT_EQ(moves[0].fraction, 1.0);
}

/// 1 to 30 agents and 1 to 3 robots of all drives in a square, none of which overlap.
Scene randomScene(KeyedRandom& random, std::uint64_t seed) {
  Scene scene = scenes::scene({});
  scene.contact = seed % 2 == 0 ? Contact::SOLID : Contact::GHOST;
  scene.tick_duration = random.uniform(0.05, 0.25);
  const double half_width = 2.5;
  for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
    RobotStart robot = robots::robot(scenes::randomPoint(random, half_width), random.uniform(-PI, PI));
    robot.drive = static_cast<Drive>(random.below(3));
    robot.limits = {random.uniform(0.2, 2.0), random.uniform(0.2, 2.0), random.uniform(0.2, 4.0), 3.0, 0.8};
    robot.footprint.radius = random.uniform(0.2, 0.4);
    if (random.below(2) == 0) {
      const double half_length = random.uniform(0.2, 0.5);
      robot.footprint.corners = {{half_length, 0.2}, {-half_length, 0.25}, {-half_length, -0.2}, {half_length, -0.2}};
    }
    scene.robots.push_back(robot);
  }
  const auto overlaps = [&](const AgentStart& agent) {
    for (const AgentStart& other : scene.agents) {
      if ((other.position - agent.position).norm() < other.radius + agent.radius) return true;
    }
    for (const RobotStart& robot : scene.robots) {
      if ((robot.position - agent.position).norm() < robot.footprint.reach() + agent.radius) return true;
    }
    return false;
  };
  for (std::uint32_t i = 1 + random.below(30); i > 0; --i) {
    const AgentStart agent =
        scenes::wanderer(scenes::randomPoint(random, half_width), random.uniform(0.5, 2.0), random.uniform(0.15, 0.3));
    if (!overlaps(agent)) scene.agents.push_back(agent);
  }
  return scene;
}

Twist randomCommand(KeyedRandom& random) {
  return {{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}, random.uniform(-2.0, 2.0)};
}

/// Between the disc that the agent perceives of the robot and its own [m]; below 0 beside a long footprint.
double gapBetween(const Robot& robot, const Agent& agent) {
  return (robot.pose.position - agent.pose.position).norm() - agent.radius - robot.perceived_radius;
}

/// How far the robot, at its present velocity, comes short of the agent in a tick [m]; below 0: it reaches it.
double shortfall(const World& world, const Robot& robot, const Agent& agent) {
  const Vector2 towards = robot.pose.position - agent.pose.position;
  return gapBetween(robot, agent) + world.tickDuration() * towards.normalized().dot(robot.velocity);
}

/// Mostly towards a robot, where contacts may happen.
CandidateMove randomMove(KeyedRandom& random, const Perception& seen) {
  Vector2 direction = unitVector(random.uniform(-PI, PI));
  for (const Neighbour& neighbour : seen.neighbours) {
    const bool chosen = neighbour.kind == NeighbourKind::ROBOT && random.below(2) == 0;
    if (chosen) direction = (neighbour.position + 0.3 * direction).normalized();
  }
  const double wanted = random.uniform();
  return {direction, wanted, wanted};
}

/// Random agents of these motion limits among robots with random commands.
void expectNoContactsByAgents(const MotionLimits& limits) {
  int contacts = 0;
  forSeeds(300, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& random) {
    World world(randomScene(random, seed));
    world.setMotion(limits);
    const SeparationRule rule(seed % 3 == 0 ? GapSharing::MOVING : GapSharing::HALF, seed % 5 == 0 ? 0.0 : LOOKOUT);
    Perceptions seen;
    for (int tick = 0; tick < 60 && !testing::Test::HasFailure(); ++tick) {
      for (RobotId id = 0; id < world.robots().size(); ++id) {
        if (random.below(10) == 0) world.robots().command(id, randomCommand(random));
      }
      perceive(world, {6.0, 0}, seen);
      std::vector<AgentAction> actions;
      for (std::size_t i = 0; i < seen.agents.size(); ++i) {
        const Perception perception(seen, i);
        const CandidateMove move = cut(rule, perception, {randomMove(random, perception)})[0];
        const BrakingLimits braking = limitsOf(perception, rule.sharing());
        actions.push_back({seen.agents[i].agent,
                           limits.areOn() ? BrakingRule(perception, braking).actionTowards(move) : toAction(move)});
      }
      const World before = world;
      world.step(actions);
      for (RobotId id = 0; id < world.robots().size(); ++id) {
        for (const RobotContact& contact : world.robots()[id].contacts) {
          if (!contact.begins) continue;
          ++contacts;
          const Robot& robot = before.robots()[id];
          const Agent& agent = before.agents()[contact.agent];
          const bool began_apart = gapBetween(robot, agent) >= 0.0;
          EXPECT_FALSE(began_apart && contact.cause == ContactCause::PERSON) << "tick " << tick;
          EXPECT_LT(shortfall(before, robot, agent), 0.0) << "tick " << tick;
        }
      }
    }
  });
  EXPECT_GT(contacts, 50);  // robots that drive at random do reach people
}

TEST(RobotSeparation, AgentsNeverMoveIntoRobotsNorIntoTheirReach) { expectNoContactsByAgents(MotionLimits()); }

TEST(RobotSeparation, NorDoAgentsWithMass) { expectNoContactsByAgents({3.0, 3.0, INFINITE}); }

TEST(RobotSeparation, AnAgentInTheOpenEscapesARobotThatDrivesStraightAtIt) {
  for (int degrees = 0; degrees < 360; degrees += 5) {
    SCOPED_TRACE(std::to_string(degrees) + " degrees");
    const Vector2 from = 3.0 * unitVector(toRadians(degrees));
    RobotStart robot = robots::robot(from, bearingOf(-from));
    robot.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
    World world(robots::with({robot}, scenes::scene({scenes::wanderer({0.0, 0.0})})));
    world.robots().command(0, {{1.0, 0.0}, 0.0});
    const SeparationRule rule(GapSharing::MOVING, LOOKOUT);
    Perceptions seen;
    for (int tick = 0; tick < 80; ++tick) {
      perceive(world, {6.0, 0}, seen);
      // Left alone, it stands.
      world.step({{0, toAction(cut(rule, {seen, 0}, {{Vector2::UnitX(), 0.0, 0.0}})[0])}});
      ASSERT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
    }
    EXPECT_GT((world.robots()[0].pose.position - from).norm(), 5.0);  // it went through where the agent stood
  }
}

}  // namespace
}  // namespace crowd::robot_separation_test
