// Scenes that an evaluation writes are evaluated again.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scenario/reading/scenario_reader.h"
#include "simulation/evaluation/evaluation.h"
#include "support/evaluations.h"
#include "support/temporary_folder.h"

namespace crowd::scene_replay_test {
namespace {

using evaluations::expectSame;
using evaluations::planOf;

const char* const HEAD = "duration: 8\ngoal_tolerance: 0.2\ncontact: solid\n";
const char* const MAP =
    "image: floor.pgm\nresolution: 0.5\norigin: [0, 0, 0.3]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// Everything that is drawn, at the start and during an episode, on a map with a wall across its middle.
std::string mapScenario() {
  return std::string("name: m\nmap: maps/floor.yaml\nseed: 7\n") + HEAD + R"(
agents:
  - {count: 3, position: {map: free}, goal: {map: free}, speed: [0.8, 1.6], radius: [0.2, 0.45], heading: random}
  - {count: 2, position: {map: free}, route: rounds, speed: 1.1, radius: 0.2, reaction_time: [0, 2]}
obstacles:
  - {position: {map: free}, radius: 0.2, to_and_fro: {map: free}, speed: [0.3, 0.7]}
  - {position: {map: free}, radius: [0.1, 0.2]}
walls: [[[2, 3], [2.5, 3.5]]]
routes:
  rounds: {repeat: true, waypoints: [{place: {map: free}, wait: [0.3, 2]}, {one_of: [{queue: till}, {place: {map: free}}]}]}
sources:
  - {area: {map: free}, rate: 1, goal: {map: free}, speed: [1, 1.5], radius: [0.15, 0.25]}
queues:
  till: {head: [1.5, 2.5], direction: 37, spacing: 0.61, service: [0.5, 1]}
gates:
  door: {wall: [[3, 3], [3, 4]], open: [[1, 3], [4, 8]]}
)";
}

std::string thesisScenario() {
  return "name: t\nunits: thesis\norder: sequential\nway_finding: false\nduration: 90\ngoal_tolerance: 0.3\n"
         "collision_radius: 0.7\nagents:\n"
         "  - {count: 4, position: {box: [[-3, -3], [3, 3]]}, goal: {opposite: [0, 0]}, speed: [0.02, 0.04],\n"
         "     radius: [0.2, 0.3], heading: kept}\n"
         "walls: [[[-3, 5], [3, 5]], [[-1, 0.1], [1, -0.1]]]\n";
}

class SceneReplay : public testing::Test {
 protected:
  SceneReplay() {
    std::filesystem::create_directories(folder_.file("maps"));
    std::string image = "P2 20 16 255\n";
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 20; ++column) {
        const bool is_edge = row == 0 || row == 15 || column == 0 || column == 19;
        const bool is_wall = column == 10 && (row < 5 || row > 8);
        image += is_edge || is_wall ? "0 " : "255 ";
      }
    }
    folder_.write("maps/floor.pgm", image);
    folder_.write("maps/floor.yaml", MAP);
  }

  std::vector<EvaluatedEpisode> evaluateFile(const std::string& file, const EvaluationPlan& plan) const {
    std::vector<EvaluatedEpisode> all;
    evaluate(evaluations::restlessTable(), readScenarios(file), plan, [&](EvaluatedEpisode& walked) {
      all.push_back(std::move(walked));
      return true;
    });
    return all;
  }

  /// Evaluates six episodes of a scenario, and the scenes that this writes into another folder.
  void check(const std::string& text, std::uint64_t seed) const {
    SCOPED_TRACE("seed " + std::to_string(seed));
    EvaluationPlan plan = planOf(6, 2, seed);
    plan.scenes = folder_.file("some/scenes");
    const std::vector<EvaluatedEpisode> walked = evaluateFile(folder_.write("s.yaml", text), plan);
    std::string documents;
    for (const EvaluatedEpisode& episode : walked) documents += episode.scene;
    std::filesystem::create_directories(plan.scenes);
    const std::string file = folder_.write("some/scenes/s.yaml", documents);
    plan.episodes = 0;
    const std::vector<EvaluatedEpisode> again = evaluateFile(file, plan);
    ASSERT_EQ(again.size(), walked.size());
    for (std::size_t i = 0; i < walked.size(); ++i) {
      expectSame(again[i], walked[i]);
      EXPECT_EQ(again[i].scene, walked[i].scene);
    }
  }

  TemporaryFolder folder_;
};

TEST_F(SceneReplay, WithAMapSourcesAndRoutes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) check(mapScenario(), seed);
}

TEST_F(SceneReplay, InThesisUnits) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) check(thesisScenario(), seed);
}

TEST_F(SceneReplay, OfDrawnScenes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) check(evaluations::SCENARIOS, seed);
}

/// {map: free} is drawn for the largest agent of the scenario, which need not be in the scene.
TEST_F(SceneReplay, NamesTheMapAndTheRadiusOfItsFreeSpace) {
  EvaluationPlan plan = planOf(1, 1);
  plan.scenes = folder_.file("some/scenes");
  const std::string scene = evaluateFile(folder_.write("s.yaml", mapScenario()), plan).at(0).scene;
  EXPECT_NE(scene.find("\nseed: 7\nmap: '../../maps/floor.yaml'\nfree_radius: 0.45\nagents:"), std::string::npos)
      << scene;
  EXPECT_NE(scene.find("\nwalls:\n  - [[2, 3], [2.5, 3.5]]\nroutes:"), std::string::npos) << scene;
}

}  // namespace
}  // namespace crowd::scene_replay_test
