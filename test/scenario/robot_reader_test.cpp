// The keys `robots` and `ends` of scenarios.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "scenario/writing/scene_document.h"
#include "support/scenario_texts.h"

namespace crowd::robot_reader_test {
namespace {

using scenario_texts::AGENTS;
using scenario_texts::errorOf;
using scenario_texts::HEAD;
using scenario_texts::sceneOf;

const char* const LEAST = "name: tug, position: [10, 0], radius: 0.3, max_speed: 1";

std::string withRobots(const std::string& entries) { return std::string(HEAD) + AGENTS + "robots:\n" + entries; }

Scene sceneWith(const std::string& entries) { return sceneOf(withRobots("  - {" + entries + "}\n")); }

std::string robotError(const std::string& entries) { return errorOf(withRobots("  - {" + entries + "}\n")); }

TEST(RobotReader, HasDefaults) {
  const Scene scene = sceneWith(LEAST);
  ASSERT_EQ(scene.robots.size(), 1U);
  const RobotStart& robot = scene.robots[0];
  EXPECT_EQ(robot.name, "tug");
  EXPECT_EQ(robot.name_space, "");
  EXPECT_EQ(robot.position, Vector2(10.0, 0.0));
  EXPECT_EQ(robot.heading, 0.0);
  EXPECT_TRUE(robot.goals.empty());
  EXPECT_EQ(robot.drive, Drive::DIFFERENTIAL);
  EXPECT_EQ(robot.limits.max_speed, 1.0);
  EXPECT_EQ(robot.limits.max_rotation, 1.0);
  EXPECT_EQ(robot.limits.max_acceleration, 1.0);
  EXPECT_EQ(robot.limits.max_rotation_acceleration, 2.0);
  EXPECT_EQ(robot.footprint.radius, 0.3);
  EXPECT_EQ(robot.cmd_timeout, 0.5);
  EXPECT_EQ(robot.goal_tolerance, 0.3);  // the scenario's
  EXPECT_TRUE(robot.perceived);
  EXPECT_EQ(robot.yields, Yields::CROWD);
  EXPECT_EQ(robot.comfort, 0.3);
  EXPECT_EQ(robot.scan.rays, 720U);
  EXPECT_EQ(robot.scan.rings, 0U);
  EXPECT_EQ(robot.scan.height, 0.0);
  EXPECT_EQ(robot.scan.first_angle, -PI);
  EXPECT_EQ(robot.scan.max_range, 20.0);
  EXPECT_FALSE(robot.tracks.occlusion);
  EXPECT_EQ(robot.tracks.range, INFINITE);
  EXPECT_EQ(robot.tracks.noise, 0.0);
  EXPECT_EQ(robot.tracks.velocity_noise, 0.0);
  EXPECT_EQ(robot.tracks.missed, 0.0);
  EXPECT_EQ(robot.tracks.false_detections, 0.0);
  EXPECT_EQ(robot.tracks.keep, std::nullopt);
  EXPECT_EQ(scene.ends, Ends::ALL);
}

TEST(RobotReader, ReadsAllKeys) {
  const Scene scene = sceneOf(withRobots(
      "  - {name: car, namespace: r1, position: [10, 0], heading: 90, goals: [[10, 5], [12, 5]], footprint: [[1, "
      "0.4],\n"
      "     [-0.5, 0.4], [-0.5, -0.4], [1, -0.4]], drive: ackermann, max_speed: 2, max_rotation: 0.7, acceleration: "
      "1.5,\n"
      "     rotation_acceleration: 3, min_turning_radius: 2.5, cmd_timeout: 1, goal_tolerance: 0.4, perceived: false,\n"
      "     yields: robot, comfort: 0.7, odometry: {distance: 0.01, rotation: 0.02, heading_per_metre: 0.03}, scan: "
      "{rays: 100,\n"
      "     angles: [-90, 90], range: [0.2, 8], position: [0.3, 0.1], heading: 90, noise: 0.01, dropout: 0.1,\n"
      "     period: 0.2, people: legs, rings: 16, elevations: [-30, 15], height: 0.4}}\n"
      "  - {name: other, position: [10, -5], radius: 0.2, max_speed: 1, drive: external, pose_from: tf}\n"
      "ends: robots\n"));
  const RobotStart& car = scene.robots.at(0);
  EXPECT_EQ(car.name_space, "r1");
  EXPECT_EQ(car.heading, PI / 2.0);
  ASSERT_EQ(car.goals.size(), 2U);
  EXPECT_EQ(car.goals[1], Vector2(12.0, 5.0));
  EXPECT_EQ(car.footprint.corners.size(), 4U);
  EXPECT_EQ(car.drive, Drive::ACKERMANN);
  EXPECT_EQ(car.limits.max_rotation, 0.7);
  EXPECT_EQ(car.limits.max_acceleration, 1.5);
  EXPECT_EQ(car.limits.max_rotation_acceleration, 3.0);
  EXPECT_EQ(car.limits.min_turning_radius, 2.5);
  EXPECT_EQ(car.cmd_timeout, 1.0);
  EXPECT_EQ(car.goal_tolerance, 0.4);
  EXPECT_FALSE(car.perceived);
  EXPECT_EQ(car.yields, Yields::ROBOT);
  EXPECT_EQ(car.odometry.heading_per_metre, 0.03);
  EXPECT_EQ(car.scan.rays, 100U);
  EXPECT_EQ(car.scan.last_angle, PI / 2.0);
  EXPECT_EQ(car.scan.min_range, 0.2);
  EXPECT_EQ(car.scan.mount.position, Vector2(0.3, 0.1));
  EXPECT_EQ(car.scan.mount.heading, PI / 2.0);
  EXPECT_EQ(car.scan.people, SeenPeople::LEGS);
  EXPECT_EQ(car.comfort, 0.7);
  EXPECT_EQ(car.scan.rings, 16U);
  EXPECT_NEAR(car.scan.lowest_ring, -PI / 6.0, 1e-15);
  EXPECT_NEAR(car.scan.highest_ring, PI / 12.0, 1e-15);
  EXPECT_EQ(car.scan.height, 0.4);
  EXPECT_EQ(scene.robots.at(1).name_space, "other");
  EXPECT_EQ(scene.robots[1].drive, Drive::EXTERNAL);
  EXPECT_TRUE(scene.robots[1].reads_tf);
  EXPECT_EQ(scene.ends, Ends::ROBOTS);
}

TEST(RobotReader, ReadsTracks) {
  const std::string keys =
      ", tracks: {occlusion: true, range: 8, noise: 0.05, velocity_noise: 0.1, missed: 0.2, false_detections: 0.3, "
      "keep: 0}";
  const Scene scene = sceneWith(LEAST + keys);
  const Scene again = parseScenarios(toDocument(scene, "."), "again").scene(5, 0);
  for (const TrackSpec& tracks : {scene.robots.at(0).tracks, again.robots.at(0).tracks}) {
    EXPECT_TRUE(tracks.occlusion);
    EXPECT_EQ(tracks.range, 8.0);
    EXPECT_EQ(tracks.noise, 0.05);
    EXPECT_EQ(tracks.velocity_noise, 0.1);
    EXPECT_EQ(tracks.missed, 0.2);
    EXPECT_EQ(tracks.false_detections, 0.3);
    EXPECT_EQ(tracks.keep, 0.0);
  }
}

TEST(RobotReader, RefusesWrongTracks) {
  const auto problem = [](const std::string& entry) { return robotError(LEAST + (", tracks: " + entry)); };
  const std::string start = "s.yaml: document 1, line 6: robots[0].tracks";
  EXPECT_EQ(problem("{occlusion: 1}"), start + ".occlusion: expected true or false, got '1'");
  EXPECT_EQ(problem("{range: 0}"), start + ".range: expected a number above 0, got '0'");
  EXPECT_EQ(problem("{noise: -0.1}"), start + ".noise: expected a number of 0 or more, got '-0.1'");
  EXPECT_EQ(problem("{velocity_noise: 1001}"), start + ".velocity_noise: expected at most 1000 m/s, got '1001'");
  EXPECT_EQ(problem("{missed: 1.1}"), start + ".missed: expected a number from 0 to 1, got '1.1'");
  EXPECT_EQ(problem("{false_detections: 1001}"),
            start + ".false_detections: expected at most 1000 per second, got '1001'");
  EXPECT_EQ(problem("{keep: .inf}"), start + ".keep: expected a number of 0 or more, got '.inf'");
  EXPECT_NE(problem("{ghosts: 1}").find(start + ": unknown key 'ghosts'"), std::string::npos);
}

TEST(RobotReader, ARobotNeedsNoPeopleAndFacesItsGoal) {
  const Scene scene = sceneOf(std::string(HEAD) + "routes: {round: {waypoints: [{place: [0, 5]}, {place: [5, 5]}]}}\n" +
                              "robots:\n  - {name: tug, position: [0, 0], route: round, radius: 0.3, max_speed: 1}\n");
  EXPECT_TRUE(scene.agents.empty());
  EXPECT_EQ(scene.robots[0].goals.size(), 2U);
  EXPECT_NEAR(scene.robots[0].heading, PI / 2.0, 1e-15);
}

TEST(RobotReader, DrawnRobotsKeepAGapAndLeaveTheDrawsOfAgentsAlone) {
  const std::string head = std::string(HEAD) +
                           "agents: [{count: 10, position: {box: [[-2, -2], [2, 2]]}, goal: {box: [[-2, -2], [2, 2]]}, "
                           "speed: 1, radius: 0.25}]\n";
  const std::string robot =
      "robots: [{name: tug, position: {box: [[-3, -3], [3, 3]]}, goal: {box: [[-3, -3], [3, 3]]}, radius: 0.3, "
      "max_speed: 1}]\n";
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene with = parseScenarios(head + robot, "s").scene(seed, 0);
    const Scene without = parseScenarios(head, "s").scene(seed, 0);
    const RobotStart& tug = with.robots[0];
    EXPECT_GT((tug.goals[0] - tug.position).norm(), 0.3);
    for (std::size_t i = 0; i < with.agents.size(); ++i) {
      EXPECT_EQ(with.agents[i].position, without.agents[i].position) << "seed " << seed;
      EXPECT_GE((with.agents[i].position - tug.position).norm(), 0.55 + DRAWN_GAP) << "seed " << seed;
    }
  }
}

TEST(RobotReader, DocumentsOfScenesAreReadBack) {
  const Scene scene = sceneOf(
      withRobots("  - {name: car, position: [10, 0], heading: 30, goal: [15, 1], footprint: [[1, 0.4], [-0.5, 0.4], "
                 "[-0.5, -0.4]],\n"
                 "     drive: ackermann, max_speed: 2, min_turning_radius: 2.5, yields: both, scan: {rays: 9, angles: "
                 "[-45, 45]}}\n"
                 "  - {name: other, position: [10, -5], radius: 0.2, max_speed: 1, drive: external, pose_from: tf,\n"
                 "     perceived: false, odometry: {distance: 0.1}}\n"
                 "ends: robots\n"));
  const std::string document = toDocument(scene, ".");
  const Scene again = parseScenarios(document, "again").scene(5, 0);
  EXPECT_EQ(toDocument(again, "."), document);
  ASSERT_EQ(again.robots.size(), 2U);
  EXPECT_EQ(again.robots[0].heading, scene.robots[0].heading);
  EXPECT_EQ(again.robots[0].limits.min_turning_radius, 2.5);
  EXPECT_EQ(again.robots[0].yields, Yields::BOTH);
  EXPECT_EQ(again.robots[0].scan.rays, 9U);
  EXPECT_EQ(again.robots[1].name_space, "other");
  EXPECT_EQ(again.robots[1].odometry.distance, 0.1);
  EXPECT_FALSE(again.robots[1].perceived);
  EXPECT_EQ(again.ends, Ends::ROBOTS);
}

TEST(RobotReader, RefusesNamesThatAreNoneOrNotUnique) {
  EXPECT_EQ(
      robotError("name: 2nd, position: [10, 0], radius: 0.3, max_speed: 1"),
      "s.yaml: document 1, line 6: robots[0].name: expected letters, digits and _, with a letter first, got '2nd'");
  const std::string twice = std::string("  - {") + LEAST + "}\n";
  EXPECT_EQ(errorOf(withRobots(twice + twice)),
            "s.yaml: document 1, line 7: robots[1].name: there are two robots 'tug'");
  EXPECT_EQ(errorOf(withRobots("  - {name: a, namespace: x, position: [10, 0], radius: 0.3, max_speed: 1}\n"
                               "  - {name: b, namespace: x, position: [12, 0], radius: 0.3, max_speed: 1}\n")),
            "s.yaml: document 1, line 7: robots[1].namespace: there are two robots in the namespace 'x'");
}

TEST(RobotReader, RefusesWrongValues) {
  const std::string start = "s.yaml: document 1, line 6: robots[0]";
  const std::string body = "name: tug, position: [10, 0], max_speed: 1";
  EXPECT_EQ(robotError(body + ", footprint: [[0, 0], [1, 1], [1, 0], [0, 1]]"),
            start + ".footprint: expected a polygon that does not cross itself, but edges 0-1 and 2-3 cross");
  EXPECT_EQ(robotError(body), start + ": the key 'radius' is missing");
  EXPECT_EQ(robotError(body + ", radius: 1, footprint: [[0, 0], [1, 1], [1, 0]]"),
            start + ".footprint: expected either radius or footprint, got both");
  EXPECT_EQ(robotError(std::string(LEAST) + ", min_turning_radius: 1"),
            start + ".min_turning_radius: is for drive: ackermann only");
  EXPECT_EQ(robotError(std::string(LEAST) + ", drive: ackermann"), start + ": the key 'min_turning_radius' is missing");
  EXPECT_EQ(robotError(std::string(LEAST) + ", pose_from: tf"), start + ".pose_from: is for drive: external only");
  EXPECT_EQ(robotError(std::string(LEAST) + ", perceived: false, yields: crowd"),
            start + ".yields: 'crowd' needs perceived: true");
  EXPECT_EQ(robotError("name: tug, position: [10, 0], radius: 0.3, max_speed: .nan"),
            start + ".max_speed: expected a number above 0, got '.nan'");
  EXPECT_EQ(robotError(std::string(LEAST) + ", scan: {range: 5}"),
            start + ".scan.range: expected [low, high], got '5'");
  EXPECT_NE(robotError("name: tug, position: [10, 0], radius: 0.3, speed: 1").find(start + ": unknown key 'speed'"),
            std::string::npos);
  EXPECT_NE(errorOf(std::string(HEAD) + AGENTS + "ends: robots\n").find("ends: there are no robots"),
            std::string::npos);
}

TEST(RobotReader, RefusesRobotsInSomething) {
  const std::string start = "s.yaml: document 1, line 6: robots[0] ";
  EXPECT_EQ(robotError("name: tug, position: [0.4, 0.3], radius: 0.3, max_speed: 1"),
            start + "and agents[0] overlap by 0.05 m");
  const std::string walls = "walls: [[[10.2, -1], [10.2, 1]]]\n";
  EXPECT_EQ(errorOf(withRobots(std::string("  - {") + LEAST + "}\n" + walls)), start + "and walls[0] overlap by 0.1 m");
  EXPECT_EQ(errorOf(withRobots("  - {name: tug, position: [10, 0], footprint: [[1, 0.1], [-1, 0.1], [-1, -0.1], "
                               "[1, -0.1]], max_speed: 1}\n" +
                               walls)),
            start + "overlaps walls[0]");
  // Turned along the wall it fits.
  EXPECT_NO_THROW(
      sceneOf(withRobots("  - {name: tug, position: [10, 0], heading: 90, footprint: [[1, 0.1], [-1, 0.1], "
                         "[-1, -0.1], [1, -0.1]], max_speed: 1}\n" +
                         walls)));
  EXPECT_EQ(errorOf(withRobots("  - {name: a, position: [10, 0], radius: 0.3, max_speed: 1}\n"
                               "  - {name: b, position: [10.5, 0], radius: 0.3, max_speed: 1}\n")),
            "s.yaml: document 1, line 7: robots[1] and robots[0] overlap by 0.1 m");
}

TEST(RobotReader, RefusesGoalsWhereTheRobotDoesNotFitOrIs) {
  const std::string start = "s.yaml: document 1, line 6: robots[0]";
  EXPECT_EQ(errorOf(withRobots("  - {name: tug, position: [10, 0], goal: [14, 2], radius: 0.5, max_speed: 1}\n"
                               "walls: [[[14, 1.9], [14, 5]]]\n")),
            start + ".goal: a robot of this footprint does not fit at (14, 2)");
  EXPECT_EQ(robotError(std::string(LEAST) + ", goal: [10.1, 0]"),
            start + " starts within goal_tolerance (0.3 m) of its goal");
  EXPECT_EQ(robotError(std::string(LEAST) + ", route: round"),
            start + ".route: there is no route 'round'; the scenario has no routes");
}

}  // namespace
}  // namespace crowd::robot_reader_test
