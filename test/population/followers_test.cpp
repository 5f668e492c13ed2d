#include "population/followers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "scenario/writing/scene_document.h"
#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::followers_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::sceneOf;
using straight_walk::step;
using straight_walk::walkUntil;

const Agent& agent(const Episode& episode, AgentId id) { return episode.world().agents()[id]; }

/// The first follower gets the goal to the left of the leader's: two radii and 0.25 m away; the second to the right.
TEST(Followers, GetGoalsBesideThatOfTheirLeader) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goals: [[10, 0], [10, 20]], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2}\n"
      "  - {position: [0, -1], leader: 0, speed: 1, radius: 0.2}\n");
  EXPECT_NEAR((agent(episode, 1).goal() - Vector2(10.0, 0.65)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((agent(episode, 2).goal() - Vector2(10.0, -0.65)).norm(), 0.0, 1e-12);
  EXPECT_EQ(agent(episode, 0).group, 0U);
  EXPECT_EQ(agent(episode, 2).group, 0U);
  while (agent(episode, 0).goal().y() < 20.0) step(episode);
  EXPECT_NEAR(agent(episode, 1).goal().y(), 20.0, 0.1);  // the leader turns within its goal tolerance
  while (!episode.isOver()) step(episode);
  EXPECT_EQ(episode.result().agents.size(), 3U);
  for (AgentId id = 0; id < 3; ++id) EXPECT_TRUE(episode.result().agents.at(id).arrived) << id;
}

/// The place to the left does not fit, so that the first follower gets the one to the right.
TEST(Followers, AGoalBesideAWallIsOnTheOtherSide) {
  const Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [10, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, -1], leader: 0, speed: 1, radius: 0.2}\n"
      "walls: [[[8, 0.5], [12, 0.5]]]\n");
  EXPECT_NEAR((agent(episode, 1).goal() - Vector2(10.0, -0.65)).norm(), 0.0, 1e-12);
}

/// A follower that is there first waits for its leader, which waits at a place of its route.
TEST(Followers, StayUntilTheLeaderGoesOn) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], route: tour, speed: 1, radius: 0.2}\n"
      "  - {position: [1, 1], leader: 0, speed: 1, radius: 0.2}\n"
      "routes: {tour: {waypoints: [{place: [4, 0], wait: 20}, {place: [0, 0]}]}}\n");
  walkUntil(15.0, episode);
  EXPECT_TRUE(agent(episode, 1).at_goal);
  EXPECT_TRUE(agent(episode, 1).isWalking());
  while (!episode.isOver()) step(episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
  EXPECT_TRUE(episode.result().agents.at(1).arrived);
}

/// The robot stands at (5, 0) and faces the x axis. Behind it is the place 0.3 + 0.2 + 0.8 m away.
TEST(Followers, FollowARobot) {
  Episode episode = episodeOf(
      "robots: [{name: guide, position: [5, 0], goal: [15, 0], radius: 0.3, max_speed: 1}]\n"
      "agents: [{position: [0, 0], leader: {robot: guide}, speed: 1, radius: 0.2}]\n",
      60.0);
  EXPECT_NEAR((agent(episode, 0).goal() - Vector2(3.7, 0.65)).norm(), 0.0, 1e-9);
  walkUntil(10.0, episode);
  EXPECT_TRUE(agent(episode, 0).isWalking());
  episode.robots().teleport(0, {{5.0, 4.0}, 0.0});
  step(episode);
  EXPECT_NEAR((agent(episode, 0).goal() - Vector2(3.7, 4.65)).norm(), 0.0, 1e-9);
  episode.robots().teleport(0, {{15.0, 0.0}, 0.0});
  while (!episode.isOver()) step(episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
}

/// The leader stops at a window. Its follower waits beside it, and leaves the world after it.
TEST(Followers, WaitAtAttractions) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [20, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2}\n"
      "attractions: {window: {area: [8, 2], radius: 3, share: 1, wait: 20}}\n");
  while (!agent(episode, 0).isHeldBy(Hold::ATTRACTION)) step(episode);
  const double begin = episode.world().time();
  while (agent(episode, 0).isHeldBy(Hold::ATTRACTION)) step(episode);
  EXPECT_NEAR(episode.world().time() - begin, 20.0, 0.5);
  EXPECT_TRUE(agent(episode, 1).isWalking());
  EXPECT_LT((agent(episode, 1).pose.position - Vector2(8.0, 2.0)).norm(), 1.0);
  while (!episode.isOver()) step(episode);
  EXPECT_TRUE(episode.result().agents.at(1).arrived);
}

