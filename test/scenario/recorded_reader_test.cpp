#include <gtest/gtest.h>

#include <string>

#include "scenario/reading/scenario_reader.h"
#include "scenario/writing/scene_document.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenario_texts.h"
#include "support/temporary_folder.h"

namespace crowd::recorded_reader_test {
namespace {

/// Two people who walk east at 1 m/s, frames of 0.1 s; person 7 comes at 1 s.
const char* const CSV =
    "instance,tick,agent,x,y\n"
    "3,0,2,0,0\n3,10,2,1,0\n3,20,2,2,0\n3,10,7,0,5\n3,30,7,2,5\n"
    "4,0,9,8,8\n4,10,9,8,9\n";
/// Somebody who is in nobody's way.
const char* const FAR_AGENT = "agents: [{position: [50, 50], goal: [54, 53], speed: 1.3, radius: 0.25}]\n";
/// As ETH: every sixth frame of a video, 0.4 s; person 40 comes before person 7.
const char* const OBSMAT =
    "7.8000000e+02 4.0e+01 8.5 0 3.5 0 0 0\r\n786 40 9.3 0 3.5 0 0 0\n792 40 10.1 0 3.9 0 0 0\n"
    "786 7 1 0 1 0 0 0\n792 7 1 0 2 0 0 0\n";
const char* const JUPEDSIM =
    "# description: corridor\n# framerate: 8.00\n# id frame x/cm y/cm z\n\n1 4 100 200 0\n1 0 0 200 0\n5 0 0 -100 0\n";

/// A folder with a recording, and what the reader makes of scenarios with it.
class RecordedReader : public ::testing::Test {
 protected:
  std::string document(const std::string& entry, const std::string& agents = FAR_AGENT) const {
    return scenario_texts::HEAD + agents + "recorded:\n  - {" + entry + "}\n";
  }
  Scene read(const std::string& entry, const std::string& agents = FAR_AGENT) const {
    return parseScenarios(document(entry, agents), folder_.file("s.yaml")).scene(1, 0);
  }
  /// The error without the folder.
  std::string error(const std::string& entry, const std::string& agents = FAR_AGENT) const {
    std::string text = errorOf<InputError>([&] { read(entry, agents); });
    for (std::size_t at = 0; (at = text.find(folder_.path() + "/")) != std::string::npos;) {
      text.erase(at, folder_.path().size() + 1);
    }
    return text;
  }
  /// The error about a file with this content.
  std::string errorAbout(const std::string& content) const {
    folder_.write("r", content);
    const std::string text = error("file: r");
    const std::string place = "s.yaml: document 1, line 6: recorded[0].file: ";
    EXPECT_EQ(text.substr(0, place.size()), place);
    return text.substr(std::min(place.size(), text.size()));
  }

