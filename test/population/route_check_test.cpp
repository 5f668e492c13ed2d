#include "population/changes/route_check.h"

#include <gtest/gtest.h>

#include <string>

#include "support/error_of.h"
#include "support/straight_walk.h"
#include "support/worlds.h"

namespace crowd::route_check_test {
namespace {

/// A room of 10 m x 10 m with a closed cell of 2 m x 2 m in its lower right corner, whose wall is on the lines x = 3
/// and y = -3, and a closed gate that separates x > 0, y > 2 from the rest.
const char* const ROOM =
    "contact: solid\n"
    "walls: [[[-5, -5], [5, -5]], [[5, -5], [5, 5]], [[5, 5], [-5, 5]], [[-5, 5], [-5, -5]],\n"
    "        [[5, -3], [3, -3]], [[3, -3], [3, -5]], [[0, 5], [0, 2]], [[2, 2], [5, 2]]]\n"
    "gates: {door: {wall: [[0, 2], [2, 2]], open: false}}\n"
    "agents: [{position: [-2, -4], goal: [-2, 4], speed: 1, radius: 0.2}]\n"
    "sinks: {cell: {area: {box: [[3.5, -4.5], [4.5, -3.5]]}}, edge: {area: {box: [[2, -4.5], [4.5, -3.5]]}}}\n"
    "queues: {till: {head: [4, -4], direction: 90, spacing: 0.5, service: 1}}\n";

/// What is said when agent 0, at (-2, -4), is to walk a route with these waypoints.
std::string refusalOf(const std::string& waypoints, const std::string& more = "") {
  Episode episode =
      straight_walk::episodeOf(ROOM + std::string("routes: {way: {waypoints: [") + waypoints + "]}}\n" + more);
  const std::vector<double> before = stateOf(episode.world());
  const std::string refusal = errorOf<InputError>([&] { episode.edit().setRoute(0, "way"); });
  EXPECT_TRUE(refusal == "no error" || stateOf(episode.world()) == before) << refusal;
  return refusal;
}

TEST(RouteCheck, AcceptsRoutesThatTheAgentCanWalk) {
  EXPECT_EQ(refusalOf("{place: [-4, -4]}, {place: {box: [[-4, 0], [-2, 2]]}}, {sink: edge}"), "no error");
  EXPECT_EQ(refusalOf("{place: [4, 4]}, {place: [-4, 4]}"), "no error");  // one waits at the gate
  EXPECT_EQ(refusalOf("{sink: nearest}"), "no error");
}

TEST(RouteCheck, NamesTheWaypointThatCannotBeReached) {
  const std::string end = " with a radius of 0.2 m";
  EXPECT_EQ(refusalOf("{place: [-4, 0]}, {place: [4, -4]}, {place: [-4, 4]}"),
            "agent 0, routes.way.waypoints[1]: the goal (4, -4) cannot be reached from (-4, 0)" + end);
  EXPECT_EQ(refusalOf("{place: [-4, 0]}, {one_of: [{place: [-4, 4]}, {place: [4, -4]}]}"),
            "agent 0, routes.way.waypoints[1].one_of[1]: the goal (4, -4) cannot be reached from (-4, 0)" + end);
  EXPECT_EQ(refusalOf("{queue: till}"),
            "agent 0, routes.way.waypoints[0]: the goal (4, -4) cannot be reached from (-2, -4)" + end);
  EXPECT_EQ(refusalOf("{place: [-4, 0]}, {place: {ring: {centre: [4, -4], radius: [0, 0.5]}}}"),
            "agent 0, routes.way.waypoints[1]: no place of the region that it fits in can be reached from (-4, 0)");
  EXPECT_EQ(refusalOf("{sink: cell}"),
            "agent 0, routes.way.waypoints[0]: no place of the region that it fits in can be reached from (-2, -4)");
}

TEST(RouteCheck, NamesTheWaypointInAWallThatWasAdded) {
  Episode episode = straight_walk::episodeOf(
      ROOM + std::string("routes: {way: {waypoints: [{place: [-4, 0]}, {place: [-3, 1]}, {sink: nearest}]}}\n"));
  episode.edit().addWall({{-3.5, 1.0}, {-2.5, 1.0}});
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().setRoute(0, "way"); }),
            "agent 0, routes.way.waypoints[1]: the goal (-3, 1) is in a wall");
  episode.edit().replaceWalls(
      {{{2.0, -5.0}, {2.0, -3.0}}, {{2.0, -3.0}, {5.0, -3.0}}, {{5.0, -3.0}, {5.0, -5.0}}, {{5.0, -5.0}, {2.0, -5.0}}});
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().setRoute(0, "way"); }),
            "agent 0, routes.way.waypoints[2]: no sink can be reached from (-3, 1)");
}

TEST(RouteCheck, IsNotMadeWithoutWayFinding) {
  EXPECT_EQ(refusalOf("{place: [-4, 0]}, {place: [4, -4]}", "way_finding: false\n"), "no error");
}

}  // namespace
}  // namespace crowd::route_check_test
