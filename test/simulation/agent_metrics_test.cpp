#include "simulation/episode_monitor.h"
#include "simulation/episode_result.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/scenes.h"
#include "world/world_editor.h"

namespace crowd::agent_metrics_test {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

constexpr double TICK = 0.5;  // [s]; at 1 m/s a step is 0.5 m, exactly

/// The result of agent 0 of a scene after a sequence of actions.
AgentResult walk(const Scene& scene, const std::vector<RelativeAction>& moves) {
  World world(scene);
  EpisodeMonitor monitor(scene, world);
  for (const RelativeAction& move : moves) {
    world.step({{0, move}});
    monitor.observe(world);
  }
  EXPECT_EQ(monitor.result().ticks, moves.size());
  return monitor.result().agents.at(0);
}

AgentResult walk(const AgentStart& start, const std::vector<RelativeAction>& moves) {
  return walk(scenes::halfSeconds(scene({start})), moves);
}

std::vector<RelativeAction> times(std::size_t count, const RelativeAction& move) {
  return std::vector<RelativeAction>(count, move);
}

const RelativeAction AHEAD{0.0, 1.0};
const RelativeAction STAY{0.0, 0.0};

TEST(AgentMetrics, StraightWalkAtFullSpeed) {
  // 4 m less the tolerance of 0.25 m are 3.75 m; the agent arrives after 8 steps of 0.5 m.
  const AgentResult result = walk(agent({0.0, 0.0}, {4.0, 0.0}, 1.0), times(8, AHEAD));
  EXPECT_TRUE(result.arrived);
  EXPECT_FALSE(result.touched);
  EXPECT_EQ(result.ticks, 8U);
  EXPECT_DOUBLE_EQ(result.path_length, 4.0);
  EXPECT_DOUBLE_EQ(result.straight_length, 3.75);
  EXPECT_DOUBLE_EQ(result.path_ratio, 4.0 / 3.75);
  EXPECT_DOUBLE_EQ(result.time_ratio, 4.0 / 3.75);  // 4 s at 1 m/s
  EXPECT_EQ(result.turn_per_metre, 0.0);
  EXPECT_DOUBLE_EQ(result.max_speed_ratio, 1.0);
}

TEST(AgentMetrics, DirectWalkHasRatiosOfOne) {
  Scene line = scenes::halfSeconds(scene({agent({1.0, 1.0}, {1.0, 5.0}, 1.0)}));
  line.goal_tolerance = 0.5;
  const AgentResult result = walk(line, times(7, AHEAD));
  EXPECT_TRUE(result.arrived);
  EXPECT_NEAR(result.path_ratio, 1.0, 1e-12);
  EXPECT_NEAR(result.time_ratio, 1.0, 1e-12);
}

TEST(AgentMetrics, RatiosUseTheMaximumSpeedOfTheAgent) {
  // At half of 0.8 m/s it walks 0.2 m a tick. 2 m less 0.25 m: it arrives after 9 ticks and 1.8 m.
  const AgentResult result = walk(agent({0.0, 0.0}, {2.0, 0.0}, 0.8), times(9, {0.0, 0.5}));
  EXPECT_TRUE(result.arrived);
  EXPECT_NEAR(result.path_ratio, 1.8 / 1.75, 1e-12);
  EXPECT_NEAR(result.time_ratio, 4.5 * 0.8 / 1.75, 1e-12);
  EXPECT_NEAR(result.max_speed_ratio, 0.5, 1e-12);
}

TEST(AgentMetrics, MaxSpeedRatioIsTheRatioOfTheFastestTick) {
  const AgentResult result = walk(wanderer({0.0, 0.0}, 2.0), {{0.0, 0.25}, {0.0, 0.75}, {0.0, 0.5}});
  EXPECT_DOUBLE_EQ(result.max_speed_ratio, 0.75);
  EXPECT_DOUBLE_EQ(result.path_length, 1.5);  // 0.25, 0.75 and 0.5 m
}

TEST(AgentMetrics, SquareHasThreeQuarterTurns) {
  // Once around a square of 2 m, to the goal 1 m south of the start: 9 m for 0.75 m.
  AgentStart start = agent({0.0, 0.0}, {0.0, -1.0}, 1.0);
  start.heading = -PI / 2;
  std::vector<RelativeAction> moves;
  for (int side = 0; side < 4; ++side) {
    moves.push_back({PI / 2, 1.0});
    for (int i = 0; i < 3; ++i) moves.push_back(AHEAD);
  }
  moves.push_back(AHEAD);
  moves.push_back(AHEAD);
  const AgentResult result = walk(start, moves);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.ticks, 18U);
  EXPECT_NEAR(result.path_length, 9.0, 1e-12);
  EXPECT_NEAR(result.path_ratio, 12.0, 1e-9);
  EXPECT_NEAR(result.time_ratio, 12.0, 1e-9);
  EXPECT_NEAR(result.turn_per_metre, 1.5 * PI / 9.0, 1e-12);
}

