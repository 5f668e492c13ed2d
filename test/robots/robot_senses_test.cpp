#include "robots/robot_senses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/robots.h"
#include "support/scenes.h"
#include "world/world_editor.h"

namespace crowd::robot_senses_test {
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
  EXPECT_EQ(senses.visibleBodies(world, ROBOT), std::vector<bool>{true});
}

TEST(RobotSenses, DoNotSeePeopleBehindWalls) {
  Scene scene = makeScene();
  scene.walls = {{{1.0, -4.0}, {1.0, 4.0}}};
  const World world(scene);
  RobotSenses senses(scene);
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[180], 1.0F);
  EXPECT_EQ(senses.visibleBodies(world, ROBOT), std::vector<bool>{false});
}

TEST(RobotSenses, SeePeopleWhoHaveArrivedIfTheyStay) {
  for (const bool stays : {false, true}) {
    Scene scene = makeScene();
    scene.agents[0].goals = {{2.0, 0.0}};
    scene.agents[0].stays = stays;
    World world(scene);
    world.step({});
    ASSERT_TRUE(world.agents()[0].hasArrived());
    RobotSenses senses(scene);
    EXPECT_EQ(senses.visibleBodies(world, ROBOT), std::vector<bool>{stays});
    const float ahead = senses.ranges(world, ROBOT)[180];
    EXPECT_FLOAT_EQ(ahead, stays ? 1.75F : std::numeric_limits<float>::infinity());
  }
}

TEST(RobotSenses, SeeRecordedPeopleWhileTheyAreThere) {
  Scene scene = makeScene();
  const auto track = std::make_shared<const Track>(Track({0.0, 0.5}, {{0.0, 3.0}, {0.0, 3.0}}));
  scene.obstacles = {{ObstaclePath::recorded(track), 0.25, 12}};
  World world(scene);
  RobotSenses senses(scene);
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[270], 2.75F);
  EXPECT_EQ(senses.visibleBodies(world, ROBOT), (std::vector<bool>{true, true}));
  for (int tick = 0; tick < 2; ++tick) world.step({});
  EXPECT_TRUE(std::isinf(senses.ranges(world, ROBOT)[270]));
  EXPECT_EQ(senses.visibleBodies(world, ROBOT), (std::vector<bool>{true, false}));
  // The legs of a person who looks east: 0.1 m to the north and to the south.
  scene.robots[ROBOT].scan.people = SeenPeople::LEGS;
  RobotSenses others(scene);
  EXPECT_FLOAT_EQ(others.ranges(World(scene), ROBOT)[270], 2.84F);
}

TEST(RobotSenses, ExactOdometryIsTheMotionFromTheStart) {
  Scene scene = makeScene();
  scene.robots[0].heading = PI / 2.0;
  World world(scene);
  RobotSenses senses(scene);
  world.robots().command(ROBOT, {{0.5, 0.0}, 0.5});
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
  WorldEditor(world).teleportRobot(ROBOT, {{0.0, 9.0}, 0.0});
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
    world.robots().command(ROBOT, {{1.0, 0.0}, 0.0});
    world.step({});
    senses.observe(world);
    return senses.odometry(ROBOT).pose.position.x();
  };
  EXPECT_EQ(length_with(1), length_with(1));
  EXPECT_NE(length_with(1), length_with(2));
  EXPECT_NE(length_with(1), 0.5);
  EXPECT_NEAR(length_with(1), 0.5, 0.5 * 0.5);  // five standard deviations
}

TEST(RobotSenses, AChangeOfTheWorldWithinATickIsSeenAfterForgetScans) {
  const Scene scene = makeScene();
  World world(scene);
  RobotSenses senses(scene);
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[180], 1.75F);
  WorldEditor(world).addWall({{1.0, -1.0}, {1.0, 1.0}});
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[180], 1.75F);
  senses.forgetScans();
  EXPECT_FLOAT_EQ(senses.ranges(world, ROBOT)[180], 1.0F);
  EXPECT_EQ(senses.visibleBodies(world, ROBOT), std::vector<bool>{false});
}

/// Covariances after four steps of 0.5 m along x, without drawn errors that change the step.
OdometryCovariance covarianceWith(const OdometrySpec& spec) {
  Scene scene = makeScene();
  scene.robots[0].odometry = spec;
  World world(scene);
  RobotSenses senses(scene);
  world.robots().command(ROBOT, {{1.0, 0.0}, 0.0});
  for (int i = 0; i < 4; ++i) {
    world.step({});
    senses.observe(world);
  }
  return senses.covariance(ROBOT);
}

TEST(RobotSenses, CovarianceOfAnExactOdometryIsZero) {
  const OdometryCovariance covariance = covarianceWith({});
  EXPECT_TRUE(covariance.pose.isZero(0.0));
  EXPECT_TRUE(covariance.twist.isZero(0.0));
}

TEST(RobotSenses, CovarianceOfDistances) {
  // 2 m with 10 %: 0.2 m, 1 m/s with 10 %: 0.1 m/s.
  const OdometryCovariance covariance = covarianceWith({0.1, 0.3, 0.0});
  Eigen::Matrix3d pose = Eigen::Matrix3d::Zero();
  pose(0, 0) = 0.2 * 0.2;
  EXPECT_TRUE(covariance.pose.isApprox(pose, 1e-9)) << covariance.pose;
  Eigen::Matrix3d twist = Eigen::Matrix3d::Zero();
  twist(0, 0) = 0.1 * 0.1;
  EXPECT_TRUE(covariance.twist.isApprox(twist, 1e-9)) << covariance.twist;
}

TEST(RobotSenses, CovarianceOfADrift) {
  // 1e-6 rad/m turns the steps of 0.5 m by 0, 0.5, 1 and 1.5 of these, and the heading by 2.
  const double drift = 1e-6;
  const OdometryCovariance covariance = covarianceWith({0.0, 0.0, drift});
  const double y = 0.5 * (0.5 + 1.0 + 1.5) * drift;
  const double heading = 2.0 * drift;
  EXPECT_NEAR(covariance.pose(1, 1) / (y * y), 1.0, 1e-4);
  EXPECT_NEAR(covariance.pose(2, 2) / (heading * heading), 1.0, 1e-9);
  EXPECT_NEAR(covariance.pose(1, 2) / (y * heading), 1.0, 1e-4);
  EXPECT_NEAR(covariance.twist(2, 2) / (drift * drift), 1.0, 1e-9);
}

}  // namespace
}  // namespace crowd::robot_senses_test