  TemporaryFolder folder_;
};

void expectTrack(const Obstacle& person, std::uint64_t number, const std::vector<double>& times,
                 const std::vector<Vector2>& places) {
  SCOPED_TRACE("person " + std::to_string(number));
  ASSERT_TRUE(person.person);
  EXPECT_EQ(*person.person, number);
  const Track& track = *person.path.track();
  ASSERT_EQ(track.times().size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(track.times()[i], times[i], 1e-12);
    EXPECT_LT((track.places()[i] - places[i]).norm(), 1e-12) << track.places()[i];
  }
}

TEST_F(RecordedReader, ReadsTheTrajectoriesOfEvaluate) {
  folder_.write("r.csv", CSV);
  const Scene scene = read("file: r.csv");
  ASSERT_EQ(scene.obstacles.size(), 2U);  // of the first instance
  expectTrack(scene.obstacles[0], 2, {0.0, 1.0, 2.0}, {{0, 0}, {1, 0}, {2, 0}});
  expectTrack(scene.obstacles[1], 7, {1.0, 3.0}, {{0, 5}, {2, 5}});
  EXPECT_EQ(scene.obstacles[0].radius, 0.25);
  const Scene other = read("file: r.csv, instance: 4, frame_rate: 20, radius: 0.3");
  ASSERT_EQ(other.obstacles.size(), 1U);
  expectTrack(other.obstacles[0], 9, {0.0, 0.5}, {{8, 8}, {8, 9}});
  EXPECT_EQ(other.obstacles[0].radius, 0.3);
}

TEST_F(RecordedReader, ReadsPeopleFilmedFromAbove) {
  folder_.write("obsmat.txt", OBSMAT);
  const Scene scene = read("file: obsmat.txt");
  ASSERT_EQ(scene.obstacles.size(), 2U);
  expectTrack(scene.obstacles[0], 7, {0.4, 0.8}, {{1, 1}, {1, 2}});
  expectTrack(scene.obstacles[1], 40, {0.0, 0.4, 0.8}, {{8.5, 3.5}, {9.3, 3.5}, {10.1, 3.9}});
}

TEST_F(RecordedReader, ReadsJuPedSim) {
  folder_.write("r.txt", JUPEDSIM);
  const Scene scene = read("file: r.txt, people: [1]");
  ASSERT_EQ(scene.obstacles.size(), 1U);
  expectTrack(scene.obstacles[0], 1, {0.0, 0.5}, {{0, 2}, {1, 2}});
}

TEST_F(RecordedReader, UsesAPartLaterAndElsewhere) {
  folder_.write("r.csv", CSV);
  const Scene scene = read("file: r.csv, from: 0.5, to: 1.5, offset: 10, shift: [100, 1]");
  ASSERT_EQ(scene.obstacles.size(), 2U);
  expectTrack(scene.obstacles[0], 2, {10.0, 10.5, 11.0}, {{100.5, 1}, {101, 1}, {101.5, 1}});
  expectTrack(scene.obstacles[1], 7, {10.5, 11.0}, {{100, 6}, {100.5, 6}});
  // Who is not there in the part is left out.
  EXPECT_EQ(read("file: r.csv, from: 2.5").obstacles.size(), 1U);
  EXPECT_EQ(read("file: r.csv, to: 0.5").obstacles.size(), 1U);
}

TEST_F(RecordedReader, RecordedPeopleComeAfterTheObstacles) {
  folder_.write("r.csv", CSV);
  const Scene scene = parseScenarios(document("file: r.csv") + "  - {file: r.csv, people: [7], shift: [0, 2]}\n" +
                                         "obstacles: [{position: [9, 9], radius: 0.5}]\n",
                                     folder_.file("s.yaml"))
                          .scene(1, 0);
  ASSERT_EQ(scene.obstacles.size(), 4U);
  EXPECT_FALSE(scene.obstacles[0].person);
  EXPECT_EQ(*scene.obstacles[3].person, 7U);
}

TEST_F(RecordedReader, AgentsAreOptional) {
  folder_.write("r.csv", CSV);
  EXPECT_EQ(parseScenarios(document("file: r.csv", ""), folder_.file("s.yaml")).scene(1, 0).agents.size(), 0U);
}

TEST_F(RecordedReader, DrawnAgentsKeepAwayFromThoseWhoAreThereAtTheStart) {
  folder_.write("r.csv", CSV);
  const std::string agents = "agents: [{position: {box: [[-1, -1], [1, 1]]}, goal: [9, 9], speed: 1, radius: 0.25}]\n";
  const ScenarioList list = parseScenarios(document("file: r.csv, radius: 0.5", agents), folder_.file("s.yaml"));
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_GE(list.scene(seed, 0).agents[0].position.norm(), 0.25 + 0.5 + DRAWN_GAP) << "seed " << seed;
  }
  // A fixed agent must not overlap them, but may be where somebody appears later.
  EXPECT_EQ(error("file: r.csv", scenario_texts::AGENTS),
            "s.yaml: document 1, line 4: agents[0] and recorded[0] (person 2) overlap by 0.5 m");
  EXPECT_EQ(error("file: r.csv, offset: 0.1", scenario_texts::AGENTS), "no error");
}

TEST_F(RecordedReader, IsWrittenAndReadBackUnchanged) {
  folder_.write("r.csv", CSV);
  const Scene scene = read(
      "file: r.csv, instance: 3, frame_rate: 8, from: 0.25, to: 2.5, offset: -0.125, people: [2, 7], "
      "shift: [9, 1], radius: 0.3");
  const std::string text = toDocument(scene, folder_.path());
  EXPECT_TRUE(contains(text,
                       "recorded:\n  - {file: 'r.csv', instance: 3, frame_rate: 8, from: 0.25, to: 2.5, offset: "
                       "-0.125, people: [2, 7], shift: [9, 1], radius: 0.3}\n"))
      << text;
  EXPECT_FALSE(contains(text, "obstacles"));
  const Scene again = parseScenarios(text, folder_.file("again.yaml")).scene(1, 0);
  ASSERT_EQ(again.obstacles.size(), scene.obstacles.size());
  for (std::size_t i = 0; i < again.obstacles.size(); ++i) {
    EXPECT_EQ(again.obstacles[i].path.track()->times(), scene.obstacles[i].path.track()->times());
    EXPECT_EQ(again.obstacles[i].path.points(), scene.obstacles[i].path.points());
  }
  EXPECT_EQ(toDocument(again, folder_.path()), text);
}

TEST_F(RecordedReader, RefusesFilesThatAreNoRecordings) {
  EXPECT_TRUE(contains(error("file: none.csv"), "line 6: recorded[0].file: none.csv: cannot be read"))
      << error("file: none.csv");
  EXPECT_TRUE(contains(errorAbout(""), "r: is not a recording; expected the header instance,tick,agent,x,y, the text"));
  EXPECT_TRUE(contains(errorAbout("1 2 3\n"), "r: is not a recording"));
  EXPECT_EQ(errorAbout("instance,tick,agent,x\n0,0,0,0\n"),
            "r:1: expected the header instance,tick,agent,x,y, got 'instance,tick,agent,x'");
  EXPECT_EQ(errorAbout("instance,tick,agent,x,y\n"), "r: has no trajectory");
  EXPECT_EQ(errorAbout("# framerate: 8\n"), "r: has no trajectory");
  EXPECT_EQ(errorAbout("# framerate: 0\n1 0 0 0 0\n"), "r:1: expected a frame rate above 0, at most 1e6 Hz, got '0'");
}

TEST_F(RecordedReader, RefusesWrongLinesWithTheirNumbers) {
  const std::string csv = "instance,tick,agent,x,y\n0,0,0,0,0\n";
  const std::string expected = "expected instance, tick and agent from 0, and finite x and y";
  EXPECT_EQ(errorAbout(csv + "0,1,0,0\n"), "r:3: " + expected + ", got '0,1,0,0'");
  EXPECT_EQ(errorAbout(csv + "0,1.5,0,0,0\n"), "r:3: " + expected + ", got '0,1.5,0,0,0'");
  EXPECT_EQ(errorAbout(csv + "0,1,-1,0,0\n"), "r:3: " + expected + ", got '0,1,-1,0,0'");
  EXPECT_EQ(errorAbout(csv + "0,1,0,nan,0\n"), "r:3: " + expected + ", got '0,1,0,nan,0'");
  EXPECT_EQ(errorAbout(csv + "0,1,0,inf,0\n"), "r:3: " + expected + ", got '0,1,0,inf,0'");
  EXPECT_EQ(errorAbout(csv + "0,1,0,1e7,0\n"), "r:3: expected a number from -1e+06 to 1e+06 m, got '0,1,0,1e7,0'");
  EXPECT_EQ(errorAbout(csv + "0,0,0,1,0\n"), "r:3: agent 0 is in tick 0 for the second time");
  EXPECT_EQ(errorAbout(csv + "0,1,0,1,2"), "r:3: the last line is not complete, as in a file that was cut off");
  EXPECT_EQ(errorAbout("1 0 0 0 0\n1 1 0\n"), "r:2: expected id and frame from 0, and finite x and y, got '1 1 0'");
  EXPECT_EQ(errorAbout("0 1 0 0 0 0 0 0\n6 1 0 0 0 0 0\n"),
            "r:2: expected 8 columns: frame and person from 0, finite x, z and y, vx, vz and vy, got '6 1 0 0 0 0 0'");
  EXPECT_EQ(errorAbout(csv + "0,1,0,200,0\n"), "r: person 0 moves at 2000 m/s, expected at most 1000 m/s");
}

TEST_F(RecordedReader, RefusesWrongEntries) {
  folder_.write("r.csv", CSV);
  const std::string line = "s.yaml: document 1, line 6: recorded[0]";
  EXPECT_EQ(error("file: r.csv, people: [2, 5]"),
            line + ".people[1]: there is no person 5 in r.csv; the 2 there have numbers from 2 to 7");
  EXPECT_EQ(error("file: r.csv, people: [2, 2]"), line + ".people[1]: 2 is there twice");
  EXPECT_EQ(error("file: r.csv, people: []"),
            line + ".people: expected the number of at least one person, got a list of 0");
  EXPECT_EQ(error("file: r.csv, people: [2], from: 2.5"),
            line + ".file: r.csv: person 2 is not there from 2.5 s to its end");
  EXPECT_EQ(error("file: r.csv, from: 20, to: 30"), line + ".file: r.csv: nobody is there from 20 s to 30 s");
  EXPECT_EQ(error("file: r.csv, from: 3, to: 2"), line + ".to: expected a time after from (3 s), got '2'");
  EXPECT_EQ(error("file: r.csv, instance: 5"), line + ".file: r.csv: has no instance 5, expected 3 to 4");
  EXPECT_EQ(error("file: r.csv, frame_rate: 0"), line + ".frame_rate: expected a number above 0, got '0'");
  EXPECT_EQ(error("file: r.csv, frame_rate: 1e-300"), line + ".file: r.csv: person 2 is there later than 1e9 s");
  EXPECT_EQ(error("file: r.csv, radius: 0"), line + ".radius: expected a number above 0, got '0'");
  EXPECT_EQ(error("people: [2]"), line + ": the key 'file' is missing");
  EXPECT_TRUE(contains(error("fiel: r.csv"), line + ": unknown key 'fiel', did you mean 'file'? Known are file, "));
}

}  // namespace
}  // namespace crowd::recorded_reader_test
