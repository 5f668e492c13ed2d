#include "robots/controllers/learned_robot.h"

#include <gtest/gtest.h>

#include "robots/controllers/steering.h"
#include "simulation/episode.h"
#include "simulation/robot_controller.h"
#include "support/anticipation.h"
#include "support/robots.h"
#include "support/seeds.h"
#include "support/worlds.h"

namespace crowd::robots::learned_robot_test {
namespace {

/// A scene with people, a pillar, a wall and another robot, and the last place: that of an agent or a robot.
Scene surroundings(KeyedRandom& random) {
  Scene made = scene({}, {scenes::pillar(scenes::randomPoint(random, 3.0), 0.3)},
                     {{scenes::randomPoint(random, 3.0), scenes::randomPoint(random, 3.0)}});
  for (int i = 0; i < 6; ++i) made.agents.push_back(wanderer(scenes::randomPoint(random, 4.0)));
  made.robots.push_back(robot(scenes::randomPoint(random, 4.0)));
  return made;
}

TEST(LearnedRobot, PerceivesAndDecidesAsAnAgentInItsPlace) {
  const Learner learner = anticipationLearner();
  forSeeds(50, KeyedRandom::EXPLORATION, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    Scene with_robot = surroundings(random);
    Scene with_agent = with_robot;
    const Vector2 goal = scenes::randomPoint(random, 8.0);
    RobotStart start = robotTo(goal, {0.1, 0.2});
    start.drive = Drive::HOLONOMIC;
    with_robot.robots.push_back(start);
    const World robots(with_robot);
    with_agent.agents.push_back(
        scenes::agent(start.position, goal, start.limits.max_speed, robots.robots()[1].perceived_radius));
    World agents(with_agent);

    Viewers viewers;
    Perceptions of_robot;
    Perceiver().perceive(robots, learner.model().vision(), viewers.inPlaceOf(1, robots, goal), of_robot);
    Perceptions of_agents;
    perceive(agents, learner.model().vision(), of_agents);
    const Perception seen(of_robot, 0);
    const Perception expected(of_agents, 6);
    ASSERT_EQ(seen.neighbours.size(), expected.neighbours.size());
    for (std::size_t i = 0; i < seen.neighbours.size(); ++i) {
      EXPECT_EQ(seen.neighbours[i].position, expected.neighbours[i].position);
      EXPECT_EQ(seen.neighbours[i].radius, expected.neighbours[i].radius);
      EXPECT_EQ(seen.neighbours[i].kind, expected.neighbours[i].kind);
    }
    ASSERT_EQ(seen.walls.size(), expected.walls.size());
    EXPECT_EQ(seen.self.goal, expected.self.goal);
    EXPECT_EQ(seen.self.max_speed, expected.self.max_speed);
    EXPECT_EQ(seen.self.radius, expected.self.radius);

    DecisionWorkspace decisions;
    std::vector<AgentAction> actions;
    learner.decideGreedily(of_agents, decisions, actions);
    LearnedRobot driver(learner, 0, false);
    const Twist command = driver.command(robots, 1, goal);
    const RelativeAction& action = actions[6].action;
    EXPECT_EQ(command.linear, steer(Drive::HOLONOMIC, wrapAngle(action.rotation), action.speed_fraction).linear);
  });
}

/// The result of a robot that the learner drives.
RobotResult drive(const Scene& scene) {
  const Learner learner = anticipationLearner();
  Episode episode(scene, 0, learner.model().vision());
  RobotDrivers drivers("learned", episode, learner);
  while (!episode.isOver()) {
    drivers.command(episode);
    episode.step({});
  }
  return episode.result().robots.at(0);
}

TEST(LearnedRobot, DrivesRoundPeopleThatStand) {
  for (const Drive kind : {Drive::DIFFERENTIAL, Drive::HOLONOMIC, Drive::ACKERMANN}) {
    RobotStart start = robotTo({8.0, 0.0}, {0.0, 0.0});
    start.drive = kind;
    start.goal_tolerance = 0.3;
    start.limits = {1.0, 1.0, 2.0, 4.0, 0.3};
    Scene standing = solid(with({start}, scene({wanderer({3.0, 0.1}), wanderer({5.5, -0.3})})));
    standing.ends = Ends::ROBOTS;
    const RobotResult result = drive(standing);
    EXPECT_TRUE(result.isClean()) << DRIVES.nameOf(kind);
    EXPECT_LT(result.path_length_ratio, 1.3) << DRIVES.nameOf(kind);
  }
}

TEST(LearnedRobot, TurnsAtAWallThatItTouches) {
  // It touches the wall y = 0.3 and faces it at 0.4 rad; the goal lies along the wall.
  RobotStart start = robotTo({5.0, 0.0}, {0.0, 0.0});
  start.heading = 0.4;
  start.limits = {1.0, 1.0, 1.0, 2.0, 0.0};
  Scene walled = solid(with({start}, scene({}, {}, {{{-2.0, 0.3}, {8.0, 0.3}}})));
  walled.max_ticks = 150;
  EXPECT_TRUE(drive(walled).success);
}

TEST(LearnedRobot, FindsItsWayRoundWalls) {
  // The goal is behind a U of walls that is open towards the robot.
  RobotStart start = robotTo({6.0, 0.0}, {0.0, 0.0});
  start.goal_tolerance = 0.3;
  Scene walled = solid(
      with({start}, scene({}, {}, {{{3.0, -3.0}, {3.0, 3.0}}, {{1.0, 3.0}, {3.0, 3.0}}, {{1.0, -3.0}, {3.0, -3.0}}})));
  walled.max_ticks = 400;
  const RobotResult result = drive(walled);
  EXPECT_TRUE(result.success);
  EXPECT_EQ(result.wall_contacts, 0U);
  // Round the ends of the U: (1, 3) and (3, 3), each at 0.4 m.
  EXPECT_NEAR(result.path_length, 10.0, 1.0);
  walled.way_finding = false;
  EXPECT_FALSE(drive(walled).success);
}

}  // namespace
}  // namespace crowd::robots::learned_robot_test
