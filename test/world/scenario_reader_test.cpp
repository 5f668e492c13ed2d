#include "social_crowd/world/scenario_reader.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "social_crowd/common/errors.h"

namespace crowd {
namespace {

const char* const HEAD = "name: n\nduration: 60\ngoal_tolerance: 0.3\n";  // lines 1 to 3
const char* const AGENT = "{position: [0, 0], goal: [4, 3], speed: 1.3, radius: 0.25}";
const char* const AGENTS = "agents: [{position: [0, 0], goal: [4, 3], speed: 1.3, radius: 0.25}]\n";  // line 4

std::string errorOf(const std::string& text) {
  try {
    parseScenarios(text, "s.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

/// What is said of a scenario whose only agent has these entries changed or added.
std::string agentError(const std::string& entries) {
  return errorOf(std::string(HEAD) + "agents:\n  - {" + entries + "}\n");
}

std::string obstacleError(const std::string& entries) {
  return errorOf(std::string(HEAD) + AGENTS + "obstacles:\n  - {" + entries + "}\n");
}

Scene sceneOf(const std::string& text) { return parseScenarios(text, "s.yaml").scene(1, 0); }

Obstacle obstacleOf(const std::string& entries) {
  return sceneOf(std::string(HEAD) + AGENTS + "obstacles: [{" + entries + "}]\n").obstacles.at(0);
}

void expectNear(const Vector2& value, const Vector2& expected) {
  EXPECT_NEAR(value.x(), expected.x(), 1e-12);
  EXPECT_NEAR(value.y(), expected.y(), 1e-12);
}

TEST(ScenarioReader, ReadsTheSchemaOfTheBenchmark) {
  const Scene scene = sceneOf(
      "---\nname: door\nduration: 60\ngoal_tolerance: 0.3\n"
      "agents:\n"
      "  - {position: [1, 2], goal: [4, 6], speed: 1.3, radius: 0.25}\n"
      "  - {position: [-1, 2], goal: [-1, 0], speed: 0.8, radius: 0.2}\n"
      "obstacles:\n"
      "  - {position: [5, 5], radius: 0.4}\n"
      "  - {position: [6, 5], radius: 0.5, velocity: [0.1, -0.2]}\n"
      "walls:\n"
      "  - [[0, 8], [9, 8]]\n");
  EXPECT_EQ(scene.name, "door");
  EXPECT_EQ(scene.tick_duration, 0.1);
  EXPECT_EQ(scene.max_ticks, 600U);
  EXPECT_EQ(scene.goal_tolerance, 0.3);
  ASSERT_EQ(scene.agents.size(), 2U);
  EXPECT_EQ(scene.agents[0].position, Vector2(1.0, 2.0));
  ASSERT_EQ(scene.agents[0].goals.size(), 1U);
  EXPECT_EQ(scene.agents[0].goals[0], Vector2(4.0, 6.0));
  EXPECT_NEAR(scene.agents[0].heading, std::atan2(4.0, 3.0), 1e-12);
  EXPECT_EQ(scene.agents[0].max_speed, 1.3);
  EXPECT_EQ(scene.agents[0].radius, 0.25);
  EXPECT_NEAR(scene.agents[1].heading, -PI / 2.0, 1e-12);
  ASSERT_EQ(scene.obstacles.size(), 2U);
  EXPECT_EQ(scene.obstacles[0].radius, 0.4);
  EXPECT_FALSE(scene.obstacles[0].path.moves());
  EXPECT_EQ(scene.obstacles[1].path.velocity(3.0), Vector2(0.1, -0.2));
  ASSERT_EQ(scene.walls.size(), 1U);
  EXPECT_EQ(scene.walls[0].to, Vector2(9.0, 8.0));
}

TEST(ScenarioReader, ReadsEveryDocumentOfAStream) {
  const std::string document = std::string(HEAD) + AGENTS;
  const ScenarioList list = parseScenarios("# note\n---\n" + document + "---\n" + document, "s.yaml");
  EXPECT_EQ(list.size(), 2U);
}

TEST(ScenarioReader, TurnsThesisUnitsIntoSI) {
  const Scene scene = sceneOf(
      "name: n\nunits: thesis\ntick: 0.2\nduration: 2000\ngoal_tolerance: 0.3\n"
      "agents: [{position: [0, 0], goal: [4, 0], speed: 0.03, radius: 0.25}]\n"
      "obstacles:\n"
      "  - {position: [5, 5], radius: 0.4, velocity: [0.01, -0.02]}\n"
      "  - {position: [6, 5], radius: 0.4, to_and_fro: [6, 9], speed: 0.01}\n");
  EXPECT_EQ(scene.max_ticks, 2000U);
  EXPECT_EQ(scene.goal_tolerance, 0.3);
  EXPECT_EQ(scene.agents[0].radius, 0.25);
  EXPECT_NEAR(scene.agents[0].max_speed * scene.tick_duration, 0.03, 1e-15);
  EXPECT_NEAR(scene.agents[0].max_speed, 0.15, 1e-15);
  expectNear(scene.obstacles[0].path.velocity(0.0), {0.05, -0.1});
  expectNear(scene.obstacles[1].path.velocity(0.0), {0.0, 0.05});
}

TEST(ScenarioReader, CountsTheTicksOfADuration) {
  const auto ticks = [](const std::string& entries) {
    return sceneOf("name: n\ngoal_tolerance: 0.3\n" + entries + AGENTS).max_ticks;
  };
  EXPECT_EQ(ticks("duration: 60\n"), 600U);
  EXPECT_EQ(ticks("duration: 0.3\n"), 3U);  // 0.3 / 0.1 is 2.9999999999999996
  EXPECT_EQ(ticks("duration: 0.39\n"), 3U);
  EXPECT_EQ(ticks("duration: 1\ntick: 0.3\n"), 3U);
}

TEST(ScenarioReader, ReadsHeadingsAsDegrees) {
  const Scene scene = sceneOf(std::string(HEAD) +
                              "agents:\n"
                              "  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.2, heading: 90}\n"
                              "  - {position: [1, 0], goal: [4, 0], speed: 1, radius: 0.2, heading: 270}\n"
                              "  - {position: [2, 0], goal: [4, 0], speed: 1, radius: 0.2, heading: [30, 60]}\n");
  EXPECT_NEAR(scene.agents[0].heading, PI / 2.0, 1e-12);
  EXPECT_NEAR(scene.agents[1].heading, -PI / 2.0, 1e-12);
  EXPECT_GE(scene.agents[2].heading, toRadians(30.0));
  EXPECT_LE(scene.agents[2].heading, toRadians(60.0));
}

TEST(ScenarioReader, ReadsGoalsThatFollowOneAnother) {
  const Scene scene = sceneOf(std::string(HEAD) +
                              "agents: [{position: [0, 0], goals: [[0, 2], {box: [[5, 5], [6, 6]]}, [1, 1]], "
                              "speed: 1, radius: 0.2}]\n");
  const AgentStart& agent = scene.agents[0];
  ASSERT_EQ(agent.goals.size(), 3U);
  EXPECT_EQ(agent.goals[0], Vector2(0.0, 2.0));
  EXPECT_GE(agent.goals[1].x(), 5.0);
  EXPECT_EQ(agent.goals[2], Vector2(1.0, 1.0));
  EXPECT_NEAR(agent.heading, PI / 2.0, 1e-12);
}

TEST(ScenarioReader, MirrorsTheStartForAnOppositeGoal) {
  const Scene scene =
      sceneOf(std::string(HEAD) + "agents: [{position: [3, 1], goal: {opposite: [1, 2]}, speed: 1, radius: 0.2}]\n");
  expectNear(scene.agents[0].goals.at(0), {-1.0, 3.0});
}

TEST(ScenarioReader, ReadsTheWaysObstaclesMove) {
  const Obstacle to_and_fro = obstacleOf("position: [5, 0], radius: 0.3, to_and_fro: [5, 4], speed: 0.5");
  EXPECT_EQ(to_and_fro.path.kind(), ObstaclePath::Kind::TO_AND_FRO);
  expectNear(to_and_fro.path.position(10.0), {5.0, 3.0});  // 5 m: 4 there, 1 back

  const Obstacle bent = obstacleOf("position: [5, 0], radius: 0.3, to_and_fro: [[5, 4], [7, 4]], speed: 0.5");
  expectNear(bent.path.position(10.0), {6.0, 4.0});

  const Obstacle loop = obstacleOf("position: [5, 0], radius: 0.3, waypoints: [[8, 0], [8, 4]], speed: 0.5");
  EXPECT_EQ(loop.path.kind(), ObstaclePath::Kind::LOOP);
  expectNear(loop.path.position(24.0), {5.0, 0.0});  // 3 + 4 + 5 m

  const Obstacle drawn =
      obstacleOf("position: [5, 0], radius: 0.3, to_and_fro: {box: [[8, 0], [9, 1]]}, speed: [0.5, 0.6]");
  ASSERT_EQ(drawn.path.points().size(), 2U);
  EXPECT_GE(drawn.path.points()[1].x(), 8.0);
  EXPECT_GE(drawn.path.velocity(0.0).norm(), 0.5);
  EXPECT_LE(drawn.path.velocity(0.0).norm(), 0.6);

  const Obstacle resting = obstacleOf("position: [5, 0], radius: 0.3, velocity: [0, 0]");
  EXPECT_FALSE(resting.path.moves());
}

TEST(ScenarioReader, TakesEmptyListsOfObstaclesAndWalls) {
  EXPECT_TRUE(sceneOf(std::string(HEAD) + AGENTS + "obstacles: []\nwalls:\n").obstacles.empty());
}

TEST(ScenarioReader, SaysFileDocumentLineAndWhatWasExpected) {
  const std::string document = std::string(HEAD) + "agents:\n  - " + AGENT + "\n";
  EXPECT_EQ(errorOf(document + "---\n" + HEAD + "agents:\n  - " + AGENT +
                    "\n  - position: [2, 2]\n    goal: [3, 3]\n    speed: fast\n    radius: 0.2\n"),
            "s.yaml: document 2, line 14: agents[1].speed: expected a number above 0, got 'fast'");
}

TEST(ScenarioReader, RefusesUnknownMissingAndDoubleKeys) {
  EXPECT_EQ(errorOf(std::string(HEAD) + AGENTS + "obstacle: []\n"),
            "s.yaml: document 1, line 5: unknown key 'obstacle', did you mean 'obstacles'? Known are name, units, "
            "tick, duration, "
            "goal_tolerance, collision_radius, contact, order, seed, agents, obstacles, walls");
  EXPECT_EQ(errorOf("name: n\nduration: 60\n" + std::string(AGENTS)),
            "s.yaml: document 1, line 1: the key 'goal_tolerance' is missing");
  EXPECT_EQ(agentError("position: [0, 0], goal: [1, 1], radius: 0.2"),
            "s.yaml: document 1, line 5: agents[0]: the key 'speed' is missing");
  EXPECT_EQ(
      agentError("position: [0, 0], goal: [1, 1], speed: 1, radius: 0.2, sped: 1"),
      "s.yaml: document 1, line 5: agents[0]: unknown key 'sped', did you mean 'speed'? Known are position, goal, "
      "goals, speed, radius, heading, count");
  // A required key that is misspelt is not told as missing, and all keys are known before the first is read.
  EXPECT_EQ(
      agentError("position: [0, 0], goal: [1, 1], speed: 1, raduis: 0.2"),
      "s.yaml: document 1, line 5: agents[0]: unknown key 'raduis', did you mean 'radius'? Known are position, goal, "
      "goals, speed, radius, heading, count");
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

TEST(ScenarioReader, ReadsWhatHappensAtContacts) {
  const auto contact = [](const std::string& entry) { return sceneOf(std::string(HEAD) + AGENTS + entry).contact; };
  EXPECT_EQ(contact(""), Contact::GHOST);
  EXPECT_EQ(contact("contact: ghost\n"), Contact::GHOST);
  EXPECT_EQ(contact("contact: solid\n"), Contact::SOLID);
  EXPECT_EQ(errorOf(std::string(HEAD) + AGENTS + "contact: soft\n"),
            "s.yaml: document 1, line 5: contact: expected ghost or solid, got 'soft'");
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
       "agents[0].position: expected [x, y], {box: ...} or {ring: ...}");
  says("position: [0, 0], goal: {disc: 3}, speed: 1, radius: 0.2",
       "agents[0].goal: expected [x, y], {box: ...}, {ring: ...} or {opposite: [x, y]}");
  says("position: {box: [[0, 1], [1, 0]]}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.box: expected the lower left corner, then the upper right one");
  says("position: {ring: {centre: [0, 0], radius: [2, 1]}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring.radius: expected [low, high]");
  says("position: {ring: {centre: [0, 0], radius: 0}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring.radius: expected an outer radius above 0");
  says("position: {ring: {center: [0, 0], radius: 1}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position.ring: unknown key 'center', did you mean 'centre'? Known are centre, radius");
  says("position: {rign: {centre: [0, 0], radius: 1}}, goal: [1, 1], speed: 1, radius: 0.2",
       "agents[0].position: expected [x, y], {box: ...} or {ring: ...}, got 'rign', did you mean 'ring'?");
  says("position: [0, 0], goal: {opposit: [0, 0]}, speed: 1, radius: 0.2",
       "agents[0].goal: expected [x, y], {box: ...}, {ring: ...} or {opposite: [x, y]}, got 'opposit', did you mean "
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

TEST(ScenarioReader, LetsBodiesTouchAndFixturesOverlap) {
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

TEST(ScenarioReader, ReadsFilesAndNamesThemInMessages) {
  EXPECT_THROW(readScenarios("no/such/scenario.yaml"), FileError);
  const std::string file = testing::TempDir() + "social_crowd_scenario_reader_test.yaml";
  std::ofstream(file) << HEAD << AGENTS;
  EXPECT_EQ(readScenarios(file).size(), 1U);
  std::ofstream(file) << HEAD;
  try {
    readScenarios(file);
    ADD_FAILURE() << "a scenario without agents was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file + ": document 1, line 1: the key 'agents' is missing");
  }
  std::remove(file.c_str());
}

TEST(ScenarioReader, ReadsTheOrderOfMoves) {
  const std::string document = std::string(HEAD) + AGENTS;
  EXPECT_EQ(sceneOf(document).order, Order::SIMULTANEOUS);
  EXPECT_EQ(sceneOf(document + "order: simultaneous\n").order, Order::SIMULTANEOUS);
  EXPECT_EQ(sceneOf(document + "order: sequential\n").order, Order::SEQUENTIAL);
  EXPECT_EQ(errorOf(document + "order: random\n"),
            "s.yaml: document 1, line 5: order: expected simultaneous or sequential, got 'random'");
}

TEST(ScenarioReader, ReadsTheCollisionRadius) {
  const std::string document = std::string(HEAD) + AGENTS;
  EXPECT_EQ(sceneOf(document).collision_radius, 0.5);  // the thesis's (4.1)
  EXPECT_EQ(sceneOf(document + "collision_radius: 0.3\n").collision_radius, 0.3);
  EXPECT_EQ(errorOf(document + "collision_radius: 0\n"),
            "s.yaml: document 1, line 5: collision_radius: expected a number above 0, got '0'");
}

TEST(ScenarioReader, ReadsHeadings) {
  const auto start = [](const std::string& heading) {
    return sceneOf(std::string(HEAD) +
                   "agents: [{position: [0, 0], goal: [0, 3], speed: 1, radius: 0.2, heading: " + heading + "}]\n")
        .agents.at(0);
  };
  EXPECT_NEAR(start("goal").heading, PI / 2.0, 1e-12);
  EXPECT_NEAR(start("30").heading, PI / 6.0, 1e-12);
  EXPECT_NEAR(start("[-60, -60]").heading, -PI / 3.0, 1e-12);
  EXPECT_FALSE(start("random").keeps_heading);
  EXPECT_TRUE(start("kept").keeps_heading);
  EXPECT_NEAR(start("kept").heading, PI / 2.0, 1e-12);  // of the first episode
  EXPECT_EQ(agentError("position: [0, 0], goal: [0, 3], speed: 1, radius: 0.2, heading: north"),
            "s.yaml: document 1, line 5: agents[0].heading: expected goal, random, kept, or degrees: a number or [low, "
            "high], got 'north'");
}

TEST(ScenarioReader, ReadsAPlaceBetweenAgentAndGoal) {
  // From (0, 0) to (4, 3), which is 5 m: half of that, and 0.5 m to the left.
  expectNear(obstacleOf("position: {between: {agent: 0, share: 0.5, aside: 0.5}}, radius: 0.4").path.position(0.0),
             Vector2(2.0 - 0.3, 1.5 + 0.4));
  expectNear(obstacleOf("position: {between: {agent: 0, share: 0.5}}, radius: 0.4").path.position(0.0),
             Vector2(2.0, 1.5));
  EXPECT_EQ(
      obstacleError("position: {between: {agent: 0, share: 1.5}}, radius: 0.4"),
      "s.yaml: document 1, line 6: obstacles[0].position.between.share: expected a number from 0 to 1, got '1.5'");
  EXPECT_EQ(obstacleError("position: {between: {agent: 1, share: 0.5}}, radius: 0.4"),
            "s.yaml: document 1, line 6: obstacles[0].position.between.agent: expected the number of an agent, 0 to 0, "
            "got 1");
  EXPECT_EQ(obstacleError("position: {between: {share: 0.5}}, radius: 0.4"),
            "s.yaml: document 1, line 6: obstacles[0].position.between: the key 'agent' is missing");
  EXPECT_EQ(obstacleError("position: {between: {agent: 0, share: 0}}, radius: 0.4"),
            "s.yaml: document 1, line 6: obstacles[0]: no free place found in 1000 tries");  // on the agent
  EXPECT_EQ(obstacleError("position: {between: {agent: 0, share: 0.5}}, radius: 0.4, count: 2"),
            "s.yaml: document 1, line 6: obstacles[0].count: more than one body needs a region as position");
}

}  // namespace
}  // namespace crowd
