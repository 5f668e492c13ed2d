#include "simulation/evaluation/robot_record.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace crowd::robot_record_test {
namespace {

/// An episode of a robot that arrived after 10 s, and of one that drove into a person.
EpisodeResult twoRobots() {
  EpisodeResult result;
  result.scenario = "hall";
  result.robots.resize(2);
  result.robots[0].name = "a";
  result.robots[0].success = true;
  result.robots[0].time_to_reach_goal = 10.0;
  result.robots[1].name = "b";
  result.robots[1].robot_on_person_collisions = 2;
  result.robots[1].mutual_collisions = 1;
  return result;
}

TEST(RobotRecord, HasARowForEachRobot) {
  std::string rows;
  appendRobotRows(7, twoRobots(), rows);
  EXPECT_EQ(rows.substr(0, 28), "7,hall,a,1,0,0,0,0,10,0,nan,");
  EXPECT_NE(rows.find("\n7,hall,b,0,0,0,0,0,nan,"), std::string::npos);
  const std::string header = robotRecordHeader();
  EXPECT_EQ(header.substr(0, 38), "episode,scenario,robot,success,timeout");
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  EXPECT_EQ(commas(rows), 2 * commas(header));
}

TEST(RobotRecord, OfGoalsHasARowForEachGoal) {
  EpisodeResult result = twoRobots();
  result.robots[1].goals.resize(2);
  result.robots[1].goals[1].x = 1.5;
  result.robots[1].goals[1].success = true;
  std::string rows;
  appendRobotGoalRows(7, result, rows);
  EXPECT_EQ(rows, "7,hall,b,0,0,0,0,nan,nan,nan,nan,nan\n7,hall,b,1,1.5,0,1,nan,nan,nan,nan,nan\n");
  EXPECT_EQ(robotGoalHeader().substr(0, 35), "episode,scenario,robot,goal,x,y,suc");
}

TEST(RobotSummary, SumsUpTheRobotsOfAllEpisodes) {
  RobotSummary summary;
  EXPECT_EQ(summary.text(), "");
  summary.add(twoRobots());
  summary.add(twoRobots());
  EXPECT_EQ(
      summary.text(),
      "robots: 2 of 4 arrived after 10.0 s, 2 of them without a contact; contacts: 4 robot on person, 0 person on "
      "robot, 2 mutual");
}

TEST(RobotSummary, WeighsTheDelayOfPeopleByTheirNumber) {
  EpisodeResult few = twoRobots();
  for (RobotResult& robot : few.robots) {
    robot.people_compared = 1;
    robot.people_delay = 4.0;
    robot.people_detour = -1.0;
  }
  EpisodeResult many = twoRobots();
  for (RobotResult& robot : many.robots) {
    robot.people_compared = 3;
    robot.people_delay = 0.0;
    robot.people_detour = 1.0;
  }
  RobotSummary summary;
  summary.add(few);
  summary.add(many);
  summary.add(twoRobots());  // not measured
  const std::string text = summary.text();
  EXPECT_EQ(text.substr(text.find("; people")), "; people are delayed by 1.00 s, with a detour of 0.50 m");
}

}  // namespace
}  // namespace crowd::robot_record_test
