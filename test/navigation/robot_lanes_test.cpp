// People who step aside from robots that wait.

#include "navigation/robot_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/robots.h"

namespace crowd::robots::robot_lanes_test {
namespace {

/// A robot of 0.3 m at the origin on its way along x, and people of 0.25 m around it.
Scene scenery(const std::vector<Vector2>& people) {
  Scene made = with({robotTo({9.0, 0.0}, {0.0, 0.0})}, scene({}));
  made.robots[0].limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  for (const Vector2& place : people) made.agents.push_back(wanderer(place));
  return made;
}

/// Lets the robot wait for a time [s].
void wait(World& world, double seconds) {
  for (int tick = 0; tick < std::lround(seconds / world.tickDuration()); ++tick) world.step({});
}

bool isAside(const World& world, AgentId agent) { return world.agents()[agent].perceivedGoal() != scenes::FAR_AWAY; }

TEST(RobotLanes, PeopleInItsWayStepAside) {
  // With the 0.015 m that its disc is larger, they are 0.085 m, 0.185 m, 0.335 m and, behind it, 0.085 m away.
  World world(scenery({{0.65, 0.05}, {0.0, -0.75}, {0.9, 0.0}, {-0.65, 0.0}}));
  RobotLanes lanes;
  wait(world, 0.5);
  lanes.update(world, false);
  EXPECT_FALSE(isAside(world, 0));  // it has not waited for a second
  wait(world, 0.6);
  lanes.update(world, false);
  EXPECT_TRUE(isAside(world, 0));
  EXPECT_TRUE(isAside(world, 1));
  EXPECT_FALSE(isAside(world, 2));
  EXPECT_TRUE(isAside(world, 3));
  EXPECT_LT(world.agents()[3].perceivedGoal().x(), -1.0);
  const Vector2 left = world.agents()[0].perceivedGoal() - world.agents()[0].pose.position;
  EXPECT_NEAR(left.norm(), 1.0, 1e-12);
  EXPECT_GT(left.x(), 0.5);  // away, and to the side on which it is
  EXPECT_GT(left.y(), 0.5);
  const Vector2 right = world.agents()[1].perceivedGoal() - world.agents()[1].pose.position;
  EXPECT_NEAR(right.y(), -1.0, 1e-9);
}

TEST(RobotLanes, TheyGoOnWhenTheRobotDrives) {
  World world(scenery({{0.8, 0.0}}));
  RobotLanes lanes;
  wait(world, 1.1);
  lanes.update(world, false);
  EXPECT_TRUE(isAside(world, 0));
  world.robots().command(0, {{0.2, 0.0}, 0.0});
  wait(world, 0.2);
  lanes.update(world, false);
  EXPECT_FALSE(isAside(world, 0));
  EXPECT_EQ(world.robots()[0].waited, 0.0);
}

TEST(RobotLanes, OnlyFromRobotsThatGetWayAndWantToGoOn) {
  const auto steps_aside = [](const Scene& made) {
    World world(made);
    RobotLanes lanes;
    wait(world, 1.1);
    lanes.update(world, false);
    return isAside(world, 0);
  };
  Scene made = scenery({{0.65, 0.05}});
  EXPECT_TRUE(steps_aside(made));
  made.robots[0].comfort = 0.0;
  EXPECT_FALSE(steps_aside(made));
  made.robots[0].comfort = 0.3;
  made.robots[0].yields = Yields::ROBOT;
  EXPECT_FALSE(steps_aside(made));
  made.robots[0].yields = Yields::CROWD;
  made.robots[0].goals.clear();
  EXPECT_FALSE(steps_aside(made));
}

}  // namespace
}  // namespace crowd::robots::robot_lanes_test
