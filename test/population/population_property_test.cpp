#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "population/population.h"
#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::population_property_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;

const char* const BUSY = R"(
walls: [[[0, 0], [10, 0]], [[10, 0], [10, 8]], [[10, 8], [0, 8]], [[0, 8], [0, 0]]]
agents: [{count: 5, position: {box: [[1, 1], [9, 7]]}, route: rounds, speed: [1, 1.5], radius: 0.2, reaction_time: [0, 5]}]
routes:
  rounds: {repeat: true, waypoints: [{place: {box: [[1, 1], [9, 7]]}, wait: [0, 3]}]}
  shop: {waypoints: [{place: {box: [[1, 1], [9, 7]]}, wait: [0, 3]}, {queue: till}, {one_of: [{sink: a}, {sink: b}]}]}
sources:
  - {area: {box: [[0.3, 0.3], [2, 2]]}, rate: 0.5, until: 60, route: shop, speed: [1, 1.5], radius: [0.18, 0.25]}
  - {area: {box: [[8, 6], [9.7, 7.7]]}, rate: 0.5, interval: regular, count: 20, goal: {box: [[1, 1], [4, 4]]}, speed: 1, radius: 0.2}
sinks: {a: {area: {box: [[9, 0], [10, 1]]}}, b: {area: {box: [[0, 7], [1, 8]]}}}
queues: {till: {head: [5, 4], direction: 90, spacing: 0.6, service: [0, 2]}}
gates: {bar: {wall: [[5, 0], [5, 3]], open: [[10, 20], [30, 40]]}}
)";

/// Created agents are walking, have arrived or were removed; ids are their numbers and never repeat.
TEST(Population, NoAgentIsLost) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Episode episode = episodeOf(BUSY, 150.0, seed);
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    std::size_t before = 0;
    std::vector<bool> left;
    while (!episode.isOver()) {
      const World& world = episode.world();
      ASSERT_GE(world.enteredCount(), before) << "seed " << seed;
      for (; before < world.enteredCount(); ++before) {
        ASSERT_TRUE(world.agents().contains(static_cast<AgentId>(before)));
        left.push_back(false);
      }
      std::size_t walking = 0;
      for (AgentId id = 0; id < before; ++id) {
        const Agent* const agent = world.agents().find(id);
        const bool is_walking = agent != nullptr && agent->isWalking();
        ASSERT_TRUE(agent == nullptr || agent->id == id);
        ASSERT_FALSE(is_walking && left[id]) << "seed " << seed << ", agent " << id;
        left[id] = !is_walking;
        walking += is_walking ? 1 : 0;
      }
      ASSERT_EQ(walking, world.activeCount()) << "seed " << seed << ", tick " << world.tick();
      const auto victim = static_cast<AgentId>(random.below(200));
      if (world.isActive(victim) && random.below(20) == 0) episode.edit().removeAgent(victim);
      step(episode);
    }
    const EpisodeResult result = episode.result();
    EXPECT_EQ(result.agents.size(), episode.world().enteredCount());
    for (AgentId id = 0; id < result.agents.size(); ++id) {
      const AgentResult agent = result.agents[id];
      EXPECT_EQ(agent.arrived || agent.removed, !episode.world().isActive(id)) << "seed " << seed << ", agent " << id;
    }
    EXPECT_GT(result.agents.size(), 35U) << "seed " << seed;
    EXPECT_GT(result.arrivedCount(), 20U) << "seed " << seed;
  }
}

TEST(Population, ThreadsDoNotMatter) {
  std::vector<std::vector<Vector2>> paths;
  for (const unsigned threads : {1U, 2U, 7U}) {
    ThreadPool pool(threads);
    Episode episode(straight_walk::sceneOf(BUSY, 60.0, 3), 0, Vision(), pool);
    std::vector<Vector2>& path = paths.emplace_back();
    while (!episode.isOver()) {
      step(episode);
      for (const Agent& agent : episode.world().agents()) path.push_back(agent.pose.position);
    }
  }
  EXPECT_EQ(paths[0], paths[1]);
  EXPECT_EQ(paths[0], paths[2]);
}

/// 1000 agents enter and leave: the population keeps no data of agents that have left.
TEST(Population, KeepsNothingOfAgentsThatHaveLeft) {
  Episode episode = episodeOf(
      "sources: [{area: [0, 0], rate: 1, interval: regular, count: 1000, route: through, speed: 1, radius: 0.2}]\n"
      "routes: {through: {waypoints: [{place: [1, 0]}, {queue: till}, {sink: out}]}}\n"
      "queues: {till: {head: [2, 0], direction: 0, spacing: 1, service: 0}}\n"
      "sinks: {out: {area: [3, 0]}}\n",
      2000.0);
  std::size_t most_bodies = 0;
  std::size_t most_members = 0;
  while (!episode.isOver()) {
    most_bodies = std::max(most_bodies, episode.world().grid().size());
    most_members = std::max(most_members, episode.population().memberCount());
    step(episode);
  }
  EXPECT_EQ(episode.result().agents.size(), 1000U);
  EXPECT_EQ(episode.result().arrivedCount(), 1000U);
  EXPECT_LE(most_bodies, 6U);
  EXPECT_LE(most_members, 6U);
  EXPECT_EQ(episode.population().memberCount(), 0U);
}

/// What is kept for the present agents does not grow with those that were removed, and numbers never repeat.
TEST(Population, ManyAgentsThatAreAddedAndRemoved) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 5], route: rounds, speed: 1, radius: 0.2}]\n"
      "routes: {rounds: {repeat: true, waypoints: [{place: [9, 5]}, {place: [0, 5]}]}}\n"
      "gates: {door: {wall: [[0, 9], [1, 9]], open: true}}\n",
      5000.0);
  AgentStart start;
  start.goals = {{9.0, 0.0}};
  start.max_speed = 1.0;
  start.radius = 0.2;
  std::size_t capacity = 0;
  for (AgentId cycle = 1; cycle <= 1000; ++cycle) {
    ASSERT_EQ(episode.edit().addAgent(start), cycle);
    episode.edit().setRoute(cycle, "rounds");
    episode.edit().setGate("door", cycle % 2 == 0);
    step(episode);
    const Perceptions& perceptions = episode.perceptions();
    EXPECT_EQ(perceptions.agents.size(), 2U);
    if (cycle == 10) capacity = perceptions.agents.capacity();
    if (cycle > 10) {
      ASSERT_EQ(perceptions.agents.capacity(), capacity);
    }
    episode.edit().removeAgent(cycle);
    step(episode);
    ASSERT_EQ(episode.world().grid().size(), 1U);
    ASSERT_EQ(episode.population().memberCount(), 1U);
    ASSERT_LE(episode.world().walls().list().size(), 1U);
  }
  EXPECT_EQ(episode.result().agentCount(), 1U);
}

}  // namespace
}  // namespace crowd::population_property_test
