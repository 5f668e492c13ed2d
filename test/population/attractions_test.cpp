#include "population/attractions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/straight_walk.h"

namespace crowd::attractions_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// An attraction at (4, 2) that is noticed at 3 m, with these further entries.
std::string window(const std::string& entries) {
  return "attractions: {window: {area: [4, 2], radius: 3, " + entries + "}}\n";
}

constexpr const char* PASSER_BY = "agents: [{position: [0, 0], goal: [10, 0], speed: 1, radius: 0.2}]\n";

/// An agent of 1 m/s sees it at x = 2, after 2 s, is there 3 s later, after 2.83 m, and waits for 3 s.
TEST(Attractions, APasserByStopsAndGoesOn) {
  Episode episode = episodeOf(PASSER_BY + window("share: 1, wait: 3, face: 180"));
  const Agent& agent = episode.world().agents()[0];
  walkUntil(1.5, episode);
  EXPECT_EQ(agent.goal(), Vector2(10.0, 0.0));
  step(episode);
  EXPECT_EQ(agent.goal(), Vector2(4.0, 2.0));
  EXPECT_TRUE(agent.leaves);
  walkUntil(5.0, episode);
  EXPECT_TRUE(agent.isHeldBy(Hold::ATTRACTION));
  EXPECT_EQ(agent.goal(), Vector2(10.0, 0.0));
  walkUntil(7.5, episode);
  EXPECT_LT((agent.pose.position - Vector2(4.0, 2.0)).norm(), 1e-12);
  EXPECT_EQ(std::abs(agent.pose.heading), toRadians(180.0));
  EXPECT_TRUE(agent.isHeldBy(Hold::ATTRACTION));
  step(episode);
  EXPECT_FALSE(agent.isHeld());
  walkUntil(100.0, episode);
  EXPECT_TRUE(agent.hasArrived());
  const double detour = std::sqrt(8.0) + std::sqrt(40.0);
  EXPECT_NEAR(episode.result().agents.at(0).straight_length, 2.0 + detour - 0.1, 1e-9);
  EXPECT_NEAR(episode.result().agents.at(0).path_length, 2.0 + detour, 0.1);
}

TEST(Attractions, PeopleFaceTheMiddleOfTheArea) {
  Episode episode = episodeOf(std::string(PASSER_BY) +
                              "attractions: {stall: {area: {ring: {centre: [4, 0], radius: [0.9, 0.9]}}, radius: 1, "
                              "share: 1, wait: 20}}\n");
  walkUntil(15.0, episode);
  const Agent& agent = episode.world().agents()[0];
  ASSERT_TRUE(agent.isHeldBy(Hold::ATTRACTION));
  EXPECT_NEAR((agent.pose.position - Vector2(4.0, 0.0)).norm(), 0.9, 0.1);
  EXPECT_LT((agent.ahead - (Vector2(4.0, 0.0) - agent.pose.position).normalized()).norm(), 1e-9);
}

TEST(Attractions, NobodyStopsWithoutAShareOrWithoutSeeingIt) {
  for (const std::string& keys :
       {window("share: 0, wait: 3"), window("share: 1, wait: 3") + "walls: [[[-9, 1], [20, 1]]]\n",
        std::string("attractions: {far: {area: [4, 2], radius: 1.9, share: 1, wait: 3}}\n")}) {
    Episode episode = episodeOf(PASSER_BY + keys);
    walkUntil(100.0, episode);
    EXPECT_EQ(episode.world().time(), 10.0) << keys;
  }
}

/// 400 agents of a ghost world pass; standard deviation of the share: 2.3 %.
TEST(Attractions, TheShare) {
  Episode episode = episodeOf(
      "agents: [{count: 400, position: {box: [[0, -40], [2, 40]]}, goal: {box: [[20, -40], [22, 40]]}, speed: 1, "
      "radius: 0.05}]\n"
      "attractions: {mall: {area: {box: [[8, -60], [14, 60]]}, radius: 1, share: 0.3, wait: 100}}\n");
  walkUntil(60.0, episode);
  std::size_t stand = 0;
  for (const Agent& agent : episode.world().agents()) stand += agent.isHeldBy(Hold::ATTRACTION) ? 1U : 0U;
  EXPECT_NEAR(static_cast<double>(stand) / 400.0, 0.3, 0.09);
  walkUntil(500.0, episode);
  EXPECT_EQ(episode.result().arrivedCount(), 400U);
}

/// The place is a point: the second agent finds it taken and walks on without a delay.
TEST(Attractions, AFullAreaIsPassed) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [10, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [-1, 0], goal: [10, 0], speed: 1, radius: 0.2}\n" +
      window("share: 1, wait: 30"));
  walkUntil(11.0, episode);
  EXPECT_TRUE(episode.world().agents()[1].hasArrived());
  EXPECT_EQ(episode.world().agents()[1].arrival_tick, 22U);
  EXPECT_TRUE(episode.world().agents()[0].isHeldBy(Hold::ATTRACTION));
}

