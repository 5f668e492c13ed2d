#include "simulation/episode.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "social_crowd/errors.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::episode_test {
namespace {

using scenes::agent;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

constexpr std::uint64_t NUMBER = 42;

/// Ticks of 0.5 s; one agent walks 1 m in 2 ticks to its goal, the other has 2 m and 4 ticks to walk.
Scene oneAndTwoMetres() {
  return scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), agent({0.0, 3.0}, {2.0, 3.0}, 1.0)}));
}

TEST(Episode, BeginsAtTickZeroWithPerceptionsOfAllAgents) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  EXPECT_EQ(episode.number(), NUMBER);
  EXPECT_EQ(episode.perceptions().episode, NUMBER);
  EXPECT_EQ(episode.perceptions().tick, 0U);
  EXPECT_EQ(episode.perceptions().agents.size(), 2U);
  EXPECT_FALSE(episode.isOver());
  EXPECT_EQ(episode.scene().agents.size(), 2U);
}

TEST(Episode, UpdatesPerceptionsInEachStep) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  episode.step({ahead(1)});
  const Perceptions& seen = episode.perceptions();
  EXPECT_EQ(seen.tick, 1U);
  EXPECT_EQ(seen.episode, NUMBER);
  EXPECT_EQ(seen.agents[0].goal, Vector2(1.0, 0.0));
  EXPECT_EQ(seen.agents[1].goal, Vector2(1.5, 0.0));
}

TEST(Episode, HeldPerceptionsDoNotChange) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  std::vector<std::shared_ptr<const Perceptions>> held;
  for (std::uint64_t tick = 0; tick < 3; ++tick) {
    held.push_back(episode.sharedPerceptions());
    EXPECT_EQ(held.back().get(), &episode.perceptions());
    episode.step({ahead(1)});
  }
  for (std::uint64_t tick = 0; tick < 3; ++tick) {
    EXPECT_EQ(held[tick]->tick, tick);
    EXPECT_EQ(held[tick]->episode, NUMBER);
    EXPECT_EQ(held[tick]->agents[1].goal, Vector2(2.0 - 0.5 * static_cast<double>(tick), 0.0));
  }
}

TEST(Episode, PerceptionsHeldByOtherThreadsDoNotChange) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  for (int tick = 0; tick < 100; ++tick) {
    const std::uint64_t expected = episode.world().tick();
    std::uint64_t read = 0;
    std::thread reader([held = episode.sharedPerceptions(), &read]() mutable {
      read = held->tick;
      held.reset();
    });
    episode.step({});
    EXPECT_EQ(episode.perceptions().tick, expected + 1);
    reader.join();
    ASSERT_EQ(read, expected);
  }
}

TEST(Episode, UsesTheGivenVision) {
  EXPECT_EQ(Episode(oneAndTwoMetres(), NUMBER, {2.7, 0}).perceptions().neighbours.size(), 0U);  // rims 2.75 m away
  EXPECT_EQ(Episode(oneAndTwoMetres(), NUMBER, {2.8, 0}).perceptions().neighbours.size(), 2U);
}

TEST(Episode, EndsWhenAllAgentsHaveArrived) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  for (int tick = 0; tick < 4; ++tick) {
    EXPECT_FALSE(episode.isOver()) << "tick " << tick;
    episode.step({ahead(0), ahead(1)});
  }
  EXPECT_TRUE(episode.isOver());
  EXPECT_TRUE(episode.perceptions().last);
  ASSERT_EQ(episode.perceptions().agents.size(), 1U);  // agent 0 arrived earlier
  EXPECT_TRUE(episode.perceptions().agents[0].arrived);

  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.scenario, "scene");
  EXPECT_EQ(result.ticks, 4U);
  ASSERT_EQ(result.agents.size(), 2U);
  EXPECT_EQ(result.agents[0].ticks, 2U);
  EXPECT_EQ(result.agents[1].ticks, 4U);
  EXPECT_TRUE(result.isClean());
}

TEST(Episode, EndsAfterTheLargestNumberOfTicks) {
  Scene hurried = oneAndTwoMetres();
  hurried.max_ticks = 3;
  Episode episode(hurried, NUMBER, Vision());
  for (int tick = 0; tick < 3; ++tick) {
    EXPECT_FALSE(episode.isOver()) << "tick " << tick;
    episode.step({ahead(0), ahead(1)});
  }
  EXPECT_TRUE(episode.isOver());
  ASSERT_EQ(episode.perceptions().agents.size(), 1U);
  EXPECT_FALSE(episode.perceptions().agents[0].arrived);
  EXPECT_TRUE(episode.result().agents[0].arrived);
  EXPECT_FALSE(episode.result().agents[1].arrived);
}

