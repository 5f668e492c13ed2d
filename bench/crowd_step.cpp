// The crowd step: what a tick of a walking crowd costs, without ROS.

#include <benchmark/benchmark.h>

#include "crowd_walk.h"
#include "thread_counts.h"

namespace crowd {
namespace {

constexpr int TICKS = 40;    // that are measured
constexpr int WARM_UP = 20;  // ticks before: vectors have grown, and the crowd has left its lattice

void walk(benchmark::State& state, const CrowdPlan& plan) {
  CrowdWalk crowd(plan);
  for (int tick = 0; tick < WARM_UP; ++tick) crowd.step();
  std::size_t steps = 0;
  for (auto _ : state) steps += crowd.step();
  state.counters["agent_steps_per_second"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

/// What the plan of a sweep is at one of its points.
CrowdPlan planOf(std::size_t agents) {
  CrowdPlan plan;
  plan.agents = agents;
  return plan;
}

CrowdPlan planOfThreads(std::int64_t threads) {
  CrowdPlan plan;
  plan.threads = static_cast<unsigned>(threads);
  return plan;
}

void walkTenThousand(benchmark::State& state) { walk(state, CrowdPlan()); }

void walkWithThreads(benchmark::State& state) { walk(state, planOfThreads(state.range(0))); }

void walkTwoThreads(benchmark::State& state) { walk(state, planOfThreads(2)); }

void walkAgents(benchmark::State& state) { walk(state, planOf(static_cast<std::size_t>(state.range(0)))); }

void walkDensity(benchmark::State& state) {
  CrowdPlan plan;
  plan.density = static_cast<double>(state.range(0)) / 100.0;
  walk(state, plan);
}

void walkVision(benchmark::State& state) {
  CrowdPlan plan;
  plan.vision_radius = static_cast<double>(state.range(0));
  walk(state, plan);
}

}  // namespace

BENCHMARK(walkTenThousand)->Name("crowd_step_10000")->Iterations(TICKS)->Unit(benchmark::kMillisecond);

BENCHMARK(walkTwoThreads)
    ->Name("crowd_step_10000_two_threads")
    ->Iterations(TICKS)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(walkTenThousand)
    ->Name("crowd_step_10000_two_threads/yardstick")
    ->Iterations(TICKS)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Sweeps: agents at equal density, hundredths of an agent per m2, metres of sight, threads.
BENCHMARK(walkAgents)
    ->Name("crowd_step_agents")
    ->ArgsProduct({{1'000, 2'000, 5'000, 10'000, 20'000, 50'000, 100'000}})
    ->Iterations(TICKS)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(walkDensity)
    ->Name("crowd_step_density")
    ->ArgsProduct({{5, 10, 25, 50, 100, 150, 200}})
    ->Iterations(TICKS)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(walkVision)->Name("crowd_step_vision")->DenseRange(1, 6)->Iterations(TICKS)->Unit(benchmark::kMillisecond);
BENCHMARK(walkWithThreads)
    ->Name("crowd_step_threads")
    ->Apply(useThreads)
    ->Iterations(TICKS)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace crowd
