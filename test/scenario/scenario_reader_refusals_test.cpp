#include "scenario/reading/scenario_reader.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "social_crowd/errors.h"
#include "support/scenario_texts.h"

namespace crowd::scenario_reader_refusals_test {
namespace {

using scenario_texts::AGENT;
using scenario_texts::agentError;
using scenario_texts::AGENTS;
using scenario_texts::errorOf;
using scenario_texts::HEAD;
using scenario_texts::obstacleError;

TEST(ScenarioReader, ErrorsContainFileDocumentLineAndExpectation) {
  const std::string document = std::string(HEAD) + "agents:\n  - " + AGENT + "\n";
  EXPECT_EQ(errorOf(document + "---\n" + HEAD + "agents:\n  - " + AGENT +
                    "\n  - position: [2, 2]\n    goal: [3, 3]\n    speed: fast\n    radius: 0.2\n"),
            "s.yaml: document 2, line 14: agents[1].speed: expected a number above 0, got 'fast'");
}

TEST(ScenarioReader, RefusesUnknownMissingAndRepeatedKeys) {
  EXPECT_EQ(
      errorOf(std::string(HEAD) + AGENTS + "obstacle: []\n"),
      "s.yaml: document 1, line 5: unknown key 'obstacle', did you mean 'obstacles'? Known are name, units, "
      "tick, duration, "
      "goal_tolerance, collision_radius, contact, order, seed, agents, obstacles, walls, map, free_radius, "
      "way_finding, routes, "
      "sources, sinks, queues, gates, robots, ends, motion, groups, recorded, kinds, attractions, alarms, arrived");
  EXPECT_EQ(errorOf("name: n\nduration: 60\n" + std::string(AGENTS)),
            "s.yaml: document 1, line 1: the key 'goal_tolerance' is missing");
  EXPECT_EQ(agentError("position: [0, 0], goal: [1, 1], radius: 0.2"),
            "s.yaml: document 1, line 5: agents[0]: the key 'speed' is missing");
  EXPECT_EQ(
      agentError("position: [0, 0], goal: [1, 1], speed: 1, radius: 0.2, sped: 1"),
      "s.yaml: document 1, line 5: agents[0]: unknown key 'sped', did you mean 'speed'? Known are position, goal, "
      "goals, route, kind, speed, hurry, radius, heading, velocity, reaction, reaction_time, count, leader, groups");
  // A misspelt required key is not reported as missing, because all keys are declared before the first is read.
  EXPECT_EQ(
      agentError("position: [0, 0], goal: [1, 1], speed: 1, raduis: 0.2"),
      "s.yaml: document 1, line 5: agents[0]: unknown key 'raduis', did you mean 'radius'? Known are position, goal, "
      "goals, route, kind, speed, hurry, radius, heading, velocity, reaction, reaction_time, count, leader, groups");
  EXPECT_EQ(errorOf("nmae: n\n" + std::string(AGENTS))
                .find("s.yaml: document 1, line 1: unknown key 'nmae', did you mean "
                      "'name'? Known are name, units, tick, duration"),
            0U);
  EXPECT_EQ(errorOf(std::string(HEAD) + "name: m\n" + AGENTS),
            "s.yaml: document 1, line 4: the key 'name' stands twice");
}

TEST(ScenarioReader, RefusesWrongNumbersOfAScenario) {
  const auto error = [](const std::string& entries) { return errorOf(entries + AGENTS); };
  EXPECT_NE(error("name: n\nduration: 0\ngoal_tolerance: 0.3\n").find("line 2: duration: expected a number above 0"),
            std::string::npos);
  EXPECT_NE(error("name: n\nduration: 0.05\ngoal_tolerance: 0.3\n").find("duration: expected a duration of 1 to 1e9"),
            std::string::npos);
  EXPECT_NE(error("name: n\nduration: 1e300\ngoal_tolerance: 0.3\n").find("duration of 1 to 1e9 ticks"),
            std::string::npos);
  EXPECT_NE(error("name: n\nduration: 60\ngoal_tolerance: -1\n").find("line 3: goal_tolerance: expected"),
            std::string::npos);
  EXPECT_NE(error(std::string(HEAD) + "tick: 0\n").find("line 4: tick: expected a number above 0"), std::string::npos);
  EXPECT_NE(error(std::string(HEAD) + "seed: -1\n").find("line 4: seed: expected a whole number from 0"),
            std::string::npos);
  EXPECT_NE(error(std::string(HEAD) + "units: feet\n").find("line 4: units: expected si or thesis, got 'feet'"),
            std::string::npos);
  EXPECT_NE(error("name: ''\nduration: 60\ngoal_tolerance: 0.3\n").find("line 1: name: expected a name"),
            std::string::npos);
}

TEST(ScenarioReader, RefusesWrongMotionLimits) {
  const auto error = [](const std::string& value) {
    return errorOf(std::string(HEAD) + AGENTS + "motion: " + value + "\n");
  };
  const std::string place = "s.yaml: document 1, line 5: motion";
  EXPECT_EQ(error("{acceleration: 3}"), place + ": the key 'braking' is missing");
  EXPECT_EQ(error("{acceleration: 3, braking: -3}"), place + ".braking: expected a number above 0, got '-3'");
  EXPECT_EQ(error("slow"), place + ": expected a map with acceleration and braking, or unlimited, got 'slow'");
  EXPECT_EQ(error("{acceleration: 3, breaking: 3}"),
            place + ": unknown key 'breaking', did you mean 'braking'? Known are acceleration, braking, turn_rate");
}

TEST(ScenarioReader, RefusesWrongAgents) {
  const auto says = [](const std::string& entries, const std::string& part) {
    const std::string error = agentError(entries);
    EXPECT_NE(error.find("s.yaml: document 1, line 5: " + part), std::string::npos) << entries << "\n" << error;
  };
  const std::string place = "position: [0, 0], goal: [1, 1], ";
  says(place + "speed: 0, radius: 0.2", "agents[0].speed: expected a number above 0, got '0'");
  says(place + "speed: .inf, radius: 0.2", "agents[0].speed: expected a number above 0, got '.inf'");
  says(place + "speed: 1, radius: -0.2", "agents[0].radius: expected a number above 0");
  says(place + "speed: [1, 0.5], radius: 0.2", "agents[0].speed: expected [low, high], got the higher number first");
  says(place + "speed: [0, 0.5], radius: 0.2", "agents[0].speed[0]: expected a number above 0");
  says(place + "speed: [1, 2, 3], radius: 0.2", "agents[0].speed: expected a number or [low, high], got a list of 3");
  says(place + "speed: 1, radius: 0.2, count: 0", "agents[0].count: expected a whole number from 1");
  says(place + "speed: 1, radius: 0.2, count: 2", "agents[0].count: more than one body needs a region as position");
  says(place + "speed: 1, radius: 0.2, goals: [[2, 2]]", "agents[0]: expected either goal or goals, got both");
  says("position: [0, 0], goals: [], speed: 1, radius: 0.2", "agents[0].goals: expected a list of one or more points");
  says("position: [0, .nan], goal: [1, 1], speed: 1, radius: 0.2", "agents[0].position[1]: expected a number");
  says("position: {opposite: [0, 0]}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position: expected [x, y], {box: ...}, {ring: ...} or {map: free}");
  says("position: [0, 0], goal: {disc: 3}, speed: 1, radius: 0.2",
       "agents[0].goal: expected [x, y], {box: ...}, {ring: ...}, {map: free} or {opposite: [x, y]}");
  says("position: {box: [[0, 1], [1, 0]]}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.box: expected the lower left corner, then the upper right one");
  says("position: {ring: {centre: [0, 0], radius: [2, 1]}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring.radius: expected [low, high]");
  says("position: {ring: {centre: [0, 0], radius: 0}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring.radius: expected an outer radius above 0");
  says("position: {ring: {center: [0, 0], radius: 1}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring: unknown key 'center', did you mean 'centre'? Known are centre, radius");
  says("position: {rign: {centre: [0, 0], radius: 1}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position: expected [x, y], {box: ...}, {ring: ...} or {map: free}, got 'rign', did you mean 'ring'?");
  says("position: [0, 0], goal: {opposit: [0, 0]}, speed: 1, radius: 0.2",
       "agents[0].goal: expected [x, y], {box: ...}, {ring: ...}, {map: free} or {opposite: [x, y]}, got 'opposit', "
       "did you mean "
       "'opposite'?");
  EXPECT_NE(errorOf(std::string(HEAD) + "agents: []\n").find("line 4: agents: expected at least one agent"),
            std::string::npos);
}

TEST(ScenarioReader, RefusesWrongObstacles) {
  const auto says = [](const std::string& entries, const std::string& part) {
    const std::string error = obstacleError(entries);
    EXPECT_NE(error.find("s.yaml: document 1, line 6: " + part), std::string::npos) << entries << "\n" << error;
  };
  const std::string body = "position: [5, 5], radius: 0.3, ";
  says("position: [5, 5], radius: 0", "obstacles[0].radius: expected a number above 0");
  says(body + "velocity: 3", "obstacles[0].velocity: expected [x, y], got '3'");
  says(body + "velocity: [0, 1], to_and_fro: [0, 1]", "obstacles[0]: expected only one of velocity, to_and_fro");
  says(body + "to_and_fro: [0, 1]", "obstacles[0]: the key 'speed' is missing");
  says(body + "waypoints: [], speed: 1", "obstacles[0].waypoints: expected a list of one or more points");
  says(body + "speed: 1", "obstacles[0].speed: a speed goes with to_and_fro or waypoints only");
  says(body + "waypoints: [[5, 5]], speed: 1", "obstacles[0]: expected a path of at least two different points");
}

TEST(ScenarioReader, RefusesWrongWalls) {
  const std::string document = std::string(HEAD) + AGENTS + "walls:\n  - ";
  EXPECT_NE(errorOf(document + "[[1, 1], [1, 1]]\n").find("line 6: walls[0]: expected a wall with a length"),
            std::string::npos);
  EXPECT_NE(errorOf(document + "[1, 2, 3, 4]\n").find("line 6: walls[0]: expected two ends"), std::string::npos);
  EXPECT_NE(errorOf(document + "[[1, 1], [2]]\n").find("line 6: walls[0][1]: expected [x, y]"), std::string::npos);
}

TEST(ScenarioReader, RefusesBodiesThatOverlapAtTheStart) {
  const std::string agents = std::string(HEAD) + "agents:\n  - " + AGENT + "\n";  // line 5: (0, 0), radius 0.25
  EXPECT_EQ(errorOf(agents + "  - {position: [0.3, 0.4], goal: [1, 1], speed: 1, radius: 0.35}\n"),
            "s.yaml: document 1, line 6: agents[1] and agents[0] overlap by 0.1 m");
  EXPECT_EQ(errorOf(agents + "obstacles:\n  - {position: [0, 0.5], radius: 0.37}\n"),
            "s.yaml: document 1, line 5: agents[0] and obstacles[0] overlap by 0.12 m");
  EXPECT_EQ(errorOf(agents + "walls:\n  - [[-1, 0.2], [1, 0.2]]\n"),
            "s.yaml: document 1, line 5: agents[0] and walls[0] overlap by 0.05 m");
}

TEST(ScenarioReader, RefusesAgentsThatStartAtTheirGoal) {
  const auto problem = [](const std::string& places) { return agentError(places + ", speed: 1, radius: 0.25"); };
  const std::string expected =
      "s.yaml: document 1, line 5: agents[0]: its goal is 0.25 m from its start, within "
      "goal_tolerance (0.3 m)";
  EXPECT_EQ(problem("position: [1, 0], goal: [1.25, 0]"), expected);
  EXPECT_EQ(problem("position: [1, 0], goals: [[1.25, 0], [4, 0]]"), expected);
  EXPECT_EQ(problem("position: [1, 0], goal: {opposite: [1.125, 0]}"), expected);
  const std::string drawn = problem("position: {box: [[0, 0], [0.125, 0]]}, goal: [0.25, 0]");
  EXPECT_NE(drawn.find("no free place for it and its goal found"), std::string::npos) << drawn;
  EXPECT_EQ(problem("position: [1, 0], goals: [[4, 0], [4, 0.25]]"), "no InputError");
}

/// An agent of radius 0.5 m stands at least 0.5 m from a wall, and has arrived 0.3 m from its goal.
TEST(ScenarioReader, RefusesGoalsInWallsAndObstacles) {
  const auto problem = [](const std::string& places, const std::string& keys = "") {
    return errorOf(std::string(HEAD) + "agents:\n  - {" + places + ", speed: 1, radius: [0.25, 0.5]}\n" + keys +
                   "walls:\n  - [[4, -2], [4, 2]]\nobstacles:\n  - {position: [0, 5], radius: 1}\n"
                   "  - {position: [0, 9], radius: 1, velocity: [1, 0]}\n");
  };
  const auto expected = [](const std::string& field, const std::string& goal) {
    return "s.yaml: document 1, line 5: agents[0]." + field +
           ": expected a goal that an agent of radius 0.5 m can get to within goal_tolerance (0.3 m), got " + goal +
           ", which is in a wall or an obstacle";
  };
  EXPECT_EQ(problem("position: [1, 0], goal: [4, 0]"), expected("goal", "(4, 0)"));
  EXPECT_EQ(problem("position: [1, 0], goal: [3.81, 0]"), expected("goal", "(3.81, 0)"));
  EXPECT_EQ(problem("position: [1, 0], goal: [3.79, 0]"), "no InputError");
  EXPECT_EQ(problem("position: [1, 0], goals: [[2, 3], [0, 6.19]]"), expected("goals[1]", "(0, 6.19)"));
  EXPECT_EQ(problem("position: [1, 0], goals: [[2, 3], [0, 6.21]]"), "no InputError");
  EXPECT_EQ(problem("position: [1, 0], goal: {opposite: [2.5, 0]}"), expected("goal", "(4, 0)"));
  EXPECT_EQ(problem("count: 3, position: {box: [[0, 0], [3, 3]]}, goal: [4, 1]"), expected("goal", "(4, 1)"));
  EXPECT_EQ(problem("position: [1, 0], goal: [0, 9]"), "no InputError");  // that obstacle moves away
  EXPECT_EQ(problem("position: [1, 0], goal: [4, 0]", "way_finding: false\n"), "no InputError");
}

TEST(ScenarioReader, AcceptsTouchingBodiesAndOverlappingObstaclesAndWalls) {
  const std::string agents = std::string(HEAD) + "agents:\n  - " + AGENT + "\n";
  EXPECT_NO_THROW(parseScenarios(agents + "obstacles:\n  - {position: [0.3, 0.4], radius: 0.25}\n", "s.yaml"));
  EXPECT_NO_THROW(parseScenarios(agents + "obstacles:\n  - {position: [3, 0], radius: 0.5}\n"
                                          "  - {position: [3.1, 0], radius: 0.5}\nwalls:\n  - [[3, 0], [3, 2]]\n",
                                 "s.yaml"));
}

TEST(ScenarioReader, RefusesFilesWithoutAScenario) {
  EXPECT_EQ(errorOf(""), "s.yaml: expected at least one scenario, got an empty file");
  EXPECT_EQ(errorOf("# only a note\n"), "s.yaml: expected at least one scenario, got an empty file");
  EXPECT_EQ(errorOf("- a\n"), "s.yaml: document 1, line 1: expected a map, got a list of 1");
  EXPECT_NE(errorOf(std::string(HEAD) + AGENTS + "---\n").find("document 2, line 6: expected a map, got nothing"),
            std::string::npos);
  EXPECT_NE(errorOf("name: [n\n").find("this is not YAML"), std::string::npos);
}

}  // namespace
}  // namespace crowd::scenario_reader_refusals_test
