#include "navigation/way_lengths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/error_of.h"
#include "support/straight_walk.h"
#include "support/worlds.h"

namespace crowd::way_lengths_test {
namespace {

using straight_walk::actions;
using straight_walk::episodeOf;
using straight_walk::sceneOf;
using straight_walk::walkUntil;

constexpr double RADIUS = 0.2;

/// A room of 10 m x 10 m. A wall on the line x = 0 leaves a gap above y = 3; a cell of 2 m x 2 m is closed.
const char* const ROOM =
    "contact: solid\n"
    "walls: [[[-5, -5], [5, -5]], [[5, -5], [5, 5]], [[5, 5], [-5, 5]], [[-5, 5], [-5, -5]], [[0, -5], [0, 3]],\n"
    "        [[5, -3], [3, -3]], [[3, -3], [3, -5]]]\n";
const char* const LEFT = "agents: [{position: [-2, -4], goal: [-2, 4], speed: 1, radius: 0.2}]\n";
/// The gap is a gate that is closed until 30 s have passed.
const char* const GATE = "gates: {door: {wall: [[0, 3], [0, 5]], open: [[30, 900]]}}\n";

std::string agentTo(const std::string& goal) {
  return "agents: [{position: [-2, -4], goal: " + goal + ", speed: 1, radius: 0.2}]\n";
}

/// The least way is past the end of the wall, at (0, 3), with a distance of 0.2 m to 0.3 m.
TEST(WayLengths, LeadsRoundWalls) {
  const Scene scene = sceneOf(std::string(ROOM) + LEFT);
  WayLengths ways(scene);
  const auto way = ways.find(World(scene), {-2.0, -4.0}, {2.0, -4.0}, RADIUS);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->kind, WayLengths::Kind::FREE);
  EXPECT_GT(way->length, 2.0 * std::hypot(2.0, 7.0));
  EXPECT_LT(way->length, 2.0 * (std::hypot(2.0, 7.3) + 0.3));
}

TEST(WayLengths, IsTheStraightLineWithoutWalls) {
  const Scene scene = sceneOf(LEFT);
  const auto way = WayLengths(scene).find(World(scene), {0.0, 0.0}, {3.0, 4.0}, RADIUS);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->length, 5.0);
}

TEST(WayLengths, PrefersWaysWithoutGates) {
  const Scene scene = sceneOf(std::string(ROOM) + LEFT + GATE);
  Episode episode(scene, 0, Vision());  // closes the gate
  WayLengths ways(scene);
  const auto near = ways.find(episode.world(), {-2.0, -4.0}, {-2.0, -3.0}, RADIUS);
  const auto behind = ways.find(episode.world(), {-2.0, -4.0}, {2.0, -4.0}, RADIUS);
  ASSERT_TRUE(near && behind);
  EXPECT_EQ(near->kind, WayLengths::Kind::FREE);
  EXPECT_EQ(behind->kind, WayLengths::Kind::GATES);
  EXPECT_TRUE(*near < *behind);
  EXPECT_TRUE((WayLengths::Way{WayLengths::Kind::FREE, 9.0} < WayLengths::Way{WayLengths::Kind::GATES, 1.0}));
  EXPECT_FALSE(ways.find(episode.world(), {-2.0, -4.0}, {4.0, -4.0}, RADIUS));
}

TEST(WayLengths, RefusesGoalsThatNoWayLeadsTo) {
  const Scene scene = sceneOf(std::string(ROOM) + LEFT + "obstacles: [{position: [-3, 0], radius: 0.5}]\n");
  const World world(scene);
  WayLengths ways(scene);
  const auto refusal = [&](const Vector2& goal) {
    return errorOf<InputError>([&] { ways.requireWay("agent 3", world, {-2.0, -4.0}, goal, RADIUS); });
  };
  EXPECT_EQ(refusal({4.0, -4.0}), "agent 3: the goal (4, -4) cannot be reached from (-2, -4) with a radius of 0.2 m");
  EXPECT_EQ(refusal({9.0, 0.0}), "agent 3: the goal (9, 0) cannot be reached from (-2, -4) with a radius of 0.2 m");
  EXPECT_EQ(refusal({0.05, 1.0}), "agent 3: the goal (0.05, 1) is in a wall");
  EXPECT_EQ(refusal({-3.0, 0.2}), "agent 3: the goal (-3, 0.2) is in obstacle 0");
  EXPECT_EQ(refusal({2.0, -4.0}), "no error");
  EXPECT_EQ(refusal({0.15, 1.0}), "no error");  // the agent arrives 0.1 m before it
}

