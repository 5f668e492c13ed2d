// Episodes of scenarios with `arrived: stay`.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "simulation/episode_runner.h"
#include "simulation/evaluation/trajectory.h"
#include "support/evaluations.h"
#include "support/scenes.h"
#include "support/seeds.h"
#include "support/straight_walk.h"

namespace crowd::staying_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::walkUntil;

AgentStatus statusOf(const Episode& episode, AgentId id) { return episode.world().agents()[id].status; }

/// Agents of 1 m/s that walk 0.5 m a tick: agent 0 arrives in tick 2, agent 1, which walks past it, in tick 8.
const char* const TWO = R"(
agents:
  - {position: [0, 0], goal: [1, 0], speed: 1, radius: 0.2}
  - {position: [-1, 0.6], goal: [3, 0.6], speed: 1, radius: 0.2}
)";

TEST(Staying, TheEpisodeEndsAsBefore) {
  std::string rows[2];
  for (const bool stays : {false, true}) {
    Episode episode = episodeOf(std::string(stays ? "arrived: stay\n" : "arrived: leave\n") + TWO);
    while (!episode.isOver()) {
      straight_walk::step(episode);
      appendTrajectoryRows(0, episode.world(), rows[stays ? 1 : 0]);
    }
    EXPECT_EQ(episode.world().tick(), 8U);
    EXPECT_EQ(statusOf(episode, 0), stays ? AgentStatus::STAYING : AgentStatus::ARRIVED);
    const EpisodeResult result = episode.result();
    EXPECT_EQ(result.arrivedCount(), 2U);
    EXPECT_EQ(result.agents.at(0).ticks, 2U);
    EXPECT_EQ(result.agents.at(0).path_length, 1.0);
    EXPECT_EQ(result.agents.at(1).ticks, 8U);
    // In tick 4 agent 1 passes at 0.6 m, 0.4 m from the rim of agent 0, whose own result is that of its arrival.
    EXPECT_EQ(result.agents.at(1).collided, stays);
    EXPECT_FALSE(result.agents.at(1).touched);
    EXPECT_FALSE(result.agents.at(0).collided);
  }
  EXPECT_EQ(rows[0].find("0,8,0,"), std::string::npos);
  EXPECT_NE(rows[1].find("0,8,0,1,0\n"), std::string::npos) << rows[1];  // a row for each tick in the world
}

TEST(Staying, HoldsAtTheLastGoalOnly) {
  Episode episode = episodeOf(
      "arrived: stay\n"
      "agents: [{position: [0, 0], goals: [[1, 0], [2, 0]], speed: 1, radius: 0.2}]\n");
  walkUntil(1.5, episode);
  EXPECT_EQ(statusOf(episode, 0), AgentStatus::WALKING);
  walkUntil(2.0, episode);
  EXPECT_EQ(statusOf(episode, 0), AgentStatus::STAYING);
  EXPECT_TRUE(episode.isOver());
}

TEST(Staying, AtTheEndOfARouteUnlessThatIsASink) {
  Episode episode = episodeOf(
      "arrived: stay\n"
      "agents:\n"
      "  - {position: [0, 0], route: tour, speed: 1, radius: 0.2}\n"
      "  - {position: [0, 3], route: out, speed: 1, radius: 0.2}\n"
      "  - {position: [0, 9], goal: [90, 9], speed: 1, radius: 0.2}\n"
      "routes:\n"
      "  tour: {waypoints: [{place: [1, 0]}, {place: [2, 0], wait: 1}]}\n"
      "  out: {waypoints: [{place: [1, 3]}, {sink: door}]}\n"
      "sinks: {door: {area: {box: [[2, 2], [3, 4]]}}}\n");
  walkUntil(10.0, episode);
  EXPECT_EQ(statusOf(episode, 0), AgentStatus::STAYING);
  EXPECT_FALSE(episode.world().agents()[0].isHeld());  // its wait is over
  EXPECT_EQ(statusOf(episode, 1), AgentStatus::ARRIVED);
  EXPECT_EQ(episode.world().activeCount(), 1U);
  EXPECT_EQ(episode.result().count().arrived, 2U);
}

