// Measures a crowd on several ranks (DistributedCrowd) under mpirun. Its yardsticks are crowds of its share of the
// agents, one on each rank, that know nothing of each other, and the whole crowd on as many threads of one process. All
// take turns of a few ticks, so that other load of the machine affects all equally. Prints a line of JSON for each
// repetition.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "crowd_walk.h"
#include "measuring.h"
#include "ranks/distributed_crowd.h"
#include "ranks/mpi_communicator.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "sleeping_ranks.h"

namespace crowd {
namespace {

constexpr int WARM_UP = 20;  // ticks
constexpr int TURNS = 4;     // of each repetition
constexpr int TICKS = 10;    // of each turn: one division of the floor

/// Time of some ticks [s]; all ranks begin together.
template <typename Tick>
double timeOfTicks(Communicator& ranks, int ticks, const Tick& tick) {
  ranks.gatherAll({});
  const double seconds = timeOf(Clock::ON_WALL, [&] {
    for (int i = 0; i < ticks; ++i) tick();
  });
  return spreadOf(ranks, seconds).largest;
}

int run(Communicator& ranks, std::size_t agents, int repetitions) {
  const auto count = static_cast<std::size_t>(ranks.size());
  CrowdPlan plan;
  plan.agents = agents;
  CrowdPlan part = plan;
  part.agents = agents / count;
  Learner learner = makeWalker();
  ThreadPool alone(1);
  DistributedCrowd crowd(makeCrowd(plan), 0, learner, alone, ranks);
  Episode separate(makeCrowd(part), 0, learner.model().vision());
  CrowdDecider decider(learner);
  plan.threads = static_cast<unsigned>(count);
  std::unique_ptr<CrowdWalk> threaded;
  if (ranks.rank() == 0) threaded = std::make_unique<CrowdWalk>(plan);
  const auto together = [&] { crowd.step(); };
  const auto apart = [&] { separate.walk(decider); };
  SleepingRanks sleeping(ranks);
  const auto time_on_threads = [&](int ticks) {
    return sleeping.timeAlone([&] {
      for (int i = 0; i < ticks; ++i) threaded->step();
    });
  };
  timeOfTicks(ranks, WARM_UP, together);
  timeOfTicks(ranks, WARM_UP, apart);
  time_on_threads(WARM_UP);
  const double steps = static_cast<double>(agents) * TURNS * TICKS;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    double together_time = 0.0;
    double apart_time = 0.0;
    double threads_time = 0.0;
    for (int turn = 0; turn < TURNS; ++turn) {
      together_time += timeOfTicks(ranks, TICKS, together);
      apart_time += timeOfTicks(ranks, TICKS, apart);
      threads_time += time_on_threads(TICKS);
    }
    const RanksReport report = crowd.report();
    if (ranks.rank() != 0) continue;
    const auto ticks = static_cast<double>(report.ticks);
    std::printf(
        "{\"rate\": %.6g, \"parts_rate\": %.6g, \"threads_rate\": %.6g, \"computing_ms\": %.6g, "
        "\"megabytes\": %.6g}\n",
        steps / together_time, steps / apart_time, steps / threads_time, 1e3 * report.busy_seconds / ticks,
        1e-6 * static_cast<double>(report.bytes) / ticks);
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}

int runMain(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: mpirun -n N rank_benchmarks AGENTS REPETITIONS" << std::endl;
    return 2;
  }
  const std::unique_ptr<Communicator> ranks = joinRanks();
  try {
    return run(*ranks, std::strtoull(argv[1], nullptr, 10), std::atoi(argv[2]));
  } catch (const std::exception& error) {
    ranks->abort(std::string("rank_benchmarks: ") + error.what());
  }
  return EXIT_FAILURE;
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
