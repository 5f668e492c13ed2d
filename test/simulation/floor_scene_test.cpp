#include "simulation/floor_scene.h"

#include <gtest/gtest.h>

#include "scenario/writing/scene_document.h"
#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::floor_scene_test {
namespace {

/// What a reader of the saved document gets.
Scene savedAndRead(const Episode& episode) {
  return parseScenarios(toDocument(sceneOnFloor(episode, false), "."), "saved.yaml").scene(1, 0);
}

/// Agent 0 is removed, so that all others get lower numbers.
TEST(FloorScene, KeepsLeadersAndGroups) {
  Episode episode = straight_walk::episodeOf(
      "agents:\n"
      "  - {position: [0, 9], goal: [30, 9], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 0], goals: [[10, 0], [30, 0]], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 1, speed: 1, radius: 0.2}\n"
      "  - {position: [0, 4], goal: [30, 4], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 5], goal: [30, 5], speed: 1, radius: 0.2}\n"
      "  - {position: [-3, 0], leader: {robot: guide}, speed: 1, radius: 0.2}\n"
      "groups: [{members: [3, 4]}]\n"
      "robots: [{name: guide, position: [-5, 0], radius: 0.3, max_speed: 1}]\n");
  episode.edit().removeAgent(0);
  straight_walk::walkUntil(3.0, episode);
  const Scene scene = sceneOnFloor(episode, false);
  ASSERT_EQ(scene.agents.size(), 5U);
  ASSERT_TRUE(scene.agents[1].leader);
  EXPECT_EQ(scene.agents[1].leader->kind, Leader::Kind::AGENT);
  EXPECT_EQ(scene.agents[1].leader->number, 0U);
  EXPECT_EQ(scene.agents[0].group, 0U);
  EXPECT_EQ(scene.agents[1].group, 0U);
  EXPECT_EQ(scene.agents[2].group, 2U);
  EXPECT_EQ(scene.agents[3].group, 2U);
  EXPECT_FALSE(scene.agents[3].leader);
  ASSERT_TRUE(scene.agents[4].leader);
  EXPECT_EQ(scene.agents[4].leader->kind, Leader::Kind::ROBOT);
}

/// A follower whose leader was removed since the last tick is saved with its own goals.
TEST(FloorScene, KeepsFollowersOfARemovedLeader) {
  Episode episode = straight_walk::episodeOf(
      "agents:\n"
      "  - {position: [0, 0], goal: [30, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2}\n");
  straight_walk::walkUntil(3.0, episode);
  episode.edit().removeAgent(0);
  const Scene scene = sceneOnFloor(episode, false);
  ASSERT_EQ(scene.agents.size(), 1U);
  EXPECT_FALSE(scene.agents[0].leader);
  EXPECT_NEAR(scene.agents[0].goals.front().x(), 30.0, 1e-9);
  const Scene again = savedAndRead(episode);
  ASSERT_EQ(again.agents.size(), 1U);
  EXPECT_EQ(again.agents[0].group, NO_GROUP);
  EXPECT_EQ(again.agents[0].goals, scene.agents[0].goals);
}

/// Of a pair one has arrived and left, or stays; of three, two are still on their way.
TEST(FloorScene, GroupsOfOneAreNoGroups) {
  for (const char* const arrived : {"leave", "stay"}) {
    Episode episode = straight_walk::episodeOf(
        "agents:\n"
        "  - {position: [0, 0], goal: [1, 0], speed: 1, radius: 0.2}\n"
        "  - {position: [0, 3], goal: [30, 3], speed: 1, radius: 0.2}\n"
        "  - {position: [0, 10], goal: [1, 10], speed: 1, radius: 0.2}\n"
        "  - {position: [0, 13], goal: [30, 13], speed: 1, radius: 0.2}\n"
        "  - {position: [0, 14], goal: [30, 14], speed: 1, radius: 0.2}\n"
        "groups: [{members: [0, 1]}, {members: [2, 3, 4]}]\n"
        "arrived: " +
        std::string(arrived) + "\n");
    straight_walk::walkUntil(5.0, episode);
    const Scene again = savedAndRead(episode);
    ASSERT_EQ(again.agents.size(), 3U) << arrived;
    EXPECT_EQ(again.agents[0].group, NO_GROUP) << arrived;
    EXPECT_EQ(again.agents[1].group, 1U) << arrived;
    EXPECT_EQ(again.agents[2].group, 1U) << arrived;
  }
}

/// Both have the same goal, in which an obstacle would be refused. Agent 0 arrives in tick 2, agent 1 is 4 m away.
TEST(FloorScene, LeavesOutAgentsThatStay) {
  Episode episode = straight_walk::episodeOf(
      "arrived: stay\n"
      "agents:\n"
      "  - {position: [0, 0], goal: [1, 0], speed: 1, radius: 0.25}\n"
      "  - {position: [7, 0], goal: [1, 0], speed: 1, radius: 0.25}\n"
      "obstacles: [{position: [9, 9], radius: 0.4}]\n");
  EXPECT_EQ(leftOutText(episode.world()), "");
  straight_walk::walkUntil(2.0, episode);
  ASSERT_EQ(episode.world().agents()[0].status, AgentStatus::STAYING);
  EXPECT_EQ(leftOutText(episode.world()), ", without 1 agent at the last goal");
  const Scene again = savedAndRead(episode);
  EXPECT_EQ(again.arrived, Arrived::STAY);
  ASSERT_EQ(again.agents.size(), 1U);
  EXPECT_LT((again.agents[0].position - Vector2(5.0, 0.0)).norm(), 1e-9);
  EXPECT_TRUE(again.agents[0].stays);
  ASSERT_EQ(again.obstacles.size(), 1U);
  EXPECT_EQ(again.obstacles[0].radius, 0.4);
}

}  // namespace
}  // namespace crowd::floor_scene_test