/// Agent 0 is at the head from 3 s on and is served until 5 s; agent 1 moves up in 1 s, and is served until 8 s.
TEST(Staying, NobodyAtTheHeadOfAQueue) {
  Episode episode = episodeOf(
      "arrived: stay\n"
      "agents:\n"
      "  - {position: [0, 0], route: buy, speed: 1, radius: 0.2}\n"
      "  - {position: [-1, 0], route: buy, speed: 1, radius: 0.2}\n"
      "routes: {buy: {waypoints: [{queue: desk}]}}\n"
      "queues: {desk: {head: [3, 0], direction: 180, spacing: 1, service: 2}}\n");
  walkUntil(5.0, episode);
  EXPECT_EQ(statusOf(episode, 0), AgentStatus::ARRIVED);
  EXPECT_EQ(statusOf(episode, 1), AgentStatus::WALKING);
  walkUntil(100.0, episode);
  EXPECT_EQ(statusOf(episode, 1), AgentStatus::ARRIVED);
  EXPECT_EQ(episode.world().time(), 8.0);
}

TEST(Staying, PeopleOfSourcesLeave) {
  Episode episode = episodeOf(
      "arrived: stay\n"
      "agents: [{position: [0, 5], goal: [1, 5], speed: 1, radius: 0.2}]\n"
      "sources: [{area: [0, 0], times: [1, 3], goal: [2, 0], speed: 1, radius: 0.2}]\n");
  while (!episode.isOver()) straight_walk::step(episode);
  EXPECT_EQ(episode.world().enteredCount(), 3U);
  EXPECT_EQ(statusOf(episode, 0), AgentStatus::STAYING);
  EXPECT_EQ(episode.result().count().arrived, 3U);
  EXPECT_EQ(episode.world().grid().size(), 1U);
}

TEST(Staying, AddedAgentsDoWhatThoseOfTheScenarioDo) {
  for (const bool stays : {false, true}) {
    Episode episode = episodeOf(std::string(stays ? "arrived: stay\n" : "") + TWO);
    const AgentId added = episode.edit().addAgent(scenes::agent({0.0, 5.0}, {1.0, 5.0}, 1.0, 0.2));
    walkUntil(2.0, episode);
    EXPECT_TRUE(episode.world().agents().find(added) == nullptr || statusOf(episode, added) != AgentStatus::WALKING);
    walkUntil(3.5, episode);
    ASSERT_EQ(episode.world().agents().find(added) != nullptr, stays);
    if (stays) EXPECT_EQ(statusOf(episode, added), AgentStatus::STAYING);
  }
}

/// Agents with goals of their own between those who stay.
TEST(Staying, NobodyTouchesThoseWhoStay) {
  std::size_t staying = 0;
  std::size_t ticks_beside = 0;
  forSeeds(20, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& random) {
    Scene scene = scenes::scene({});
    scene.max_ticks = 200;
    for (int i = 0; i < 25; ++i) {
      const Vector2 start(1.2 * (i % 5), 1.2 * static_cast<double>(i / 5));
      const Vector2 goal(random.uniform(-1.0, 6.0), random.uniform(-1.0, 6.0));
      scene.agents.push_back(scenes::agent(start, goal, random.uniform(0.8, 1.6), 0.2));
      scene.agents.back().stays = true;
    }
    const TrainedTable trained = loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt");
    Learner learner = makeDemoLearner(trained, 1);
    Episode episode(scene, seed, learner.model().vision());
    EpisodeObserver observer;
    std::map<AgentId, Vector2> places;
    observer.on_tick = [&](const World& world) {
      for (const Agent& agent : world.agents()) {
        if (agent.status != AgentStatus::STAYING) continue;
        const Vector2 place = places.try_emplace(agent.id, agent.pose.position).first->second;
        EXPECT_EQ(agent.pose.position, place);
        ++ticks_beside;
      }
    };
    CrowdDecider decider(learner);
    const EpisodeResult result = runEpisode(episode, decider, observer);
    EXPECT_EQ(result.touchedCount(), 0U);
    EXPECT_EQ(result.arrivedCount(), places.size());
    staying += places.size();
  });
  EXPECT_GT(staying, 100U);
  EXPECT_GT(ticks_beside, 10000U);
}

}  // namespace
}  // namespace crowd::staying_test
