#include "simulation/episode_result.h"
#include "simulation/episode_monitor.h"
#include "simulation/evaluation/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/scenes.h"

namespace crowd::episode_result_test {
namespace {

AgentResult agentResult(bool arrived, bool touched, double path, double time, double turn, double speed) {
  AgentResult result;
  result.arrived = arrived;
  result.touched = touched;
  result.path_ratio = path;
  result.time_ratio = time;
  result.turn_per_metre = turn;
  result.max_speed_ratio = speed;
  return result;
}

EpisodeResult episodeResult(std::vector<AgentResult> agents) {
  EpisodeResult result;
  result.agents = std::move(agents);
  return result;
}

AgentResult blocked(AgentResult result, std::uint64_t moves) {
  result.blocked_moves = moves;
  return result;
}

const AgentResult CLEAN = agentResult(true, false, 1.0, 1.25, 0.5, 0.875);
const AgentResult BUMPED = agentResult(true, true, 1.5, 2.0, 1.0, 0.75);
const AgentResult LOST = agentResult(false, false, 7.0, 8.0, 9.0, 1.0);

TEST(EpisodeResult, IsCleanIfAllArrivedWithoutContact) {
  EXPECT_TRUE(episodeResult({CLEAN, CLEAN}).isClean());
  EXPECT_FALSE(episodeResult({CLEAN, BUMPED}).isClean());
  EXPECT_FALSE(episodeResult({LOST, CLEAN}).isClean());
  EXPECT_EQ(episodeResult({LOST, CLEAN, BUMPED}).arrivedCount(), 2U);
  EXPECT_EQ(episodeResult({LOST, CLEAN, BUMPED}).touchedCount(), 1U);
}

TEST(Metrics, OverTwoEpisodesByHand) {
  Metrics metrics;
  metrics.add(episodeResult({CLEAN, BUMPED, LOST}));
  metrics.add(episodeResult({CLEAN}));
  EXPECT_EQ(metrics.episodes(), 2U);
  EXPECT_DOUBLE_EQ(metrics.successPercent(), 75.0);
  EXPECT_DOUBLE_EQ(metrics.contactPercent(), 25.0);
  EXPECT_DOUBLE_EQ(metrics.cleanPercent(), 50.0);
  EXPECT_DOUBLE_EQ(metrics.pathRatio(), 3.5 / 3.0);  // of the three that arrived
  EXPECT_DOUBLE_EQ(metrics.timeRatio(), 4.5 / 3.0);
  EXPECT_DOUBLE_EQ(metrics.turnPerMetre(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(metrics.maxSpeedRatio(), 1.0);  // of all, even if they did not arrive
}

TEST(Metrics, CollisionPercentExcludesRemovedAgents) {
  AgentResult collided = LOST;
  collided.collided = true;
  AgentResult removed = collided;
  removed.removed = true;
  const EpisodeResult result = episodeResult({CLEAN, collided, removed, CLEAN, CLEAN});
  EXPECT_EQ(result.collidedCount(), 1U);
  Metrics metrics;
  metrics.add(result);
  EXPECT_DOUBLE_EQ(metrics.collisionPercent(), 25.0);
  EXPECT_DOUBLE_EQ(metrics.contactPercent(), 0.0);
}

TEST(EpisodeMonitor, RecordsACollisionWithoutContact) {
  // The agent passes an obstacle 0.45 m from its rim.
  Scene passing = scenes::scene({scenes::agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}, {scenes::pillar({1.0, 0.7}, 0.25)});
  World world(passing);
  EpisodeMonitor monitor(passing, world);
  while (world.activeCount() > 0) {
    world.step({{0, {0.0, 1.0}}});
    monitor.observe(world);
  }
  const AgentResult agent = monitor.result().agents.at(0);
  EXPECT_TRUE(agent.collided);
  EXPECT_FALSE(agent.touched);
  EXPECT_DOUBLE_EQ(agent.heading, 0.0);
}

TEST(Metrics, BlockedMovesPerAgentIsAMeanOverAllAgents) {
  AgentResult removed = blocked(CLEAN, 100);
  removed.removed = true;
  const EpisodeResult crowded = episodeResult({blocked(BUMPED, 4), blocked(LOST, 5), removed});
  EXPECT_EQ(crowded.blockedMoves(), 9U);
  Metrics metrics;
  metrics.add(crowded);
  metrics.add(episodeResult({CLEAN, CLEAN}));
  EXPECT_DOUBLE_EQ(metrics.blockedMovesPerAgent(), 9.0 / 4.0);
}

TEST(Metrics, HaveNoMeansWithoutArrivals) {
  Metrics metrics;
  EXPECT_TRUE(std::isnan(metrics.blockedMovesPerAgent()));
  EXPECT_TRUE(std::isnan(metrics.successPercent()));  // nobody was to arrive
  EXPECT_EQ(metrics.cleanPercent(), 0.0);
  metrics.add(episodeResult({LOST}));
  EXPECT_EQ(metrics.successPercent(), 0.0);
  EXPECT_TRUE(std::isnan(metrics.pathRatio()));
  EXPECT_TRUE(std::isnan(metrics.timeRatio()));
  EXPECT_TRUE(std::isnan(metrics.turnPerMetre()));
}

}  // namespace
}  // namespace crowd::episode_result_test
