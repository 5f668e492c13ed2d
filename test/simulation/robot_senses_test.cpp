#include "social_crowd/simulation/robot_senses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/robots.h"
#include "support/scenes.h"

namespace crowd {
namespace {

constexpr RobotId ROBOT = 0;

/// A robot at the origin that sees an agent 2 m ahead, and a second robot 3 m behind.
Scene makeScene() {
  Scene scene = robots::with({robots::robot({0.0, 0.0}), robots::robot({-3.0, 0.0})},
                             scenes::halfSeconds(scenes::scene({scenes::wanderer({2.0, 0.0})})));
  for (RobotStart& robot : scene.robots) robot.scan.rays = 360;
  return scene;
}

TEST(RobotSenses, SeePeopleRobotsAndWalls) {
  Scene scene = makeScene();
  scene.walls = {{{-5.0, 4.0}, {5.0, 4.0}}};
  const World world(scene);
  RobotSenses senses(scene);
  const std::vector<float>& ranges = senses.ranges(world, ROBOT);
  ASSERT_EQ(ranges.size(), 360U);
  EXPECT_FLOAT_EQ(ranges[180], 1.75F);
  EXPECT_FLOAT_EQ(ranges[0], 2.7F);
  EXPECT_FLOAT_EQ(ranges[270], 4.0F);
  EXPECT_TRUE(std::isinf(ranges[90]));
  EXPECT_EQ(senses.visibleAgents(world, ROBOT), std::vector<bool>{true});
}

TEST(RobotSenses, DoNotSeePeopleBehindWalls) {
  Scene scene = makeScene();
  scene.walls = {{{1.0, -4.0}, {1.0, 4.0}}};
  const World world(scene);
  RobotSenses senses(scene);
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[180], 1.0F);
  EXPECT_EQ(senses.visibleAgents(world, ROBOT), std::vector<bool>{false});
}

TEST(RobotSenses, ExactOdometryIsTheMotionFromTheStart) {
  Scene scene = makeScene();
  scene.robots[0].heading = PI / 2.0;
  World world(scene);
  RobotSenses senses(scene);
  world.commandRobot(ROBOT, {{0.5, 0.0}, 0.5});
  for (int i = 0; i < 4; ++i) {
    world.step({});
    senses.observe(world);
  }
  // An arc of radius 1 m and 1 rad in two seconds.
  const Odometry& odometry = senses.odometry(ROBOT);
  EXPECT_NEAR(odometry.pose.position.x(), std::sin(1.0), 1e-12);
  EXPECT_NEAR(odometry.pose.position.y(), 1.0 - std::cos(1.0), 1e-12);
  EXPECT_NEAR(odometry.pose.heading, 1.0, 1e-12);
  EXPECT_EQ(odometry.twist.rotation, 0.5);
}

TEST(RobotSenses, OdometryDoesNotNoticeATeleportation) {
  const Scene scene = makeScene();
  World world(scene);
  RobotSenses senses(scene);
  world.teleportRobot(ROBOT, {{0.0, 9.0}, 0.0});
  world.step({});
  senses.observe(world);
  EXPECT_EQ(senses.odometry(ROBOT).pose.position.norm(), 0.0);
}

TEST(RobotSenses, ErrorsOfOdometryDependOnTheSeed) {
  const auto length_with = [](std::uint64_t seed) {
    Scene scene = makeScene();
    scene.population_seed = seed;
    scene.robots[0].odometry.distance = 0.1;
    World world(scene);
    RobotSenses senses(scene);
    world.commandRobot(ROBOT, {{1.0, 0.0}, 0.0});
    world.step({});
    senses.observe(world);
    return senses.odometry(ROBOT).pose.position.x();
  };
  EXPECT_EQ(length_with(1), length_with(1));
  EXPECT_NE(length_with(1), length_with(2));
  EXPECT_NE(length_with(1), 0.5);
  EXPECT_NEAR(length_with(1), 0.5, 0.5 * 0.5);  // five standard deviations
}

}  // namespace
}  // namespace crowd
