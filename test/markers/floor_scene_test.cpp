#include "ros/markers/floor_scene.h"

#include <gtest/gtest.h>

#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::floor_scene_test {
namespace {

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
}

/// They cannot start at their goals, so they are obstacles at rest, before the others.
TEST(FloorScene, AgentsThatStayAreObstacles) {
  Episode episode = straight_walk::episodeOf(
      "arrived: stay\n"
      "agents:\n"
      "  - {position: [0, 0], goal: [1, 0], speed: 1, radius: 0.2}\n"
      "  - {position: [0, 3], goal: [30, 3], speed: 1, radius: 0.2}\n"
      "obstacles: [{position: [9, 9], radius: 0.4}]\n");
  straight_walk::walkUntil(3.0, episode);
  const Scene scene = sceneOnFloor(episode, false);
  EXPECT_EQ(scene.arrived, Arrived::STAY);
  ASSERT_EQ(scene.agents.size(), 1U);
  EXPECT_TRUE(scene.agents[0].stays);
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(scene.obstacles[0].path.position(7.0), Vector2(1.0, 0.0));
  EXPECT_EQ(scene.obstacles[0].radius, 0.2);
  EXPECT_EQ(scene.obstacles[1].radius, 0.4);
}

}  // namespace
}  // namespace crowd::floor_scene_test
