#include "population/population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "simulation/episode.h"
#include "simulation/evaluation/metrics.h"
#include "support/error_of.h"
#include "support/straight_walk.h"

namespace crowd::population_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// The time at whose end this holds for the first time; -1 if it never does.
template <typename Condition>
double timeUntil(Episode& episode, const Condition& holds) {
  while (!holds() && !episode.isOver()) step(episode);
  return holds() ? episode.world().time() : -1.0;
}

/// Agents of 1 m/s that walk 0.5 m a tick. Agent 0 reaches x = 2 at t = 2 s, waits until 5 s, and is back at 7 s.
TEST(Population, WalksARouteAndLeavesAtItsEnd) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: tour, speed: 1, radius: 0.2}]\n"
      "routes: {tour: {waypoints: [{place: [2, 0], wait: 3}, {place: [0, 0]}]}}\n");
  const Agent& agent = episode.world().agents()[0];
  EXPECT_EQ(agent.goal(), Vector2(2.0, 0.0));
  walkUntil(4.5, episode);
  EXPECT_EQ(agent.pose.position, Vector2(2.0, 0.0));
  EXPECT_TRUE(agent.isHeld());
  EXPECT_EQ(timeUntil(episode, [&] { return !agent.isHeld(); }), 5.0);
  EXPECT_EQ(agent.goal(), Vector2(0.0, 0.0));
  EXPECT_EQ(timeUntil(episode, [&] { return agent.hasArrived(); }), 7.0);
  EXPECT_TRUE(episode.isOver());
  const AgentResult result = episode.result().agents.at(0);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.waypoints, 2U);
  EXPECT_EQ(result.ticks, 14U);
  EXPECT_NEAR(result.path_length, 4.0, 1e-12);
  EXPECT_NEAR(result.straight_length, 3.9, 1e-12);
}

/// A closed room covers half of the region that goals are drawn in.
const char* const CLOSED_ROOM =
    "walls: [[[-1, -6], [3, -6]], [[3, -6], [3, 6]], [[3, 6], [-1, 6]], [[-1, 6], [-1, -6]]]\n";
const char* const PLACES = "{box: [[-5, -5], [3, 5]]}";

TEST(Population, PlacesOfRoutesAreDrawnWhereAWayLeads) {
  const std::string routes =
      std::string("routes: {tour: {repeat: true, waypoints: [{place: ") + PLACES + "}]}}\n" + CLOSED_ROOM;
  Episode episode = episodeOf("agents: [{position: [-4, 0], route: tour, speed: 2, radius: 0.2}]\n" + routes, 100.0);
  while (!episode.isOver()) {
    ASSERT_LT(episode.world().agents()[0].goal().x(), -1.0);
    step(episode);
  }
  EXPECT_GT(episode.result().agents.at(0).waypoints, 20U);
}

TEST(Population, PlacesOutOfReachAreDrawnIfThereAreNoOthers) {
  Episode episode = episodeOf(std::string("agents: [{position: [-4, 0], route: tour, speed: 2, radius: 0.2}]\n"
                                          "routes: {tour: {waypoints: [{place: {box: [[-1.1, -5], [3, 5]]}}]}}\n") +
                              CLOSED_ROOM);
  const Agent& agent = episode.world().agents()[0];
  EXPECT_FALSE(episode.world().walls().index().isAnyWithin(agent.goal(), agent.radius - 1e-6));
}

TEST(Population, GoalsOfSourcesAreDrawnWhereAWayLeads) {
  Episode episode = episodeOf(std::string("agents: []\nsources: [{area: {box: [[-5, -5], [-2, 5]]}, rate: 2, goal: ") +
                                  PLACES + ", speed: 1, radius: [0.2, 0.3]}]\n" + CLOSED_ROOM,
                              20.0);
  while (!episode.isOver()) step(episode);
  ASSERT_GT(episode.result().agents.size(), 20U);
  EXPECT_EQ(episode.result().outOfReach(), std::vector<AgentId>());
}

TEST(Population, ARouteThatRepeatsGoesOnAndHasNotFailed) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: rounds, speed: 1, radius: 0.2}]\n"
      "routes: {rounds: {repeat: true, waypoints: [{place: [2, 0]}, {place: [0, 0]}]}}\n",
      21.0);
  walkUntil(100.0, episode);
  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.ticks, 42U);
  EXPECT_FALSE(result.agents.at(0).arrived);
  EXPECT_EQ(result.agents.at(0).waypoints, 10U);
  EXPECT_EQ(result.expectedCount(), 0U);
  EXPECT_TRUE(result.isClean());
  Metrics metrics;
  metrics.add(result);
  EXPECT_TRUE(std::isnan(metrics.successPercent()));
}

