// What people expect of a robot.

#include <gtest/gtest.h>

#include "support/robots.h"
#include "world/perceiver.h"
#include "world/world.h"

namespace crowd::robots::robot_intent_test {
namespace {

void expectVector(const Vector2& got, double x, double y) {
  EXPECT_NEAR(got.x(), x, 1e-12);
  EXPECT_NEAR(got.y(), y, 1e-12);
}

TEST(RobotIntent, ARobotThatWaitsOnItsWayWantsToGoAhead) {
  World world(with({robotTo({0.0, 5.0}, {0.0, 0.0})}, scene({})));
  expectVector(world.robots()[0].wantedVelocity(), 0.0, 0.3);
  world.robots().command(0, {{-0.05, 0.0}, 0.0});              // back
  expectVector(world.robots()[0].wantedVelocity(), 0.0, 0.3);  // people do not know it yet
  world.step({});
  expectVector(world.robots()[0].wantedVelocity(), 0.0, -0.3);
  world.robots().command(0, {{0.5, 0.0}, 0.0});
  world.step({});
  expectVector(world.robots()[0].wantedVelocity(), 0.0, 0.5);  // it drives
}

TEST(RobotIntent, ARobotWithoutAGoalOrAtItsGoalStands) {
  World world(with({robot({0.0, 0.0}), robotTo({0.05, 0.0}, {0.0, 0.0})}, scene({})));
  world.step({});
  expectVector(world.robots()[0].wantedVelocity(), 0.0, 0.0);
  EXPECT_TRUE(world.robots()[1].hasArrived());
  expectVector(world.robots()[1].wantedVelocity(), 0.0, 0.0);
}

TEST(RobotIntent, IsPerceivedInTheFrameOfTheAgent) {
  RobotStart start = robotTo({5.0, 0.0}, {0.0, 0.0});
  start.comfort = 0.7;
  AgentStart person = wanderer({2.0, 0.0});
  person.heading = PI / 2.0;
  World world(with({start}, scene({person})));
  Perceptions perceptions;
  Viewers viewers;
  Perceiver().perceive(world, Vision(), viewers.all(world), perceptions);
  ASSERT_EQ(perceptions.neighbours.size(), 1U);
  const Neighbour seen = perceptions.neighbours[0];
  EXPECT_EQ(seen.kind, NeighbourKind::ROBOT);
  EXPECT_EQ(seen.intent.comfort, 0.7);
  expectVector(seen.velocity, 0.0, 0.0);
  expectVector(seen.intent.wanted, 0.0, -0.3);  // to its right
}

}  // namespace
}  // namespace crowd::robots::robot_intent_test
