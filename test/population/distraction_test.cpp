#include "population/distraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenario/writing/scene_document.h"
#include "support/scenes.h"
#include "support/straight_walk.h"

namespace crowd::distraction_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::sceneOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// Ends of the first intervals of an agent [s]: a pause begins at the first one, ends at the second one, and so on.
std::vector<double> scheduleOf(std::uint64_t seed, AgentId agent, const PauseDescription& pauses, int count) {
  KeyedRandom random(seed, KeyedRandom::DISTRACTION, {agent});
  std::vector<double> times;
  double time = 0.0;
  for (int i = 0; i < count; ++i) {
    const double walks = -std::log1p(-random.uniform()) * pauses.every;
    times.push_back(time += walks);
    times.push_back(time += random.uniform(pauses.duration.low, pauses.duration.high));
  }
  return times;
}

const char* const STANDS = "kinds: {own: {speed: 1, radius: 0.2, pauses: {every: 10, duration: [3, 6]}}}\n";
const char* const SLOWS = "kinds: {own: {speed: 1, radius: 0.2, pauses: {every: 10, duration: [3, 6], speed: 0.5}}}\n";
const char* const ONE = "agents: [{position: [0, 0], goal: [900, 0], kind: own}]\n";
const PauseDescription PAUSES{10.0, {3.0, 6.0}, 0.0};

/// Whether the agent is distracted at a time: the number of the times that have passed is odd.
bool isDistracted(const std::vector<double>& schedule, double time) {
  std::size_t passed = 0;
  while (passed < schedule.size() && schedule[passed] <= time + 1e-9) ++passed;
  return passed % 2 == 1;
}

TEST(Distraction, AgentsStandAsScheduled) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Episode episode = episodeOf(std::string(ONE) + STANDS, 200.0, seed);
    const std::vector<double> schedule = scheduleOf(episode.scene().population_seed, 0, PAUSES, 30);
    const Agent& agent = episode.world().agents()[0];
    double walked = 0.0;
    while (!episode.isOver()) {
      const bool was_held = agent.isHeldBy(Hold::PAUSE);
      walked += was_held ? 0.0 : 0.5;
      step(episode);
      ASSERT_EQ(agent.isHeldBy(Hold::PAUSE), isDistracted(schedule, episode.world().time())) << seed;
      ASSERT_NEAR(agent.pose.position.x(), walked, 1e-9) << seed << " at " << episode.world().time();
    }
    EXPECT_LT(walked, 190.0) << seed;
  }
}

TEST(Distraction, AgentsSlowDownAsScheduled) {
  Episode episode = episodeOf(std::string(ONE) + SLOWS, 200.0);
  const std::vector<double> schedule = scheduleOf(episode.scene().population_seed, 0, PAUSES, 30);
  const Agent& agent = episode.world().agents()[0];
  while (!episode.isOver()) {
    step(episode);
    ASSERT_EQ(agent.wanted_speed, isDistracted(schedule, episode.world().time()) ? 0.5 : 1.0);
    ASSERT_FALSE(agent.isHeld());
  }
}

TEST(Distraction, TheShareOfTimeIsThatOfTheDescription) {
  Episode episode = episodeOf(
      std::string("agents: [{count: 60, position: {box: [[-20, -20], [20, 20]]}, goal: [9000, 0], kind: own}]\n") +
          STANDS,
      1000.0);
  double held = 0.0;
  double all = 0.0;
  while (!episode.isOver()) {
    step(episode);
    if (episode.world().time() < 50.0) continue;
    for (const Agent& agent : episode.world().agents()) held += agent.isHeldBy(Hold::PAUSE) ? 1.0 : 0.0;
    all += static_cast<double>(episode.world().agents().size());
  }
  EXPECT_NEAR(held / all, 4.5 / 14.5, 0.01);  // pauses of 4.5 s after 10 s of walking, on average
}

