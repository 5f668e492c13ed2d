#include <gtest/gtest.h>

#include <cmath>

#include "learning/states/occupancy_states.h"
#include "support/error_of.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::thesis_reward_test {
namespace {

std::shared_ptr<const Reward> make(const std::string& yaml) {
  return rewardOf(yaml, *statesOf("{type: nearest_obstacle}"));
}

/// (3.6) or (3.7), with the obstacle part of the thesis's state set 1 (3.8).
std::shared_ptr<const Reward> nearestReward(const std::string& goal) {
  return make("{goal: " + goal + ", obstacle_cost: 80}");
}

/// (3.7), with the obstacle part of state set 2 (3.9).
std::shared_ptr<const Reward> occupancyReward() {
  return rewardOf("{goal: cosine_cubed, obstacle_cost: 10}", OccupancyStates());
}

/// The row of state set 1 with the goal in a sector and an obstacle in another one (3.3).
Row nearestRow(int goal_sector, int obstacle_sector, int distance_class) {
  return static_cast<Row>(7 + goal_sector * 16 + obstacle_sector * 2 + distance_class);
}

AgentPerception withGoalAt(const Vector2& goal) {
  AgentPerception self;
  self.goal = goal;
  return self;
}

double worth(const Reward& reward, const AgentPerception& before, const AgentPerception& after, Row row) {
  Perceptions perceptions;
  perceptions.agents = {after};
  return reward(before, {perceptions, 0}, row);
}

/// The obstacle part: the goal is aside of the agent, so that (3.7) is 0.
double obstaclePart(const Reward& reward, Row row) {
  return worth(reward, withGoalAt({0.0, 3.0}), withGoalAt({0.0, 3.0}), row);
}

/// (3.7) for a goal at a bearing after the move, nothing around.
double cosineReward(double degrees) {
  const auto reward = nearestReward("cosine_cubed");
  return worth(*reward, withGoalAt({7.0, 7.0}), withGoalAt(polar(degrees, 4.0)), 0);
}

/// (3.6) for a goal at two distances, nothing around.
double distanceReward(const Vector2& before, const Vector2& after) {
  return worth(*nearestReward("distance_gained"), withGoalAt(before), withGoalAt(after), 0);
}

TEST(ThesisReward, GoalPartIsTheDistanceGained) {
  EXPECT_DOUBLE_EQ(distanceReward({3.0, 4.0}, {0.0, 4.0}), 1.0);  // 5 m before, 4 m after
  EXPECT_DOUBLE_EQ(distanceReward({0.0, -4.0}, {-3.0, 4.0}), -1.0);
  EXPECT_DOUBLE_EQ(distanceReward({0.0, 2.0}, {-2.0, 0.0}), 0.0);  // turned, but no nearer
  EXPECT_DOUBLE_EQ(distanceReward({0.25, 0.0}, {0.0, 0.0}), 0.25);
}

TEST(ThesisReward, DistanceGainedIsZeroForANewGoal) {
  const auto reward = nearestReward("distance_gained");
  const AgentPerception before = withGoalAt({0.2, 0.0});
  AgentPerception after = withGoalAt({9.0, 0.0});
  EXPECT_DOUBLE_EQ(worth(*reward, before, after, 0), -8.8);
  after.goal_number = 1;
  EXPECT_DOUBLE_EQ(worth(*reward, before, after, 0), 0.0);
}

TEST(ThesisReward, GoalPartIsTheCubeOfTheCosine) {
  EXPECT_NEAR(cosineReward(0.0), 1.0, 1e-12);
  EXPECT_NEAR(cosineReward(45.0), 0.35355339, 1e-8);  // (1/sqrt(2))^3
  EXPECT_NEAR(cosineReward(60.0), 0.125, 1e-12);      // (1/2)^3
  EXPECT_NEAR(cosineReward(-60.0), 0.125, 1e-12);
  EXPECT_NEAR(cosineReward(90.0), 0.0, 1e-12);
  EXPECT_NEAR(cosineReward(120.0), -0.125, 1e-12);
  EXPECT_NEAR(cosineReward(180.0), -1.0, 1e-12);
}

TEST(ThesisReward, GoalPartIsDefinedAtTheGoalItself) {
  const auto reward = nearestReward("cosine_cubed");
  EXPECT_EQ(worth(*reward, withGoalAt({0.1, 0.0}), withGoalAt({0.0, 0.0}), 0), 1.0);
}

TEST(ThesisReward, NearestObstacleCosts80Or08) {
  const auto reward = nearestReward("cosine_cubed");
  for (int goal = 0; goal < 8; ++goal) {
    EXPECT_EQ(obstaclePart(*reward, static_cast<Row>(goal)), 0.0);
    for (int sector = 0; sector < 8; ++sector) {
      EXPECT_DOUBLE_EQ(obstaclePart(*reward, nearestRow(goal, sector, 1)), -80.0);
      EXPECT_DOUBLE_EQ(obstaclePart(*reward, nearestRow(goal, sector, 2)), -0.8);  // 80 / 10^2
    }
  }
  EXPECT_EQ(obstaclePart(*reward, 136), 0.0);  // the terminal row
}

TEST(ThesisReward, OccupiedSectorsCost10Or01) {
  const auto reward = occupancyReward();
  const OccupancyStates states;
  const auto part_of = [&](const OccupancyStates::Situation& situation) {
    return obstaclePart(*reward, states.rowOf(situation));
  };
  EXPECT_EQ(part_of({0, {}}), 0.0);
  EXPECT_EQ(part_of({5, {}}), 0.0);
  EXPECT_DOUBLE_EQ(part_of({0, {1}}), -10.0);
  EXPECT_DOUBLE_EQ(part_of({0, {0, 0, 0, 0, 0, 0, 0, 2}}), -0.1);  // 10 / 10^2
  EXPECT_DOUBLE_EQ(part_of({3, {1, 2, 0, 1, 0, 2, 2, 0}}), -20.3);
  EXPECT_DOUBLE_EQ(part_of({7, {1, 1, 1, 1, 1, 1, 1, 1}}), -80.0);
  EXPECT_DOUBLE_EQ(part_of({7, {2, 2, 2, 2, 2, 2, 2, 2}}), -0.8);
  EXPECT_EQ(obstaclePart(*reward, states.terminal()), 0.0);
}

TEST(ThesisReward, WorkedExampleOfSet2) {
  // A disc of radius 0.3 at (0.7, 0): class 1 ahead, class 2 on either side (occupancy_states_test.cpp).
  const OccupancyStates states;
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({0.7, 0.0}, 0.3);
  EXPECT_DOUBLE_EQ(obstaclePart(*occupancyReward(), states.rowOf(scene.perception())), -10.2);  // -(10 + 0.1 + 0.1)
}

TEST(ThesisReward, IsTheSumOfBothParts) {
  const auto cosine = nearestReward("cosine_cubed");
  EXPECT_NEAR(worth(*cosine, withGoalAt({9.0, 0.0}), withGoalAt(polar(60.0, 3.0)), nearestRow(1, 2, 2)), -0.675,
              1e-12);  // 0.125 - 0.8
  const auto distance = nearestReward("distance_gained");
  EXPECT_NEAR(worth(*distance, withGoalAt({3.0, 4.0}), withGoalAt({4.5, 0.0}), nearestRow(0, 0, 1)), -79.5, 1e-12);
  const OccupancyStates occupancy;
  EXPECT_NEAR(worth(*occupancyReward(), withGoalAt({9.0, 0.0}), withGoalAt({3.0, 0.0}), occupancy.rowOf({0, {1, 2}})),
              -9.1,
              1e-12);  // 1 - 10 - 0.1
}

TEST(ThesisReward, ArrivalGives100WithAnyObstacles) {
  for (const std::string goal : {"distance_gained", "cosine_cubed"}) {
    AgentPerception after = withGoalAt({-0.1, 0.2});
    after.arrived = true;
    const Row near_row = nearestRow(0, 0, 1);
    EXPECT_EQ(worth(*nearestReward(goal), withGoalAt({0.3, 0.0}), after, near_row), 100.0);
  }
}

TEST(ThesisReward, IncludesTheCostOfStaying) {
  for (const std::string goal : {"distance_gained", "cosine_cubed"}) {
    const auto reward = make("{goal: " + goal + ", obstacle_cost: 80, stay_cost: 0.25}");
    const double goal_part = goal == "cosine_cubed" ? 1.0 : 0.0;
    AgentPerception after = withGoalAt({3.0, 0.0});
    after.velocity = Vector2::Zero();
    EXPECT_DOUBLE_EQ(worth(*reward, withGoalAt({3.0, 0.0}), after, 0), goal_part - 0.25);
    const Row seen = nearestRow(0, 0, 2);
    EXPECT_DOUBLE_EQ(worth(*reward, withGoalAt({3.0, 0.0}), after, seen), goal_part - 0.8 - 0.25);
    after.velocity = {0.0, 1e-200};  // however slowly
    EXPECT_DOUBLE_EQ(worth(*reward, withGoalAt({3.0, 0.0}), after, 0), goal_part);
    after.velocity = {-0.3, 0.0};
    EXPECT_DOUBLE_EQ(worth(*reward, withGoalAt({3.0, 0.0}), after, 0), goal_part);
    after.velocity = Vector2::Zero();
    after.arrived = true;
    EXPECT_EQ(worth(*reward, withGoalAt({3.0, 0.0}), after, 0), 100.0);
  }
}

std::string errorIn(const std::string& yaml) {
  return errorOf<InputError>([&] { make(yaml); });
}

TEST(MakeReward, ReadsAllParameters) {
  const auto reward = make("{goal: distance_gained, arrival: 50, obstacle_cost: 8}");
  EXPECT_EQ(reward->spec(), "{goal: distance_gained, arrival: 50, obstacle_cost: 8}");
  EXPECT_DOUBLE_EQ(worth(*reward, withGoalAt({3.0, 4.0}), withGoalAt({3.0, 0.0}), nearestRow(0, 0, 2)),
                   1.92);  // 2 - 8 / 10^2
  AgentPerception after;
  after.arrived = true;
  EXPECT_EQ(worth(*reward, withGoalAt({0.1, 0.0}), after, 0), 50.0);
}

TEST(MakeReward, UsesTheArrivalRewardOfTheThesisByDefault) {
  EXPECT_EQ(make("{goal: cosine_cubed, obstacle_cost: 80}")->spec(),
            "{goal: cosine_cubed, arrival: 100, obstacle_cost: 80}");
}

TEST(MakeReward, WritesTheCostOfStayingUnlessItIsZero) {
  const std::string rest = "goal: cosine_cubed, arrival: 100, obstacle_cost: 80";
  EXPECT_EQ(make("{" + rest + ", stay_cost: 0.5}")->spec(), "{" + rest + ", stay_cost: 0.5}");
  EXPECT_EQ(make("{" + rest + ", stay_cost: 0}")->spec(), "{" + rest + "}");
  AgentPerception after = withGoalAt({3.0, 0.0});
  EXPECT_DOUBLE_EQ(worth(*make("{" + rest + ", stay_cost: 0.5}"), withGoalAt({3.0, 0.0}), after, 0), 0.5);
  EXPECT_DOUBLE_EQ(worth(*make("{" + rest + "}"), withGoalAt({3.0, 0.0}), after, 0), 1.0);
  EXPECT_TRUE(contains(errorIn("{" + rest + ", stay_cost: -0.5}"), "reward.stay_cost: expected"));
  EXPECT_TRUE(contains(errorIn("{" + rest + ", stay_cost: much}"), "reward.stay_cost: expected"));
}

TEST(MakeReward, ErrorsNameWrongKeysAndValues) {
  EXPECT_TRUE(contains(errorIn("{goal: cosine, obstacle_cost: 80}"),
                       "reward.goal: expected distance_gained or cosine_cubed, got 'cosine'"));
  EXPECT_TRUE(contains(errorIn("{obstacle_cost: 80}"), "'goal' is missing"));
  EXPECT_TRUE(contains(errorIn("{goal: cosine_cubed}"), "'obstacle_cost' is missing"));
  EXPECT_TRUE(contains(errorIn("{goal: cosine_cubed, obstacle_cost: -1}"), "reward.obstacle_cost: expected"));
  EXPECT_TRUE(contains(errorIn("{goal: cosine_cubed, obstacle_cost: nan}"), "reward.obstacle_cost: expected"));
  EXPECT_TRUE(contains(errorIn("{goal: cosine_cubed, obstacle_cost: 1, arrival: inf}"), "reward.arrival: expected"));
  EXPECT_TRUE(contains(errorIn("{goal: cosine_cubed, obstacle_cost: 1, prize: 1}"), "unknown key 'prize'"));
}

}  // namespace
}  // namespace crowd::thesis_reward_test
