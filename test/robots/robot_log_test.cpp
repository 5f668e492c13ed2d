#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "robots/log/robot_log_reading.h"
#include "robots/log/robot_log_scoring.h"
#include "robots/log/robot_log_writing.h"
#include "simulation/evaluation/robot_log_record.h"
#include "support/error_of.h"
#include "support/robot_episodes.h"
#include "support/robot_logs.h"
#include "support/seeds.h"
#include "support/straight_walk.h"
#include "support/temporary_folder.h"

namespace crowd::robots::robot_log_test {
namespace {

const std::string HEADER =
    R"({"tick_duration": 0.5, "robots": [{"radius": 0.3, "max_speed": 1, "goals": [[2, 0]], "goal_tolerance": 0.1}]})"
    "\n";

/// The result of the first robot of the last episode of a log.
RobotResult scored(const std::string& log) {
  const TemporaryFolder folder;
  RobotResult result;
  LogScoring scoring;
  scoring.on_episode = [&](const RobotLogReplay& replay) { result = replay.results().at(0); };
  scoreRobotLog(folder.write("log.jsonl", log), {}, scoring);
  return result;
}

/// The error without the folder's name.
std::string errorIn(const std::string& log) {
  const TemporaryFolder folder;
  const std::string file = folder.write("log.jsonl", log);
  const std::string error = errorOf<InputError>([&] { scoreRobotLog(file, {}, {}); });
  return error.rfind(file + ": ", 0) == 0 ? error.substr(file.size() + 2) : error;
}

TEST(RobotLog, MadeByHandIsScored) {
  // Without spaces, with spaces, with a blank line; a robot of 1 m/s that passes a person at 0.7 m.
  const RobotResult result = scored(
      HEADER + R"({"tick":0,"robots":[{"x":0,"y":0,"heading":0}],"people":[{"id":1,"x":1,"y":1,"radius":0.2}]})"
               "\n\n"
               R"({"tick": 1, "robots": [{"x": 0.5, "y": 0, "heading": 0}], "people": [{"id": 1, "x": 1, "y": 1}]})"
               "\n"
               R"({"tick": 2, "robots": [{"x": 1e0, "y": 0.0, "heading": 0}], "people": [{"id": 1, "x": 1, "y": 1}]})"
               "\n"
               R"({"tick": 3, "robots": [{"x": 1.5, "y": 0, "heading": 0}]})"
               "\n"
               R"({"tick": 4, "robots": [{"x": 2, "y": 0, "heading": 0}]})");
  EXPECT_EQ(result.name, "robot");
  EXPECT_TRUE(result.success);
  EXPECT_NEAR(result.time_to_reach_goal, 2.0, 1e-12);
  EXPECT_NEAR(result.path_length, 2.0, 1e-12);
  EXPECT_NEAR(result.avg_robot_linear_speed, 1.0, 1e-12);
  EXPECT_NEAR(result.minimum_distance_to_people, 0.7, 1e-12);
  EXPECT_NEAR(result.minimum_clearance, 0.5, 1e-12);
  EXPECT_NEAR(result.personal_space_time, 1.0, 1e-12);  // 0.818 m and 0.7 m away
  EXPECT_NEAR(result.spl, 1.9 / 2.0, 1e-12);
}

TEST(RobotLog, ContactsAndImpactsOfTheLogCount) {
  const auto score = [](const std::string& more) {
    return scored(HEADER +
                  R"({"tick": 5, "robots": [{"x": 0, "y": 0, "heading": 0, "vx": 0, "vy": 0}],)"
                  R"( "people": [{"id": 4, "x": 0, "y": 9}]})" +
                  "\n" + R"({"tick": 6, "robots": [{"x": 0.5, "y": 0, "heading": 0)" + more + "}]}\n");
  };
  EXPECT_NEAR(score("").max_acceleration, 2.0, 1e-12);
  EXPECT_EQ(score(R"(, "impact": true)").max_acceleration, 0.0);
  EXPECT_EQ(score(R"(, "contacts": [{"person": 4, "cause": "person"}])").person_on_robot_collisions, 1U);
  EXPECT_EQ(score(R"(, "contacts": [{"person": 4, "cause": "robot", "begins": false}])").contacts, 0U);
  EXPECT_NEAR(score(R"(, "vx": 3, "vy": 4)").max_speed, 5.0, 1e-12);
}

TEST(RobotLog, TheFirstLineMayHaveTheVelocityBefore) {
  // 1 m/s in all three ticks of 0.5 s.
  const auto score = [](const std::string& velocity) {
    std::string log = HEADER + R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0)" + velocity + "}]}\n";
    for (int tick = 1; tick <= 3; ++tick) {
      log += R"({"tick": )" + std::to_string(tick) + R"(, "robots": [{"x": )" + std::to_string(0.5 * tick) +
             R"(, "y": 0, "heading": 0}]})" + "\n";
    }
    return scored(log);
  };
  EXPECT_EQ(score(R"(, "vx": 1, "vy": 0)").max_acceleration, 0.0);
  EXPECT_EQ(score(R"(, "vx": 1, "vy": 0)").max_jerk, 0.0);
  // From rest: 2 m/s^2, 0, 0, and 4 m/s^3, 4 m/s^3, 0.
  EXPECT_NEAR(score(R"(, "vx": 0, "vy": 0)").avg_acceleration, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(score(R"(, "vx": 0, "vy": 0)").avg_jerk, 8.0 / 3.0, 1e-12);
  EXPECT_NEAR(score(R"(, "vx": 1, "vy": 2)").max_acceleration, 4.0, 1e-12);
  // Without it, the first acceleration and the first two jerks are not known.
  EXPECT_EQ(score("").max_acceleration, 0.0);
  EXPECT_EQ(score("").min_acceleration, 0.0);
  EXPECT_EQ(score("").max_jerk, 0.0);
  EXPECT_NEAR(score("").avg_robot_linear_speed, 1.0, 1e-12);
}

