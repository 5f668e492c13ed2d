// Measures a training on several ranks under mpirun. Its yardstick is the same training on as many threads of one
// process. They take turns of a few merges, so that other load of the machine affects both equally. Prints a line of
// JSON for each repetition.

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "measuring.h"
#include "ranks/mpi_communicator.h"
#include "sleeping_ranks.h"
#include "training/training.h"

namespace crowd {
namespace {

constexpr int TURNS = 4;  // of each repetition

TrainingConfig configFor(std::uint32_t learners) {
  TrainingConfig config = readTrainingConfig(SOURCE_DIR "/config/learning/anticipation.yaml");
  config.training.scenarios = {SOURCE_DIR "/bench/scenarios/random_crowd_12.yaml"};
  config.training.side_by_side = learners;
  config.training.episodes = UINT32_MAX;  // more than are run
  return config;
}

/// Work of a turn, and how long it took.
struct Done {
  std::uint64_t decisions = 0;
  double seconds = 0.0;

  double rate() const { return static_cast<double>(decisions) / seconds; }
};

void runTurn(Training& training, Done& done) {
  for (const LearnedEpisode& episode : training.runNextTurn()) done.decisions += episode.decisions;
}

int run(Communicator& ranks, std::uint32_t learners, int repetitions) {
  Training together(configFor(learners), 1, ranks);
  std::unique_ptr<Training> threaded;
  if (ranks.rank() == 0) {
    threaded = std::make_unique<Training>(configFor(learners), static_cast<unsigned>(ranks.size()));
  }
  SleepingRanks sleeping(ranks);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    Done on_ranks;
    Done on_threads;
    for (int turn = 0; turn < TURNS; ++turn) {
      ranks.gatherAll({});  // all begin together
      on_ranks.seconds += timeOf(Clock::ON_WALL, [&] { runTurn(together, on_ranks); });
      on_threads.seconds += sleeping.timeAlone([&] { runTurn(*threaded, on_threads); });
    }
    const TurnsReport report = together.report();
    if (ranks.rank() != 0) continue;
    const auto turns = static_cast<double>(report.turns);
    std::printf(
        "{\"rate\": %.6g, \"threads_rate\": %.6g, \"turn_ms\": %.6g, \"episodes_ms\": %.6g, \"exchange_ms\": %.6g, "
        "\"megabytes\": %.6g, \"imbalance\": %.6g}\n",
        on_ranks.rate(), on_threads.rate(), 1e3 * report.seconds / turns, 1e3 * report.episode_seconds / turns,
        1e3 * report.exchange_seconds / turns, 1e-6 * static_cast<double>(report.bytes) / turns, report.imbalance);
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}

int runMain(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: mpirun -n N rank_training LEARNERS REPETITIONS" << std::endl;
    return 2;
  }
  const std::unique_ptr<Communicator> ranks = joinRanks();
  try {
    return run(*ranks, static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10)), std::atoi(argv[2]));
  } catch (const std::exception& error) {
    ranks->abort(std::string("rank_training: ") + error.what());
  }
  return EXIT_FAILURE;
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