TEST(AgentMetrics, ZigzagTurnsWithEveryStep) {
  // 8 steps of 0.5 m, alternately 30 degrees to the left and to the right: 7 turns of 60 degrees in 4 m.
  std::vector<RelativeAction> moves = {{PI / 6, 1.0}};
  for (int i = 1; i < 8; ++i) moves.push_back({i % 2 == 1 ? -PI / 3 : PI / 3, 1.0});
  const AgentResult result = walk(wanderer({0.0, 0.0}, 1.0), moves);
  EXPECT_FALSE(result.arrived);
  EXPECT_NEAR(result.path_length, 4.0, 1e-12);
  EXPECT_NEAR(result.turn_per_metre, 7.0 * PI / 3.0 / 4.0, 1e-12);
}

TEST(AgentMetrics, TurningBackIsHalfATurn) {
  const AgentResult result = walk(wanderer({0.0, 0.0}, 1.0), {AHEAD, {PI, 1.0}});
  EXPECT_NEAR(result.turn_per_metre, PI, 1e-9);  // in 1 m
}

TEST(AgentMetrics, StandingAgentHasNoPath) {
  const AgentResult result = walk(agent({0.0, 0.0}, {2.25, 0.0}, 1.0), times(10, {1.0, 0.0}));
  EXPECT_FALSE(result.arrived);
  EXPECT_EQ(result.ticks, 10U);
  EXPECT_EQ(result.path_length, 0.0);
  EXPECT_EQ(result.path_ratio, 0.0);
  EXPECT_DOUBLE_EQ(result.time_ratio, 2.5);  // 5 s at 1 m/s for 2 m
  EXPECT_EQ(result.turn_per_metre, 0.0);     // turns without motion do not count
  EXPECT_EQ(result.max_speed_ratio, 0.0);
}

TEST(AgentMetrics, TurnsDuringAStopDoNotCount) {
  const AgentResult result = walk(wanderer({0.0, 0.0}, 1.0), {AHEAD, AHEAD, STAY, {PI / 2, 1.0}, AHEAD});
  EXPECT_EQ(result.turn_per_metre, 0.0);
  EXPECT_DOUBLE_EQ(result.path_length, 2.0);
}

TEST(AgentMetrics, TurnsCountOnlyAboveFiveCentimetresPerSecond) {
  // Ten steps and nine quarter turns.
  const std::vector<RelativeAction> circling = times(10, {PI / 2, 1.0});
  EXPECT_EQ(walk(wanderer({0.0, 0.0}, 0.049), circling).turn_per_metre, 0.0);
  EXPECT_NEAR(walk(wanderer({0.0, 0.0}, 0.051), circling).turn_per_metre, 4.5 * PI / 0.255, 1e-9);
}

TEST(AgentMetrics, TurnsCountOnlyIfBothTicksAreFast) {
  const RelativeAction creep{PI / 2, 0.04};  // 0.04 m/s
  const RelativeAction turn{PI / 2, 1.0};
  EXPECT_EQ(walk(wanderer({0.0, 0.0}, 1.0), {AHEAD, creep, turn, creep}).turn_per_metre, 0.0);
  EXPECT_NEAR(walk(wanderer({0.0, 0.0}, 1.0), {creep, AHEAD, turn, creep}).turn_per_metre, PI / 2 / 1.04, 1e-9);
}

TEST(AgentMetrics, TurnPerMetreAssumesAPathOfTenCentimetresOrMore) {
  // One quarter turn in 0.06 m.
  const AgentResult result = walk(wanderer({0.0, 0.0}, 0.06), {AHEAD, {PI / 2, 1.0}});
  EXPECT_NEAR(result.path_length, 0.06, 1e-12);
  EXPECT_NEAR(result.turn_per_metre, PI / 2 / 0.1, 1e-9);
}

