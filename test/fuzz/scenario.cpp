// Scenarios: they are read, their first episode is placed, written again, and walked for some ticks.

#include "fuzz/fuzz.h"
#include "fuzz/small_world.h"
#include "scenario/population_spec.h"
#include "scenario/reading/scenario_reader.h"
#include "scenario/writing/scene_document.h"
#include "simulation/episode_runner.h"
#include "support/temporary_folder.h"

namespace {

using namespace crowd;

constexpr std::size_t MOST_BODIES = 300;  // that are placed; each takes some memory, up to limits::BODIES
constexpr std::uint64_t MOST_TICKS = 5;

bool isSmall(const Scenario& scenario) {
  std::size_t bodies = scenario.robots.size();
  if (scenario.population != nullptr) {
    const double time = scenario.tick_duration * MOST_TICKS;
    for (const SourceDescription& source : scenario.population->sources)
      bodies += static_cast<std::size_t>(source.rate.value_or(0.0) * time);
  }
  for (const AgentGroup& group : scenario.agents) bodies += static_cast<std::size_t>(group.count);
  for (const ObstacleGroup& group : scenario.obstacles) bodies += static_cast<std::size_t>(group.count);
  return bodies <= MOST_BODIES;
}

void walk(const Scenario& scenario, const StopRequest& stop) {
  static Learner learner = fuzz::makeLearner();
  Scene scene = scenario.instantiate(1, 0, stop);
  toDocument(scene, ".");
  scene.max_ticks = std::min(scene.max_ticks, MOST_TICKS);
  Episode episode(std::move(scene), 0, learner.model().vision(), ThreadPool::callerOnly(), stop);
  CrowdDecider decider(learner);
  runEpisode(episode, decider);
}

/// A folder with a scenario, the shipped maps and the recordings.
class ScenarioFolder {
 public:
  ScenarioFolder() {
    std::filesystem::create_directory(folder_.file("scenarios"));
    for (const char* name : {"maps", "recordings"})
      std::filesystem::create_symlink(std::string(SOURCE_DIR) + "/config/" + name, folder_.file(name));
  }
  std::string write(const std::string& text) const { return folder_.write("scenarios/input.yaml", text); }

 private:
  TemporaryFolder folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScenarioFolder folder;
  const std::string name = folder.write(fuzz::textOf(data, size));
  return fuzz::feed(
      size, 10'000,
      [&] {
        const StopRequest stop = fuzz::stopAfter(fuzz::PATIENCE);
        const ScenarioList scenarios = readScenarios(name, stop);
        if (!scenarios.empty() && isSmall(scenarios[0])) walk(scenarios[0], stop);
      },
      fuzz::FLOOR_MEMORY);
}
