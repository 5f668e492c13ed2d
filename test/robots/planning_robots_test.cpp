#include <gtest/gtest.h>

#include <cmath>

#include "robots/controllers/orca_robot.h"
#include "robots/controllers/social_force_robot.h"
#include "simulation/episode.h"
#include "simulation/robot_controller.h"
#include "support/anticipation.h"
#include "support/robots.h"

namespace crowd::robots::planning_robots_test {
namespace {

/// The result of a robot that a controller drives among people who stand.
RobotResult drive(const std::string& controller, const Scene& scene) {
  const Learner learner = anticipationLearner();
  Episode episode(scene, 0, learner.model().vision());
  RobotDrivers drivers(controller, episode, learner);
  while (!episode.isOver()) {
    drivers.command(episode);
    episode.step({});
  }
  return episode.result().robots.at(0);
}

class PlanningRobots : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PlanningRobots, testing::Values("orca", "social_force"));

TEST_P(PlanningRobots, DriveRoundPeopleWhoStand) {
  for (const Drive kind : {Drive::DIFFERENTIAL, Drive::HOLONOMIC, Drive::ACKERMANN}) {
    RobotStart start = robotTo({8.0, 0.0}, {0.0, 0.0});
    start.drive = kind;
    start.goal_tolerance = 0.3;
    start.limits = {1.0, 1.0, 2.0, 4.0, 0.3};
    Scene standing = solid(with({start}, scene({wanderer({3.0, 0.3}), wanderer({5.5, -0.4})})));
    standing.ends = Ends::ROBOTS;
    const RobotResult result = drive(GetParam(), standing);
    EXPECT_TRUE(result.isClean()) << DRIVES.nameOf(kind);
  }
}

TEST_P(PlanningRobots, FindTheirWayRoundWalls) {
  // The goal is behind a U of walls that is open towards the robot.
  RobotStart start = robotTo({6.0, 0.0}, {0.0, 0.0});
  start.goal_tolerance = 0.3;
  start.limits = {1.0, 1.0, 2.0, 4.0, 0.3};
  Scene walled = solid(
      with({start}, scene({}, {}, {{{3.0, -3.0}, {3.0, 3.0}}, {{1.0, 3.0}, {3.0, 3.0}}, {{1.0, -3.0}, {3.0, -3.0}}})));
  walled.max_ticks = 400;
  const RobotResult result = drive(GetParam(), walled);
  EXPECT_TRUE(result.success);
  EXPECT_EQ(result.wall_contacts, 0U);
  walled.way_finding = false;
  EXPECT_FALSE(drive(GetParam(), walled).success);
}

/// A robot at the origin that faces along x at rest, with a goal ahead.
World worldWith(std::vector<AgentStart> people, std::vector<Segment> walls = {}) {
  RobotStart start = robotTo({9.0, 0.0}, {0.0, 0.0});
  start.drive = Drive::HOLONOMIC;
  return World(with({start}, scene(std::move(people), {}, std::move(walls))));
}

TEST(OrcaRobot, DrivesAtFullSpeedInTheOpenAndSlowlyAtItsGoal) {
  EXPECT_EQ(OrcaRobot(0, false).command(worldWith({}), 0, {9.0, 0.0}).linear, Vector2(1.0, 0.0));
  EXPECT_EQ(OrcaRobot(0, false).command(worldWith({}), 0, {0.5, 0.0}).linear, Vector2(0.5, 0.0));
}

TEST(OrcaRobot, StopsInTimeInFrontOfAWall) {
  // Its perceived radius is a little above 0.3 m: 0.5 m less that, in 1 s.
  const World world = worldWith({}, {{{0.5, -1.0}, {0.5, 1.0}}});
  const double room = 0.5 - world.robots()[0].perceived_radius;
  EXPECT_NEAR(OrcaRobot(0, false).command(world, 0, {9.0, 0.0}).linear.x(), room / OrcaRobot::WALL_HORIZON, 1e-12);
}

TEST(SocialForceRobot, SpeedsUpByTheDrivingForce) {
  // From rest, 2 m/s^2 for a tick of 0.1 s.
  const Twist twist = SocialForceRobot(0, false).command(worldWith({}), 0, {9.0, 0.0});
  EXPECT_NEAR(twist.linear.x(), 0.2, 1e-12);
}

TEST(SocialForceRobot, AddsTheForcesOfPeopleAndOfTheNearestWall) {
  const World world =
      worldWith({wanderer({2.0, 0.0}, 1.3, 0.25)}, {{{-5.0, 0.6}, {5.0, 0.6}}, {{-5.0, 2.0}, {5.0, 2.0}}});
  const double gap = 2.0 - 0.25 - world.robots()[0].perceived_radius;
  const Twist twist = SocialForceRobot(0, false).command(world, 0, {9.0, 0.0});
  EXPECT_NEAR(twist.linear.x(), 0.1 * (2.0 - 7.0 * std::exp(-gap / 0.3)), 1e-9);
  EXPECT_NEAR(twist.linear.y(), -0.1 * 50.0 * std::exp(-0.6 / 0.2), 1e-9);
}

}  // namespace
}  // namespace crowd::robots::planning_robots_test
