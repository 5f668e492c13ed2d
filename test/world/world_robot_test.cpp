// Robots in the world: commands, places, goals.

#include <gtest/gtest.h>

#include <limits>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/robots.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::robots::world_robot_test {
namespace {

TEST(WorldRobot, FollowsItsCommandUntilTheNext) {
  World world(with({robot({1.0, 2.0}, PI / 2.0)}, scene({})));
  world.step({});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(1.0, 2.0));
  world.robots().command(0, {{0.5, 0.0}, 0.0});
  world.step({});
  world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 1.0, 1e-15);
  EXPECT_NEAR(world.robots()[0].pose.position.y(), 2.1, 1e-15);
  EXPECT_NEAR(world.robots()[0].velocity.y(), 0.5, 1e-15);
  world.robots().command(0, {});
  world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.y(), 2.1, 1e-15);
}

TEST(WorldRobot, MovesAtTheEndOfASequentialTick) {
  World world(with({robot({1.0, 2.0})}, scene({wanderer({-5.0, 0.0})})));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  world.moveAgent(0, {});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(1.0, 2.0));
  world.endTick();
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 1.1, 1e-15);
}

TEST(WorldRobot, ReachesItsGoalsOneAfterTheOther) {
  RobotStart start = robotTo({1.0, 0.0}, {0.0, 0.0});
  start.goals.emplace_back(1.5, 0.0);
  start.goal_tolerance = 0.15;
  World world(with({start}, scene({})));
  world.robots().command(0, {{1.0, 0.0}, 0.0});
  // After tick k it is at 0.1 k m. The goals at 1 m and 1.5 m are within the tolerance of 0.15 m from ticks 9 and 14
  // on.
  for (int tick = 1; tick <= 15; ++tick) {
    world.step({});
    EXPECT_EQ(world.robots()[0].next_goal, tick < 9 ? 0U : 1U) << "tick " << tick;
    EXPECT_EQ(world.robots()[0].hasArrived(), tick >= 14) << "tick " << tick;
  }
  world.robots().setGoals(0, {{3.0, 0.0}});
  EXPECT_FALSE(world.robots()[0].hasArrived());
  world.step({});
  EXPECT_NEAR(world.robots()[0].pose.position.x(), 1.6, 1e-12);
}

TEST(WorldRobot, ElsewhereIsWhereItWasPlaced) {
  RobotStart start = robot({0.0, 0.0});
  start.drive = Drive::EXTERNAL;
  World world(with({start}, scene({})));
  world.robots().place(0, {{0.1, 0.0}, 7.0}, {1.0, 0.0}, false);
  world.step({});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(0.1, 0.0));
  EXPECT_EQ(world.robots()[0].pose.heading, wrapAngle(7.0));
  EXPECT_EQ(world.robots()[0].velocity, Vector2(1.0, 0.0));
  world.step({});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(0.1, 0.0));
  EXPECT_EQ(world.robots()[0].velocity, Vector2(0.0, 0.0));
  world.robots().place(0, {{5.0, 5.0}, 0.0}, {1.0, 0.0}, true);
  world.step({});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(5.0, 5.0));
  EXPECT_EQ(world.robots()[0].velocity, Vector2(0.0, 0.0));
  EXPECT_TRUE(world.robots()[0].jumped);
}

TEST(WorldRobot, TeleportsToFreePlacesOnly) {
  World world(with({robot({0.0, 0.0})}, scene({wanderer({3.0, 0.0})})));
  EXPECT_EQ(errorOf<InputError>([&] {
              WorldEditor(world).teleportRobot(0, {{3.5, 0.0}, 0.0});
            }),
            "the place is taken by agent 0");
  WorldEditor(world).teleportRobot(0, {{3.56, 0.0}, 1.0});
  EXPECT_EQ(world.robots()[0].pose.position, Vector2(3.56, 0.0));
  EXPECT_EQ(world.robots()[0].pose.heading, 1.0);
}

TEST(WorldRobot, RefusesWrongCommands) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RobotStart elsewhere = robot({5.0, 0.0});
  elsewhere.drive = Drive::EXTERNAL;
  World world(with({robot({0.0, 0.0}), elsewhere}, scene({})));
  EXPECT_EQ(errorOf<InputError>([&] { world.robots().command(2, {}); }), "there is no robot 2");
  EXPECT_EQ(errorOf<InputError>([&] { world.robots().command(1, {}); }),
            "robot 'robot' is external: it takes no commands");
  EXPECT_EQ(errorOf<InputError>([&] {
              world.robots().command(0, {{nan, 0.0}, 1.0});
            }),
            "robot 'robot': expected a command of finite numbers, got linear [nan, 0], rotation 1");
  EXPECT_EQ(errorOf<InputError>([&] {
              world.robots().place(0, {}, {0.0, 0.0}, false);
            }),
            "robot 'robot' is not external: it moves by commands");
  EXPECT_EQ(errorOf<InputError>([&] {
              world.robots().place(1, {{nan, 0.0}, 0.0}, {0.0, 0.0}, false);
            }),
            "position [m]: expected finite numbers, got [nan, 0]");
  EXPECT_EQ(errorOf<InputError>([&] {
              world.robots().place(1, {{0.0, 0.0}, nan}, {0.0, 0.0}, false);
            }),
            "heading [rad]: expected a finite number, got nan");
  EXPECT_EQ(errorOf<InputError>([&] {
              world.robots().setGoals(0, {{0.0, nan}});
            }),
            "goal [m]: expected finite numbers, got [0, nan]");
}

}  // namespace
}  // namespace crowd::robots::world_robot_test