TEST(Population, ReactionTimes) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [1, 0], speed: 1, radius: 0.2, reaction_time: 3}\n"
      "  - {position: [0, 5], goal: [1, 5], speed: 1, radius: 0.2}\n");
  const auto& agents = episode.world().agents();
  EXPECT_EQ(timeUntil(episode, [&] { return agents[1].hasArrived(); }), 1.0);
  EXPECT_EQ(timeUntil(episode, [&] { return agents[0].pose.position.x() > 0.0; }), 3.5);
  EXPECT_EQ(timeUntil(episode, [&] { return agents[0].hasArrived(); }), 4.0);
}

/// The source is at x = 0; an agent walks 1 m, which takes 1 s, to its goal.
TEST(Population, SourcesAddAgentsAtTheirTimes) {
  Episode episode = episodeOf("sources: [{area: [0, 0], times: [0, 1, 2.5], goal: [1, 0], speed: 1, radius: 0.2}]\n");
  const World& world = episode.world();
  std::vector<std::size_t> counts;
  while (!episode.isOver()) {
    counts.push_back(world.enteredCount());
    step(episode);
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 1, 2, 2, 2, 3, 3}));
  EXPECT_EQ(world.time(), 3.5);
  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.agents.size(), 3U);
  EXPECT_EQ(result.arrivedCount(), 3U);
  for (const AgentResult& agent : result.agents) EXPECT_EQ(agent.ticks, 2U);
}

/// All three are due at once at one point; a place is free again after the one before has walked on 0.5 m.
TEST(Population, NoAgentIsLostWhereThereIsNoRoom) {
  Episode episode = episodeOf("sources: [{area: [0, 0], times: [0, 0, 0], goal: [3, 0], speed: 1, radius: 0.2}]\n");
  std::vector<std::size_t> counts;
  while (!episode.isOver()) {
    counts.push_back(episode.world().agents().size());
    step(episode);
  }
  ASSERT_GE(counts.size(), 3U);
  EXPECT_EQ(counts[0], 1U);
  EXPECT_EQ(counts[1], 2U);
  EXPECT_EQ(counts[2], 3U);
  EXPECT_EQ(episode.result().arrivedCount(), 3U);
}

TEST(Population, AgentsLeaveInTheAreaOfASink) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: out, speed: 1, radius: 0.2}]\n"
      "routes: {out: {waypoints: [{sink: exit}]}}\n"
      "sinks: {exit: {area: {box: [[3, -1], [5, 1]]}}}\n");
  const Agent& agent = episode.world().agents()[0];
  EXPECT_EQ(agent.goal(), Vector2(3.2, 0.0));  // where its disc is inside
  EXPECT_EQ(timeUntil(episode, [&] { return agent.hasArrived(); }), 3.0);
  EXPECT_EQ(agent.pose.position, Vector2(3.0, 0.0));
}

TEST(Population, TheNearestSink) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: out, speed: 1, radius: 0.2}, {position: [9, 0], route: out, speed: 1, "
      "radius: 0.2}]\n"
      "routes: {out: {waypoints: [{sink: nearest}]}}\n"
      "sinks: {left: {area: [-3, 0]}, right: {area: [12, 0]}}\n");
  EXPECT_EQ(episode.world().agents()[0].goal(), Vector2(-3.0, 0.0));
  EXPECT_EQ(episode.world().agents()[1].goal(), Vector2(12.0, 0.0));
}

TEST(Population, GoalsAreDrawnWhereAgentsFit) {
  const std::string keys =
      "agents: [{position: [0, 0], route: rounds, speed: 1, radius: 0.2}]\n"
      "walls: [[[2, 0], [4, 0]]]\n"
      "obstacles: [{position: [3, 1], radius: 0.5}]\n"
      "routes: {rounds: {repeat: true, waypoints: [{place: {box: [[2, -1], [4, 2]]}}]}}\n";
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Episode episode = episodeOf(keys, 10.0, seed);
    const Vector2& goal = episode.world().agents()[0].goal();
    EXPECT_GE(distanceTo({{2.0, 0.0}, {4.0, 0.0}}, goal), 0.2) << "seed " << seed;
    EXPECT_GE((goal - Vector2(3.0, 1.0)).norm(), 0.7) << "seed " << seed;
  }
}

/// Four agents at a till with places at x = 0, 1, 2, 3; each is served for 2 s, and needs 1 s to move up.
TEST(Population, QueuesServeEachAgentOnce) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], route: shop, speed: 1, radius: 0.2}\n"
      "  - {position: [1, 0], route: shop, speed: 1, radius: 0.2}\n"
      "  - {position: [2, 0], route: shop, speed: 1, radius: 0.2}\n"
      "  - {position: [3, 0], route: shop, speed: 1, radius: 0.2}\n"
      "routes: {shop: {waypoints: [{queue: till}, {place: [-1, 0]}]}}\n"
      "queues: {till: {head: [0, 0], direction: 0, spacing: 1, service: 2}}\n");
  std::vector<double> left(4, -1.0);
  while (!episode.isOver()) {
    step(episode);
    for (const Agent& agent : episode.world().agents()) {
      if (agent.hasArrived() && left[agent.id] < 0.0) left[agent.id] = episode.world().time();
    }
  }
  // The first is at the head after one tick. It then walks 1 m.
  EXPECT_EQ(left, (std::vector<double>{3.5, 6.5, 9.5, 12.5}));
}

