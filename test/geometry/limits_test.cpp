// The limits of numbers in scenarios and of changes of the world, and what is said of larger ones.

#include "geometry/limits.h"

#include <gtest/gtest.h>

#include <string>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/robots.h"
#include "support/scenario_texts.h"
#include "support/scenes.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::limits_test {
namespace {

using scenario_texts::agentError;
using scenario_texts::AGENTS;
using scenario_texts::HEAD;
using scenario_texts::obstacleError;

const std::string PLACES = "expected a number from -1e+06 to 1e+06 m, got ";

void expectSaid(const std::string& said, int line, const std::string& expected) {
  EXPECT_EQ(said, "s.yaml: document 1, line " + std::to_string(line) + ": " + expected);
}

/// What is said of an agent with another position, or with another entry.
void positionSays(const std::string& position, const std::string& expected) {
  expectSaid(agentError("goal: [4, 3], speed: 1, radius: 0.2, position: " + position), 5,
             "agents[0].position" + expected);
}

/// What is said of a scenario with one agent, and these keys from line 5 on.
void says(const std::string& keys, const std::string& expected) {
  expectSaid(scenario_texts::errorOf(std::string(HEAD) + AGENTS + keys + "\n"), 5, expected);
}

void robotSays(const std::string& entries, const std::string& expected) {
  says("robots: [{name: tug, position: [9, 9], " + entries + "}]", "robots[0]." + expected);
}

TEST(Limits, Places) {
  positionSays("[1e17, 0]", "[0]: " + PLACES + "'1e17'");
  positionSays("{box: [[0, -1000000.5], [1, 1]]}", ".box[0][1]: " + PLACES + "'-1000000.5'");
  positionSays("{ring: {centre: [2e6, 0], radius: 1}}", ".ring.centre[0]: " + PLACES + "'2e6'");
  positionSays("{ring: {centre: [0, 0], radius: 1e200}}", ".ring.radius: expected at most 1e+06 m, got '1e200'");
  positionSays("{ring: {centre: [9e5, 0], radius: 2e5}}",
               ".ring: expected a ring with coordinates of up to 1e+06 m, got 1100000 m");
  const std::string body = "position: [0, 0], speed: 1, radius: 0.2, ";
  expectSaid(agentError(body + "goal: [0, 1e7]"), 5, "agents[0].goal[1]: " + PLACES + "'1e7'");
  expectSaid(agentError(body + "goal: {opposite: [1e7, 0]}"), 5, "agents[0].goal.opposite[0]: " + PLACES + "'1e7'");
  says("walls: [[[0, 0], [1e17, 0]]]", "walls[0][1][0]: " + PLACES + "'1e17'");
  says("gates: {door: {wall: [[0, 0], [0, 1e17]], open: true}}", "gates.door.wall[1][1]: " + PLACES + "'1e17'");
  says("queues: {till: {head: [1e17, 0], direction: 0, spacing: 1, service: 1}}",
       "queues.till.head[0]: " + PLACES + "'1e17'");
  says("queues: {till: {head: [1, 0], direction: 0, spacing: 1e200, service: 1}}",
       "queues.till.spacing: expected at most 1e+06 m, got '1e200'");
  EXPECT_NO_THROW(parseScenarios(std::string(HEAD) + AGENTS + "walls: [[[-1e6, 0], [-1e6, 1e6]]]\n", "s.yaml"));
}

TEST(Limits, RadiiAndSpeeds) {
  const std::string body = "position: [0, 0], goal: [4, 3], ";
  expectSaid(agentError(body + "speed: 1e300, radius: 0.2"), 5,
             "agents[0].speed: expected at most 1000 m/s, got '1e300'");
  expectSaid(agentError(body + "speed: [1, 1001], radius: 0.2"), 5,
             "agents[0].speed[1]: expected at most 1000 m/s, got '1001'");
  expectSaid(agentError(body + "speed: 1, radius: 1e200"), 5, "agents[0].radius: expected at most 1000 m, got '1e200'");
  expectSaid(obstacleError("position: [50, 5], radius: 1001"), 6,
             "obstacles[0].radius: expected at most 1000 m, got '1001'");
  expectSaid(obstacleError("position: [5, 5], radius: 1, velocity: [0, -1e300]"), 6,
             "obstacles[0].velocity[1]: expected a number from -1000 to 1000 m/s, got '-1e300'");
  expectSaid(obstacleError("position: [5, 5], radius: 1, to_and_fro: [9, 9], speed: 1e4"), 6,
             "obstacles[0].speed: expected at most 1000 m/s, got '1e4'");
  says("collision_radius: 1e200", "collision_radius: expected at most 1000 m, got '1e200'");
}

TEST(Limits, SpeedsPerTick) {
  const std::string head = "name: n\nunits: thesis\ntick: 0.5\nduration: 60\ngoal_tolerance: 0.3\n";
  const std::string agent = "agents: [{position: [0, 0], goal: [4, 3], radius: 0.2, speed: ";
  expectSaid(scenario_texts::errorOf(head + agent + "501}]\n"), 6,
             "agents[0].speed: expected at most 500 m/tick, got '501'");
  EXPECT_NO_THROW(parseScenarios(head + agent + "500}]\n", "s.yaml"));
}

TEST(Limits, Times) {
  says("tick: 1e3", "tick: expected at most 100 s, got '1e3'");
  expectSaid(
      scenario_texts::errorOf("name: n\ntick: 100\ngoal_tolerance: 0.3\n" + std::string(AGENTS) + "duration: 1e10\n"),
      5, "duration: expected a duration of 1 to 1e9 ticks, at most 1e9 s, got '1e10'");
}

TEST(Limits, Numbers) {
  const std::string one = "{position: {box: [[0, 0], [9, 9]]}, goal: [1, 1], speed: 1, radius: 0.2, count: ";
  expectSaid(agentError("position: [0, 0], goal: [4, 3], speed: 1, radius: 0.2, count: 1000000000"), 5,
             "agents[0].count: expected a whole number from 1 to 1000000, got '1000000000'");
  std::string ten;
  for (int i = 0; i < 10; ++i) ten += one + "1000000}, ";
  const std::string agents = "agents: [" + ten + one + "1}]\n";
  expectSaid(scenario_texts::errorOf(HEAD + agents), 4, "agents: expected at most 10000000 in all, got 10000001");
  const std::string obstacle = "{position: {box: [[0, 0], [9, 9]]}, radius: 0.2, count: ";
  std::string obstacles;
  for (int i = 0; i < 10; ++i) obstacles += obstacle + "1000000}, ";
  says("obstacles: [" + obstacles + obstacle + "1}]", "obstacles: expected at most 10000000 in all, got 10000001");
  std::string robots;
  for (int i = 0; i <= 1000; ++i) {
    robots += "{name: r" + std::to_string(i) + ", position: [9, 9], radius: 0.1, max_speed: 1}, ";
  }
  says("robots: [" + robots + "]", "robots: expected at most 1000 robots, got a list of 1001");
}

TEST(Limits, Sources) {
  const std::string source = "sources: [{area: [9, 9], goal: [1, 9], speed: 1, radius: 0.2, rate: ";
  says(source + "1e9}]", "sources[0].rate: expected at most 1000 agents/s, got '1e9'");
  EXPECT_NO_THROW(parseScenarios(std::string(HEAD) + AGENTS + source + "1000}]\n", "s.yaml"));
}

TEST(Limits, Robots) {
  const std::string body = "max_speed: 1, radius: 0.3, ";
  robotSays("radius: 1e200, max_speed: 1", "radius: expected at most 1000 m, got '1e200'");
  robotSays("radius: 1, max_speed: 1e300", "max_speed: expected at most 1000 m/s, got '1e300'");
  robotSays("max_speed: 1, footprint: [[0, 0], [1e4, 0], [0, 1]]",
            "footprint[1][0]: expected a number from -1000 to 1000 m, got '1e4'");
  robotSays(body + "max_rotation: 1e4", "max_rotation: expected at most 1000 rad/s, got '1e4'");
  robotSays(body + "acceleration: 1e7", "acceleration: expected at most 1e+06 m/s^2, got '1e7'");
  robotSays(body + "rotation_acceleration: 1e7", "rotation_acceleration: expected at most 1e+06 rad/s^2, got '1e7'");
  robotSays(body + "drive: ackermann, min_turning_radius: 1e7",
            "min_turning_radius: expected at most 1e+06 m, got '1e7'");
  robotSays(body + "goal_tolerance: 1e7", "goal_tolerance: expected at most 1e+06 m, got '1e7'");
  robotSays(body + "odometry: {distance: 11}", "odometry.distance: expected at most 10, got '11'");
  robotSays(body + "scan: {rays: 100001}", "scan.rays: expected a whole number from 1 to 100000, got '100001'");
  robotSays(body + "scan: {range: [0, 1e7]}", "scan.range[1]: expected at most 1e+06 m, got '1e7'");
  robotSays(body + "scan: {noise: 1e7}", "scan.noise: expected at most 1e+06 m, got '1e7'");
  robotSays(body + "scan: {position: [0, 1e7]}", "scan.position[1]: expected a number from -1000 to 1000 m, got '1e7'");
}

TEST(Limits, ChangesOfTheWorld) {
  World world(robots::with({robots::robot({50.0, 0.0})},
                           scenes::scene({scenes::wanderer({0.0, 0.0})}, {scenes::pillar({0.0, 9.0}, 0.5)})));
  const auto expect = [](const std::string& what, const std::string& expected, const auto& change) {
    EXPECT_EQ(errorOf<InputError>(change), what + ": expected " + expected);
  };
  const std::string place = "a number from -1e+06 to 1e+06 m, got 1e+17";
  const Vector2 far(0.0, 1e17);
  expect("max_speed [m/s]", "at most 1000 m/s, got 1e+300", [&] {
    WorldEditor(world).spawnAgent(scenes::wanderer({9.0, 0.0}, 1e300));
  });
  expect("radius [m]", "at most 1000 m, got 1e+200", [&] {
    WorldEditor(world).spawnAgent(scenes::wanderer({9.0, 0.0}, 1.0, 1e200));
  });
  expect("position [m]", place, [&] { WorldEditor(world).spawnAgent(scenes::wanderer(far)); });
  expect("position [m]", place, [&] { WorldEditor(world).teleport(0, {far, 0.0}); });
  expect("radius [m]", "at most 1000 m, got 1e+200", [&] {
    WorldEditor(world).spawnObstacle({9.0, 0.0}, {0.0, 0.0}, 1e200);
  });
  expect("position [m]", place, [&] { WorldEditor(world).spawnObstacle(far, {0.0, 0.0}, 1.0); });
  expect("velocity [m/s]", "a number from -1000 to 1000 m/s, got -1e+300", [&] {
    WorldEditor(world).spawnObstacle({9.0, 0.0}, {-1e300, 0.0}, 1.0);
  });
  expect("position [m]", place, [&] { WorldEditor(world).moveObstacle(0, far); });
  expect("wall [m]", place, [&] { WorldEditor(world).addWall({{0.0, 0.0}, far}); });
  expect("goal [m]", place, [&] { world.robots().setGoals(0, {far}); });
  expect("position [m]", place, [&] { WorldEditor(world).teleportRobot(0, {far, 0.0}); });
}

}  // namespace
}  // namespace crowd::limits_test
