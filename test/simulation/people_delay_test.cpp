#include "simulation/evaluation/people_delay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/evaluations.h"

namespace crowd::people_delay_test {
namespace {

AgentResult walker(std::uint64_t ticks, double path_length, const Vector2& start, bool arrived = true) {
  AgentResult agent;
  agent.arrived = arrived;
  agent.appeared = 3;
  agent.start_x = start.x();
  agent.start_y = start.y();
  agent.ticks = ticks;
  agent.path_length = path_length;
  return agent;
}

TEST(PeopleDelay, IsTheMeanDifferenceOfThePeopleThatArriveInBothEpisodes) {
  EpisodeResult with;
  EpisodeResult without;
  with.robots.resize(2);
  with.agents = {walker(50, 6.0, {0.0, 0.0}), walker(70, 7.0, {1.0, 0.0}), walker(60, 9.0, {2.0, 0.0}),
                 walker(30, 3.0, {3.0, 0.0}), walker(20, 2.0, {4.0, 0.0})};
  without.agents = {walker(40, 5.0, {0.0, 0.0}), walker(10, 1.0, {1.0, 0.0}, false), walker(10, 1.0, {2.1, 0.0}),
                    walker(34, 3.25, {3.0, 0.0})};
  // Persons 0 and 3: 10 ticks later and 4 ticks earlier, 1 m farther and 0.25 m shorter.
  measurePeopleDelay(without, 0.1, with);
  for (const RobotResult& robot : with.robots) {
    EXPECT_EQ(robot.people_compared, 2U);
    EXPECT_NEAR(robot.people_delay, 0.3, 1e-12);
    EXPECT_NEAR(robot.people_detour, 0.375, 1e-12);
  }
}

TEST(PeopleDelay, IsNotANumberWithoutPeople) {
  EpisodeResult with;
  with.robots.resize(1);
  with.agents = {walker(50, 6.0, {0.0, 0.0}, false)};
  measurePeopleDelay(with, 0.1, with);
  EXPECT_EQ(with.robots[0].people_compared, 0U);
  EXPECT_TRUE(std::isnan(with.robots[0].people_delay));
  EXPECT_TRUE(std::isnan(with.robots[0].people_detour));
}

/// The results of five people that walk along y = 0, and of robots.
EpisodeResult walk(const std::string& robots, bool people_delay) {
  const std::string text =
      "name: line\nduration: 60\ngoal_tolerance: 0.3\ncontact: solid\nends: robots\n"
      "agents: [{count: 5, position: {box: [[-8, -0.5], [-2, 0.5]]}, goal: [8, 0], speed: 1.3, radius: 0.25}]\n"
      "robots: [" +
      robots + "]\n";
  EvaluationPlan plan;
  plan.robot_controller = "straight";
  plan.people_delay = people_delay;
  return evaluations::evaluateOnce(text, plan);
}

TEST(PeopleDelay, IsZeroIfTheRobotIsNotMet) {
  const RobotResult robot =
      walk("{name: far, position: [0, 40], goal: [5, 40], radius: 0.3, max_speed: 1}", true).robots[0];
  EXPECT_EQ(robot.people_compared, 5U);
  EXPECT_EQ(robot.people_delay, 0.0);
  EXPECT_EQ(robot.people_detour, 0.0);
}

TEST(PeopleDelay, IsPositiveBehindASlowRobot) {
  const std::string slow = "{name: slow, position: [-1, 0], goal: [1, 0], radius: 0.6, max_speed: 0.2}";
  const EpisodeResult measured = walk(slow, true);
  EXPECT_EQ(measured.robots[0].people_compared, 5U);
  EXPECT_GT(measured.robots[0].people_delay, 0.05);
  EXPECT_GT(measured.robots[0].people_detour, 0.02);
  // The robot's own measures end with its arrival, also if the episode goes on.
  const EpisodeResult plain = walk(slow, false);
  EXPECT_TRUE(std::isnan(plain.robots[0].people_delay));
  EXPECT_EQ(measured.robots[0].time_to_reach_goal, plain.robots[0].time_to_reach_goal);
  EXPECT_EQ(measured.robots[0].path_length, plain.robots[0].path_length);
  EXPECT_EQ(measured.robots[0].personal_space_time, plain.robots[0].personal_space_time);
}

}  // namespace
}  // namespace crowd::people_delay_test
