// The yardstick of the crowd step: finding everybody's nearest neighbours and nothing else.

#include <benchmark/benchmark.h>

#include "crowd_walk.h"
#include "social_crowd/world/neighbour_grid.h"
#include "social_crowd/world/neighbour_search.h"

namespace crowd {
namespace {

constexpr double CELL_SIZE = 2.0;  // [m]; that of World

/// Where a crowd is after a while, as discs.
std::vector<NeighbourGrid::Disc> walkedDiscs(const World& world) {
  std::vector<NeighbourGrid::Disc> discs;
  for (const Agent& agent : world.agents()) discs.push_back({agent.pose.position, agent.radius, agent.id});
  return discs;
}

void findNeighbours(benchmark::State& state) {
  constexpr int TICKS_BEFORE = 40;
  CrowdWalk crowd{CrowdPlan()};
  for (int tick = 0; tick < TICKS_BEFORE; ++tick) crowd.step();
  const std::vector<NeighbourGrid::Disc> discs = walkedDiscs(crowd.world());
  const Vision& vision = crowd.vision();
  NeighbourGrid grid;
  NeighbourSearch search;
  for (auto _ : state) {
    grid.clear();
    for (const NeighbourGrid::Disc& disc : discs) grid.add(disc.centre, disc.radius, disc.body);
    grid.build(CELL_SIZE);
    for (std::size_t disc = 0; disc < grid.size(); ++disc) {
      benchmark::DoNotOptimize(
          search.findNearest(grid, grid.centre(disc), vision.radius, vision.max_bodies, grid.body(disc)).size());
    }
  }
  state.counters["agent_steps_per_second"] =
      benchmark::Counter(static_cast<double>(discs.size() * state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace

BENCHMARK(findNeighbours)->Name("crowd_step_10000/yardstick")->Unit(benchmark::kMillisecond);

}  // namespace crowd