TEST(Population, GatesOpenAndCloseDuringTheEpisode) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], goal: [9, 0], speed: 1, radius: 0.2}]\n"
      "contact: solid\nway_finding: false\n"
      "gates: {door: {wall: [[1, -1], [1, 1]], open: [[3, 100]]}}\n");
  const Agent& agent = episode.world().agents()[0];
  walkUntil(3.0, episode);
  EXPECT_NEAR(agent.pose.position.x(), 0.8, 1e-9);
  walkUntil(4.0, episode);
  EXPECT_GT(agent.pose.position.x(), 1.2);
}

TEST(Population, SetRoute) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], goal: [9, 0], speed: 1, radius: 0.2}]\n"
      "routes: {back: {waypoints: [{place: [-1, 0]}, {place: [0, 0]}]}, on: {waypoints: [{place: [5, 0]}]}}\n");
  walkUntil(1.0, episode);
  episode.edit().setRoute(0, "back");
  EXPECT_EQ(episode.world().agents()[0].goal(), Vector2(-1.0, 0.0));
  walkUntil(4.0, episode);
  EXPECT_TRUE(episode.isOver());  // 2 m there, 1 m back
  EXPECT_TRUE(episode.result().agents[0].arrived);
  EXPECT_EQ(episode.result().agents[0].waypoints, 2U);
}

TEST(Population, AGoalEndsARoute) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: rounds, speed: 1, radius: 0.2}, {position: [0, 5], route: shop, speed: 1, "
      "radius: 0.2}]\n"
      "routes:\n  rounds: {repeat: true, waypoints: [{place: [2, 0], wait: 50}]}\n  shop: {waypoints: [{queue: "
      "till}]}\n"
      "queues: {till: {head: [0, 5], direction: 0, spacing: 1, service: 100}}\n");
  walkUntil(10.0, episode);
  for (const Agent& agent : episode.world().agents()) EXPECT_TRUE(agent.isHeld());
  episode.edit().setGoal(0, {1.0, 0.0});
  episode.edit().setGoal(1, {1.0, 5.0});
  for (const Agent& agent : episode.world().agents()) EXPECT_FALSE(agent.isHeld());
  walkUntil(11.0, episode);
  EXPECT_TRUE(episode.isOver());
  EXPECT_EQ(episode.result().arrivedCount(), 2U);
  EXPECT_EQ(episode.result().expectedCount(), 2U);
}

TEST(Population, UnknownNamesAndAgentsAreRefused) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], goal: [9, 0], speed: 1, radius: 0.2}]\n"
      "routes: {back: {waypoints: [{place: [-1, 0]}]}}\n"
      "gates: {door: {wall: [[1, -1], [1, 1]], open: true}}\n");
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().setRoute(0, "bak"); }),
            "there is no route 'bak', did you mean 'back'? Known are back");
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().setRoute(7, "back"); }), "there is no agent 7 on its way");
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().setGate("gate", true); }),
            "there is no gate 'gate'; known are door");
  EXPECT_EQ(episode.world().agents()[0].goal(), Vector2(9.0, 0.0));
}

/// The first agent appears at t = 1 s, with a wall between it and its goal.
TEST(Population, AgentsThatAppearLaterFindTheirWay) {
  Episode episode = episodeOf(
      "walls: [[[2, -3], [2, 3]]]\n"
      "contact: solid\n"
      "sources: [{area: [0, 0], times: [1], goal: [4, 0], speed: 1, radius: 0.2}, {area: [0, 1], times: [2], goal: [4, "
      "1], speed: 1, radius: 0.3}]\n");
  walkUntil(2.5, episode);
  ASSERT_EQ(episode.world().agents().size(), 2U);
  for (const Agent& agent : episode.world().agents()) EXPECT_TRUE(agent.has_waypoint);
  walkUntil(60.0, episode);
  EXPECT_TRUE(episode.isOver());
  EXPECT_EQ(episode.result().arrivedCount(), 2U);
}

/// A wall leaves room for two in line; the other agents wait near it.
TEST(Population, MoreAgentsThanALineHasPlaces) {
  Episode episode = episodeOf(
      "agents: [{count: 6, position: {box: [[-4, -4], [4, -2]]}, route: shop, speed: 1, radius: 0.2}]\n"
      "walls: [[[2, -5], [2, 5]]]\nway_finding: false\n"
      "routes: {shop: {waypoints: [{queue: till}, {place: [0, 5]}]}}\n"
      "queues: {till: {head: [0, 0], direction: 0, spacing: 1, service: 3}}\n");
  std::size_t most = 0;
  while (!episode.isOver()) {
    most = std::max(most, episode.population().queue(0).line().size());
    step(episode);
  }
  EXPECT_EQ(most, 2U);
  EXPECT_EQ(episode.result().arrivedCount(), 6U);
}

}  // namespace
}  // namespace crowd::population_test