TEST(Episode, ArrivalInTheLastTickCounts) {
  Scene hurried = oneAndTwoMetres();
  hurried.max_ticks = 4;
  Episode episode(hurried, NUMBER, Vision());
  while (!episode.isOver()) episode.step({ahead(0), ahead(1)});
  EXPECT_EQ(episode.result().arrivedCount(), 2U);
}

TEST(Episode, InvalidActionMovesNoAgent) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  episode.step({ahead(0), ahead(1)});
  EXPECT_THROW(episode.step({ahead(0), {1, {0.0, 2.0}}}), InputError);
  EXPECT_EQ(episode.perceptions().tick, 1U);
  EXPECT_EQ(episode.world().agents()[0].pose.position, Vector2(0.5, 0.0));
  EXPECT_EQ(episode.result().ticks, 1U);
  EXPECT_EQ(episode.result().agents[0].path_length, 0.5);
}

TEST(EpisodeChanges, SpawnedAgentIsPerceivedAndMeasuredAtOnce) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  episode.step({ahead(0), ahead(1)});
  EXPECT_EQ(episode.edit().addAgent(agent({0.0, -3.0}, {1.0, -3.0}, 1.0)), 2U);
  ASSERT_EQ(episode.perceptions().agents.size(), 3U);
  EXPECT_EQ(episode.perceptions().tick, 1U);
  while (!episode.isOver()) episode.step({ahead(0), ahead(1), ahead(2)});
  const EpisodeResult result = episode.result();
  ASSERT_EQ(result.agents.size(), 3U);
  EXPECT_EQ(result.ticks, 4U);
  EXPECT_TRUE(result.agents[2].arrived);
  EXPECT_EQ(result.agents[2].ticks, 2U);  // on its way from tick 1 to 3
  EXPECT_EQ(result.agents[2].path_length, 1.0);
  EXPECT_EQ(result.agents[2].straight_length, 0.75);
}

TEST(EpisodeChanges, RemovedAgentIsNotPerceivedAndHasNotArrived) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  episode.step({ahead(0), ahead(1)});
  episode.edit().removeAgent(1);
  ASSERT_EQ(episode.perceptions().agents.size(), 1U);
  EXPECT_EQ(episode.perceptions().agents[0].agent, 0U);
  EXPECT_TRUE(episode.perceptions().neighbours.empty());
  episode.step({ahead(0)});
  EXPECT_TRUE(episode.isOver());
  EXPECT_EQ(episode.result().arrivedCount(), 1U);
  EXPECT_EQ(episode.result().agents[1].ticks, 1U);
}

TEST(EpisodeChanges, EndsWithItsLastAgentAndContinuesWithANewOne) {
  Episode episode(scene({wanderer({0.0, 0.0})}), NUMBER, Vision());
  episode.edit().removeAgent(0);
  EXPECT_TRUE(episode.isOver());
  episode.edit().addAgent(wanderer({0.0, 0.0}));
  EXPECT_FALSE(episode.isOver());
}

TEST(EpisodeChanges, NewGoalAndObstaclesAreInThePerceptionsAtOnce) {
  Episode episode(scene({wanderer({0.0, 0.0})}, {pillar({2.0, 0.0}, 0.5)}), NUMBER, Vision());
  episode.edit().setGoal(0, {0.0, 4.0});
  EXPECT_EQ(episode.perceptions().agents[0].goal, Vector2(0.0, 4.0));
  EXPECT_EQ(episode.edit().spawnObstacle({0.0, 1.0}, {0.0, 0.0}, 0.25), 1U);
  ASSERT_EQ(episode.perceptions().neighbours.size(), 2U);
  EXPECT_EQ(episode.perceptions().neighbours[0].position, Vector2(0.0, 1.0));
  episode.edit().removeObstacle(0);
  ASSERT_EQ(episode.perceptions().neighbours.size(), 1U);
  EXPECT_EQ(episode.perceptions().neighbours[0].position, Vector2(0.0, 1.0));
}

TEST(EpisodeChanges, RefusedChangesHaveNoEffect) {
  Episode episode(oneAndTwoMetres(), NUMBER, Vision());
  EXPECT_THROW(episode.edit().addAgent(wanderer({0.1, 0.0})), InputError);
  EXPECT_THROW(episode.edit().removeAgent(5), InputError);
  EXPECT_THROW(episode.edit().setGoal(0, {std::numeric_limits<double>::quiet_NaN(), 0.0}), InputError);
  EXPECT_THROW(episode.edit().spawnObstacle({0.1, 0.0}, {0.0, 0.0}, 0.5), InputError);
  EXPECT_THROW(episode.edit().removeObstacle(0), InputError);
  EXPECT_EQ(episode.perceptions().agents.size(), 2U);
  EXPECT_EQ(episode.perceptions().neighbours.size(), 2U);
  EXPECT_EQ(episode.perceptions().agents[0].goal, Vector2(1.0, 0.0));
  EXPECT_EQ(episode.result().agents.size(), 2U);
}

}  // namespace
}  // namespace crowd::episode_test
