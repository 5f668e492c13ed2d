#include "social_crowd/robot_batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "scenario/reading/scenario_reader.h"
#include "simulation/episode_runner.h"
#include "simulation/evaluation/evaluation.h"
#include "social_crowd/errors.h"
#include "social_crowd/evaluation.h"
#include "support/error_of.h"

namespace crowd::library::robot_batch_test {
namespace {

const char* const TABLE = SOURCE_DIR "/config/q_tables/anticipation.txt";

/// A robot drives straight ahead through people who cross its way.
const char* const CROSSING =
    "name: crossing\n"
    "duration: 14\n"
    "goal_tolerance: 0.3\n"
    "contact: solid\n"
    "agents:\n"
    "  - {count: 8, position: {box: [[-2, -6], [2, -3]]}, goal: {box: [[-2, 6], [2, 9]]}, speed: 1.2, radius: 0.25}\n"
    "robots:\n"
    "  - {name: cart, position: [-6, 3], radius: 0.3, max_speed: 1}\n"
    "  - {name: tug, position: [-6, 0], goal: [6, 0], heading: 0, radius: 0.3, max_speed: 1, yields: nobody,\n"
    "     scan: {rays: 90, noise: 0.01}}\n";

Scenario crossing() { return Scenario::parse(CROSSING, "crossing.yaml"); }

RobotBatchOptions optionsFor(std::size_t size, unsigned threads = 1) {
  RobotBatchOptions options;
  options.size = size;
  options.robot = "tug";
  options.max_people = 4;
  options.threads = threads;
  return options;
}

/// Full speed ahead, also at the goal.
std::vector<double> ahead(std::size_t size) {
  std::vector<double> commands(3 * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) commands[3 * i] = 1.0;
  return commands;
}

TEST(RobotBatch, WalksAsTheClassesBehindIt) {
  const QTable table = QTable::load(TABLE);
  RobotBatch batch({crossing()}, table, optionsFor(3, 2));
  batch.begin({{0, 0, 7, 0, 0}, {1, 0, 7, 1, 1}, {2, 0, 8, 0, 5}});
  crowd::Learner learner = makeDemoLearner(table.trained(), 1);
  CrowdDecider decider(learner);
  const Scenario scenario = crossing();
  crowd::Episode expected(scenario.list().scene(7, 1), 1, table.trained().model.vision());
  RobotSenses senses(expected.scene());
  for (int tick = 0; tick < 100; ++tick) {
    batch.step(ahead(3));
    expected.robots().command(1, {{1.0, 0.0}, 0.0});
    ASSERT_TRUE(expected.walk(decider));
    senses.observe(expected.world());
    const Robot& robot = expected.world().robots()[1];
    ASSERT_EQ(batch.arrays().pose[3], robot.pose.position.x()) << tick;
    ASSERT_EQ(batch.arrays().pose[4], robot.pose.position.y()) << tick;
    ASSERT_EQ(batch.arrays().contacts[1], robot.contacts.size()) << tick;
    const std::vector<float>& ranges = senses.ranges(expected.world(), 1);
    for (std::size_t ray = 0; ray < ranges.size(); ++ray) ASSERT_EQ(batch.arrays().scan[90 + ray], ranges[ray]);
  }
  EXPECT_EQ(batch.result(1).path_length, expected.result().robots[1].path_length);
  EXPECT_EQ(batch.result(1).name, "tug");
}

TEST(RobotBatch, ThreadsChangeNothing) {
  const QTable table = QTable::load(TABLE);
  RobotBatch one({crossing()}, table, optionsFor(5, 1));
  RobotBatch many({crossing()}, table, optionsFor(5, 4));
  std::vector<EpisodeStart> starts;
  for (std::size_t i = 0; i < 5; ++i) starts.push_back({i, 0, 100 + i, 0, 0});
  one.begin(starts);
  many.begin(starts);
  for (int tick = 0; tick < 60; ++tick) {
    one.step(ahead(5));
    many.step(ahead(5));
  }
  EXPECT_EQ(one.arrays().pose, many.arrays().pose);
  EXPECT_EQ(one.arrays().people, many.arrays().people);
  EXPECT_EQ(one.arrays().clearance, many.arrays().clearance);
  EXPECT_EQ(one.arrays().scan, many.arrays().scan);
}

TEST(RobotBatch, DescribesItsRobot) {
  const RobotBatch batch({crossing()}, QTable::load(TABLE), optionsFor(1));
  EXPECT_EQ(batch.robot().name, "tug");
  EXPECT_EQ(batch.robot().drive, "differential");
  EXPECT_EQ(batch.robot().max_speed, 1.0);
  EXPECT_EQ(batch.robot().radius, 0.3);
  EXPECT_EQ(batch.robot().rays, 90U);
  EXPECT_DOUBLE_EQ(batch.robot().angle_increment, 2.0 * 3.14159265358979323846 / 90.0);
}

TEST(RobotBatch, RefusesInvalidInput) {
  const QTable table = QTable::load(TABLE);
  RobotBatch batch({crossing()}, table, optionsFor(2));
  EXPECT_THROW(batch.step(ahead(2)), InputError);  // nothing has begun
  EXPECT_THROW(batch.begin({{2, 0, 1, 0, 0}}), InputError);
  EXPECT_THROW(batch.begin({{0, 1, 1, 0, 0}}), InputError);
  EXPECT_THROW(batch.begin({{1, 0, 1, 0, 0}, {1, 0, 2, 0, 0}}), InputError);
  batch.begin({{0, 0, 1, 0, 0}, {1, 0, 2, 0, 0}});
  EXPECT_THROW(batch.step(ahead(1)), InputError);
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<double> commands = ahead(2);
    commands[5] = number;
    EXPECT_THROW(batch.step(commands), InputError);
  }
  EXPECT_EQ(batch.arrays().tick[0], 0U);  // nothing has moved
  EXPECT_THROW(batch.result(2), InputError);
  RobotBatchOptions options = optionsFor(1);
  options.robot = "truck";
  EXPECT_THROW(RobotBatch({crossing()}, table, options), InputError);
  EXPECT_THROW(RobotBatch({}, table, optionsFor(1)), InputError);
  EXPECT_THROW(RobotBatch({crossing()}, table, optionsFor(0)), InputError);
}

/// A scenario with a robot like `tug` in all but these words.
Scenario withTug(const std::string& words) {
  return Scenario::parse(
      "name: other\nduration: 14\ngoal_tolerance: 0.3\nrobots:\n  - {name: tug, position: [-6, 0], goal: [6, 0], "
      "radius: "
      "0.3, " +
          words + "}\n",
      "other.yaml");
}

TEST(RobotBatch, TakesRobotsThatAreAlikeOnly) {
  const QTable table = QTable::load(TABLE);
  const auto error = [&](const std::string& words) {
    return errorOf<InputError>([&] { RobotBatch({crossing(), withTug(words)}, table, optionsFor(1)); });
  };
  EXPECT_EQ(error("max_speed: 1, yields: both, scan: {rays: 90, period: 0.2, noise: 0.5}"), "no error");
  for (const char* const words :
       {"max_speed: 1, drive: holonomic, scan: {rays: 90}", "max_speed: 2, scan: {rays: 90}",
        "max_speed: 1, max_rotation: 0.5, scan: {rays: 90}", "max_speed: 1, scan: {rays: 91}",
        "max_speed: 1, scan: {rays: 90, angles: [-90, 270]}", "max_speed: 1, scan: {rays: 90, angles: [-180, 90]}",
        "max_speed: 1, scan: {rays: 90, range: [0.2, 10]}", "max_speed: 1, scan: {rays: 90, range: [0.05, 7]}"}) {
    EXPECT_TRUE(contains(error(words), "expected drive, greatest speeds and scanner of the robot of the first"))
        << words << ": " << error(words);
  }
  EXPECT_TRUE(contains(error("max_speed: 1, drive: external"), "got drive: external"));
}

TEST(RobotBatch, CommandsTheFirstRobotIfNoneIsNamed) {
  RobotBatchOptions options = optionsFor(1);
  options.robot.clear();
  options.max_people = 0;
  options.scan = false;
  options.ticks = 5;
  RobotBatch batch({crossing()}, QTable::load(TABLE), options);
  EXPECT_EQ(batch.robot().name, "cart");
  batch.begin({{0, 0, 1, 0, 0}});
  batch.step(ahead(1));
  EXPECT_EQ(batch.arrays().tick[0], 5U);
  EXPECT_GT(batch.arrays().pose[0], -6.0);
  EXPECT_EQ(batch.arrays().has_goal[0], 0);
  EXPECT_TRUE(batch.arrays().scan.empty());
  EXPECT_TRUE(batch.arrays().people.empty());
  options.ticks = 0;
  EXPECT_THROW(RobotBatch({crossing()}, QTable::load(TABLE), options), InputError);
}

TEST(RobotBatch, NamesTheRobotsThatThereAre) {
  const auto error = [](const Scenario& scenario) {
    return errorOf<InputError>([&] {
      RobotBatchOptions options = optionsFor(1);
      options.robot = "truck";
      RobotBatch({scenario}, QTable::load(TABLE), options);
    });
  };
  EXPECT_EQ(error(crossing()), "crossing.yaml: document 1: there is no robot 'truck', only: cart, tug");
  const char* const people =
      "name: people\nduration: 1\ngoal_tolerance: 0.3\nagents: [{position: [0, 0], goal: [1, 0], speed: 1, radius: "
      "0.2}]\n";
  EXPECT_EQ(error(Scenario::parse(people, "people.yaml")), "people.yaml: document 1: the scenario has no robot");
}

TEST(RobotBatch, HasAgentsAndWallsOfEachEpisode) {
  const Scenario walled = Scenario::parse(std::string(CROSSING) + "walls: [[[-9, 9], [9, 9]]]\n", "walled.yaml");
  RobotBatch batch({crossing(), walled}, QTable::load(TABLE), optionsFor(2));
  EXPECT_THROW(batch.walls(0), InputError);  // has not begun
  batch.begin({{0, 0, 1, 0, 0}, {1, 1, 2, 0, 0}});
  EXPECT_TRUE(batch.walls(0).empty());
  ASSERT_EQ(batch.walls(1).size(), 1U);
  EXPECT_EQ(batch.walls(1)[0].to.x, 9.0);
  batch.step(ahead(2));
  AgentArrays agents;
  batch.agents(1, agents);
  ASSERT_EQ(agents.id, (std::vector<AgentId>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(agents.position.size(), 16U);
  EXPECT_EQ(agents.radius, std::vector<double>(8, 0.25));
  EXPECT_EQ(agents.max_speed, std::vector<double>(8, 1.2));
  EXPECT_GE(agents.goal[1], 6.0);
  EXPECT_THROW(batch.agents(2, agents), InputError);
}

}  // namespace
}  // namespace crowd::library::robot_batch_test