TEST(RobotLog, WithoutTheKeyABeginningContactIsAnImpact) {
  const std::string header = R"({"tick_duration": 1, "walls": [[1.3, -1, 1.3, 1]], "robots": [{"radius": 0.3}]})";
  const std::string ticks =
      "\n"
      R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0, "vx": 0, "vy": 0}]})"
      "\n"
      R"({"tick": 1, "robots": [{"x": 0.1, "y": 0, "heading": 0}]})"
      "\n"
      R"({"tick": 2, "robots": [{"x": 1, "y": 0, "heading": 0, "vx": 0, "vy": 0}]})"
      "\n"
      R"({"tick": 3, "robots": [{"x": 1, "y": 0, "heading": 0}]})";
  const RobotResult result = scored(header + ticks);
  EXPECT_EQ(result.wall_contacts, 1U);
  EXPECT_NEAR(result.max_acceleration, 0.1, 1e-12);  // from 0 to 0.1 m/s, then an impact, then it stands
}

TEST(RobotLog, ErrorsSayWhereAndWhatIsExpected) {
  const std::string tick = R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0}]})";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "expected a log of robots, got no header with the key 'tick_duration'"},
      {HEADER, "expected ticks behind each header, got a header without any"},
      {tick, "line 1: expected a header with the key 'tick_duration' before the first tick"},
      {"[1]", "line 1: expected an object, {...}, got a list of 1"},
      {"{\"a\": 1}", "line 1: expected a header with the key 'tick_duration', or a tick with the key 'tick'"},
      {HEADER + tick + "\n" + "{\"tick\": 2, \"robots\": []}",
       "line 3: tick: expected 1, as ticks follow each other, got '2'"},
      {HEADER + "\n{\"tick\": 0, \"robots\": []}",
       "line 3: robots: expected a list of 1, as in the header, got a list of 0"},
      {HEADER + R"({"tick": 0, "robots": [{"x": 0, "y": 0}]})", "line 2: robots[0]: the key 'heading' is missing"},
      {HEADER + R"({"tick": 0, "robots": [{"x": "a", "y": 0, "heading": 0}]})",
       "line 2: robots[0].x: expected a number, got the text 'a'"},
      {HEADER + R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heding": 0}]})", "heding"},
      {HEADER + R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0, "vx": 1}]})",
       "line 2: robots[0]: the key 'vy' is missing"},
      {HEADER +
           R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0}], "people": [{"id": 1, "x": 0, "y": 0}, {"id": 1, "x": 1, "y": 0}]})",
       "line 2: people: there are two people 1"},
      {HEADER + tick + "\n" + R"({"tick": 1, "robots": [{"x": 9999, "y": 0, "heading": 0}]})",
       "line 3: robots[0]: velocity [m/s]: expected"},
      {HEADER + tick + "\n" + R"({"tick": 1, "robots": [{"x": 0, "y": 0, "heading": 0}], "arrived": [11]})",
       "line 3: arrived[0]: there has been no person 11 in 'people'"},
      {HEADER +
           R"({"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0, "contacts": [{"person": 4, "cause": "robot"}]}]})",
       "line 2: robots[0].contacts[0].person: there has been no person 4 in 'people'"},
      {HEADER + tick + "\n{\"tick\": 1, ", "line 3: this is not a complete line of JSON"},
      {HEADER + "\n{\"tick\": \n" + tick + "\n" + tick, "line 3: this is not a complete line of JSON"},
      {"{\"tick_duration\": 0, \"robots\": []}", "line 1: tick_duration: expected a number above 0, got '0'"},
      {"{\"tick_duration\": 1, \"robots\": []}", "line 1: robots: expected at least one robot"},
      {R"({"tick_duration": 1, "robots": [{"radius": 1, "goals": [[0, 0]]}]})",
       "line 1: robots[0]: the key 'goal_tolerance' is missing"},
      {R"({"tick_duration": 1, "walls": [[0, 0, 1]], "robots": [{"radius": 1}]})",
       "line 1: walls[0]: expected [x1, y1, x2, y2], got a list of 3"},
      {R"({"tick_duration": 1, "obstacles": [[0, 0, 0]], "robots": [{"radius": 1}]})",
       "line 1: obstacles[0]: expected a radius above 0, got 0"},
  };
  for (const auto& [log, expected] : cases)
    EXPECT_TRUE(contains(errorIn(log), expected)) << errorIn(log) << "\n" << log;
}

