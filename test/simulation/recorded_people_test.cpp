#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/random.h"
#include "common/text/numbers.h"
#include "scenario/reading/scenario_reader.h"
#include "support/evaluations.h"
#include "support/temporary_folder.h"

namespace crowd::recorded_people_episode_test {
namespace {

const char* const HEAD = "name: n\nduration: 30\ngoal_tolerance: 0.3\n";
constexpr double RADIUS = 0.2;  // [m]

/// The recording of people who cross a square of 12 m one after the other, straight on at walking speed.
std::string crossings(std::uint64_t seed, int people) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  std::string text = "instance,tick,agent,x,y\n";
  for (int person = 0; person < people; ++person) {
    const bool is_upward = random.below(2) == 0;
    const double x = -3.0 + 3.0 * person + random.uniform(-0.5, 0.5);
    const std::uint32_t begin = random.below(60);
    const auto duration = static_cast<std::uint32_t>(12.0 / random.uniform(0.8, 1.6) / 0.1);
    for (const double share : {0.0, 0.5, 1.0}) {
      const double y = (is_upward ? 1.0 : -1.0) * (-6.0 + 12.0 * share);
      const auto tick = begin + static_cast<std::uint32_t>(share * 2.0) * (duration / 2);
      text += "0," + std::to_string(tick) + "," + std::to_string(person) + "," + toText(x) + "," + toText(y) + "\n";
    }
  }
  return text;
}

std::vector<EvaluatedEpisode> walk(const TemporaryFolder& folder, const std::string& document,
                                   const EvaluationPlan& plan, const std::string& table = "anticipation") {
  std::vector<EvaluatedEpisode> all;
  evaluate(loadQTable(SOURCE_DIR "/config/q_tables/" + table + ".txt"),
           parseScenarios(HEAD + document, folder.file("s.yaml")), plan, [&](EvaluatedEpisode& walked) {
             all.push_back(std::move(walked));
             return true;
           });
  return all;
}

TEST(RecordedPeopleOfAnEpisode, AnAgentAmongThemIsNeverTouched) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TemporaryFolder folder;
    folder.write("r.csv", crossings(seed, 3));
    const std::string document = "agents: [{position: [-7, 0], goal: [7, 0], speed: 1.3, radius: " + toText(RADIUS) +
                                 "}]\nrecorded: [{file: r.csv, radius: " + toText(RADIUS) + "}]\n";
    const AgentResult agent = walk(folder, document, evaluations::planOf(1, 1)).at(0).result.agents[0];
    EXPECT_TRUE(agent.arrived);
    EXPECT_FALSE(agent.touched);
  }
}

TEST(RecordedPeopleOfAnEpisode, TakeNoNoticeOfAgents) {
  // Somebody walks over an agent whose way they bar: the agent gets into contact, and they go on.
  TemporaryFolder folder;
  folder.write("r.csv", "instance,tick,agent,x,y\n0,0,0,3,-1\n0,50,0,3,-1\n0,51,0,0.1,0\n0,60,0,0.1,0\n");
  const AgentResult agent =
      walk(folder,
           "agents: [{position: [0, 0], goal: [0.5, 9], speed: 0.01, radius: 0.2}]\nrecorded: [{file: r.csv}]\n",
           evaluations::planOf(1, 1))
          .at(0)
          .result.agents[0];
  EXPECT_TRUE(agent.touched);
}

TEST(RecordedPeopleOfAnEpisode, TrajectoriesDoNotDependOnTheNumberOfThreads) {
  TemporaryFolder folder;
  folder.write("r.csv", crossings(1, 3));
  const std::string document =
      "agents:\n  - {count: 12, position: {box: [[-6, -6], [6, 6]]}, goal: {opposite: [0, 0]}, speed: [1, 1.5], "
      "radius: "
      "0.2}\nrecorded: [{file: r.csv, offset: -0.7}]\n";
  for (const std::string table : {"anticipation", "human"}) {
    const std::vector<EvaluatedEpisode> expected = walk(folder, document, evaluations::planOf(4, 1), table);
    ASSERT_EQ(expected.size(), 4U);
    const std::vector<EvaluatedEpisode> walked = walk(folder, document, evaluations::planOf(4, 3), table);
    for (std::size_t i = 0; i < expected.size(); ++i) evaluations::expectSame(walked.at(i), expected[i]);
  }
}

TEST(RecordedPeopleOfAnEpisode, AnEpisodeWaitsForAgentsOnly) {
  TemporaryFolder folder;
  folder.write("r.csv", "instance,tick,agent,x,y\n0,0,0,0,0\n0,9000,0,9,0\n");
  const std::string agent = "agents: [{position: [0, 5], goal: [2, 5], speed: 1, radius: 0.2}]\n";
  EXPECT_LT(walk(folder, agent + "recorded: [{file: r.csv}]\n", evaluations::planOf(1, 1)).at(0).result.ticks, 30U);
  EXPECT_EQ(walk(folder, "recorded: [{file: r.csv}]\n", evaluations::planOf(1, 1)).at(0).result.ticks, 300U);
}

}  // namespace
}  // namespace crowd::recorded_people_episode_test
