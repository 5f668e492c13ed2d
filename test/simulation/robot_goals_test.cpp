// Goals to which users send robots.

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "maps/map_walls.h"
#include "simulation/episode.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/maps.h"
#include "support/robots.h"

namespace crowd::robots::robot_goals_test {
namespace {

/// A room of 8 m x 4 m with walls of 1 m, whose free cells are x 0 to 8 and y 0 to 4, and a robot in it.
Scene room() {
  RobotStart start = robot({1.5, 1.5});
  start.goals = {{3.5, 1.5}};
  Scene made = with({start}, scene({}));
  made.ends = Ends::ROBOTS;
  made.max_ticks = 1000;
  const OccupancyMap map = maps::drawn(
      {"##########", "#........#", "#........#", "#...??...#", "#........#", "##########"}, 1.0, {{-1.0, -1.0}, 0.0});
  made.map = std::make_shared<const OccupancyMap>(map);
  made.walls = traceWalls(map);
  return made;
}

Episode begun(Scene scene) { return {std::move(scene), 0, Vision()}; }

std::string refusalOf(Episode& episode, const Vector2& goal) {
  return errorOf<InputError>([&] { episode.edit().sendRobot(0, goal); });
}

/// Drives ahead for a number of ticks at 1 m/s.
void driveAhead(Episode& episode, int ticks) {
  episode.robots().command(0, {{1.0, 0.0}, 0.0});
  for (int i = 0; i < ticks && !episode.isOver(); ++i) episode.step({});
}

TEST(RobotGoals, AGoalOffTheMapIsRefusedAndTheRobotKeepsItsOwn) {
  Episode episode = begun(room());
  EXPECT_EQ(refusalOf(episode, {9.5, 1.5}), "the goal (9.5, 1.5) is beyond the map");
  EXPECT_EQ(refusalOf(episode, {8.5, 1.5}), "the goal (8.5, 1.5) is on a cell of the map that is not free");
  EXPECT_EQ(refusalOf(episode, {3.5, 1.5}), "the goal (3.5, 1.5) is on a cell of the map that is not free");
  // A disc of 0.3 m with a tolerance of 0.1 m needs 0.2 m.
  EXPECT_EQ(refusalOf(episode, {7.85, 0.5}), "the goal (7.85, 0.5) is in a wall");
  EXPECT_EQ(refusalOf(episode, {std::numeric_limits<double>::quiet_NaN(), 0.5}),
            "goal [m]: expected finite numbers, got [nan, 0.5]");
  EXPECT_EQ(episode.world().robots()[0].goal(), Vector2(3.5, 1.5));
  EXPECT_FALSE(episode.world().robots()[0].sent);
  episode.edit().sendRobot(0, {7.75, 0.5});
  EXPECT_EQ(episode.world().robots()[0].goal(), Vector2(7.75, 0.5));
}

TEST(RobotGoals, WithoutAMapOnlyWallsCount) {
  Scene made = with({robot({0.0, 0.0})}, scene({}));
  made.walls = {{{5.0, -1.0}, {5.0, 1.0}}};
  Episode episode = begun(made);
  EXPECT_EQ(refusalOf(episode, {5.1, 0.0}), "the goal (5.1, 0) is in a wall");
  episode.edit().sendRobot(0, {1000.0, 0.0});
  EXPECT_EQ(errorOf<InputError>([&] { episode.edit().sendRobot(1, {1.0, 0.0}); }), "there is no robot 1");
}

TEST(RobotGoals, AnotherMapCounts) {
  Episode episode = begun(room());
  const auto other = std::make_shared<const OccupancyMap>(maps::drawn({"....", "...."}));
  episode.edit().replaceMap(other, {});
  EXPECT_EQ(refusalOf(episode, {7.5, 0.5}), "the goal (7.5, 0.5) is beyond the map");
  episode.edit().sendRobot(0, {3.5, 1.5});
}

TEST(RobotGoals, AnEpisodeEndsWhenTheGoalOfTheScenarioIsReached) {
  Scene made = room();
  made.robots[0].goals = {{2.55, 1.5}};
  Episode episode = begun(made);
  driveAhead(episode, 100);
  EXPECT_TRUE(episode.isOver());
  EXPECT_EQ(episode.world().tick(), 10U);  // after 1 m it is within the tolerance of 0.1 m
}

TEST(RobotGoals, AnEpisodeDoesNotEndWhenAGoalOfTheUserIsReached) {
  for (const Ends ends : {Ends::ROBOTS, Ends::ALL}) {
    Scene made = room();
    made.ends = ends;
    Episode episode = begun(made);
    episode.edit().sendRobot(0, {2.55, 1.5});
    driveAhead(episode, 10);
    EXPECT_TRUE(episode.world().robots()[0].hasArrived());
    EXPECT_FALSE(episode.isOver());
    episode.edit().sendRobot(0, {2.7, 1.5});
    EXPECT_FALSE(episode.world().robots()[0].hasArrived());
    driveAhead(episode, 2000);
    EXPECT_EQ(episode.world().tick(), 1000U);  // the duration
  }
}

}  // namespace
}  // namespace crowd::robots::robot_goals_test