TEST(RobotLog, ErrorsBehindManyLinesHaveTheirLine) {
  std::string log = HEADER;
  for (int tick = 0; tick < 200; ++tick) {
    log += "{\"tick\": " + std::to_string(tick) + R"(, "robots": [{"x": 0, "y": 0, "heading": 0}]})" + "\n";
  }
  EXPECT_EQ(scored(log).stalled_time, 199 * 0.5);
  EXPECT_TRUE(contains(errorIn(log + "{\"tick\": 7}\n"), "line 202: tick: expected 200"));
}

/// A robot of any shape and drive among people, some in groups, with walls and obstacles; in half of the worlds solid.
Scene randomWorld(std::uint64_t seed, KeyedRandom& random) {
  Scene made = scenes::randomScene(seed, 20, 5.0);
  made.contact = random.below(2) == 0 ? Contact::SOLID : Contact::GHOST;
  for (AgentStart& start : made.agents) start.group = random.below(3) == 0 ? random.below(3) : NO_GROUP;
  const auto track = std::make_shared<const Track>(
      std::vector<double>{1.0, 4.0},
      std::vector<Vector2>{scenes::randomPoint(random, 5.0), scenes::randomPoint(random, 5.0)});
  made.obstacles.push_back({ObstaclePath::recorded(track), 0.6, 12});
  for (std::size_t i = 0; i < 2; ++i) {
    RobotStart start = robot(scenes::randomPoint(random, 5.0), random.uniform(-PI, PI));
    start.name = "robot_" + std::to_string(i);
    start.limits = {random.uniform(0.5, 1.5), 1.0, random.uniform(0.5, 5.0), 5.0, 0.0};
    start.drive = random.below(2) == 0 ? Drive::HOLONOMIC : Drive::DIFFERENTIAL;
    if (random.below(2) == 0) start.footprint.corners = {{-0.4, -0.2}, {0.4, -0.2}, {0.4, 0.2}, {-0.4, 0.2}};
    for (std::uint32_t goals = random.below(3); goals > 0; --goals) {
      start.goals.push_back(start.position + scenes::randomPoint(random, 1.5));
    }
    start.goal_tolerance = 0.4;
    made.robots.push_back(start);
  }
  return made;
}

