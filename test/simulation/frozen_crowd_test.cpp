#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/evaluations.h"

namespace crowd::frozen_crowd_test {
namespace {

/// People of an episode of circle50_varied who stood close to each other in the middle for the rest of the time: the
/// table `human` without the key `shift` of its gait chose to stay for all of them.
const char* const CROWD =
    "name: frozen\n"
    "duration: 60\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {position: [0.0884, -0.7882], goal: [7.2, 9.6], speed: 1.57, radius: 0.25}\n"
    "  - {position: [-0.3015, -0.4706], goal: [4.5, 11.1], speed: 1.53, radius: 0.25}\n"
    "  - {position: [0.3522, -0.2650], goal: [-1.4, 11.9], speed: 1.47, radius: 0.25}\n"
    "  - {position: [0.5922, -0.8413], goal: [-8.1, 8.8], speed: 1.47, radius: 0.25}\n"
    "  - {position: [-0.0987, 0.0309], goal: [-12.0, -0.6], speed: 1.64, radius: 0.25}\n"
    "  - {position: [0.8542, -0.1462], goal: [-10.2, -6.3], speed: 1.59, radius: 0.25}\n"
    "  - {position: [-0.1750, 1.1118], goal: [-4.5, -11.1], speed: 1.28, radius: 0.25}\n"
    "  - {position: [0.5247, 0.3257], goal: [4.3, -11.2], speed: 1.57, radius: 0.25}\n"
    "  - {position: [-0.7066, 0.9300], goal: [8.1, -8.8], speed: 1.37, radius: 0.25}\n"
    "  - {position: [0.0807, 0.6383], goal: [10.1, -6.5], speed: 1.62, radius: 0.25}\n"
    "  - {position: [-0.7591, 0.4232], goal: [11.4, -3.8], speed: 1.39, radius: 0.25}\n"
    "  - {position: [-0.6643, -0.0733], goal: [9.3, 7.5], speed: 1.56, radius: 0.25}\n";

/// Numbers of people who arrive, by episode. Nobody is touched.
std::vector<std::size_t> arrivals(const TrainedTable& table, std::uint64_t episodes) {
  std::vector<std::size_t> numbers;
  const auto note = [&](const EvaluatedEpisode& walked) {
    std::size_t arrived = 0;
    for (std::size_t k = 0; k < walked.result.agents.size(); ++k) {
      arrived += walked.result.agents[k].arrived ? 1 : 0;
      EXPECT_FALSE(walked.result.agents[k].touched) << "episode " << numbers.size() << ", agent " << k;
    }
    numbers.push_back(arrived);
    return true;
  };
  evaluate(table, parseScenarios(CROWD, "frozen.yaml"), evaluations::planOf(episodes, 2), note);
  return numbers;
}

TEST(FrozenCrowd, Dissolves) {
  const TrainedTable human = loadQTable(SOURCE_DIR "/config/q_tables/human.txt");
  EXPECT_EQ(arrivals(human, 20), std::vector<std::size_t>(20, 12));
}

TEST(FrozenCrowd, StaysWithoutRandomMoves) {
  TrainedTable human = loadQTable(SOURCE_DIR "/config/q_tables/human.txt");
  std::string spec = human.model.spec();
  const std::string key = ", shift: 0.2";
  ASSERT_NE(spec.find(key), std::string::npos);
  human.model = parseModel(spec.erase(spec.find(key), key.size()));
  EXPECT_EQ(arrivals(human, 1), std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace crowd::frozen_crowd_test
