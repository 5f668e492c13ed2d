#include "population/facing.h"

#include <gtest/gtest.h>

#include <string>

#include "support/straight_walk.h"

namespace crowd::facing_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// It reaches x = 2 after 2 s with a heading of 0, stands after 2.5 s, and waits until 12 s.
Episode waiting(const std::string& face, const std::string& further_keys = "") {
  return episodeOf(
      "agents: [{position: [0, 0], route: tour, speed: 1, radius: 0.2}]\nroutes: {tour: {waypoints: "
      "[{place: [2, 0], wait: 10, face: " +
      face + "}, {place: [9, 0]}]}}\n" + further_keys);
}

double degrees(const Episode& episode, AgentId id = 0) { return toDegrees(episode.world().agents()[id].pose.heading); }

TEST(Facing, APersonWhoStandsTurnsBy180DegreesASecond) {
  Episode episode = waiting("135");
  walkUntil(2.0, episode);
  EXPECT_EQ(degrees(episode), 0.0);
  step(episode);
  EXPECT_NEAR(degrees(episode), 90.0, 1e-12);
  step(episode);
  EXPECT_EQ(episode.world().agents()[0].pose.heading, toRadians(135.0));
  EXPECT_EQ(episode.world().agents()[0].ahead, unitVector(toRadians(135.0)));
  walkUntil(11.5, episode);
  EXPECT_EQ(episode.world().agents()[0].pose.heading, toRadians(135.0));
  EXPECT_EQ(episode.world().agents()[0].pose.position, Vector2(2.0, 0.0));
  walkUntil(13.0, episode);
  EXPECT_EQ(degrees(episode), 0.0);  // it walks on
  EXPECT_EQ(episode.world().agents()[0].pose.position, Vector2(3.0, 0.0));
}

TEST(Facing, TurnsTheShorterWay) {
  Episode episode = waiting("-120");
  walkUntil(2.5, episode);
  EXPECT_NEAR(degrees(episode), -90.0, 1e-12);
  Episode far_round = waiting("660");  // 300, or -60 degrees
  walkUntil(2.5, far_round);
  EXPECT_NEAR(degrees(far_round), -60.0, 1e-9);
}

TEST(Facing, APoint) {
  Episode episode = waiting("[2, -7]");
  walkUntil(4.0, episode);
  EXPECT_NEAR(degrees(episode), -90.0, 1e-12);
}

TEST(Facing, NowhereFromThePointItself) {
  Episode episode = waiting("[2, 0]");
  walkUntil(4.0, episode);
  EXPECT_EQ(degrees(episode), 0.0);
}

/// A robot that is put above the agent, and then behind it.
TEST(Facing, ARobotThatMoves) {
  Episode episode =
      waiting("{robot: rob}", "robots: [{name: rob, position: [2, 5], radius: 0.3, max_speed: 1, perceived: false}]\n");
  walkUntil(4.0, episode);
  EXPECT_NEAR(degrees(episode), 90.0, 1e-12);
  episode.edit().teleportRobot(0, {{-4.0, 0.0}, 0.0});
  step(episode);
  EXPECT_NEAR(std::abs(degrees(episode)), 180.0, 1e-9);
}

/// Of agents with mass the turn rate is that of the scenario, and they turn only when they have come to rest.
TEST(Facing, MotionLimits) {
  Episode episode = waiting("90", "motion: {acceleration: 2, braking: 1, turn_rate: 0.5}\n");
  const Agent& agent = episode.world().agents()[0];
  while (!agent.isHeld()) step(episode);
  ASSERT_NE(agent.velocity, Vector2(Vector2::Zero()));
  EXPECT_EQ(agent.pose.heading, 0.0);
  step(episode);
  ASSERT_EQ(agent.velocity, Vector2(Vector2::Zero()));
  EXPECT_NEAR(agent.pose.heading, 0.25, 1e-12);
  step(episode);
  EXPECT_NEAR(agent.pose.heading, 0.5, 1e-12);
}

/// The second one in line looks ahead, along the line.
TEST(Facing, TheHeadOfAQueue) {
  Episode episode = episodeOf(
      "agents:\n"
      "  - {position: [0, 0], route: buy, speed: 1, radius: 0.2}\n"
      "  - {position: [-1, 0], route: buy, speed: 1, radius: 0.2}\n"
      "routes: {buy: {waypoints: [{queue: till}, {place: [9, 0]}]}}\n"
      "queues: {till: {head: [3, 0], direction: 180, spacing: 1, service: 10, face: 90}}\n");
  walkUntil(6.0, episode);
  EXPECT_NEAR(degrees(episode, 0), 90.0, 1e-12);
  EXPECT_NEAR(degrees(episode, 1), 0.0, 1e-9);
}

}  // namespace
}  // namespace crowd::facing_test
