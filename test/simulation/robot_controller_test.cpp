#include "simulation/robot_controller.h"

#include <gtest/gtest.h>

#include "support/anticipation.h"
#include "support/error_of.h"
#include "support/evaluations.h"
#include "support/robots.h"

namespace crowd::robot_controller_test {
namespace {

using robots::robotTo;

/// The result of a scenario with the table `anticipation`.
EpisodeResult walk(const std::string& text, const std::string& controller) {
  EvaluationPlan plan;
  plan.robot_controller = controller;
  return evaluations::evaluateOnce(text, plan);
}

/// The ticks until a robot alone arrives at (4, 3) from the origin, with an initial heading [degrees].
std::uint64_t ticksOf(Drive drive, double heading) {
  RobotStart robot = robotTo({4.0, 3.0}, {0.0, 0.0});
  robot.heading = toRadians(heading);
  robot.drive = drive;
  robot.limits.min_turning_radius = 0.5;
  Episode episode(robots::with({robot}, scenes::scene({})), 0, Vision());
  const Learner learner = anticipationLearner();
  RobotDrivers drivers("straight", episode, learner);
  while (!episode.isOver()) {
    drivers.command(episode);
    episode.step({});
  }
  EXPECT_TRUE(episode.world().robots()[0].hasArrived());
  return episode.world().tick();
}

TEST(StraightController, GetsToItsGoalWithAllDrives) {
  // 4.9 m at 1 m/s, and the last metre at a speed of distance / s: from 1 m to 0.1 m it takes ln(10) = 2.3 s.
  const double straight = toDegrees(std::atan2(3.0, 4.0));
  for (const Drive drive : {Drive::DIFFERENTIAL, Drive::HOLONOMIC, Drive::ACKERMANN}) {
    EXPECT_NEAR(static_cast<double>(ticksOf(drive, straight)), 40.0 + 22.0, 2.0) << DRIVES.nameOf(drive);
    EXPECT_LT(ticksOf(drive, straight + 180.0), 140U) << DRIVES.nameOf(drive);
  }
}

TEST(StraightController, StopsAtTheGoal) {
  Episode episode(robots::with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scenes::scene({scenes::wanderer({0.0, 5.0})})), 0,
                  Vision());
  const Learner learner = anticipationLearner();
  RobotDrivers drivers("straight", episode, learner);
  for (int tick = 0; tick < 60; ++tick) {
    drivers.command(episode);
    episode.step({});
  }
  EXPECT_TRUE(episode.world().robots()[0].hasArrived());
  EXPECT_EQ(episode.world().robots()[0].velocity, Vector2(0.0, 0.0));
}

TEST(RobotControllers, RefuseUnknownNames) {
  const Learner learner = anticipationLearner();
  const Episode episode(scenes::scene({}), 0, Vision());
  EXPECT_EQ(errorOf<InputError>([&] { makeRobotController("sraight", episode, learner); }),
            "robot controller: expected none, straight, reactive, learned, orca or social_force, got 'sraight'");
}

TEST(ReactiveController, DrivesRoundPeopleWhoStand) {
  Scene scene = robots::with({robotTo({8.0, 0.0}, {0.0, 0.0})}, scenes::scene({}));
  scene.robots[0].limits.max_acceleration = 1.0;
  scene.contact = Contact::SOLID;
  for (const double y : {-0.6, 0.0, 0.5}) scene.agents.push_back(scenes::wanderer({4.0, y}));
  scene.ends = Ends::ROBOTS;
  Episode episode(scene, 0, Vision());
  const Learner learner = anticipationLearner();
  RobotDrivers drivers("reactive", episode, learner);
  while (!episode.isOver()) {
    drivers.command(episode);
    episode.step({});
  }
  const RobotResult result = episode.result().robots.at(0);
  EXPECT_TRUE(result.isClean());
  EXPECT_GT(result.minimum_clearance, 0.0);
  EXPECT_LT(result.path_length_ratio, 1.3);
}

TEST(RobotEpisode, ACrowdFlowsRoundARobotThatStandsStill) {
  const EpisodeResult result = walk(
      "name: round\nduration: 120\ngoal_tolerance: 0.3\ncontact: solid\n"
      "agents: [{count: 50, position: {box: [[-14, -4], [-4, 4]]}, goal: {box: [[4, -4], [14, 4]]}, speed: 1.3,\n"
      "          radius: 0.25}]\n"
      "robots: [{name: tug, position: [0, 0], radius: 0.6, max_speed: 1}]\n",
      "none");
  EXPECT_EQ(result.arrivedCount(), 50U);
  EXPECT_EQ(result.robots[0].collisions(), 0U);
  EXPECT_EQ(result.touchedCount(), 0U);
}

TEST(RobotEpisode, ACrowdNeverWalksIntoARobotThatDrivesThroughIt) {
  const EpisodeResult result = walk(
      "name: against\nduration: 60\ngoal_tolerance: 0.3\ncontact: solid\n"
      "agents: [{count: 30, position: {box: [[-12, -3], [-4, 3]]}, goal: {box: [[4, -3], [12, 3]]}, speed: 1.3,\n"
      "          radius: 0.25}]\n"
      "robots: [{name: tug, position: [8, 0], goal: [-14, 0], radius: 0.3, max_speed: 1}]\n",
      "straight");
  EXPECT_EQ(result.arrivedCount(), 30U);
  EXPECT_TRUE(result.robots[0].success);
  EXPECT_EQ(result.robots[0].person_on_robot_collisions, 0U);
  EXPECT_EQ(result.robots[0].mutual_collisions, 0U);
}

}  // namespace
}  // namespace crowd::robot_controller_test
