// Episodes in which the agents of a tick take turns.

#include <gtest/gtest.h>

#include <vector>

#include "simulation/episode.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::sequential_episode_test {
namespace {

using scenes::agent;
using scenes::scene;
using scenes::wanderer;

Scene sequential(Scene scene) {
  scene.order = Order::SEQUENTIAL;
  return scene;
}

/// Ticks of 0.5 s; agent 0 has 1 m and 2 ticks to its goal, agent 1 has 2 m and 4 ticks.
Scene oneAndTwoMetres() {
  return sequential(
      scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), agent({0.0, 3.0}, {2.0, 3.0}, 1.0)})));
}

/// The agents whose turn it is.
std::vector<AgentId> asked(Episode& episode) {
  std::vector<AgentId> ids;
  for (const AgentPerception& self : episode.perceptions().agents) ids.push_back(self.agent);
  return ids;
}

using Ids = std::vector<AgentId>;

TEST(SequentialEpisode, HasOneTurnPerAgentInEachTick) {
  Episode episode(oneAndTwoMetres(), 7, Vision());
  EXPECT_EQ(episode.turnsOfTick(), 2U);
  EXPECT_EQ(asked(episode), Ids{0});
  EXPECT_EQ(episode.perceptions().turn, 0U);
  EXPECT_FALSE(episode.step({ahead(0)}));
  EXPECT_EQ(asked(episode), Ids{1});
  EXPECT_EQ(episode.perceptions().turn, 1U);
  EXPECT_EQ(episode.perceptions().tick, 0U);
  EXPECT_TRUE(episode.step({ahead(1)}));
  EXPECT_EQ(asked(episode), Ids{0});
  EXPECT_EQ(episode.perceptions().tick, 1U);
}

TEST(SequentialEpisode, ArrivedAgentGetsItsLastPerceptionInItsTurn) {
  Episode episode(oneAndTwoMetres(), 7, Vision());
  for (int tick = 0; tick < 2; ++tick) {
    episode.step({ahead(0)});
    episode.step({});
  }
  ASSERT_EQ(asked(episode), Ids{0});
  EXPECT_TRUE(episode.perceptions().agents[0].arrived);
  EXPECT_FALSE(episode.step({}));
  EXPECT_EQ(asked(episode), Ids{1});
  EXPECT_EQ(episode.perceptions().agents[0].neighbour_count, 0U);  // agent 0 has left
  EXPECT_TRUE(episode.step({}));
  EXPECT_EQ(asked(episode), Ids{1});  // agent 0 has no further turn
}

TEST(SequentialEpisode, LastPerceptionsIncludeAllAgents) {
  Scene scene = oneAndTwoMetres();
  scene.max_ticks = 1;
  Episode episode(scene, 7, Vision());
  episode.step({});
  EXPECT_FALSE(episode.isOver());
  episode.step({});
  EXPECT_TRUE(episode.isOver());
  EXPECT_TRUE(episode.perceptions().last);
  EXPECT_EQ(asked(episode), (Ids{0, 1}));
}

TEST(SequentialEpisode, MeasuresTheWorldOncePerTick) {
  Episode episode(oneAndTwoMetres(), 7, Vision());
  while (!episode.isOver()) episode.step({ahead(0), ahead(1)});
  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.ticks, 4U);
  EXPECT_EQ(result.agents[0].ticks, 2U);
  EXPECT_DOUBLE_EQ(result.agents[1].path_length, 2.0);
}

TEST(SequentialEpisode, AgentsCanBeRemovedAndSpawnedBetweenTurns) {
  Episode episode(sequential(scene({wanderer({0.0, 0.0}), wanderer({0.0, 3.0}), wanderer({0.0, 6.0})})), 7, Vision());
  episode.step({});
  episode.edit().removeAgent(1);  // it had the next turn
  EXPECT_EQ(asked(episode), Ids{2});
  const AgentId spawned = episode.edit().addAgent(wanderer({0.0, 9.0}));
  EXPECT_FALSE(episode.step({ahead(2)}));
  EXPECT_EQ(asked(episode), Ids{spawned});
  EXPECT_TRUE(episode.step({}));
  EXPECT_EQ(asked(episode), Ids{0});
}

TEST(SequentialEpisode, RemovingTheLastAgentsOfATickEndsIt) {
  Episode episode(sequential(scene({wanderer({0.0, 0.0}), wanderer({0.0, 3.0})})), 7, Vision());
  episode.step({});
  episode.edit().removeAgent(1);
  EXPECT_EQ(asked(episode), Ids{});
  EXPECT_TRUE(episode.step({}));
  EXPECT_EQ(episode.world().tick(), 1U);
}

TEST(SequentialEpisode, RemovingAnAgentInItsTurnKeepsTheNextTurn) {
  Episode episode(sequential(scene({wanderer({0.0, 0.0}), wanderer({0.0, 3.0})})), 7, Vision());
  ASSERT_EQ(asked(episode), Ids{0});
  episode.edit().removeAgent(0);
  EXPECT_FALSE(episode.step({ahead(0)}));
  EXPECT_EQ(asked(episode), Ids{1});
}

}  // namespace
}  // namespace crowd::sequential_episode_test
