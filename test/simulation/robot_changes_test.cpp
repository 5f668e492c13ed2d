// Robots that are added to an episode, and removed.

#include <gtest/gtest.h>

#include "robots/robot_senses.h"
#include "scenario/reading/robot_reader.h"
#include "simulation/episode.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/robots.h"

namespace crowd::robots::robot_changes_test {
namespace {

RobotStart named(const std::string& name, const Vector2& position) {
  RobotStart start = robot(position);
  start.name = name;
  start.name_space = name;
  return start;
}

TEST(RobotChanges, ARobotIsAddedAndDrives) {
  Episode episode(with({named("a", {0.0, 0.0})}, scene({wanderer({3.0, 0.0})})), 0, Vision());
  episode.step({});
  EXPECT_EQ(episode.edit().addRobot(named("b", {0.0, 2.0})), 1U);
  episode.robots().command(1, {{1.0, 0.0}, 0.0});
  episode.step({});
  EXPECT_NEAR(episode.world().robots()[1].pose.position.x(), 0.1, 1e-12);
  ASSERT_EQ(episode.result().robots.size(), 2U);
  EXPECT_EQ(episode.result().robots[1].name, "b");
  EXPECT_NEAR(episode.result().robots[1].path_length, 0.1, 1e-12);
  EXPECT_EQ(episode.scene().robots.size(), 2U);
}

TEST(RobotChanges, WhatIsRefusedChangesNothing) {
  Episode episode(with({named("a", {0.0, 0.0})}, scene({wanderer({3.0, 0.0})}, {}, {{{5.0, -1.0}, {5.0, 1.0}}})), 0,
                  Vision());
  const auto refusal = [&](const RobotStart& start) {
    return errorOf<InputError>([&] { episode.edit().addRobot(start); });
  };
  EXPECT_EQ(refusal(named("a", {0.0, 5.0})), "there is a robot 'a' already");
  RobotStart same_space = named("b", {0.0, 5.0});
  same_space.name_space = "a";
  EXPECT_EQ(refusal(same_space), "robot 'a' is in the namespace 'a'");
  EXPECT_EQ(refusal(named("b", {3.2, 0.0})), "the place is taken by agent 0");
  EXPECT_EQ(refusal(named("b", {0.2, 0.0})), "the place is taken by robot 'a'");
  RobotStart to_wall = named("b", {0.0, 5.0});
  to_wall.goals = {{5.0, 0.0}};
  EXPECT_EQ(refusal(to_wall), "the goal (5, 0) is in a wall");
  EXPECT_EQ(episode.world().robots().size(), 1U);
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().removeRobot(1); }), "there is no robot 1");
}

TEST(RobotChanges, TheOthersGoOnWhenOneIsRemoved) {
  Episode episode(with({named("a", {0.0, 0.0}), named("b", {0.0, 2.0})}, scene({wanderer({9.0, 0.0})})), 0, Vision());
  episode.robots().command(1, {{1.0, 0.0}, 0.0});
  episode.step({});
  episode.edit().removeRobot(0);
  episode.step({});
  ASSERT_EQ(episode.world().robots().size(), 1U);
  EXPECT_EQ(episode.world().robots()[0].start.name, "b");
  EXPECT_NEAR(episode.world().robots()[0].pose.position.x(), 0.2, 1e-12);
  EXPECT_NEAR(episode.result().robots.at(0).path_length, 0.2, 1e-12);
  episode.edit().addRobot(named("a", {0.0, 0.0}));  // its place and name are free again
  EXPECT_EQ(episode.world().robots().idOf("a"), 1U);
}

TEST(RobotChanges, ALeaderOfAgentsIsNotRemoved) {
  AgentStart follower = wanderer({0.0, 3.0});
  follower.leader = Leader{Leader::Kind::ROBOT, 0};
  Scene made = with({named("a", {0.0, 0.0})}, scene({follower}));
  made.robots[0].goals = {{9.0, 0.0}};
  Episode episode(made, 0, Vision());
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().removeRobot(0); }), "agents follow robot 'a', or one after it");
}

TEST(RobotChanges, TheErrorsOfTheOthersStay) {
  Scene made = with({named("a", {0.0, 0.0}), named("b", {0.0, 2.0})}, scene({}));
  made.robots[1].scan.noise = 0.1;
  made.robots[1].scan.rays = 10;
  made.walls = {{{5.0, -5.0}, {5.0, 5.0}}};
  Episode episode(made, 0, Vision());
  RobotSenses senses(made);
  const std::vector<float> before = senses.ranges(episode.world(), 1);
  senses.remove(0);
  senses.forgetScans();
  episode.edit().removeRobot(0);
  EXPECT_EQ(senses.ranges(episode.world(), 0), before);
}

TEST(RobotChanges, ARobotIsReadFromAnEntryOfAScenario) {
  const RobotStart start =
      readRobotStart("{name: b, position: [1, 2], goal: [1, 5], radius: 0.2, max_speed: 1}", 0.4, false);
  EXPECT_EQ(start.name_space, "b");
  EXPECT_EQ(start.position, Vector2(1.0, 2.0));
  EXPECT_NEAR(start.heading, PI / 2.0, 1e-12);
  EXPECT_EQ(start.goal_tolerance, 0.4);
  EXPECT_EQ(readRobotStart("{name: b, position: [1, 2], radius: 0.2, max_speed: 1}", 0.4, true).name_space, "");
}

}  // namespace
}  // namespace crowd::robots::robot_changes_test
