#include "social_crowd/episode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "learning/q_table_file.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/episode_runner.h"
#include "simulation/evaluation/evaluation.h"
#include "social_crowd/errors.h"

namespace crowd::library::episode_test {
namespace {

constexpr double HALF_TURN = 3.14159265358979323846;
const char* const TABLE = SOURCE_DIR "/config/q_tables/anticipation.txt";

/// Two agents 6 m apart, and a robot beside them; ticks of 0.1 s.
const char* const TWO_AGENTS =
    "name: two\n"
    "duration: 20\n"
    "goal_tolerance: 0.35\n"
    "agents:\n"
    "  - {position: [0, 0], goal: [10, 0], heading: 90, speed: 1, radius: 0.25}\n"
    "  - {position: [0, 6], goal: [3, 6], speed: 2, radius: 0.5}\n"
    "robots:\n"
    "  - {name: cart, position: [-5, 0], radius: 0.3, max_speed: 1, acceleration: 10, drive: holonomic}\n"
    "walls:\n"
    "  - [[0, -1], [1, -1]]\n";

Episode twoAgents() { return Episode(Scenario::parse(TWO_AGENTS, "two.yaml"), Vision()); }

std::vector<Action> stay(const Perceptions& /*perceptions*/) { return {}; }

/// Straight ahead, towards the goal.
std::vector<Action> walkToGoal(const Perceptions& perceptions) {
  std::vector<Action> actions;
  for (const Perception& seen : perceptions.agents) {
    actions.push_back({seen.agent, std::atan2(seen.goal.y, seen.goal.x), 1.0});
  }
  return actions;
}

void expectSamePlaces(const Episode& episode, const crowd::Episode& expected) {
  const std::vector<AgentState> agents = episode.agents();
  ASSERT_EQ(agents.size(), expected.world().agents().size());
  for (const AgentState& agent : agents) {
    const Agent& other = expected.world().agents()[agent.id];
    ASSERT_EQ(agent.pose.position.x, other.pose.position.x()) << agent.id;
    ASSERT_EQ(agent.pose.position.y, other.pose.position.y()) << agent.id;
    ASSERT_EQ(agent.pose.heading, other.pose.heading) << agent.id;
    ASSERT_EQ(agent.velocity.x, other.velocity.x()) << agent.id;
    ASSERT_EQ(agent.status == AgentStatus::ARRIVED, other.hasArrived()) << agent.id;
  }
}

void expectSameResult(const EpisodeResult& result, const crowd::EpisodeResult& expected) {
  EXPECT_EQ(result.scenario, expected.scenario);
  EXPECT_EQ(result.ticks, expected.ticks);
  EXPECT_EQ(result.count.arrived, expected.arrivedCount());
  EXPECT_EQ(result.count.touched, expected.touchedCount());
  EXPECT_EQ(result.count.collided, expected.collidedCount());
  ASSERT_EQ(result.agents.size(), expected.agents.size());
  for (std::size_t i = 0; i < result.agents.size(); ++i) {
    EXPECT_EQ(result.agents[i].ticks, expected.agents[i].ticks) << i;
    EXPECT_EQ(result.agents[i].path_length, expected.agents[i].path_length) << i;
  }
  ASSERT_EQ(result.robots.size(), expected.robots.size());
}

/// Walks a scenario of the package by `walk` and by the classes behind it.
template <typename Walk>
void expectSameWalk(const std::string& name, const Walk& walk) {
  SCOPED_TRACE(name);
  const TrainedTable trained = loadQTable(TABLE);
  crowd::Learner learner = makeDemoLearner(trained, 7);
  crowd::Episode expected(readScenarios(findScenario(name)).scene(7, 2), 2, trained.model.vision());
  CrowdDecider decider(learner);
  Episode episode(Scenario::load(name), QTable::load(TABLE).vision(), 7, 2);
  EXPECT_EQ(episode.tickDuration(), expected.world().tickDuration());
  bool goes_on = true;
  for (int tick = 0; goes_on && tick < 150; ++tick) {
    do {
      goes_on = expected.walk(decider);
    } while (goes_on && !expected.beginsTick());
    ASSERT_EQ(walk(episode), goes_on);
    ASSERT_EQ(episode.tick(), expected.world().tick());
    expectSamePlaces(episode, expected);
  }
  EXPECT_EQ(episode.isOver(), expected.isOver());
  expectSameResult(episode.result(), expected.result());
}

TEST(LibraryEpisode, WalksAsTheClassesBehindIt) {
  Learner learner(QTable::load(TABLE), 7);
  for (const char* const name : {"circle6", "line6_mover", "robot_circle_20", "place_corner"}) {
    expectSameWalk(name, [&](Episode& episode) { return episode.walk(learner); });
  }
}

TEST(LibraryEpisode, DecisionsThroughPerceptionsAreTheSame) {
  Learner learner(QTable::load(TABLE), 7);
  const Decide decide = [&](const Perceptions& perceptions) { return learner.decide(perceptions); };
  for (const char* const name : {"circle6", "line6_mover", "robot_circle_20", "place_corner"}) {
    expectSameWalk(name, [&](Episode& episode) { return episode.walk(decide); });
  }
}

TEST(LibraryEpisode, ResultsDoNotDependOnTheNumberOfThreads) {
  const QTable table = QTable::load(TABLE);
  Learner learner(table);
  const Scenario scenario = Scenario::load("crowd_circle_200");
  Episode one(scenario, table.vision());
  Episode two(scenario, table.vision(), 1, 0, 2);
  for (int tick = 0; tick < 20; ++tick) {
    ASSERT_TRUE(one.walk(learner));
    ASSERT_TRUE(two.walk(learner));
  }
  const std::vector<AgentState> agents = two.agents();
  for (const AgentState& agent : one.agents()) EXPECT_EQ(agent.pose.position.x, agents[agent.id].pose.position.x);
}

TEST(LibraryEpisode, PassesOnWhatAgentsPerceive) {
  Episode episode = twoAgents();
  int calls = 0;
  episode.walk([&](const Perceptions& perceptions) {
    ++calls;
    EXPECT_EQ(perceptions.tick, 0U);
    EXPECT_EQ(perceptions.tick_duration, 0.1);
    EXPECT_FALSE(perceptions.last);
    EXPECT_EQ(perceptions.agents.size(), 2U);
    const Perception& seen = perceptions.agents.at(0);
    EXPECT_EQ(seen.agent, 0U);
    EXPECT_EQ(seen.max_speed, 1.0);
    EXPECT_EQ(seen.radius, 0.25);
    EXPECT_NEAR(seen.pose.heading, HALF_TURN / 2, 1e-12);
    // It looks along y: the goal is on its right, the other agent ahead, the robot on its left.
    EXPECT_NEAR(seen.goal.x, 0.0, 1e-12);
    EXPECT_NEAR(seen.goal.y, -10.0, 1e-12);
    EXPECT_EQ(seen.neighbours.size(), 2U);
    const Neighbour& robot = seen.neighbours.at(0);
    EXPECT_EQ(robot.kind, NeighbourKind::ROBOT);
    EXPECT_NEAR(robot.position.x, 0.0, 1e-12);
    EXPECT_NEAR(robot.position.y, 5.0, 1e-12);
    const Neighbour& other = seen.neighbours.at(1);
    EXPECT_EQ(other.kind, NeighbourKind::AGENT);
    EXPECT_NEAR(other.position.x, 6.0, 1e-12);
    EXPECT_EQ(other.radius, 0.5);
    EXPECT_EQ(seen.walls.size(), 1U);
    EXPECT_NEAR(seen.walls.at(0).to.x, -1.0, 1e-12);
    EXPECT_NEAR(seen.walls.at(0).to.y, -1.0, 1e-12);
    return std::vector<Action>();
  });
  EXPECT_EQ(calls, 1);
}

TEST(LibraryEpisode, CarriesOutOwnDecisions) {
  Episode episode = twoAgents();
  ASSERT_TRUE(episode.walk([](const Perceptions&) { return std::vector<Action>{{0, HALF_TURN / 2, 0.5}}; }));
  EXPECT_EQ(episode.tick(), 1U);
  EXPECT_DOUBLE_EQ(episode.time(), 0.1);
  const std::vector<AgentState> agents = episode.agents();
  // Half of 1 m/s for 0.1 s along -x; the other agent has no action.
  EXPECT_NEAR(agents.at(0).pose.position.x, -0.05, 1e-12);
  EXPECT_NEAR(agents.at(0).pose.position.y, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(agents.at(0).pose.heading), HALF_TURN, 1e-12);
  EXPECT_NEAR(agents.at(0).velocity.x, -0.5, 1e-12);
  EXPECT_EQ(agents.at(0).goal.x, 10.0);
  EXPECT_EQ(agents.at(1).pose.position.x, 0.0);
  EXPECT_EQ(agents.at(1).max_speed, 2.0);
  EXPECT_EQ(agents.at(1).radius, 0.5);
}

TEST(LibraryEpisode, EndsWhenAllHaveArrived) {
  Episode episode = twoAgents();
  int last = 0;
  const Decide decide = [&](const Perceptions& perceptions) {
    last += perceptions.last ? 1 : 0;
    return walkToGoal(perceptions);
  };
  while (episode.walk(decide)) EXPECT_EQ(last, 0);
  EXPECT_EQ(last, 1);
  EXPECT_TRUE(episode.isOver());
  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.scenario, "two");
  EXPECT_EQ(result.ticks, 97U);  // 9.65 m at 1 m/s
  EXPECT_EQ(result.count.agents, 2U);
  EXPECT_EQ(result.count.arrived, 2U);
  EXPECT_TRUE(result.count.isClean());
  EXPECT_EQ(result.agents.at(0).ticks, 97U);
  EXPECT_NEAR(result.agents.at(0).path_length, 9.7, 1e-9);
  EXPECT_NEAR(result.agents.at(0).path_ratio, 9.7 / 9.65, 1e-9);
  EXPECT_EQ(result.agents.at(1).ticks, 14U);  // 2.65 m at 2 m/s
  EXPECT_EQ(result.robots.at(0).name, "cart");
  EXPECT_EQ(episode.agents().at(1).status, AgentStatus::ARRIVED);
}

TEST(LibraryEpisode, EachAgentHasATurnInASequentialScenario) {
  Episode episode(Scenario::load("circle6"), Vision());
  std::vector<AgentId> turns;
  ASSERT_TRUE(episode.walk([&](const Perceptions& perceptions) {
    for (const Perception& seen : perceptions.agents) turns.push_back(seen.agent);
    return std::vector<Action>();
  }));
  EXPECT_EQ(turns, (std::vector<AgentId>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(episode.tick(), 1U);
}

TEST(LibraryEpisode, AgentsAreAddedMovedAndRemoved) {
  Episode episode = twoAgents();
  AgentStart start;
  start.position = {4.0, 3.0};
  start.goals = {{8.0, 3.0}};
  EXPECT_EQ(episode.spawnAgent(start), 2U);
  episode.setGoal(0, {1.0, 1.0});
  episode.teleport(0, {{2.0, 0.0}, 0.5});
  episode.removeAgent(1);
  const std::vector<AgentState> agents = episode.agents();
  ASSERT_EQ(agents.size(), 3U);
  EXPECT_EQ(agents[0].goal.y, 1.0);
  EXPECT_EQ(agents[0].pose.position.x, 2.0);
  EXPECT_EQ(agents[0].pose.heading, 0.5);
  EXPECT_EQ(agents[1].status, AgentStatus::REMOVED);
  EXPECT_EQ(agents[2].max_speed, 1.3);
  EXPECT_EQ(agents[2].goal.x, 8.0);
  while (episode.walk(walkToGoal)) {
  }
  const EpisodeResult result = episode.result();
  EXPECT_EQ(result.count.agents, 2U);  // without the one that was removed
  EXPECT_EQ(result.count.arrived, 2U);
  EXPECT_EQ(result.agents.at(2).ticks, 29U);  // 3.65 m at 1.3 m/s
}

TEST(LibraryEpisode, WallsAreAddedAndRemoved) {
  Episode episode = twoAgents();
  EXPECT_EQ(episode.addWall({{3.0, -2.0}, {3.0, 2.0}}), 1U);
  episode.removeWall(0);
  const std::map<std::size_t, Wall> walls = episode.walls();
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls.at(1).from.y, -2.0);
  EXPECT_EQ(walls.at(1).to.x, 3.0);
}

TEST(LibraryEpisode, RobotsAreCommanded) {
  Episode episode = twoAgents();
  episode.commandRobot(0, {0.0, 1.0}, 0.0);
  ASSERT_TRUE(episode.walk(stay));
  RobotState robot = episode.robots().at(0);
  EXPECT_EQ(robot.name, "cart");
  EXPECT_NEAR(robot.pose.position.x, -5.0, 1e-12);
  EXPECT_NEAR(robot.pose.position.y, 0.1, 1e-12);
  EXPECT_NEAR(robot.velocity.y, 1.0, 1e-12);
  EXPECT_FALSE(robot.goal);
  EXPECT_FALSE(robot.arrived);
  EXPECT_FALSE(robot.in_contact);
  episode.teleportRobot(0, {{-7.0, 2.0}, 1.0});
  robot = episode.robots().at(0);
  EXPECT_EQ(robot.pose.position.x, -7.0);
  EXPECT_EQ(robot.pose.heading, 1.0);
}

TEST(LibraryEpisode, RefusesWhatIsInvalidAndChangesNothing) {
  Episode episode = twoAgents();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(episode.walk([&](const Perceptions&) { return std::vector<Action>{{0, nan, 1.0}}; }), InputError);
  EXPECT_THROW(episode.walk([&](const Perceptions&) { return std::vector<Action>{{0, 0.0, 1.5}}; }), InputError);
  EXPECT_THROW(episode.walk([](const Perceptions&) -> std::vector<Action> { throw FileError("mine"); }), FileError);
  EXPECT_THROW(episode.setGoal(7, {0.0, 0.0}), InputError);
  EXPECT_THROW(episode.teleport(0, {{0.0, 6.0}, 0.0}), InputError);  // the other agent is there
  EXPECT_THROW(episode.spawnAgent({}), InputError);                  // no goal
  EXPECT_THROW(episode.removeWall(1), InputError);
  EXPECT_THROW(episode.commandRobot(1, {0.0, 0.0}, 0.0), InputError);
  EXPECT_EQ(episode.tick(), 0U);
  EXPECT_EQ(episode.agents().size(), 2U);
  EXPECT_EQ(episode.agents().at(0).pose.position.x, 0.0);
  EXPECT_TRUE(episode.walk(stay));
}

TEST(LibraryEpisode, ArraysHaveTheNumbersOfTheAgents) {
  Episode episode = twoAgents();
  AgentArrays arrays;
  arrays.id.resize(9);  // of another episode
  while (episode.agents()[1].status == AgentStatus::WALKING) {
    ASSERT_TRUE(episode.walk(walkToGoal));
    episode.agents(arrays);
    const std::vector<AgentState> agents = episode.agents();
    ASSERT_EQ(arrays.id, (std::vector<AgentId>{0, 1}));
    for (const AgentState& agent : agents) {
      ASSERT_EQ(arrays.status[agent.id], static_cast<std::uint8_t>(agent.status));
      ASSERT_EQ(arrays.position[2 * agent.id], agent.pose.position.x);
      ASSERT_EQ(arrays.position[2 * agent.id + 1], agent.pose.position.y);
      ASSERT_EQ(arrays.heading[agent.id], agent.pose.heading);
      ASSERT_EQ(arrays.velocity[2 * agent.id], agent.velocity.x);
      ASSERT_EQ(arrays.goal[2 * agent.id], agent.goal.x);
      ASSERT_EQ(arrays.max_speed[agent.id], agent.max_speed);
      ASSERT_EQ(arrays.radius[agent.id], agent.radius);
      ASSERT_EQ(arrays.in_contact[agent.id] != 0, agent.in_contact);
    }
  }
  EXPECT_EQ(arrays.status, (std::vector<std::uint8_t>{0, 1}));
}

TEST(LibraryEpisode, CarriesOutGivenActionsInTurns) {
  const char* const turns =
      "name: turns\nduration: 5\ngoal_tolerance: 0.3\norder: sequential\nagents:\n"
      "  - {position: [0, 0], goal: [10, 0], heading: 0, speed: 1, radius: 0.25}\n"
      "  - {position: [0, 6], goal: [10, 6], heading: 0, speed: 2, radius: 0.25}\n";
  Episode episode(Scenario::parse(turns, "turns.yaml"), Vision());
  ASSERT_TRUE(episode.walk({{1, 0.0, 1.0}, {0, 0.0, 0.5}}));
  EXPECT_EQ(episode.tick(), 1U);
  EXPECT_NEAR(episode.agents()[0].pose.position.x, 0.05, 1e-12);
  EXPECT_NEAR(episode.agents()[1].pose.position.x, 0.2, 1e-12);
  ASSERT_TRUE(episode.walk({{1, 0.0, 1.0}}));  // the other one stays
  EXPECT_NEAR(episode.agents()[0].pose.position.x, 0.05, 1e-12);
  EXPECT_NEAR(episode.agents()[1].pose.position.x, 0.4, 1e-12);
}

TEST(LibraryEpisode, GoesOnInAnotherObject) {
  Learner other(QTable::load(TABLE), 7);
  Learner learner(QTable::load(TABLE), 8);
  learner = std::move(other);
  Episode expected(Scenario::load("circle6"), QTable::load(TABLE).vision());
  Episode first(Scenario::load("circle6"), QTable::load(TABLE).vision());
  Learner own(QTable::load(TABLE), 7);
  ASSERT_TRUE(first.walk(learner));
  Episode episode = twoAgents();
  episode = std::move(first);
  ASSERT_TRUE(episode.walk(learner));
  for (int tick = 0; tick < 2; ++tick) ASSERT_TRUE(expected.walk(own));
  EXPECT_EQ(episode.tick(), 2U);
  for (const AgentState& agent : expected.agents()) {
    EXPECT_EQ(episode.agents()[agent.id].pose.position.x, agent.pose.position.x);
  }
}

TEST(LibraryEpisode, ScansOfRobots) {
  Episode episode = twoAgents();
  episode.addWall({{-4.0, -3.0}, {-4.0, 3.0}});
  const RobotScan scan = episode.scan(0);
  ASSERT_FALSE(scan.ranges.empty());
  const auto ahead = static_cast<std::size_t>(std::lround(-scan.first_angle / scan.increment));
  EXPECT_NEAR(scan.ranges[ahead], 1.0F, 0.01F);
  EXPECT_THROW(episode.scan(1), InputError);
}

}  // namespace
}  // namespace crowd::library::episode_test
