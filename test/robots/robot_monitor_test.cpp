#include "robots/robot_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/robot_episodes.h"
#include "support/worlds.h"

namespace crowd::robots::robot_monitor_test {
namespace {

TEST(RobotResult, MeasuresTheMotion) {
  // From rest at 1 m/s^2: 0.1, 0.2, ... 1.0 m/s in ticks of 0.1 s.
  RobotStart start = robotTo({5.0, 0.0}, {0.0, 0.0});
  start.limits.max_acceleration = 1.0;
  const RobotResult result = resultAfter(10, with({start}, scene({})), {{1.0, 0.0}, 0.0});
  EXPECT_EQ(result.name, "robot");
  EXPECT_NEAR(result.path_length, 0.55, 1e-12);
  EXPECT_NEAR(result.path_length_ratio, 0.55 / 4.9, 1e-12);
  EXPECT_NEAR(result.final_distance, 4.45, 1e-12);
  EXPECT_NEAR(result.minimum_distance_to_goal, 4.45, 1e-12);
  EXPECT_NEAR(result.avg_robot_linear_speed, 0.55, 1e-12);
  EXPECT_NEAR(result.max_speed, 1.0, 1e-12);
  EXPECT_NEAR(result.avg_acceleration, 1.0, 1e-9);
  EXPECT_NEAR(result.avg_jerk, 1.0, 1e-9);  // 10 m/s^3 in the first tick, then 0
  EXPECT_NEAR(result.max_jerk, 10.0, 1e-9);
  EXPECT_NEAR(result.min_speed, 0.1, 1e-12);
  EXPECT_NEAR(result.min_acceleration, 1.0, 1e-9);
  EXPECT_NEAR(result.min_jerk, 0.0, 1e-9);
  EXPECT_EQ(result.avg_angle_to_goal, 0.0);
  EXPECT_TRUE(result.timeout);
  EXPECT_FALSE(result.success);
  EXPECT_FALSE(result.stuck);  // 10 s are not over
  EXPECT_TRUE(std::isnan(result.time_to_reach_goal));
  EXPECT_TRUE(std::isnan(result.minimum_distance_to_people));
}

TEST(RobotResult, MeasuresRotationAndRest) {
  const RobotResult turning = resultAfter(5, with({robot({0.0, 0.0})}, scene({})), {{0.0, 0.0}, -1.0});
  EXPECT_NEAR(turning.cumulative_heading_changes, 0.5, 1e-12);
  EXPECT_EQ(turning.time_not_moving, 0.0);
  const RobotResult standing = resultAfter(5, with({robot({0.0, 0.0})}, scene({})), {});
  EXPECT_NEAR(standing.time_not_moving, 0.5, 1e-12);
  EXPECT_FALSE(standing.timeout);  // it has no goal
  EXPECT_TRUE(std::isnan(standing.final_distance));
}

TEST(RobotResult, EndsAtTheArrival) {
  // 0.9 m to the tolerance of 0.1 m; then it drives on, which is not measured.
  RobotStart start = robotTo({1.05, 0.0}, {0.0, 0.0});
  const RobotResult result = resultAfter(20, with({start}, scene({})), {{1.0, 0.0}, 0.0});
  EXPECT_TRUE(result.success);
  EXPECT_FALSE(result.timeout);
  EXPECT_NEAR(result.time_to_reach_goal, 1.0, 1e-12);
  EXPECT_NEAR(result.path_length, 1.0, 1e-12);
  EXPECT_NEAR(result.path_length_ratio, 1.0 / 0.95, 1e-12);
  EXPECT_TRUE(result.isClean());
}

TEST(RobotResult, AStuckRobotHasNotMovedFor10Seconds) {
  const Scene blocked =
      scenes::solid(with({robotTo({5.0, 0.0}, {0.0, 0.0})}, scene({}, {}, {{{0.8, -1.0}, {0.8, 1.0}}})));
  EXPECT_FALSE(resultAfter(100, blocked, {{1.0, 0.0}, 0.0}).stuck);
  const RobotResult result = resultAfter(104, blocked, {{1.0, 0.0}, 0.0});
  EXPECT_TRUE(result.stuck);
  EXPECT_EQ(result.wall_contacts, 1U);
  const Scene open = with({robotTo({50.0, 0.0}, {0.0, 0.0})}, scene({}));
  EXPECT_FALSE(resultAfter(150, open, {{1.0, 0.0}, 0.0}).stuck);
}

TEST(RobotResult, MeasuresTheDistanceToPeople) {
  // After tick k the robot of 0.3 m is at 0.1 k m, its rim 1.45 - 0.1 k m from the centre of the person: 1.35 to 0.45
  // m. 1.35 and 1.25 are above 1.2; in 3 more ticks it is below 0.45.
  const RobotResult result =
      resultAfter(13, with({robot({0.0, 0.0})}, scene({wanderer({1.745, 0.0})})), {{1.0, 0.0}, 0.0});
  EXPECT_NEAR(result.minimum_distance_to_people, 0.145, 1e-9);
  EXPECT_NEAR(result.minimum_clearance, 0.145 - 0.25, 1e-9);
  EXPECT_NEAR(result.avg_closest_person, 1.445 - 0.7 - 0.25, 1e-9);  // the mean of 0.1 to 1.3 m is 0.7 m
  EXPECT_NEAR(result.intimate_space_time, 0.4, 1e-9);                // after ticks 10 to 13
  EXPECT_NEAR(result.personal_space_time, 1.1, 1e-9);                // after ticks 3 to 13
  EXPECT_NEAR(result.intimate_space_intrusions, 100.0 * 4 / 13, 1e-9);
  EXPECT_NEAR(result.personal_space_intrusions, 100.0 * 7 / 13, 1e-9);
}

TEST(RobotResult, CountsContactsByCause) {
  // The robot passes through a standing person: contact from 1.951 m to 3.049 m, in ticks 20 to 31.
  const RobotResult result =
      resultAfter(40, with({robot({0.0, 0.0})}, scene({wanderer({2.5, 0.0})})), {{1.0, 0.0}, 0.0});
  EXPECT_EQ(result.robot_on_person_collisions, 1U);
  EXPECT_EQ(result.person_on_robot_collisions, 0U);
  EXPECT_EQ(result.mutual_collisions, 0U);
  EXPECT_NEAR(result.contact_time, 1.2, 1e-9);
  EXPECT_FALSE(result.isClean());
}

TEST(RobotResult, CountsContactsWithRecordedPeople) {
  // A person of 0.25 m at 1 - t m walks through the robot of 0.3 m, in ticks 5 to 16.
  for (const Contact contact : {Contact::GHOST, Contact::SOLID}) {
    Scene made = with({robot({0.0, 0.0})}, scene({}));
    made.contact = contact;
    const auto track =
        std::make_shared<const Track>(std::vector<double>{0.0, 2.0}, std::vector<Vector2>{{1.0, 0.0}, {-1.0, 0.0}});
    made.obstacles = {{ObstaclePath::recorded(track), 0.25, 12}};
    const RobotResult result = resultAfter(25, made, {});
    EXPECT_EQ(result.person_on_robot_collisions, 1U);
    EXPECT_EQ(result.people_contacts, 1U);
    EXPECT_EQ(result.obstacle_contacts, 0U);
    EXPECT_NEAR(result.contact_time, 1.2, 1e-9);
    EXPECT_NEAR(result.minimum_clearance, -0.55, 1e-9);
  }
}

TEST(RobotResult, ATeleportIsNoDriving) {
  // 0.5 m along x, then from (3, 2) 0.5 m along y, the first 0.1 m of which are in the tick of the jump.
  Episode episode = after(5, with({robotTo({3.0, 5.0}, {0.0, 0.0})}, scene({})), {{1.0, 0.0}, 0.0});
  const double turned_at_start = episode.world().robots()[0].pose.heading;
  episode.edit().teleportRobot(0, {{3.0, 2.0}, PI / 2.0});
  for (int tick = 0; tick < 5; ++tick) episode.step({});
  const RobotResult result = episode.result().robots.at(0);
  EXPECT_NEAR(episode.world().robots()[0].pose.position.y(), 2.5, 1e-12);
  EXPECT_GT(std::abs(turned_at_start - PI / 2.0), 0.1);
  EXPECT_NEAR(result.path_length, 0.9, 1e-12);
  EXPECT_NEAR(result.cumulative_heading_changes, 0.0, 1e-12);
  EXPECT_NEAR(result.max_acceleration, 10.0, 1e-9);  // of the first tick
  EXPECT_NEAR(result.avg_acceleration, 10.0 / 9.0, 1e-9);
  EXPECT_NEAR(result.avg_jerk, 200.0 / 8.0, 1e-9);  // of the first two ticks
  // 0.5 m up to the jump, and 2.9 m from (3, 2.1) on.
  EXPECT_NEAR(result.shortest_path_length, 0.5 + 2.9 - 0.1, 1e-12);
  EXPECT_NEAR(result.goals.at(0).path_length, 0.9, 1e-12);
  EXPECT_NEAR(result.goals[0].shortest_path_length, 0.5 + 2.9 - 0.1, 1e-12);
}

TEST(RobotResult, AJumpOfAPoseIsNoDriving) {
  RobotStart start = robotTo({9.0, 4.0}, {0.0, 0.0});
  start.drive = Drive::EXTERNAL;
  Episode episode(with({start}, scene({})), 0, Vision());
  episode.step({});
  episode.robots().place(0, {{5.0, 4.0}, PI}, {1.0, 0.0}, true);  // its first pose
  episode.step({});
  for (const double x : {5.1, 5.2}) {
    episode.robots().place(0, {{x, 4.0}, PI}, {1.0, 0.0}, false);
    episode.step({});
  }
  const RobotResult result = episode.result().robots.at(0);
  EXPECT_NEAR(result.path_length, 0.2, 1e-12);
  EXPECT_EQ(result.cumulative_heading_changes, 0.0);
  EXPECT_NEAR(result.max_acceleration, 10.0, 1e-9);  // from 0 to 1 m/s after the jump
  EXPECT_EQ(result.max_jerk, 100.0);                 // from that to 0, in the last tick; none in the one after the jump
  EXPECT_NEAR(result.shortest_path_length, 4.0 - 0.1, 1e-12);  // from the first pose
}

TEST(RobotResult, WhatARobotDoesAfterItsArrivalIsNotCounted) {
  // It arrives at 1 m and drives on to 2 m; then it drives 0.1 m to another goal.
  Episode episode = after(10, with({robotTo({1.05, 0.0}, {0.0, 0.0})}, scene({})), {{1.0, 0.0}, 0.0});
  EXPECT_TRUE(episode.result().robots.at(0).success);
  for (int tick = 0; tick < 10; ++tick) episode.step({});
  const double avg_jerk = episode.result().robots.at(0).avg_jerk;
  EXPECT_NEAR(avg_jerk, 20.0, 1e-9);  // 100 m/s^3 in each of the first two of ten ticks
  episode.robots().setGoals(0, {{5.0, 0.0}});
  episode.step({});
  const RobotResult result = episode.result().robots.at(0);
  EXPECT_NEAR(result.path_length, 1.1, 1e-12);
  EXPECT_NEAR(result.avg_acceleration, 10.0 / 11.0, 1e-9);
  EXPECT_NEAR(result.avg_jerk, 200.0 / 11.0, 1e-9);
  EXPECT_NEAR(result.shortest_path_length, 1.0 + 3.0 - 0.1, 1e-9);
  EXPECT_NEAR(result.goals.at(0).path_length, 0.1, 1e-12);
  EXPECT_NEAR(result.goals[0].shortest_path_length, 3.0 - 0.1, 1e-9);
}

TEST(RobotResult, AGoalThatIsSentAgainIsMeasured) {
  Episode episode = after(10, with({robotTo({1.05, 0.0}, {0.0, 0.0})}, scene({})), {{1.0, 0.0}, 0.0});
  ASSERT_TRUE(episode.world().robots()[0].hasArrived());
  for (int tick = 0; tick < 5; ++tick) episode.step({});
  episode.edit().sendRobot(0, {1.05, 0.0});  // from 1.5 m
  episode.robots().command(0, {{-1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 2; ++tick) episode.step({});
  RobotResult result = episode.result().robots.at(0);
  EXPECT_FALSE(result.success);
  EXPECT_TRUE(result.timeout);
  EXPECT_NEAR(result.minimum_distance_to_goal, 0.25, 1e-9);
  for (int tick = 0; tick < 2; ++tick) episode.step({});
  result = episode.result().robots.at(0);
  EXPECT_TRUE(result.success);
  EXPECT_NEAR(result.time_to_reach_goal, 1.4, 1e-9);  // 1 s and 0.4 s
  EXPECT_NEAR(result.path_length, 1.4, 1e-9);
}

TEST(RobotResult, ATourThatIsSentAgainBeginsAnew) {
  RobotStart start = robotTo({1.0, 0.0}, {0.0, 0.0});
  start.goals = {{1.0, 0.0}, {3.0, 0.0}};
  Episode episode = after(15, with({start}, scene({})), {{1.0, 0.0}, 0.0});
  EXPECT_TRUE(episode.result().robots.at(0).goals.at(0).success);
  episode.robots().setGoals(0, start.goals);  // at 1.5 m
  episode.robots().command(0, {{-1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 3; ++tick) episode.step({});
  const RobotResult result = episode.result().robots.at(0);
  ASSERT_EQ(result.goals.size(), 2U);
  EXPECT_FALSE(result.goals[0].success);
  EXPECT_NEAR(result.goals[0].path_length, 0.3, 1e-9);
  EXPECT_TRUE(std::isnan(result.goals[1].path_length));
}

TEST(RobotResult, LeavesOutTheAccelerationOfAnImpact) {
  // From rest at 1 m/s^2; the wall stops it in the tenth tick, at 0.5 m, from 0.9 m/s to 0 in 0.1 s.
  RobotStart start = robotTo({5.0, 0.0}, {0.0, 0.0});
  start.limits.max_acceleration = 1.0;
  const Scene walled = scenes::solid(with({start}, scene({}, {}, {{{0.8, -1.0}, {0.8, 1.0}}})));
  const RobotResult result = resultAfter(12, walled, {{1.0, 0.0}, 0.0});
  EXPECT_EQ(result.wall_contacts, 1U);
  EXPECT_NEAR(result.path_length, 0.5, 1e-6);
  EXPECT_NEAR(result.max_acceleration, 1.0, 1e-9);
  EXPECT_NEAR(result.min_acceleration, 1.0, 1e-9);
  EXPECT_NEAR(result.avg_acceleration, 1.0, 1e-9);
  EXPECT_NEAR(result.max_jerk, 10.0, 1e-9);  // of the first tick
}

TEST(RobotResult, HasTheTimeUntilAllHadArrived) {
  // One person arrives after 0.3 s, the robot after 1 s.
  const Scene both = with({robotTo({1.05, 0.0}, {0.0, 0.0})}, scene({scenes::agent({0.0, 5.0}, {0.5, 5.0}, 1.0)}));
  Episode episode(both, 0, Vision());
  episode.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 10; ++tick) episode.step({ahead(0)});
  EXPECT_NEAR(episode.result().robots[0].aggregated_time, 1.0, 1e-12);
  const Scene lost = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({wanderer({0.0, 5.0})}));
  EXPECT_TRUE(std::isnan(resultAfter(10, lost, {{1.0, 0.0}, 0.0}).aggregated_time));
}

TEST(RobotResult, CountsContactsOfRobots) {
  const Scene two = scenes::solid(with({robot({0.0, 0.0}), robot({0.9, 0.0})}, scene({})));
  Episode episode(two, 0, Vision());
  episode.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 6; ++tick) episode.step({});
  EXPECT_EQ(episode.result().robots[0].robot_contacts, 1U);
  EXPECT_EQ(episode.result().robots[1].robot_contacts, 1U);
}

TEST(RobotResult, ANewGoalBeginsAnew) {
  Episode episode = after(12, with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({})), {{1.0, 0.0}, 0.0});
  EXPECT_TRUE(episode.result().robots[0].success);
  episode.robots().setGoals(0, {{3.0, 0.0}});
  episode.step({});
  const RobotResult result = episode.result().robots[0];
  EXPECT_FALSE(result.success);
  EXPECT_TRUE(result.timeout);
}

TEST(RobotEpisode, IsOverWhenTheCrowdAndTheRobotsAre) {
  const Scene both = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({scenes::agent({0.0, 5.0}, {0.5, 5.0}, 1.0)}));
  Episode episode(both, 0, Vision());
  for (int tick = 0; tick < 5; ++tick) episode.step({ahead(0)});
  EXPECT_EQ(episode.world().activeCount(), 0U);
  EXPECT_FALSE(episode.isOver());
  episode.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int tick = 0; tick < 10; ++tick) episode.step({});
  EXPECT_TRUE(episode.isOver());
}

TEST(RobotEpisode, MayEndWithTheRobots) {
  Scene both = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({wanderer({0.0, 5.0})}));
  both.ends = Ends::ROBOTS;
  EXPECT_FALSE(after(5, both, {{1.0, 0.0}, 0.0}).isOver());
  EXPECT_TRUE(after(10, both, {{1.0, 0.0}, 0.0}).isOver());
}

TEST(RobotEpisode, WithoutGoalsLastsForItsDuration) {
  Scene alone = with({robot({0.0, 0.0})}, scene({}));
  alone.max_ticks = 7;
  EXPECT_FALSE(after(6, alone, {}).isOver());
  EXPECT_TRUE(after(7, alone, {}).isOver());
}

}  // namespace
}  // namespace crowd::robots::robot_monitor_test
