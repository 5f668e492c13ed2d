// Benchmarks of the crowd step: one tick of a walking crowd, without ROS.

#include <benchmark/benchmark.h>

#include <memory>
#include <numeric>
#include <vector>

#include "crowd_walk.h"
#include "geometry/neighbour_grid.h"
#include "geometry/neighbour_search.h"
#include "measuring.h"
#include "thread_counts.h"

namespace crowd {
namespace {

constexpr int TICKS = 40;    // measured ticks
constexpr int TURNS = 2;     // repetitions of TICKS in comparisons with a yardstick
constexpr int WARM_UP = 20;  // unmeasured ticks, in which vectors grow and the crowd leaves its lattice

/// A crowd after the warm-up.
std::unique_ptr<CrowdWalk> warmUp(const CrowdPlan& plan) {
  auto crowd = std::make_unique<CrowdWalk>(plan);
  for (int tick = 0; tick < WARM_UP; ++tick) crowd->step();
  return crowd;
}

/// The yardstick of the crowd step: only finds the nearest neighbours of all agents.
class NeighbourLoop {
 public:
  /// @return number of agents
  std::size_t find(const World& world, const Vision& vision) {
    grid_.clear();
    for (const Agent& agent : world.agents()) grid_.add(agent.pose.position, agent.radius, agent.id);
    grid_.build(World::CELL_SIZE);
    for (std::size_t disc = 0; disc < grid_.size(); ++disc) {
      const auto found =
          search_.findNearest(grid_, grid_.centre(disc), vision.radius, vision.max_neighbours, grid_.body(disc));
      benchmark::DoNotOptimize(found.size());
    }
    return grid_.size();
  }

 private:
  NeighbourGrid grid_;
  NeighbourSearch search_;
};

/// Repeats the work of a tick, because a thread is slow at first after an idle time.
/// @return total work done
template <typename Work>
std::size_t repeat(const Work& work) {
  std::size_t done = 0;
  for (int tick = 0; tick < TICKS; ++tick) done += work();
  return done;
}

void walkTenThousand(benchmark::State& state) {
  const auto crowd = warmUp(CrowdPlan());
  NeighbourLoop neighbours;
  const auto find = [&] { return neighbours.find(crowd->world(), crowd->vision()); };
  const auto walk = [&] { return crowd->step(); };
  takeTurns(
      state, Clock::OF_THREAD, [&] { return repeat(walk); }, [&] { return repeat(find); });
}

CrowdPlan planOfThreads(std::int64_t threads) {
  CrowdPlan plan;
  plan.threads = static_cast<unsigned>(threads);
  return plan;
}

void walkTwoThreads(benchmark::State& state) {
  const auto crowd = warmUp(planOfThreads(2));
  const auto alone = warmUp(planOfThreads(1));
  const auto walk = [&] { return crowd->step(); };
  const auto walk_alone = [&] { return alone->step(); };
  takeTurns(
      state, Clock::ON_WALL, [&] { return repeat(walk); }, [&] { return repeat(walk_alone); });
}

void walkWithMass(benchmark::State& state) {
  CrowdPlan plan;
  plan.motion = MotionLimits{2.0, 3.0, INFINITE};
  const auto crowd = warmUp(plan);
  const auto without = warmUp(CrowdPlan());
  const auto walk = [&] { return crowd->step(); };
  const auto walk_without = [&] { return without->step(); };
  takeTurns(
      state, Clock::OF_THREAD, [&] { return repeat(walk); }, [&] { return repeat(walk_without); });
}

void walk(benchmark::State& state, const CrowdPlan& plan) {
  const auto crowd = warmUp(plan);
  std::size_t steps = 0;
  for (auto _ : state) steps += crowd->step();
  setRate(state, steps);
}

/// The plan of a sweep over the number of agents.
CrowdPlan planOf(std::size_t agents) {
  CrowdPlan plan;
  plan.agents = agents;
  return plan;
}

void walkWithThreads(benchmark::State& state) { walk(state, planOfThreads(state.range(0))); }

/// One independent crowd per thread: upper bound of the speed-up by threads on this machine.
void walkSideBySide(benchmark::State& state) {
  ThreadPool thread_pool(static_cast<unsigned>(state.range(0)));
  std::vector<std::unique_ptr<CrowdWalk>> crowds;
  while (crowds.size() < thread_pool.count()) crowds.push_back(warmUp(CrowdPlan()));
  std::vector<std::size_t> steps(crowds.size());
  for (auto _ : state) {
    thread_pool.run(crowds.size(), [&](unsigned /*worker*/, std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) steps[i] += repeat([&] { return crowds[i]->step(); });
    });
  }
  setRate(state, std::accumulate(steps.begin(), steps.end(), std::size_t{0}));
}

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

BENCHMARK(walkTenThousand)->Name("crowd_step_10000")->Iterations(TURNS)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(walkWithMass)
    ->Name("crowd_step_10000_mass")
    ->Iterations(TURNS)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(walkTwoThreads)
    ->Name("crowd_step_10000_two_threads")
    ->Iterations(TURNS)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

// Sweeps: number of agents at constant density, density [0.01 agents per m2], vision radius [m], threads.
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
BENCHMARK(walkSideBySide)
    ->Name("crowds_side_by_side")
    ->Apply(useThreads)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace crowd