/// Agent 0 is there from 2 s on; agent 1 notices the window in 3 s, and walks its 11 m in 22 ticks.
TEST(Attractions, WhoStaysTakesAPlace) {
  Episode episode = episodeOf(
      "arrived: stay\n"
      "agents:\n"
      "  - {position: [4, 4], goal: [4, 2], speed: 1, radius: 0.2}\n"
      "  - {position: [-1, 0], goal: [10, 0], speed: 1, radius: 0.2}\n" +
      window("share: 1, wait: 30"));
  walkUntil(11.0, episode);
  EXPECT_EQ(episode.world().agents()[0].status, AgentStatus::STAYING);
  EXPECT_EQ(episode.world().agents()[1].arrival_tick, 22U);
}

/// 4 m to and fro; the stop takes 3 s and a detour.
TEST(Attractions, AnAgentStopsOnceAtEach) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: rounds, speed: 1, radius: 0.2}]\n"
      "routes: {rounds: {repeat: true, waypoints: [{place: [8, 0]}, {place: [0, 0]}]}}\n"
      "attractions:\n"
      "  window: {area: [4, 2], radius: 3, share: 1, wait: 3}\n"
      "  stall: {area: [4, -2], radius: 3, share: 1, wait: 3}\n",
      200.0);
  const Agent& agent = episode.world().agents()[0];
  std::size_t stops = 0;
  bool stood = false;
  while (!episode.isOver()) {
    step(episode);
    stops += agent.isHeldBy(Hold::ATTRACTION) && !stood ? 1U : 0U;
    stood = agent.isHeldBy(Hold::ATTRACTION);
  }
  EXPECT_EQ(stops, 2U);
  EXPECT_GT(episode.result().agents.at(0).waypoints, 15U);
}

TEST(Attractions, NotOnTheWayToAQueue) {
  Episode episode = episodeOf(
      "agents: [{position: [0, 0], route: buy, speed: 1, radius: 0.2}]\n"
      "routes: {buy: {waypoints: [{queue: till}, {place: [10, 0]}]}}\n"
      "queues: {till: {head: [3, 0], direction: 180, spacing: 1, service: 1}}\n" +
      window("share: 1, wait: 30"));
  const Agent& agent = episode.world().agents()[0];
  walkUntil(4.0, episode);
  EXPECT_EQ(agent.pose.position, Vector2(3.0, 0.0));
  walkUntil(9.0, episode);
  EXPECT_TRUE(agent.isHeldBy(Hold::ATTRACTION));  // it was served first
}

/// It has 10 s, and three times the 2 s that it takes at 1 m/s, but soon walks at 0.05 m/s.
TEST(Attractions, AnAgentThatDoesNotGetThereGoesOn) {
  Episode episode = episodeOf(
      "agents: [{position: [4, 0], goal: [10, 0], speed: 1, radius: 0.2}]\n"
      "alarms: [{time: 1, area: all, speed_factor: 0.05}]\n" +
      window("share: 1, wait: 3"));
  const Agent& agent = episode.world().agents()[0];
  step(episode);
  EXPECT_EQ(agent.goal(), Vector2(4.0, 2.0));
  const double start = episode.world().time();
  const double time = 10.0 + 3.0 * (agent.pose.position - agent.goal()).norm();
  while (episode.world().time() + 0.5 < start + time) step(episode);
  EXPECT_EQ(agent.goal(), Vector2(4.0, 2.0));
  step(episode);
  EXPECT_EQ(agent.goal(), Vector2(10.0, 0.0));
  EXPECT_FALSE(agent.isHeld());
}

TEST(Attractions, AnotherGoalOrRouteEndsTheVisit) {
  const std::string keys =
      std::string(PASSER_BY) + "routes: {back: {waypoints: [{place: [0, 9]}]}}\n" + window("share: 1, wait: 30");
  for (const double time : {3.0, 7.0}) {  // on the way to it, and at it
    Episode by_goal = episodeOf(keys);
    walkUntil(time, by_goal);
    by_goal.edit().setGoal(0, {-5.0, 0.0});
    EXPECT_FALSE(by_goal.world().agents()[0].isHeld());
    EXPECT_EQ(by_goal.world().agents()[0].goals, std::vector<Vector2>{Vector2(-5.0, 0.0)});
    Episode by_route = episodeOf(keys);
    walkUntil(time, by_route);
    by_route.edit().setRoute(0, "back");
    EXPECT_FALSE(by_route.world().agents()[0].isHeld());
    EXPECT_EQ(by_route.world().agents()[0].goal(), Vector2(0.0, 9.0));
    walkUntil(100.0, by_route);
    EXPECT_TRUE(by_route.world().agents()[0].hasArrived());
  }
}

}  // namespace
}  // namespace crowd::attractions_test
