// What a tick, and what is known of an episode, depends on: the agents that are present, not those that have left.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::departures_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;

/// Two streams of 1 agent per tick, each on a way of some 3 m, and one agent that stays. There is a wall to walk round.
const char* const STREAMS = R"(
agents: [{position: [0, 9], route: rounds, speed: 1, radius: 0.2}]
walls: [[[1.5, -0.3], [1.5, 0.3]]]
routes:
  rounds: {repeat: true, waypoints: [{place: [5, 9]}, {place: [0, 9]}]}
  through: {waypoints: [{sink: out}]}
sources:
  - {area: {box: [[0, -1], [0.5, 1]]}, rate: 2, interval: regular, count: 1000, route: through, speed: [1, 2], radius: [0.1, 0.2]}
  - {area: {box: [[3, 4], [3.5, 6]]}, rate: 2, interval: regular, count: 1000, goal: [0, 5], speed: 1.5, radius: 0.1}
sinks: {out: {area: {box: [[3, -1], [4, 1]]}}}
)";
constexpr std::size_t ENTER = 2001;
constexpr std::size_t MOST = 40;          // present at a time
constexpr std::size_t MOST_LEAVING = 10;  // in a tick

/// What was seen of an agent.
struct Seen {
  std::uint64_t first = 0;    // tick
  std::uint64_t arrived = 0;  // tick
  double path = 0.0;          // [m]
  Vector2 place = Vector2::Zero();
  int states = 0;  // in which it had arrived
  bool is_removed = false;
};

void look(const World& world, std::map<AgentId, Seen>& seen) {
  for (const Agent& agent : world.agents()) {
    const auto [entry, is_new] = seen.try_emplace(agent.id);
    Seen& one = entry->second;
    if (is_new) {
      one.first = world.tick();
      one.place = agent.pose.position;
    }
    one.path += (agent.pose.position - one.place).norm();
    one.place = agent.pose.position;
    one.is_removed = one.is_removed || agent.status == AgentStatus::REMOVED;
    if (agent.hasArrived() && one.states++ == 0) one.arrived = world.tick();
  }
}

TEST(Departures, ATickHasThePresentAgentsOnly) {
  Episode episode = episodeOf(STREAMS, 520.0);
  const World& world = episode.world();
  std::size_t entered = 0;
  while (!episode.isOver()) {
    ASSERT_LE(world.agents().size(), MOST) << "tick " << world.tick();
    ASSERT_LE(world.grid().size(), MOST);
    ASSERT_LE(episode.perceptions().agents.size(), MOST);
    ASSERT_LE(episode.population().memberCount(), MOST);
    ASSERT_TRUE(std::is_sorted(world.agents().begin(), world.agents().end(),
                               [](const Agent& a, const Agent& b) { return a.id < b.id; }));
    ASSERT_GE(world.enteredCount(), entered);
    entered = world.enteredCount();
    ASSERT_LT(world.agents().back().id, entered);
    ASSERT_EQ(std::count_if(world.agents().begin(), world.agents().end(), [](const Agent& a) { return a.isWalking(); }),
              static_cast<std::ptrdiff_t>(world.activeCount()));
    step(episode);
  }
  EXPECT_EQ(entered, ENTER);
  EXPECT_EQ(world.departed().arrived, ENTER - 1);
}

/// Agents that come and go are seen in the tick in which they arrive and in the next one. Their results are kept.
TEST(Departures, ResultsOfAllAgents) {
  Episode episode = episodeOf(STREAMS, 520.0);
  std::map<AgentId, Seen> seen;
  std::vector<EpisodeResult> early;
  while (!episode.isOver()) {
    look(episode.world(), seen);
    if (episode.world().tick() % 300 == 50 && episode.world().isActive(episode.world().agents().back().id)) {
      early.push_back(episode.result());
      episode.edit().removeAgent(episode.world().agents().back().id);
    }
    step(episode);
  }
  look(episode.world(), seen);
  const EpisodeResult result = episode.result();
  ASSERT_EQ(seen.size(), ENTER);
  ASSERT_EQ(result.agents.size(), ENTER);
  std::size_t removed = 0;
  for (const auto& [id, one] : seen) {
    const AgentResult agent = result.agents[id];
    ASSERT_EQ(agent.appeared, one.first) << "agent " << id;
    ASSERT_EQ(agent.removed, one.is_removed) << "agent " << id;
    removed += one.is_removed ? 1 : 0;
    ASSERT_EQ(agent.arrived, one.states > 0) << "agent " << id;
    if (agent.removed || id == 0) continue;
    ASSERT_EQ(one.states, 2) << "agent " << id;
    ASSERT_EQ(agent.ticks, one.arrived - one.first) << "agent " << id;
    ASSERT_NEAR(agent.path_length, one.path, 1e-9) << "agent " << id;
  }
  EXPECT_EQ(removed, early.size());
  EXPECT_GT(removed, 2U);
  EXPECT_EQ(result.arrivedCount(), ENTER - 1 - removed);
  EXPECT_EQ(result.expectedCount(), ENTER - 1 - removed);
  // Earlier results have not changed.
  for (const EpisodeResult& before : early) {
    EXPECT_FALSE(before.agents[before.agents.size() - 1].arrived);
    EXPECT_LT(before.agents.size(), ENTER);
  }
}

TEST(Departures, IdsOfAgentsThatAreAddedAreNeverUsedAgain) {
  Episode episode = episodeOf("agents: [{position: [0, 9], goal: [900, 9], speed: 1, radius: 0.2}]\n");
  AgentStart start;
  start.goals = {{0.6, 0.0}};
  start.max_speed = 1.0;
  start.radius = 0.2;
  for (AgentId id = 1; id <= 100; ++id) {
    ASSERT_EQ(episode.edit().addAgent(start), id);
    if (id % 3 == 0) episode.edit().removeAgent(id);
    for (int tick = 0; tick < 3; ++tick) step(episode);
    ASSERT_LE(episode.world().agents().size(), 3U);
    EXPECT_FALSE(episode.world().isActive(id));
    EXPECT_FALSE(episode.world().agents().contains(id) && episode.world().isPerceiving(episode.world().agents()[id]));
  }
  EXPECT_EQ(episode.world().enteredCount(), 101U);
  EXPECT_EQ(episode.result().arrivedCount(), 67U);
}

/// Turns of a sequential scenario go to the present agents, by ascending id.
TEST(Departures, TurnsOfTheOthers) {
  Episode episode = episodeOf(std::string("order: sequential\n") + STREAMS, 120.0);
  const World& world = episode.world();
  std::vector<AgentId> turns;
  while (!episode.isOver()) {
    const Perceptions& perceptions = episode.perceptions();
    std::vector<AgentAction> actions;
    for (const AgentPerception& self : perceptions.agents) {
      turns.push_back(self.agent);
      const double share = std::min(1.0, self.goal.norm() / (self.max_speed * perceptions.tick_duration));
      actions.push_back({self.agent, {bearingOf(self.goal), share}});
    }
    const std::size_t active = world.activeCount();
    if (!episode.step(actions)) continue;
    ASSERT_TRUE(std::is_sorted(turns.begin(), turns.end()));
    ASSERT_EQ(std::adjacent_find(turns.begin(), turns.end()), turns.end());
    ASSERT_GE(turns.size(), active);
    ASSERT_LE(turns.size(), active + MOST_LEAVING);
    turns.clear();
  }
  EXPECT_GT(world.departed().arrived, 200U);
}

}  // namespace
}  // namespace crowd::departures_test