TEST(Followers, AGoalOfAUserEndsIt) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [10, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2}\n");
  episode.edit().setGoal(1, {0.0, 3.0});
  EXPECT_EQ(agent(episode, 1).group, NO_GROUP);
  EXPECT_EQ(agent(episode, 1).wanted_speed, 1.0);
  walkUntil(5.0, episode);
  EXPECT_TRUE(agent(episode, 1).hasArrived());
}

/// A leader that gets a goal keeps its group while somebody follows it.
TEST(Followers, WithoutThemALeaderLeavesItsGroup) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [10, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2}\n"
      "  - {position: [0, -1], leader: 0, speed: 1, radius: 0.2}\n");
  episode.edit().removeAgent(1);
  episode.edit().setGoal(0, {0.0, 30.0});
  EXPECT_EQ(agent(episode, 0).group, 0U);
  episode.edit().removeAgent(2);
  episode.edit().setGoal(0, {0.0, 20.0});
  EXPECT_EQ(agent(episode, 0).group, NO_GROUP);
}

/// Groups of three, one after the other: agents 0, 3, 6 lead, and the others appear at once beside them.
TEST(Followers, SourcesLetGroupsAppear) {
  Episode episode = episodeOf(
      "sources:\n"
      "  - {area: {box: [[0, -5], [2, 5]]}, rate: 0.5, interval: regular, count: 9, goal: [30, 0], speed: 1,\n"
      "     radius: 0.2, groups: {share: 1, sizes: {3: 1}}}\n");
  std::set<std::uint64_t> starts;
  for (AgentId id = 0; id < 9;) {
    for (; id < episode.world().enteredCount(); ++id) {
      EXPECT_EQ(agent(episode, id).group, id / 3 * 3) << id;
      starts.insert(episode.world().tick());
      const Vector2 offset = agent(episode, id).pose.position - agent(episode, id / 3 * 3).pose.position;
      EXPECT_LE(offset.norm(), 0.4 + 0.8 + 1e-9) << id;
    }
    ASSERT_FALSE(episode.isOver());
    step(episode);
  }
  EXPECT_EQ(starts, (std::set<std::uint64_t>{0, 12, 24}));  // every 6 s, ticks of 0.5 s
  while (!episode.isOver()) step(episode);
  for (AgentId id = 0; id < 9; ++id) EXPECT_TRUE(episode.result().agents.at(id).arrived) << id;
}

TEST(Followers, DocumentsKeepGroups) {
  const std::string text =
      "agents:\n"
      "  - {count: 6, position: {box: [[0, 0], [9, 9]]}, goal: [20, 5], speed: 1, radius: 0.2, groups: {share: 1}}\n"
      "  - {position: [0, 20], goal: [9, 20], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 21], goal: [9, 21], speed: 1, radius: 0.2}\n"
      "  - {position: [-2, 0], leader: {robot: r}, speed: 1, radius: 0.2}\n"
      "robots: [{name: r, position: [-5, 0], radius: 0.3, max_speed: 1}]\n"
      "groups: [{members: [6, 7]}]\n"
      "sources: [{area: [0, 40], rate: 1, goal: [9, 40], speed: 1, radius: 0.2, groups: {share: 0.4, sizes: {2: "
      "1}}}]\n";
  const Scene scene = sceneOf(text);
  const ScenarioList read = parseScenarios(toDocument(scene, "."), "s.yaml");
  const Scene again = read.scene(1, 0);
  ASSERT_EQ(again.agents.size(), scene.agents.size());
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    EXPECT_EQ(again.agents[i].group, scene.agents[i].group) << i;
    EXPECT_EQ(again.agents[i].leader.has_value(), scene.agents[i].leader.has_value()) << i;
  }
  EXPECT_EQ(again.agents[7].group, 6U);
  EXPECT_EQ(again.agents[8].leader->kind, Leader::Kind::ROBOT);
  EXPECT_EQ(toDocument(again, "."), toDocument(scene, "."));
}

}  // namespace
}  // namespace crowd::followers_test
