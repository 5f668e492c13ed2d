// Training: decisions that are learned from in a second.

#include <benchmark/benchmark.h>

#include "social_crowd/simulation/training.h"
#include "social_crowd/world/scenario_reader.h"
#include "thread_counts.h"

namespace crowd {
namespace {

constexpr const char* ONE_OBSTACLE = SOURCE_DIR "/config/scenarios/training_single.yaml";

/// A shipped recipe with another scenario, episodes and learners side by side.
Recipe recipeFor(const std::string& config, const std::string& scenario, std::uint64_t episodes,
                 std::uint32_t side_by_side = 1) {
  Recipe recipe = readRecipe(SOURCE_DIR "/config/learning/" + config + ".yaml");
  recipe.training.scenarios = {scenario};
  recipe.training.episodes = episodes;
  recipe.training.side_by_side = side_by_side;
  return recipe;
}

Recipe occupancyRecipe() { return recipeFor("thesis_occupancy", ONE_OBSTACLE, 2000); }

Recipe crowdRecipe(std::uint64_t episodes, std::uint32_t side_by_side = 1) {
  return recipeFor("anticipation", SOURCE_DIR "/bench/scenarios/random_crowd_12.yaml", episodes, side_by_side);
}

void count(benchmark::State& state, std::uint64_t decisions) {
  state.counters["decisions_per_second"] =
      benchmark::Counter(static_cast<double>(decisions), benchmark::Counter::kIsRate);
}

/// Trains from nothing, again and again.
void train(benchmark::State& state, const Recipe& recipe, unsigned threads = 1) {
  std::uint64_t decisions = 0;
  for (auto _ : state) {
    Training training(recipe, threads);
    while (!training.isDone()) benchmark::DoNotOptimize(training.runNextTurn());
    decisions += training.decisions();
  }
  count(state, decisions);
}

void trainOccupancy(benchmark::State& state) { train(state, occupancyRecipe()); }

/// The same loop with a learner that does not learn: it walks the training's episodes with what came of them.
void walkOccupancy(benchmark::State& state) {
  const Recipe recipe = occupancyRecipe();
  Training training(recipe);
  while (!training.isDone()) training.runNextTurn();
  Learner learner(recipe.model, Learner::Options(), training.learner().tableOf(0));
  const ScenarioList scenarios = readScenarios(ONE_OBSTACLE);
  std::uint64_t decisions = 0;
  for (auto _ : state) {
    for (std::uint64_t episode = 0; episode < recipe.training.episodes; ++episode) {
      const EpisodeResult result = runEpisode(scenarios.scene(recipe.training.seed, episode), episode, learner);
      decisions += result.ticks;
    }
  }
  count(state, decisions);
}

void trainAnticipation(benchmark::State& state) { train(state, crowdRecipe(200)); }

/// Two turns of ten episodes each.
void trainSideBySide(benchmark::State& state) {
  constexpr std::uint32_t LEARNERS = 16;
  train(state, crowdRecipe(2 * 10 * LEARNERS, LEARNERS), static_cast<unsigned>(state.range(0)));
}

}  // namespace

BENCHMARK(trainOccupancy)->Name("train_occupancy")->Unit(benchmark::kMillisecond);
BENCHMARK(walkOccupancy)->Name("train_occupancy/yardstick")->Unit(benchmark::kMillisecond);
BENCHMARK(trainAnticipation)->Name("train_anticipation")->Unit(benchmark::kMillisecond);

// Sweep: threads that 16 learners side by side share.
BENCHMARK(trainSideBySide)->Name("train_threads")->Apply(useThreads)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
