// Training: learned decisions per second.

#include <benchmark/benchmark.h>

#include "measuring.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/episode_runner.h"
#include "thread_counts.h"
#include "training/training.h"

namespace crowd {
namespace {

constexpr const char* ONE_OBSTACLE = SOURCE_DIR "/config/scenarios/training_single.yaml";

/// A shipped training configuration with the given scenario, number of episodes and of learners side by side.
TrainingConfig configFor(const std::string& name, const std::string& scenario, std::uint64_t episodes,
                         std::uint32_t side_by_side = 1) {
  TrainingConfig config = readTrainingConfig(SOURCE_DIR "/config/learning/" + name + ".yaml");
  config.training.scenarios = {scenario};
  config.training.episodes = episodes;
  config.training.side_by_side = side_by_side;
  return config;
}

TrainingConfig occupancyConfig() { return configFor("thesis_occupancy", ONE_OBSTACLE, 2000); }

TrainingConfig crowdConfig(std::uint64_t episodes, std::uint32_t side_by_side = 1) {
  return configFor("anticipation", SOURCE_DIR "/bench/scenarios/random_crowd_12.yaml", episodes, side_by_side);
}

void finish(Training& training) {
  while (!training.isDone()) benchmark::DoNotOptimize(training.runNextTurn());
}

/// Trains from an empty table. @return number of decisions
std::uint64_t train(const TrainingConfig& config, unsigned threads = 1) {
  Training training(config, threads);
  finish(training);
  return training.decisions();
}

/// The yardstick: the same episodes without learning, with the trained table.
class WalkedEpisodes {
 public:
  explicit WalkedEpisodes(const TrainingConfig& config)
      : config_(config),
        scenarios_(readScenarios(config.training.scenarios.front())),
        learner_(config.model, Learner::Options(), trainedTable(config)) {}

  /// @return number of decisions
  std::uint64_t walk() {
    std::uint64_t decisions = 0;
    for (std::uint64_t episode = 0; episode < config_.training.episodes; ++episode) {
      Episode walked(scenarios_.scene(config_.training.seed, episode), episode, learner_.model().vision());
      CrowdDecider decider(learner_);
      decisions += runEpisode(walked, decider).ticks;
    }
    return decisions;
  }

 private:
  static QTable trainedTable(const TrainingConfig& config) {
    Training training(config);
    finish(training);
    return training.learner().tables().of(0);
  }

  TrainingConfig config_;
  ScenarioList scenarios_;
  Learner learner_;
};

void trainOccupancy(benchmark::State& state) {
  const TrainingConfig config = occupancyConfig();
  WalkedEpisodes episodes(config);
  takeTurns(
      state, Clock::OF_THREAD, [&] { return train(config); }, [&] { return episodes.walk(); });
}

/// Trains repeatedly.
void train(benchmark::State& state, const TrainingConfig& config, unsigned threads = 1) {
  std::uint64_t decisions = 0;
  for (auto _ : state) decisions += train(config, threads);
  setRate(state, decisions);
}

void trainAnticipation(benchmark::State& state) { train(state, crowdConfig(200)); }

/// Two turns of ten episodes each.
void trainSideBySide(benchmark::State& state) {
  constexpr std::uint32_t LEARNERS = 16;
  train(state, crowdConfig(2 * 10 * LEARNERS, LEARNERS), static_cast<unsigned>(state.range(0)));
}

}  // namespace

BENCHMARK(trainOccupancy)->Name("train_occupancy")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(trainAnticipation)->Name("train_anticipation")->Unit(benchmark::kMillisecond);

// Sweep: number of threads shared by 16 learners side by side.
BENCHMARK(trainSideBySide)->Name("train_threads")->Apply(useThreads)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
