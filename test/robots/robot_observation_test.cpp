#include "robots/robot_observation.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/robots.h"

namespace crowd::robots::robot_observation_test {
namespace {

TEST(RobotObservation, IncludesRecordedPeople) {
  // A recorded person of 0.25 m at 1 - t m, in front of a robot of 0.3 m; an agent beyond, 2 - 0.3 - 0.25 m away.
  Scene made = with({robot({0.0, 0.0})}, scene({wanderer({0.0, 2.0})}));
  const auto track =
      std::make_shared<const Track>(std::vector<double>{0.0, 1.0}, std::vector<Vector2>{{1.0, 0.0}, {0.0, 0.0}});
  made.obstacles = {{ObstaclePath::recorded(track), 0.25, 12}};
  World world(made);
  std::vector<RobotContact> contacts;
  EXPECT_NEAR(observeRobot(world.robots()[0], world, contacts).clearance, 0.45, 1e-12);
  for (int tick = 0; tick < 5; ++tick) {
    world.step({});
    addContacts(world.robots()[0], contacts);
  }
  const RobotObservation touched = observeRobot(world.robots()[0], world, contacts);
  EXPECT_NEAR(touched.clearance, -0.05, 1e-12);
  EXPECT_EQ(touched.contacts, std::vector<AgentId>{idOfRecorded(0)});
  EXPECT_EQ(touched.by_person, touched.contacts);
  EXPECT_TRUE(touched.by_robot.empty());
  for (int tick = 0; tick < 6; ++tick) world.step({});
  EXPECT_NEAR(observeRobot(world.robots()[0], world, {}).clearance, 1.45, 1e-12);  // the person has left
}

}  // namespace
}  // namespace crowd::robots::robot_observation_test
