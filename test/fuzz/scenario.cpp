// Scenarios: they are read, their first episode is placed, written again, and walked for some ticks.

#include "fuzz/fuzz.h"
#include "learning/learner.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "scenario/writing/scene_document.h"
#include "simulation/episode_runner.h"

namespace {

using namespace crowd;

constexpr std::size_t MOST_BODIES = 300;  // that are placed; each takes some memory, up to limits::BODIES
constexpr std::uint64_t MOST_TICKS = 5;
constexpr std::uint64_t MOST_LOOKS = 100'000;  // at the request to stop

Learner makeLearner() {
  return {parseModel("state_set: {type: nearest_obstacle}\naction_set: {type: kings_moves}\n"
                     "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"),
          {}};
}

bool isSmall(const Scenario& scenario) {
  std::size_t bodies = scenario.robots.size();
  for (const AgentGroup& group : scenario.agents) bodies += static_cast<std::size_t>(group.count);
  for (const ObstacleGroup& group : scenario.obstacles) bodies += static_cast<std::size_t>(group.count);
  return bodies <= MOST_BODIES;
}

void walk(const Scenario& scenario) {
  static Learner learner = makeLearner();
  const StopRequest stop = fuzz::stopAfter(MOST_LOOKS);
  Scene scene = scenario.instantiate(1, 0, stop);
  toDocument(scene, shippedScenarios());
  scene.max_ticks = std::min(scene.max_ticks, MOST_TICKS);
  Episode episode(std::move(scene), 0, learner.model().vision(), ThreadPool::callerOnly(), stop);
  CrowdDecider decider(learner);
  runEpisode(episode, decider);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name = shippedScenarios() + "/fuzz.yaml";  // maps and recordings are relative to it
  return fuzz::feed(size, 10'000, [&] {
    const ScenarioList scenarios = parseScenarios(fuzz::textOf(data, size), name);
    if (!scenarios.empty() && isSmall(scenarios[0])) walk(scenarios[0]);
  });
}