void expectSame(const RobotResult& result, const RobotResult& expected) {
  std::vector<double> numbers;
  RobotResult::visitMeasures(
      [&](const char* /*name*/, const auto& value) { numbers.push_back(static_cast<double>(value)); }, expected);
  std::size_t next = 0;
  const auto compare = [&](const char* name, const auto& value) {
    const double wanted = numbers[next++];
    const auto got = static_cast<double>(value);
    EXPECT_TRUE(got == wanted || (std::isnan(got) && std::isnan(wanted)))
        << name << ": " << got << ", expected " << wanted;
  };
  RobotResult::visitMeasures(compare, result);
  ASSERT_EQ(result.goals.size(), expected.goals.size());
  for (std::size_t i = 0; i < result.goals.size(); ++i) {
    EXPECT_EQ(result.goals[i].success, expected.goals[i].success);
    EXPECT_TRUE(result.goals[i].path_length == expected.goals[i].path_length ||
                std::isnan(expected.goals[i].path_length));
  }
}

TEST(RobotLogProperty, OfAnEpisodeHasTheSameResultsBitForBit) {
  std::uint64_t contacts = 0;
  std::uint64_t with_recorded = 0;
  std::uint64_t teleports = 0;
  forSeeds(12, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& random) {
    Episode episode(randomWorld(seed, random), seed, Vision());
    RobotLogRecord record;
    std::string log;
    record.append(seed, episode, log);
    for (int tick = 0; tick < 60; ++tick) {
      for (RobotId id = 0; id < 2; ++id) {
        const Vector2 linear(random.uniform(-0.2, 1.5), random.uniform(-0.5, 0.5));
        episode.robots().command(id, {linear, random.uniform(-1.0, 1.0)});
      }
      const Vector2 place = scenes::randomPoint(random, 5.0);
      if (tick % 20 == 10 && episode.world().blockerAt(place, 0.5).empty()) {
        episode.edit().teleportRobot(0, {place, random.uniform(-PI, PI)});
        ++teleports;
      }
      episode.step(scenes::randomActions(episode.world(), random));
      record.append(seed, episode, log);
      for (const Robot& robot : episode.world().robots()) {
        for (const RobotContact& contact : robot.contacts) {
          with_recorded += contact.agent == idOfRecorded(episode.world().obstacles().size() - 1) ? 1 : 0;
        }
      }
    }
    std::vector<RobotResult> results;
    LogScoring scoring;
    scoring.on_episode = [&](const RobotLogReplay& replay) { results = replay.results(); };
    const TemporaryFolder folder;
    scoreRobotLog(folder.write("log.jsonl", log), {}, scoring);
    const std::vector<RobotResult> expected = episode.result().robots;
    ASSERT_EQ(results.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      expectSame(results[i], expected[i]);
      EXPECT_EQ(results[i].name, expected[i].name);
      contacts += expected[i].contacts;
    }
  });
  EXPECT_GT(contacts, 10U);
  EXPECT_GT(with_recorded, 0U);
  EXPECT_GT(teleports, 5U);
}

TEST(RobotLog, HasTheNamesOfTheScenario) {
  Scene made = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({}));
  made.name = "a \"hall\"\\\n";
  Episode episode(made, 0, Vision());
  std::string log;
  RobotLogRecord().append(7, episode, log);
  const TemporaryFolder folder;
  RobotLogHeader read;
  readRobotLog(
      folder.write("log.jsonl", log), [&](RobotLogHeader& header) { read = header; }, [](RobotLogTick&) {});
  EXPECT_EQ(read.scenario, made.name);
  EXPECT_EQ(read.episode, 7U);
  EXPECT_EQ(read.robots.at(0).goals.size(), 1U);
}