TEST(AgentMetrics, StraightLengthIsSummedOverGoals) {
  AgentStart start = agent({0.0, 0.0}, {3.0, 4.0}, 1.0);
  start.goals.emplace_back(3.0, 10.0);
  EXPECT_DOUBLE_EQ(walk(start, {STAY}).straight_length, 10.75);  // 5 + 6 - 0.25
}

TEST(AgentMetrics, StraightLengthIsAtLeastTenCentimetres) {
  const AgentResult result = walk(agent({0.0, 0.0}, {0.3, 0.0}, 1.0), {AHEAD});
  EXPECT_TRUE(result.arrived);
  EXPECT_DOUBLE_EQ(result.straight_length, 0.1);
  EXPECT_NEAR(result.path_ratio, 5.0, 1e-12);
  EXPECT_NEAR(result.time_ratio, 5.0, 1e-12);
}

TEST(AgentMetrics, AreZeroWithoutATick) {
  const AgentResult result = walk(agent({0.0, 0.0}, {0.1, 0.0}, 1.0), {});
  EXPECT_FALSE(result.arrived);
  EXPECT_EQ(result.ticks, 0U);
  EXPECT_EQ(result.path_ratio, 0.0);
  EXPECT_EQ(result.time_ratio, 0.0);
  EXPECT_EQ(result.turn_per_metre, 0.0);
}

TEST(AgentMetrics, ResultIncludesEarlierContacts) {
  // The agent walks through a static obstacle at 1 m; start and end are free.
  const Scene through = scenes::halfSeconds(scene({agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}, {pillar({1.0, 0.0}, 0.2)}));
  EXPECT_FALSE(walk(through, {AHEAD}).touched);
  EXPECT_TRUE(walk(through, {AHEAD, AHEAD}).touched);
  const AgentResult result = walk(through, times(4, AHEAD));
  EXPECT_TRUE(result.arrived);
  EXPECT_TRUE(result.touched);
}

TEST(AgentMetrics, EndAtTheArrival) {
  // Agent 0 arrives at (1, 0) after 2 ticks; then agent 1 walks through this position.
  const Scene crossing = scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({-1.5, 0.0}, 1.0)}));
  World world(crossing);
  EpisodeMonitor monitor(crossing, world);
  for (int tick = 0; tick < 7; ++tick) {
    world.step({{0, AHEAD}, {1, AHEAD}});
    monitor.observe(world);
  }
  const EpisodeResult result = monitor.result();
  EXPECT_EQ(result.ticks, 7U);
  EXPECT_EQ(result.agents[0].ticks, 2U);
  EXPECT_DOUBLE_EQ(result.agents[0].path_length, 1.0);
  EXPECT_EQ(result.agents[1].ticks, 7U);
  EXPECT_DOUBLE_EQ(result.agents[1].path_length, 3.5);
  EXPECT_EQ(result.touchedCount(), 0U);
}

// The two ratios of the thesis for walks worked out by hand.
TEST(DistanceGained, EqualsThePathOfAStraightWalk) {
  const AgentResult result = walk(agent({0.0, 0.0}, {4.0, 0.0}, 1.0), times(3, AHEAD));
  EXPECT_DOUBLE_EQ(result.distance_gained, 1.5);
  EXPECT_DOUBLE_EQ(result.gain_per_tick, 0.5);  // the speed, in metres a tick
  EXPECT_DOUBLE_EQ(result.path_per_gain, 1.0);
}

TEST(DistanceGained, OfAWalkAlongTwoSidesOfATriangle) {
  // 3 m at a right angle to a goal 4 m away: 5 m remain. After 4 m more 3 m remain.
  AgentStart start = agent({0.0, 0.0}, {4.0, 0.0}, 1.0);
  start.heading = PI / 2;
  std::vector<RelativeAction> moves = times(6, AHEAD);
  const AgentResult away = walk(start, moves);
  EXPECT_NEAR(away.distance_gained, -1.0, 1e-12);
  EXPECT_NEAR(away.gain_per_tick, -1.0 / 6.0, 1e-12);
  EXPECT_TRUE(std::isnan(away.path_per_gain));
  moves.push_back({-PI / 2, 1.0});
  for (int i = 0; i < 7; ++i) moves.push_back(AHEAD);
  const AgentResult around = walk(start, moves);
  EXPECT_NEAR(around.distance_gained, 1.0, 1e-12);
  EXPECT_NEAR(around.gain_per_tick, 1.0 / 14.0, 1e-12);
  EXPECT_NEAR(around.path_per_gain, 7.0, 1e-9);
}

