#include "population/robot_reactions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenario/writing/scene_document.h"
#include "simulation/episode.h"
#include "support/straight_walk.h"

namespace crowd::robot_reactions_test {
namespace {

using straight_walk::episodeOf;
using straight_walk::step;
using straight_walk::walkUntil;

/// An agent that walks along the x axis at 1 m/s.
std::string walker(const std::string& reaction, const std::string& goal = "goal: [20, 0]") {
  return "agents: [{position: [0, 0], " + goal + ", speed: 1, radius: 0.2, reaction: " + reaction + "}]\n";
}

/// A robot that stands.
std::string robotAt(const std::string& place, const std::string& keys = "heading: 0") {
  return "robots: [{name: r, position: " + place + ", radius: 0.3, max_speed: 1, " + keys + "}]\n";
}

const Agent& person(const Episode& episode) { return episode.world().agents()[0]; }

/// The bearing of the robot as the person sees it [rad].
double bearingOfRobot(const Episode& episode) {
  const Vector2 way = episode.world().robots()[0].pose.position - person(episode).pose.position;
  return wrapAngle(bearingOf(way) - person(episode).pose.heading);
}

double gapToRobot(const Episode& episode) {
  const Robot& robot = episode.world().robots()[0];
  return (robot.pose.position - person(episode).pose.position).norm() - robot.perceived_radius - 0.2;
}

/// The robot is 4 m away after 6.13 s; ticks take 0.5 s.
TEST(RobotReactions, TheSurprisedStopAndLook) {
  Episode episode = episodeOf(walker("surprised") + robotAt("[10, 1]"));
  walkUntil(6.0, episode);
  EXPECT_FALSE(person(episode).isHeld());
  step(episode);
  EXPECT_TRUE(person(episode).isHeldBy(Hold::REACTION));
  walkUntil(8.0, episode);
  EXPECT_NEAR(bearingOfRobot(episode), 0.0, 1e-9);
  walkUntil(36.0, episode);
  EXPECT_EQ(person(episode).pose.position, Vector2(6.5, 0.0));
  step(episode);
  EXPECT_FALSE(person(episode).isHeld());
  walkUntil(100.0, episode);
  EXPECT_EQ(person(episode).arrival_tick, 2U * (20U + 30U));
}

TEST(RobotReactions, OnceForEachEncounter) {
  Episode episode = episodeOf(walker("surprised", "route: rounds") + robotAt("[10, 1]") +
                                  "routes: {rounds: {repeat: true, waypoints: [{place: [12, 0]}, {place: [8, 0]}, "
                                  "{place: [20, 0]}, {place: [0, "
                                  "0]}]}}\n",
                              190.0);
  std::vector<double> stops;
  bool stood = false;
  while (!episode.isOver()) {
    step(episode);
    const bool stands = person(episode).isHeldBy(Hold::REACTION);
    if (stands && !stood) stops.push_back(person(episode).pose.position.x());
    stood = stands;
  }
  // From the left, not between 12 and 8, after the turn at 20 from the right, and both again.
  ASSERT_EQ(stops.size(), 4U);
  EXPECT_NEAR(stops[0], 6.5, 1e-9);
  EXPECT_NEAR(stops[1], 13.8, 0.4);
  EXPECT_NEAR(stops[2], 6.3, 0.4);
  EXPECT_NEAR(stops[3], 13.8, 0.4);
}

TEST(RobotReactions, TheCuriousApproachSlowlyFollowAndGoOn) {
  Episode episode = episodeOf(walker("curious") + robotAt("[8, 0]"));
  step(episode);
  EXPECT_NEAR(person(episode).wanted_speed, 0.6, 1e-12);
  walkUntil(14.0, episode);
  EXPECT_TRUE(person(episode).isHeldBy(Hold::REACTION));
  EXPECT_GE(gapToRobot(episode), 1.2 - 1e-9);
  EXPECT_LE(gapToRobot(episode), 1.5);
  episode.robots().teleport(0, {{8.0, 3.0}, 0.0});
  walkUntil(22.0, episode);
  EXPECT_TRUE(person(episode).isHeldBy(Hold::REACTION));
  EXPECT_LE(gapToRobot(episode), 1.5);
  EXPECT_NEAR(bearingOfRobot(episode), 0.0, 1e-9);
  walkUntil(30.5, episode);
  EXPECT_FALSE(person(episode).isHeld());
  EXPECT_EQ(person(episode).goal(), Vector2(20.0, 0.0));
  EXPECT_EQ(person(episode).wanted_speed, 1.0);
  walkUntil(100.0, episode);
  EXPECT_TRUE(person(episode).hasArrived());
}

/// From x = 5 back until the robot is 4.5 m away, for a tick at 1 m/s and two at 1.3 m/s.
TEST(RobotReactions, TheScaredWalkAwayFaster) {
  Episode episode = episodeOf(walker("scared") + robotAt("[8, 0]"));
  walkUntil(5.0, episode);
  EXPECT_NEAR((person(episode).goal() - Vector2(3.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(person(episode).wanted_speed, 1.3, 1e-12);
  walkUntil(6.5, episode);
  EXPECT_NEAR(person(episode).pose.position.x(), 5.0 - 0.5 - 2.0 * 0.65, 1e-9);
  EXPECT_EQ(person(episode).goal(), Vector2(20.0, 0.0));
  EXPECT_EQ(person(episode).wanted_speed, 1.0);
  episode.robots().teleport(0, {{8.0, 9.0}, 0.0});
  walkUntil(100.0, episode);
  EXPECT_TRUE(person(episode).hasArrived());
}

/// A corridor of 1 m with an end.
TEST(RobotReactions, TheScaredGoOnWithoutRoomToFlee) {
  Episode episode = episodeOf(walker("scared") + robotAt("[2.5, 0]") +
                              "walls: [[[-1, -0.5], [30, -0.5]], [[-1, 0.5], [30, 0.5]], [[-1, -0.5], [-1, 0.5]]]\n");
  step(episode);
  EXPECT_EQ(person(episode).goal(), Vector2(20.0, 0.0));
  EXPECT_NEAR(person(episode).wanted_speed, 1.3, 1e-12);
  episode.robots().teleport(0, {{2.5, 9.0}, 0.0});
  step(episode);
  EXPECT_EQ(person(episode).wanted_speed, 1.0);
  walkUntil(100.0, episode);
  EXPECT_TRUE(person(episode).hasArrived());
}

TEST(RobotReactions, TheThreateningStandInTheWay) {
  Episode episode = episodeOf(walker("threatening") + robotAt("[4, 3]", "heading: -90"));
  walkUntil(10.0, episode);
  EXPECT_TRUE(person(episode).isHeldBy(Hold::REACTION));
  EXPECT_NEAR(gapToRobot(episode), 0.6, 0.3 + 1e-9);
  EXPECT_NEAR(person(episode).pose.position.x(), 4.0, 0.3);
  EXPECT_LT(person(episode).pose.position.y(), 3.0);
  EXPECT_NEAR(bearingOfRobot(episode), 0.0, 1e-9);
  walkUntil(50.0, episode);
  EXPECT_FALSE(person(episode).isHeld());
  EXPECT_EQ(person(episode).goal(), Vector2(20.0, 0.0));
}

/// The robot drives along the x axis at 0.5 m/s; the person keeps in front of it.
TEST(RobotReactions, TheThreateningStayInFrontOfARobotThatDrives) {
  Episode episode = episodeOf(walker("threatening", "goal: [40, 0]") + robotAt("[3, 2]", "drive: holonomic"));
  while (episode.world().time() < 20.0) {
    episode.robots().command(0, {{0.5, 0.0}, 0.0});
    step(episode);
    if (episode.world().time() < 8.0) continue;
    EXPECT_GT(person(episode).pose.position.x(), episode.world().robots()[0].pose.position.x());
    EXPECT_LE(gapToRobot(episode), 0.6 + 0.3 + 0.5);
  }
}

std::vector<double> pathOf(const std::string& keys) {
  std::vector<double> path;
  Episode episode = episodeOf(keys, 30.0);
  while (!episode.isOver()) {
    step(episode);
    path.insert(path.end(), {person(episode).pose.position.x(), person(episode).pose.heading});
  }
  return path;
}

TEST(RobotReactions, NobodyReactsToWhatNobodySees) {
  const std::vector<double> regular = pathOf(walker("regular") + robotAt("[10, 1]"));
  EXPECT_EQ(pathOf(walker("indifferent") + robotAt("[10, 1]")), regular);
  for (const std::string reaction : {"surprised", "curious", "scared", "threatening"}) {
    EXPECT_NE(pathOf(walker(reaction) + robotAt("[10, 1]")), regular) << reaction;
    EXPECT_EQ(pathOf(walker(reaction)), regular) << reaction;
    EXPECT_EQ(pathOf(walker(reaction) + robotAt("[10, 1]", "perceived: false")), regular) << reaction;
    EXPECT_EQ(pathOf(walker(reaction) + robotAt("[-1, 0]")), regular) << reaction;
    EXPECT_EQ(pathOf(walker(reaction) + robotAt("[10, 1]") + "walls: [[[-9, 0.5], [30, 0.5]]]\n"), regular) << reaction;
    EXPECT_EQ(pathOf(walker(reaction) + robotAt("[10, 10.5]")), regular) << reaction;
  }
}

TEST(RobotReactions, GoalsRoutesAndAlarmsEndThem) {
  const std::string keys = robotAt("[8, 0]") +
                           "routes: {back: {waypoints: [{place: [0, 9]}]}}\n"
                           "sinks: {exit: {area: [0, -9]}}\n";
  for (const std::string reaction : {"surprised", "curious", "scared", "threatening"}) {
    Episode by_goal = episodeOf(walker(reaction) + keys);
    walkUntil(5.5, by_goal);
    by_goal.edit().setGoal(0, {-5.0, 0.0});
    EXPECT_FALSE(person(by_goal).isHeld()) << reaction;
    EXPECT_EQ(person(by_goal).goals, std::vector<Vector2>{Vector2(-5.0, 0.0)}) << reaction;
    EXPECT_EQ(person(by_goal).wanted_speed, 1.0) << reaction;
    Episode by_route = episodeOf(walker(reaction) + keys);
    walkUntil(5.5, by_route);
    by_route.edit().setRoute(0, "back");
    walkUntil(100.0, by_route);
    EXPECT_TRUE(person(by_route).hasArrived()) << reaction;
    Episode by_alarm = episodeOf(walker(reaction) + keys + "alarms: [{time: 5.5, area: all, sink: exit}]\n");
    walkUntil(5.5, by_alarm);
    EXPECT_FALSE(person(by_alarm).isHeld()) << reaction;
    EXPECT_EQ(person(by_alarm).goal(), Vector2(0.0, -9.0)) << reaction;
    walkUntil(100.0, by_alarm);
    EXPECT_TRUE(person(by_alarm).hasArrived()) << reaction;
  }
}

/// The follower keeps its goal beside that of its leader.
TEST(RobotReactions, FollowersStayWithTheirLeader) {
  for (const std::string reaction : {"curious", "scared", "threatening"}) {
    Episode episode = episodeOf(
        "agents:\n"
        "  - {position: [0, 0], goal: [20, 0], speed: 1, radius: 0.2}\n"
        "  - {position: [0, 1], leader: 0, speed: 1, radius: 0.2, reaction: " +
        reaction + "}\n" + robotAt("[8, 2]"));
    double fastest = 0.0;
    const Vector2 goal = episode.world().agents()[1].goal();
    for (int tick = 0; tick < 20; ++tick) {
      step(episode);
      EXPECT_EQ(episode.world().agents()[1].goal(), goal) << reaction;
      fastest = std::max(fastest, episode.world().agents()[1].paceOf(Pace::REACTION));
    }
    EXPECT_EQ(fastest, reaction == "scared" ? 1.3 : 1.0);
  }
}

TEST(RobotReactions, PeopleInLineDoNotReact) {
  Episode episode = episodeOf(walker("threatening", "route: buy") + robotAt("[8, 0]") +
                              "routes: {buy: {waypoints: [{queue: till}, {place: [20, 0]}]}}\n"
                              "queues: {till: {head: [6, 0], direction: 180, spacing: 1, service: 3}}\n");
  walkUntil(8.0, episode);
  EXPECT_EQ(person(episode).pose.position, Vector2(6.0, 0.0));
  walkUntil(10.0, episode);
  EXPECT_NE(person(episode).goal(), Vector2(20.0, 0.0));  // it was served first
}

/// Three shares of 1200 agents; standard deviations are below 1.5 %.
TEST(RobotReactions, SharesAreDrawnAndWrittenBack) {
  const std::string keys =
      "agents: [{count: 1200, position: {box: [[0, 0], [90, 90]]}, goal: [99, 99], speed: 1, radius: 0.1, "
      "reaction: {regular: 5, curious: 3, scared: 2}}]\n"
      "sources: [{area: [95, 5], rate: 1, goal: [99, 99], speed: 1, radius: 0.2, reaction: {surprised: 1, "
      "indifferent: 2}}]\n";
  const Scene scene = straight_walk::sceneOf(keys);
  std::vector<int> counts(REACTIONS.names().size());
  for (const AgentStart& agent : scene.agents) ++counts[static_cast<std::size_t>(agent.reaction)];
  EXPECT_NEAR(counts[0] / 1200.0, 0.5, 0.06);
  EXPECT_NEAR(counts[3] / 1200.0, 0.3, 0.06);
  EXPECT_NEAR(counts[4] / 1200.0, 0.2, 0.06);
  EXPECT_EQ(counts[0] + counts[3] + counts[4], 1200);
  const std::string text = toDocument(scene, ".");
  EXPECT_NE(text.find("reaction: {surprised: 1, indifferent: 2}"), std::string::npos);
  const Scene again = parseScenarios(text, "s.yaml").scene(1, 0);
  EXPECT_EQ(toDocument(again, "."), text);
  for (std::size_t i = 0; i < 1200; ++i) EXPECT_EQ(again.agents[i].reaction, scene.agents[i].reaction) << i;
}

TEST(RobotReactions, PeopleOfSourcesReact) {
  Episode episode =
      episodeOf("sources: [{area: [0, 0], times: [1], goal: [20, 0], speed: 1, radius: 0.2, reaction: surprised}]\n" +
                robotAt("[10, 1]"));
  walkUntil(9.0, episode);
  EXPECT_TRUE(person(episode).isHeldBy(Hold::REACTION));
}

}  // namespace
}  // namespace crowd::robot_reactions_test
