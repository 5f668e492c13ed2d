// Robots that stop in front of people.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/robots.h"
#include "support/seeds.h"
#include "world/world.h"

namespace crowd::robots::protective_stop_test {
namespace {

/// A robot of any drive, shape and limits.
RobotStart randomRobot(KeyedRandom& random) {
  RobotStart start = robot({0.0, 0.0}, random.uniform(-PI, PI));
  start.drive = static_cast<Drive>(random.below(3));
  start.limits.max_speed = random.uniform(0.3, 2.0);
  start.limits.max_rotation = random.uniform(0.3, 2.0);
  start.limits.max_acceleration = random.uniform(0.3, 3.0);
  start.limits.max_rotation_acceleration = random.uniform(0.3, 4.0);
  start.limits.min_turning_radius = random.uniform(0.3, 1.0);
  start.yields = random.below(2) == 0 ? Yields::ROBOT : Yields::BOTH;
  if (random.below(2) == 0) return start;
  const double length = random.uniform(0.2, 0.8);
  const double width = random.uniform(0.1, 0.4);
  start.footprint.corners = {{length, -width}, {length, width}, {-0.2, width}, {-0.2, -width}};
  return start;
}

/// The robot among people that stand, none of them nearer than 5 cm.
Scene randomStand(KeyedRandom& random) {
  const RobotStart start = randomRobot(random);
  Scene made = with({start}, scene({}));
  made.contact = random.below(2) == 0 ? Contact::GHOST : Contact::SOLID;
  while (made.agents.size() < 10) {
    const AgentStart person = wanderer(scenes::randomPoint(random, 3.0), random.uniform(0.5, 2.0));
    const double apart = distance(start.footprint, {start.position, start.heading}, person.position) - person.radius;
    if (apart > 0.05) made.agents.push_back(person);
  }
  return made;
}

double nearestPerson(const World& world) {
  const Robot& robot = world.robots()[0];
  double nearest = std::numeric_limits<double>::infinity();
  for (const Agent& agent : world.agents()) {
    nearest = std::min(nearest, distance(robot.start.footprint, robot.pose, agent.pose.position) - agent.radius);
  }
  return nearest;
}

/// A command at or beyond the limits: often straight at the nearest person, or a curve that passes it.
Twist extremeTwist(const World& world, KeyedRandom& random) {
  const Robot& robot = world.robots()[0];
  const DriveLimits& limits = robot.start.limits;
  const auto is_nearer = [&](const Agent& one, const Agent& other) {
    return (one.pose.position - robot.pose.position).norm() < (other.pose.position - robot.pose.position).norm();
  };
  const Agent& nearest = *std::min_element(world.agents().begin(), world.agents().end(), is_nearer);
  const Vector2 to_person = Rotation(robot.pose.heading).intoFrame(nearest.pose.position - robot.pose.position);
  const double speed = random.uniform(0.8, 2.0) * limits.max_speed;
  const bool is_holonomic = robot.start.drive == Drive::HOLONOMIC;
  const Vector2 ahead = is_holonomic ? Vector2(speed * to_person.normalized()) : Vector2(speed, 0.0);
  const double rotation = random.uniform(-1.5, 1.5) * limits.max_rotation;
  switch (random.below(3)) {
    case 0:
      return {ahead, 3.0 * bearingOf(to_person)};
    case 1:
      return {ahead, rotation};
    default:
      return {speed * unitVector(random.uniform(-PI, PI)), rotation};
  }
}

TEST(ProtectiveStopProperty, NeverTouchesPeopleThatStand) {
  int came_near = 0;
  double driven = 0.0;
  constexpr int WORLDS = 300;
  forSeeds(WORLDS, KeyedRandom::EXPLORATION, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    World world(randomStand(random));
    const std::uint32_t patience = 1 + random.below(20);  // mean time of a command [ticks]
    double nearest = std::numeric_limits<double>::infinity();
    for (int tick = 0; tick < 200; ++tick) {
      const Vector2 from = world.robots()[0].pose.position;
      if (random.below(patience) == 0) world.robots().command(0, extremeTwist(world, random));
      world.step({});
      ASSERT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
      ASSERT_GT(nearestPerson(world), 0.0) << "tick " << tick;
      nearest = std::min(nearest, nearestPerson(world));
      driven += (world.robots()[0].pose.position - from).norm();
    }
    came_near += nearest < 0.3 ? 1 : 0;
  });
  EXPECT_GT(came_near, WORLDS / 2);  // the stop was needed
  EXPECT_GT(driven / WORLDS, 2.0);   // [m]; it does not merely stand
}

TEST(ProtectiveStop, TestsTheTwistThatTheLimitsPermit) {
  // It drives at 2 m/s towards the person at (1, 0), and needs 1.9 m to stop. From x = -2 m on it is commanded a curve
  // of radius 1 m, which passes the person until it is 1.3 m away. But its rotation changes by 0.01 rad/s in a tick
  // only, so that it continues nearly straight. It has to brake in this tick.
  RobotStart start = robot({-6.0, 0.0});
  start.limits = {2.0, 2.0, 1.0, 0.1, 0.0};
  start.yields = Yields::ROBOT;
  World world(with({start}, scene({wanderer({1.0, 0.0}, 1.0)})));
  world.robots().command(0, {{2.0, 0.0}, 0.0});
  for (int tick = 0; tick < 100; ++tick) {
    if (world.robots()[0].pose.position.x() > -2.0) world.robots().command(0, {{2.0, 0.0}, 2.0});
    world.step({});
    ASSERT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
  }
  EXPECT_GT(world.robots()[0].pose.position.x(), -1.0);
}

TEST(ProtectiveStop, LetsARobotTurnAway) {
  // In front of a person it is commanded a curve to the left: it turns, and can then drive on.
  RobotStart start = robot({0.0, 0.0});
  start.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  start.yields = Yields::ROBOT;
  World world(with({start}, scene({wanderer({0.6, 0.0}, 1.0)})));
  world.robots().command(0, {{0.5, 0.0}, 0.5});
  for (int tick = 0; tick < 60; ++tick) {
    world.step({});
    ASSERT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
  }
  EXPECT_GT(world.robots()[0].pose.position.norm(), 0.3);
}

TEST(ProtectiveStop, LeavesAGapToPeopleThatStand) {
  RobotStart start = robot({0.0, 0.0});
  start.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  start.yields = Yields::ROBOT;
  World world(with({start}, scene({wanderer({3.0, 0.2}, 1.0)})));
  world.robots().command(0, {{5.0, 0.0}, 0.0});
  double fastest = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    world.step({});
    fastest = std::max(fastest, world.robots()[0].velocity.x());
    EXPECT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
  }
  EXPECT_NEAR(fastest, 1.0, 1e-9);
  // It comes near the distance that the agent could walk in a tick, 0.1 m, where the centres are 0.65 m apart.
  EXPECT_NEAR((world.robots()[0].pose.position - Vector2(3.0, 0.2)).norm(), 0.65, 0.02);
  EXPECT_LT(world.robots()[0].velocity.norm(), 0.05);
  world.robots().command(0, {{-1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 10; ++tick) world.step({});
  EXPECT_LT(world.robots()[0].velocity.x(), -0.5);  // the way back is free
}

/// It does not walk in the next tick: the robot comes near to 0.55 m, the sum of both radii.
TEST(ProtectiveStop, LeavesNoGapToAPersonWhoStays) {
  RobotStart start = robot({0.0, 0.0});
  start.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  start.yields = Yields::ROBOT;
  Scene made = with({start}, scene({scenes::agent({3.0, 0.2}, {3.0, 0.2}, 1.0)}));
  made.agents[0].stays = true;
  World world(made);
  for (int tick = 0; tick < 100; ++tick) {
    world.step({});
    world.robots().command(0, {{5.0, 0.0}, 0.0});
    EXPECT_TRUE(world.robots()[0].contacts.empty()) << "tick " << tick;
  }
  EXPECT_EQ(world.agents()[0].status, AgentStatus::STAYING);
  EXPECT_NEAR((world.robots()[0].pose.position - Vector2(3.0, 0.2)).norm(), 0.55, 0.02);
}

}  // namespace
}  // namespace crowd::robots::protective_stop_test