TEST(Distraction, EachAgentHasItsOwnTimes) {
  Episode episode = episodeOf(std::string("agents: [{position: [0, 0], goal: [900, 0], kind: own}, "
                                          "{position: [0, 5], goal: [900, 5], kind: own}]\n") +
                              STANDS);
  walkUntil(100.0, episode);
  EXPECT_NE(episode.world().agents()[0].pose.position.x(), episode.world().agents()[1].pose.position.x());
}

TEST(Distraction, AgentsOfSourcesPauseFromWhenTheyAppear) {
  Episode episode =
      episodeOf(std::string("sources: [{area: [0, 0], times: [7], goal: [900, 0], kind: own}]\n") + STANDS, 200.0);
  const std::vector<double> schedule = scheduleOf(episode.scene().population_seed, 0, PAUSES, 30);
  std::size_t ticks = 0;
  while (!episode.isOver()) {
    step(episode);
    if (episode.world().enteredCount() == 0) continue;
    const Agent& agent = episode.world().agents()[0];
    ASSERT_EQ(agent.isHeldBy(Hold::PAUSE), isDistracted(schedule, episode.world().time() - 7.0));
    ++ticks;
  }
  EXPECT_GT(ticks, 300U);
}

TEST(Distraction, AgentsThatAreGoneAreForgotten) {
  World world(sceneOf(std::string(ONE) + STANDS));
  Distraction distraction(1);
  distraction.add(0, PAUSES, 0.0);
  world.walkingAgent(0).status = AgentStatus::REMOVED;
  distraction.update(world);
  EXPECT_TRUE(distraction.isEmpty());
}

TEST(Distraction, ASourceKeepsItsShares) {
  Episode episode = episodeOf(
      "sources: [{area: {box: [[0, -50], [1, 50]]}, rate: 20, goal: [3, 0], kind: {a: 3, b: 1}}]\n"
      "kinds: {a: {speed: 1, radius: 0.2, figure: old}, b: {speed: 2, radius: 0.3, figure: child}}\n",
      50.0);
  double fast = 0.0;
  double all = 0.0;
  while (!episode.isOver()) {
    const std::size_t before = episode.world().enteredCount();
    step(episode);
    for (AgentId id = static_cast<AgentId>(before); id < episode.world().enteredCount(); ++id) {
      const Agent& agent = episode.world().agents()[id];
      ASSERT_EQ(agent.figure, agent.own_speed == 2.0 ? Figure::CHILD : Figure::OLD);
      ASSERT_EQ(agent.radius, agent.own_speed == 2.0 ? 0.3 : 0.2);
      fast += agent.own_speed == 2.0 ? 1.0 : 0.0;
      all += 1.0;
    }
  }
  ASSERT_GT(all, 500.0);
  EXPECT_NEAR(fast / all, 0.25, 4.0 * std::sqrt(0.25 * 0.75 / all));
}

/// A scenario with kinds, written and read back, is the same episode.
TEST(Distraction, AWrittenSceneWalksTheSameWay) {
  const Scene scene = sceneOf(
      std::string("agents: [{count: 10, position: {box: [[-5, -5], [5, 5]]}, goal: [900, 0], kind: {own: 1, old: 1}}]\n"
                  "sources: [{area: [-9, 0], rate: 0.2, goal: [900, 0], kind: {own: 2, luggage: 1}}]\n") +
          STANDS,
      60.0, 3);
  const std::string document = toDocument(scene, ".");
  const Scene read = parseScenarios(document, "s.yaml").scene(3, 0);
  EXPECT_EQ(toDocument(read, "."), document);
  Episode first(scene, 0, Vision());
  Episode second(read, 0, Vision());
  while (!first.isOver()) {
    step(first);
    step(second);
    ASSERT_EQ(first.world().enteredCount(), second.world().enteredCount());
    for (const Agent& agent : first.world().agents()) {
      const Agent& other = second.world().agents()[agent.id];
      ASSERT_EQ(agent.pose.position, other.pose.position);
      ASSERT_EQ(agent.figure, other.figure);
      ASSERT_EQ(agent.radius, other.radius);
    }
  }
}

}  // namespace
}  // namespace crowd::distraction_test