TEST(DistanceGained, OfAStandingAgentIsZero) {
  const AgentResult result = walk(agent({0.0, 0.0}, {2.0, 0.0}, 1.0), times(5, STAY));
  EXPECT_EQ(result.distance_gained, 0.0);
  EXPECT_EQ(result.gain_per_tick, 0.0);
  EXPECT_TRUE(std::isnan(result.path_per_gain));
}

TEST(DistanceGained, IsSummedOverGoals) {
  // 1 m to the first goal and 1.5 m towards the second; the change of the goal is neither gain nor loss.
  AgentStart start = agent({0.0, 0.0}, {1.0, 0.0}, 1.0);
  start.goals.emplace_back(1.0, 2.0);
  const AgentResult result = walk(start, {AHEAD, AHEAD, {PI / 2, 1.0}, AHEAD, AHEAD});
  EXPECT_NEAR(result.distance_gained, 2.5, 1e-12);
  EXPECT_NEAR(result.path_per_gain, 1.0, 1e-12);
}

TEST(DistanceGained, DoesNotChangeWithANewGoal) {
  // 1 m towards a goal in front, then 1 m away from one behind.
  const Scene scene = scenes::halfSeconds(scenes::scene({agent({0.0, 0.0}, {9.0, 0.0}, 1.0)}));
  World world(scene);
  EpisodeMonitor monitor(scene, world);
  for (int tick = 0; tick < 4; ++tick) {
    if (tick == 2) {
      WorldEditor(world).setGoal(0, {-5.0, 0.0});
      monitor.recordGoal(world.agents()[0], {-5.0, 0.0});
    }
    world.step({{0, AHEAD}});
    monitor.observe(world);
    EXPECT_DOUBLE_EQ(monitor.result().agents[0].distance_gained, tick < 2 ? 0.5 * (tick + 1) : 1.0 - 0.5 * (tick - 1));
  }
  EXPECT_DOUBLE_EQ(monitor.result().agents[0].distance_gained, 0.0);
}

TEST(AgentMetrics, CountBlockedMoves) {
  // Two steps of 0.5 m lead up to the wall; the next two are blocked.
  const Scene blocked_way =
      scenes::solid(scenes::halfSeconds(scene({wanderer({0.0, 0.0}, 1.0)}, {}, {{{1.25, -1.0}, {1.25, 1.0}}})));
  const AgentResult result = walk(blocked_way, times(4, AHEAD));
  EXPECT_EQ(result.blocked_moves, 2U);  // the second step ends at the wall without being blocked
  EXPECT_TRUE(result.touched);
  EXPECT_DOUBLE_EQ(result.path_length, 1.0);
  EXPECT_EQ(walk(blocked_way, times(2, AHEAD)).blocked_moves, 0U);
  EXPECT_FALSE(walk(blocked_way, times(2, AHEAD)).touched);
}

TEST(AgentMetrics, TurnsFollowTheMotionOfAPushedAgent) {
  // An obstacle pushes it 0.5 m to the side, then it walks 0.5 m ahead: a quarter turn in 1 m.
  Scene pushed = scenes::solid(scenes::halfSeconds(scene({wanderer({0.0, 0.0}, 1.0, 0.25)})));
  pushed.obstacles.push_back(moving_obstacle({0.0, 0.5}, {0.0, -1.0}, 0.25));
  World world(pushed);
  EpisodeMonitor monitor(pushed, world);
  for (const RelativeAction& move : {STAY, AHEAD}) {
    world.step({{0, move}});
    monitor.observe(world);
    if (!world.obstacles().empty()) WorldEditor(world).removeObstacle(0);
  }
  const AgentResult result = monitor.result().agents.at(0);
  EXPECT_NEAR(result.turn_per_metre, PI / 2, 1e-12);
  EXPECT_NEAR(result.path_length, 1.0, 1e-12);
  EXPECT_TRUE(result.touched);
}

}  // namespace
}  // namespace crowd::agent_metrics_test