/// A wall on the line x = 0 has a gap of 0.8 m at y = 0, for agents of up to 0.3 m, and one of 3 m at y = 7.
TEST(Reach, WaysAreForTheSizeOfEachAgent) {
  const std::string keys =
      "walls: [[[0, -20], [0, -0.4]], [[0, 0.4], [0, 5.5]], [[0, 8.5], [0, 20]]]\n"
      "agents:\n"
      "  - {position: [-2, 0.5], goal: [2, 0.5], speed: 1, radius: 0.2}\n"
      "  - {position: [-4, 0.5], goal: [4, 0.5], speed: 1, radius: 0.4}\n"
      "sources: [{area: [-9, 0], times: [900], goal: [-5, 0], speed: 1, radius: [0.2, 0.5]}]\n";
  const Episode episode = episodeOf(keys);
  EXPECT_LT(episode.world().agents()[0].perceivedGoal().y(), 0.5);
  EXPECT_GT(episode.world().agents()[1].perceivedGoal().y(), 5.0);
  const Scene scene = sceneOf(keys);
  const World world(scene);
  WayLengths ways(scene);
  const auto length = [&](double radius) { return ways.find(world, {-2.0, 0.5}, {2.0, 0.5}, radius)->length; };
  EXPECT_LT(length(RADIUS), 4.5);
  EXPECT_GT(length(0.4), 2.0 * std::hypot(2.0, 5.0));
  EXPECT_LT(length(RADIUS), 4.5);
}

TEST(AgentSize, IsTheRadiusRoundedUp) {
  EXPECT_DOUBLE_EQ(sizeOf(0.2), 0.2);
  EXPECT_DOUBLE_EQ(sizeOf(0.2F), 0.2);  // slightly above
  EXPECT_DOUBLE_EQ(sizeOf(0.201), 0.25);
  EXPECT_DOUBLE_EQ(sizeOf(0.3), 0.3);
  EXPECT_DOUBLE_EQ(sizeOf(0.01), 0.05);
}