/// The user of an episode through ROS sends robots, adds and removes some.
TEST(RobotLog, HasAHeaderWhereRobotsOrTheirGoalsChange) {
  Scene made = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({}));
  made.robots[0].name = "tug";
  Episode episode(made, 0, Vision());
  RobotStart other = made.robots[0];
  other.name = other.name_space = "cart";
  other.position = {0.0, 5.0};
  other.goals = {};
  RobotLogRecord record;
  std::string log;
  const auto walk = [&] {
    episode.step({});
    record.append(3, episode, log);
  };
  record.append(3, episode, log);
  walk();
  episode.edit().addRobot(other);
  walk();
  walk();
  episode.edit().sendRobot(1, {3.0, 5.0});
  walk();
  episode.edit().removeRobot(0);
  walk();
  const TemporaryFolder folder;
  const std::string file = folder.write("log.jsonl", log);
  std::vector<std::string> headers;
  const auto begin = [&](const RobotLogHeader& header) {
    headers.push_back(std::to_string(header.episode));
    for (const RobotStart& robot : header.robots) {
      headers.back() += " " + robot.name + " " + std::to_string(robot.goals.size());
    }
  };
  readRobotLog(file, begin, [&](const RobotLogTick& tick) { headers.back() += ", " + std::to_string(tick.tick); });
  EXPECT_EQ(headers,
            (std::vector<std::string>{"3 tug 1, 0, 1", "3 tug 1 cart 0, 2, 3", "3 tug 1 cart 1, 4", "3 cart 1, 5"}));
  std::size_t scored = 0;
  LogScoring scoring;
  scoring.on_episode = [&](const RobotLogReplay& replay) { scored += replay.results().size(); };
  scoreRobotLog(file, {}, scoring);
  EXPECT_EQ(scored, 6U);
}

/// Each tick begins a part. The part that begins when the person arrives does not have this person.
TEST(RobotLog, PeopleMayArriveInTheFirstTickOfAPart) {
  Scene made = with({robotTo({1.0, 5.0}, {0.0, 5.0})},
                    straight_walk::sceneOf("agents: [{position: [0, 0], goal: [0.6, 0], speed: 1, radius: 0.2}]\n"));
  Episode episode(made, 0, Vision());
  RobotLogRecord record;
  std::string log;
  record.append(0, episode, log);
  while (episode.world().activeCount() > 0U) {
    ASSERT_LT(episode.world().tick(), 100U);
    episode.edit().sendRobot(0, {3.0, 5.0 + 0.01 * static_cast<double>(episode.world().tick())});
    straight_walk::step(episode);
    record.append(0, episode, log);
  }
  const TemporaryFolder folder;
  std::size_t parts = 0;
  LogScoring scoring;
  scoring.on_episode = [&](const RobotLogReplay& /*replay*/) { ++parts; };
  scoreRobotLog(folder.write("log.jsonl", log), {}, scoring);
  EXPECT_EQ(parts, episode.world().tick() + 1U);
}

/// A robot is replaced by a larger one of its name, and this by its like elsewhere.
TEST(RobotLog, HasAHeaderForAnotherRobotOfTheSameName) {
  Scene made = with({robotTo({1.0, 0.0}, {0.0, 0.0})}, scene({}));
  made.robots[0].name = "tug";
  Episode episode(made, 0, Vision());
  RobotLogRecord record;
  std::string log;
  record.append(0, episode, log);
  RobotStart larger = episode.world().robots()[0].start;
  larger.footprint.radius += 0.2;
  for (int i = 0; i < 2; ++i) {
    episode.edit().removeRobot(0);
    episode.edit().addRobot(larger);
    episode.step({});
    record.append(0, episode, log);
    larger.position.y() += 1.0;
  }
  std::vector<double> radii;
  const TemporaryFolder folder;
  readRobotLog(
      folder.write("log.jsonl", log),
      [&](const RobotLogHeader& header) { radii.push_back(header.robots.at(0).footprint.radius); },
      [](const RobotLogTick&) {});
  ASSERT_EQ(radii.size(), 3U);
  EXPECT_DOUBLE_EQ(radii[1], radii[0] + 0.2);
  EXPECT_DOUBLE_EQ(radii[2], radii[1]);
}

}  // namespace
}  // namespace crowd::robots::robot_log_test
