#include "scenario/reading/scenario_reader.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "social_crowd/errors.h"
#include "support/scenario_texts.h"

namespace crowd::scenario_reader_test {
namespace {

using scenario_texts::agentError;
using scenario_texts::AGENTS;
using scenario_texts::errorOf;
using scenario_texts::expectNear;
using scenario_texts::HEAD;
using scenario_texts::obstacleError;
using scenario_texts::obstacleOf;
using scenario_texts::sceneOf;

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

TEST(ScenarioReader, ConvertsThesisUnitsToSI) {
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

TEST(ScenarioReader, ReadsMotionLimits) {
  const auto motion = [](const std::string& entry) { return sceneOf(std::string(HEAD) + entry + AGENTS).motion; };
  EXPECT_FALSE(motion("").has_value());
  EXPECT_EQ(motion("motion: {acceleration: 2, braking: 3, turn_rate: 1.75}\n"), (MotionLimits{2.0, 3.0, 1.75}));
  EXPECT_EQ(motion("motion: {acceleration: 2, braking: 3}\n"), (MotionLimits{2.0, 3.0, INFINITE}));
  EXPECT_EQ(motion("motion: unlimited\n"), MotionLimits());
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

TEST(ScenarioReader, ReadsSequencesOfGoals) {
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

TEST(ScenarioReader, ReadsPathsOfObstacles) {
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

TEST(ScenarioReader, AcceptsEmptyListsOfObstaclesAndWalls) {
  EXPECT_TRUE(sceneOf(std::string(HEAD) + AGENTS + "obstacles: []\nwalls:\n").obstacles.empty());
}

TEST(ScenarioReader, ReadsTheContactModel) {
  const auto contact = [](const std::string& entry) { return sceneOf(std::string(HEAD) + AGENTS + entry).contact; };
  EXPECT_EQ(contact(""), Contact::GHOST);
  EXPECT_EQ(contact("contact: ghost\n"), Contact::GHOST);
  EXPECT_EQ(contact("contact: solid\n"), Contact::SOLID);
  EXPECT_EQ(errorOf(std::string(HEAD) + AGENTS + "contact: soft\n"),
            "s.yaml: document 1, line 5: contact: expected ghost or solid, got 'soft'");
}

TEST(ScenarioReader, ReadsFilesAndNamesThemInErrors) {
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

TEST(ScenarioReader, ReadsWhatArrivedAgentsDo) {
  const std::string document = std::string(HEAD) + AGENTS;
  for (const char* const leaving : {"", "arrived: leave\n"}) {
    EXPECT_EQ(sceneOf(document + leaving).arrived, Arrived::LEAVE);
    EXPECT_FALSE(sceneOf(document + leaving).agents[0].stays);
  }
  EXPECT_EQ(sceneOf(document + "arrived: stay\n").arrived, Arrived::STAY);
  EXPECT_TRUE(sceneOf(document + "arrived: stay\n").agents[0].stays);
  EXPECT_EQ(errorOf(document + "arrived: go\n"),
            "s.yaml: document 1, line 5: arrived: expected leave or stay, got 'go'");
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
}  // namespace crowd::scenario_reader_test
