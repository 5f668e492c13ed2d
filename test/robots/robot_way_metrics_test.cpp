// Metrics of the way to the goal, worked out by hand from the formulas of docs/metrics.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/robot_logs.h"

namespace crowd::robots::robot_way_metrics_test {
namespace {

const double SQUARE_ROOT_2 = std::sqrt(2.0);

/// 3 m along x, then 4 m along y, at 1 m/s, to a goal that is 5 m away.
std::vector<Pose> roundTheCorner() {
  return {{{0.0, 0.0}, 0.0},      {{1.0, 0.0}, 0.0},      {{2.0, 0.0}, 0.0},      {{3.0, 0.0}, 0.0},
          {{3.0, 1.0}, PI / 2.0}, {{3.0, 2.0}, PI / 2.0}, {{3.0, 3.0}, PI / 2.0}, {{3.0, 4.0}, PI / 2.0}};
}

TEST(RobotWayMetrics, ComparePathAndTimeWithTheShortest) {
  const RobotResult result = scoreOf(headerTo({3.0, 4.0}), roundTheCorner());
  EXPECT_TRUE(result.success);
  EXPECT_NEAR(result.path_length, 7.0, 1e-12);
  EXPECT_NEAR(result.shortest_path_length, 4.9, 1e-12);  // 5 m less the tolerance
  EXPECT_NEAR(result.path_length_ratio, 7.0 / 4.9, 1e-12);
  EXPECT_NEAR(result.path_efficiency, 0.7, 1e-12);
  EXPECT_NEAR(result.spl, 0.7, 1e-12);
  EXPECT_NEAR(result.stl, 0.35, 1e-12);  // 4.9 m at 2 m/s are 2.45 s, of 7 s
  EXPECT_NEAR(result.time_to_reach_goal, 7.0, 1e-12);
  EXPECT_NEAR(result.aggregated_time, 7.0, 1e-12);
}

TEST(RobotWayMetrics, MeasureRotationAgainstTheShortestWay) {
  // It turned by pi / 2; straight to the goal it would have turned by atan(4 / 3) = 0.9273.
  const RobotResult result = scoreOf(headerTo({3.0, 4.0}), roundTheCorner());
  EXPECT_NEAR(result.cumulative_heading_changes, PI / 2.0, 1e-12);
  EXPECT_NEAR(result.path_irregularity, 0.64350, 1e-5);
  // Directions to the goal after 1, 2 and 3 m: atan(4 / 2), atan(4 / 1), pi / 2; then straight to it.
  EXPECT_NEAR(result.avg_angle_to_goal, (1.107149 + 1.325818 + 1.570796) / 7.0, 1e-6);
  EXPECT_NEAR(result.avg_robot_angular_speed, PI / 2.0 / 7.0, 1e-12);
}

TEST(RobotWayMetrics, MeasureVelocityAccelerationAndJerk) {
  // 1 m/s from rest, then 90 degrees to the left at once: accelerations 1, 0, 0, sqrt(2), 0, 0, 0, and jerks 1, 1, 0,
  // sqrt(2), sqrt(2), 0, 0.
  const RobotResult result = scoreOf(headerTo({3.0, 4.0}), roundTheCorner());
  EXPECT_NEAR(result.min_speed, 1.0, 1e-12);
  EXPECT_NEAR(result.avg_robot_linear_speed, 1.0, 1e-12);
  EXPECT_NEAR(result.min_acceleration, 0.0, 1e-12);
  EXPECT_NEAR(result.avg_acceleration, (1.0 + SQUARE_ROOT_2) / 7.0, 1e-12);
  EXPECT_NEAR(result.max_acceleration, SQUARE_ROOT_2, 1e-12);
  EXPECT_NEAR(result.min_jerk, 0.0, 1e-12);
  EXPECT_NEAR(result.avg_jerk, (2.0 + 2.0 * SQUARE_ROOT_2) / 7.0, 1e-12);
  EXPECT_NEAR(result.max_jerk, SQUARE_ROOT_2, 1e-12);
}

TEST(RobotWayMetrics, OfAFailureCountNothing) {
  const RobotResult result = scoreOf(headerTo({9.0, 0.0}), roundTheCorner());
  EXPECT_TRUE(result.timeout);
  EXPECT_EQ(result.spl, 0.0);
  EXPECT_EQ(result.stl, 0.0);
  EXPECT_TRUE(std::isnan(result.path_efficiency));
  EXPECT_TRUE(std::isnan(result.aggregated_time));
  EXPECT_NEAR(result.path_length_ratio, 7.0 / 8.9, 1e-12);
}

TEST(RobotWayMetrics, NeedAGoal) {
  RobotLogHeader header = headerTo({0.0, 0.0});
  header.robots[0].goals.clear();
  const RobotResult result = scoreOf(header, roundTheCorner());
  for (const double number : {result.shortest_path_length, result.path_length_ratio, result.path_irregularity,
                              result.avg_angle_to_goal, result.spl, result.stl, result.aggregated_time}) {
    EXPECT_TRUE(std::isnan(number));
  }
  EXPECT_EQ(result.failures_to_progress, 0U);
}

TEST(RobotWayMetrics, TheShortestWayLeadsRoundWalls) {
  // A disc of 0.3 m passes the end of the wall at (0, 1): two tangents of sqrt(10 - 0.09) = 3.148 m and an arc of 0.3 m
  // times 2 (atan(1 / 3) + asin(0.3 / sqrt(10))) = 0.8335 are 6.546 m. The mesh keeps some centimetres more at the end.
  RobotLogHeader header = headerTo({3.0, 0.0});
  header.walls = {{{0.0, -10.0}, {0.0, 1.0}}};
  const RobotResult result = scoreOf(header, std::vector<Pose>{{{-3.0, 0.0}, 0.0}, {{-2.0, 0.0}, 0.0}});
  EXPECT_GE(result.shortest_path_length, 6.546 - 0.1);
  EXPECT_LE(result.shortest_path_length, 6.546 - 0.1 + 0.06);
  // From the heading 0 it turns to the left by 0.42, then by 0.84 to the right; the robot has not turned yet.
  EXPECT_EQ(result.path_irregularity, 0.0);
  header.gates = header.walls;  // a gate may be open
  const RobotResult open = scoreOf(header, std::vector<Pose>{{{-3.0, 0.0}, 0.0}, {{-2.0, 0.0}, 0.0}});
  EXPECT_NEAR(open.shortest_path_length, 5.9, 1e-9);
}

TEST(RobotWayMetrics, TheShortestWayLeadsRoundObstaclesAtRest) {
  // Two tangents of sqrt(9 - 1.3^2) = 2.7037 m to the disc of 1 + 0.3 m, and an arc of 2 asin(1.3 / 3) = 0.8963: 6.573
  // m.
  RobotLogHeader header = headerTo({3.0, 0.0});
  header.obstacles = {{{0.0, 0.0}, 1.0, false}};
  const RobotResult result = scoreOf(header, std::vector<Pose>{{{-3.0, 0.0}, 0.0}, {{-2.9, 0.0}, 0.0}});
  EXPECT_GE(result.shortest_path_length, 6.573 - 0.1);
  EXPECT_LE(result.shortest_path_length, 6.573 - 0.1 + 0.08);
}

TEST(RobotWayMetrics, WithoutAWayThereIsNoShortestOne) {
  RobotLogHeader header = headerTo({3.0, 0.0});
  header.walls = {
      {{2.0, -1.0}, {4.0, -1.0}}, {{4.0, -1.0}, {4.0, 1.0}}, {{4.0, 1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {2.0, -1.0}}};
  const RobotResult result = scoreOf(header, std::vector<Pose>{{{0.0, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}});
  EXPECT_TRUE(std::isnan(result.shortest_path_length));
  EXPECT_TRUE(std::isnan(result.path_length_ratio));
  EXPECT_EQ(result.spl, 0.0);
}

TEST(RobotWayMetrics, CountFailuresToProgress) {
  const auto at_speed = [](double speed) {
    std::vector<Pose> poses;
    for (int tick = 0; tick <= 25; ++tick) poses.push_back({{speed * tick, 0.0}, 0.0});
    return scoreOf(headerTo({50.0, 0.0}), poses);
  };
  // At rest it fails after 10 and 20 s; at 0.04 m/s it comes 0.4 m nearer in 10 s, which is not 0.5 m.
  EXPECT_EQ(at_speed(0.0).failures_to_progress, 2U);
  EXPECT_EQ(at_speed(0.04).failures_to_progress, 2U);
  EXPECT_EQ(at_speed(0.06).failures_to_progress, 0U);
  EXPECT_EQ(at_speed(0.0).stalled_time, 25.0);
  EXPECT_EQ(at_speed(0.04).stalled_time, 25.0);
  EXPECT_EQ(at_speed(0.06).stalled_time, 0.0);
  EXPECT_TRUE(at_speed(0.04).stuck);
  EXPECT_FALSE(at_speed(0.06).stuck);
}

TEST(RobotWayMetrics, HaveParametersOfProgress) {
  std::vector<Pose> poses(13, Pose{{0.0, 0.0}, 0.0});
  for (int tick = 0; tick <= 12; ++tick) poses[tick].position.x() = 0.2 * tick;
  // It comes 0.2 m nearer each second: 1 m in 5 s. It does not come 1 m nearer in 4 s, three times in 12 s.
  EXPECT_EQ(scoreOf(headerTo({9.0, 0.0}), poses, {1.0, 5.5, 0.05}).failures_to_progress, 0U);
  EXPECT_EQ(scoreOf(headerTo({9.0, 0.0}), poses, {1.0, 4.0, 0.05}).failures_to_progress, 3U);
  EXPECT_EQ(scoreOf(headerTo({9.0, 0.0}), poses, {1.0, 4.0, 0.25}).stalled_time, 12.0);
  EXPECT_TRUE(scoreOf(headerTo({9.0, 0.0}), poses, {1.0, 4.0, 0.05}).stuck);
}

TEST(RobotWayMetrics, ProgressAllowsForRounding) {
  // It comes 0.3 m nearer in 3 s; 1.2 - 0.9 is less than 0.3 by 7e-17.
  const std::vector<Pose> poses = {{{1.2, 0.0}, 0.0}, {{1.1, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}, {{0.9, 0.0}, 0.0}};
  const RobotResult result = scoreOf(headerTo({0.0, 0.0}), poses, {0.3, 3.0, 0.05});
  EXPECT_EQ(result.failures_to_progress, 0U);
  EXPECT_FALSE(result.stuck);
  EXPECT_EQ(scoreOf(headerTo({0.0, 0.0}), poses, {0.3001, 3.0, 0.05}).failures_to_progress, 1U);
}

TEST(RobotWayMetrics, BeginAnewAfterAJump) {
  // 1 m towards the goal; put to (9, 4), which is 4 m from it; 1 m towards it. No step, no turn and no progress by
  // that.
  std::vector<RobotLogTick> ticks = {tickAt(0, {{0.0, 0.0}, 0.0}), tickAt(1, {{1.0, 0.0}, 0.0}),
                                     tickAt(2, {{9.0, 4.0}, -PI / 2.0}), tickAt(3, {{9.0, 3.0}, -PI / 2.0})};
  ticks[2].robots[0].jump = true;
  const RobotResult result = scoreOf(headerTo({9.0, 0.0}), ticks, {0.5, 1.0, 0.05});
  EXPECT_NEAR(result.path_length, 2.0, 1e-12);
  EXPECT_EQ(result.cumulative_heading_changes, 0.0);
  EXPECT_NEAR(result.shortest_path_length, 1.0 + 4.0 - 0.1, 1e-12);
  EXPECT_NEAR(result.avg_acceleration, (1.0 + 1.0) / 2.0, 1e-12);  // it stands after the jump
  EXPECT_NEAR(result.max_jerk, 1.0, 1e-12);
  EXPECT_EQ(result.failures_to_progress, 1U);  // in the tick of the jump it came no nearer
}

TEST(RobotWayMetrics, OfEachGoalOfATour) {
  RobotLogHeader header = headerTo({2.0, 0.0});
  header.robots[0].goals = {{2.0, 0.0}, {2.0, 3.0}, {9.0, 3.0}};
  // 2 m straight to the first goal; 1 m past it and back, then 3 m to the second one; 1 m towards the third one.
  const RobotResult result = scoreOf(header, std::vector<Pose>{{{0.0, 0.0}, 0.0},
                                                               {{1.0, 0.0}, 0.0},
                                                               {{2.0, 0.0}, 0.0},
                                                               {{3.0, 0.0}, 0.0},
                                                               {{2.0, 0.0}, PI},
                                                               {{2.0, 1.5}, PI / 2.0},
                                                               {{2.0, 3.0}, PI / 2.0},
                                                               {{3.0, 3.0}, 0.0}});
  ASSERT_EQ(result.goals.size(), 3U);
  EXPECT_TRUE(result.goals[0].success);
  EXPECT_NEAR(result.goals[0].time_to_reach_goal, 2.0, 1e-12);
  EXPECT_NEAR(result.goals[0].path_length, 2.0, 1e-12);
  EXPECT_NEAR(result.goals[0].shortest_path_length, 1.9, 1e-12);
  EXPECT_NEAR(result.goals[0].spl, 1.9 / 2.0, 1e-12);
  EXPECT_TRUE(result.goals[1].success);
  EXPECT_NEAR(result.goals[1].time_to_reach_goal, 4.0, 1e-12);
  EXPECT_NEAR(result.goals[1].path_length, 5.0, 1e-12);
  EXPECT_NEAR(result.goals[1].path_length_ratio, 5.0 / 2.9, 1e-12);
  EXPECT_NEAR(result.goals[1].spl, 2.9 / 5.0, 1e-12);
  EXPECT_EQ(result.goals[1].y, 3.0);
  EXPECT_FALSE(result.goals[2].success);
  EXPECT_TRUE(std::isnan(result.goals[2].time_to_reach_goal));
  EXPECT_NEAR(result.goals[2].path_length, 1.0, 1e-12);
  EXPECT_EQ(result.goals[2].spl, 0.0);
  EXPECT_NEAR(result.shortest_path_length, 2.0 + 3.0 + 7.0 - 0.1, 1e-12);
  EXPECT_FALSE(result.success);
}

TEST(RobotWayMetrics, OfAGoalThatItDidNotSetOutFor) {
  RobotLogHeader header = headerTo({5.0, 0.0});
  header.robots[0].goals = {{5.0, 0.0}, {9.0, 0.0}};
  const RobotResult result = scoreOf(header, std::vector<Pose>{{{0.0, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}});
  EXPECT_TRUE(std::isnan(result.goals.at(1).path_length));
  EXPECT_EQ(result.goals[1].spl, 0.0);
}

}  // namespace
}  // namespace crowd::robots::robot_way_metrics_test