TEST(Reach, RefusedChangesChangeNothing) {
  Episode episode = episodeOf(std::string(ROOM) + LEFT + "routes: {cell: {waypoints: [{place: [4, -4]}]}}\n");
  walkUntil(1.0, episode);
  const std::vector<double> before = stateOf(episode.world());
  const auto expect = [&](const std::string& words, const auto& change) {
    EXPECT_NE(errorOf<InputError>(change).find(words), std::string::npos)
        << words << ": " << errorOf<InputError>(change);
    EXPECT_EQ(stateOf(episode.world()), before) << words;
  };
  const AgentStart caged{{4.0, -4.0}, 0.0, {{0.0, 4.0}}, 1.0, RADIUS};
  expect("agent 0: the goal (4, -4) cannot", [&] { episode.edit().setGoal(0, {4.0, -4.0}); });
  expect("agent 0, routes.cell.waypoints[0]: the goal (4, -4) cannot", [&] { episode.edit().setRoute(0, "cell"); });
  expect("from (4, -4)", [&] { episode.edit().teleport(0, {{4.0, -4.0}, 0.0}); });
  expect("the agent: the goal (0, 4) cannot", [&] { episode.edit().addAgent(caged); });
  expect("too large", [&] { episode.edit().setGoal(0, {1e6, 0.0}); });
  expect("too large", [&] { episode.edit().addWall({{1e6, 0.0}, {1e6, 1.0}}); });
  expect("too large", [&] { episode.edit().spawnObstacle({0.0, 1e6}, {0.0, 0.0}, 2.0); });
  expect("too large", [&] { episode.edit().replaceWalls({{{3e7, 0.0}, {3e7, 1.0}}}); });
  expect("goal [m]: expected a number from -1e+06 to 1e+06 m, got 1e+17", [&] {
    episode.edit().setGoal(0, {1e17, 0.0});
  });
  const AgentStart far_goal{{0.0, 3.0}, 0.0, {{0.0, -1.1e6}}, 1.0, RADIUS};
  expect("goal [m]: expected a number from -1e+06 to 1e+06 m, got -1100000",
         [&] { episode.edit().addAgent(far_goal); });
  expect("no agent 7", [&] { episode.edit().setGoal(7, {1.0, 1.0}); });
  walkUntil(20.0, episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
  EXPECT_EQ(episode.result().wayWarning(), "");
}

TEST(Reach, AnAgentStaysWhileItsGoalIsOutOfReach) {
  Episode episode = episodeOf(std::string(ROOM) + agentTo("[2, -4]"), 60.0);
  walkUntil(1.0, episode);
  const Vector2 place = episode.world().agents()[0].pose.position;
  const std::size_t wall = episode.edit().addWall({{0.0, 3.0}, {0.0, 5.0}});
  walkUntil(5.0, episode);
  EXPECT_EQ(episode.world().agents()[0].pose.position, place);
  EXPECT_EQ(episode.result().outOfReach(), std::vector<AgentId>{0});
  EXPECT_EQ(episode.result().wayWarning(), "1 agent has a goal out of reach (0)");
  episode.edit().removeWall(wall);
  EXPECT_TRUE(episode.result().outOfReach().empty());
  walkUntil(60.0, episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
}

TEST(Reach, AnAgentWaitsAtAClosedGate) {
  Episode episode = episodeOf(std::string(ROOM) + agentTo("[2, 4]") + GATE, 60.0);
  walkUntil(29.0, episode);
  const Vector2 place = episode.world().agents()[0].pose.position;
  EXPECT_TRUE(episode.result().outOfReach().empty());
  EXPECT_LT(place.x(), -RADIUS + 1e-9);
  EXPECT_LT((place - Vector2(0.0, 4.0)).norm(), 1.5);
  walkUntil(60.0, episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
}

TEST(Reach, AgentsOnAFloorThatIsTooLargeWalkWithoutWayFinding) {
  Episode episode = episodeOf(
      "walls: [[[1000000, 0], [1000000, 1]]]\n"
      "agents: [{position: [0, 0], goal: [4, 0], speed: 1, radius: 0.2}]\n");
  const std::string problem = episode.result().way_finding_problem;
  EXPECT_NE(problem.find("too large"), std::string::npos) << problem;
  EXPECT_NE(episode.result().wayWarning().find("way-finding was left out: "), std::string::npos);
  episode.edit().setGoal(0, {3.0, 0.0});
  walkUntil(10.0, episode);
  EXPECT_TRUE(episode.result().agents.at(0).arrived);
}

/// The east sink is 4 m away behind the wall, 15 m by the gap; the west one is 5.2 m away, north of the agent.
TEST(Reach, TheNearestSinkIsThatWithTheShortestWay) {
  const std::string keys = std::string(ROOM) +
                           "agents: [{position: [-2, -4], route: leave, speed: 1, radius: 0.2}]\n"
                           "routes: {leave: {waypoints: [{sink: nearest}]}}\n"
                           "sinks: {east: {area: [2, -4]}, west: {area: [-2, 1.2]}}\n";
  EXPECT_EQ(episodeOf(keys).world().agents()[0].goal(), Vector2(-2.0, 1.2));
  EXPECT_EQ(episodeOf(keys + "way_finding: false\n").world().agents()[0].goal(), Vector2(2.0, -4.0));
}

}  // namespace
}  // namespace crowd::way_lengths_test
