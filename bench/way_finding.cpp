// Way-finding on a map: a new goal, the navigation data of the map, and a crowd step with it.

#include <benchmark/benchmark.h>

#include <cstddef>

#include "crowd_walk.h"
#include "maps/map_walls.h"
#include "measuring.h"
#include "navigation/mesh_cache.h"
#include "navigation/path_follower.h"
#include "navigation/way_claims.h"
#include "office.h"

namespace crowd {
namespace {

constexpr double RADIUS = 0.25;     // of the agents [m]
constexpr std::size_t PAIRS = 200;  // of start and goal
constexpr std::size_t AGENTS = 1000;
constexpr int TICKS = 40;    // of a repetition of the crowd step
constexpr int TURNS = 5;     // repetitions of TICKS
constexpr int WARM_UP = 20;  // unmeasured ticks; all first paths are found in the first one

FloorPlan floorOf(const OccupancyMap& map) {
  FloorPlan floor;
  floor.walls = traceWalls(map);
  return floor;
}

/// Finds ways as WayFinder does: on the tight mesh if the comfortable one has none.
class Finder {
 public:
  explicit Finder(const NavigationData& data) : comfortable_(data.comfortable), tight_(data.tight) {}

  bool find(const AgentStart& agent) {
    PathFollower follower(agent.goals.front());
    benchmark::DoNotOptimize(follower.next(agent.position, comfortable_));
    if (follower.state() == PathFollower::State::ON_THE_WAY) return true;
    follower.replan();
    benchmark::DoNotOptimize(follower.next(agent.position, tight_));
    return follower.state() == PathFollower::State::ON_THE_WAY;
  }
  std::size_t bytes() const { return comfortable_.bytes() + tight_.bytes(); }

 private:
  NavigationMesh::Query comfortable_;
  NavigationMesh::Query tight_;
};

/// What way-finding prepares for agents of one size.
struct Prepared {
  explicit Prepared(const FloorPlan& floor)
      : meshes{NavigationMesh(floor, RADIUS + COMFORTABLE_MARGIN), NavigationMesh(floor, RADIUS + TIGHT_MARGIN)},
        ruler(floor, WayClaims::wideClearance(RADIUS)) {}
  std::size_t bytes() const { return meshes.comfortable.bytes() + meshes.tight.bytes() + ruler.bytes(); }

  NavigationData meshes;
  FloorRuler ruler;
};

void findWays(benchmark::State& state) {
  const OccupancyMap map = benchmarkMap();
  const Prepared prepared(floorOf(map));
  const Scene scene = makeMapCrowd(map, PAIRS);
  Finder finder(prepared.meshes);
  for (auto _ : state) {
    const double time = timeOf(Clock::OF_THREAD, [&] {
      for (const AgentStart& agent : scene.agents) {
        if (!finder.find(agent)) state.SkipWithError("a goal is out of reach");
      }
    });
    state.SetIterationTime(time / static_cast<double>(PAIRS));
  }
}

void prepareMap(benchmark::State& state) {
  const FloorPlan floor = floorOf(benchmarkMap());
  for (auto _ : state) {
    state.SetIterationTime(timeOf(Clock::OF_THREAD, [&] { benchmark::DoNotOptimize(Prepared(floor)); }));
  }
}

void rememberMap(benchmark::State& state) {
  const OccupancyMap map = benchmarkMap();
  const Scene scene = makeMapCrowd(map, PAIRS);
  const Prepared prepared(floorOf(map));
  Finder finder(prepared.meshes);
  for (auto _ : state) {
    for (const AgentStart& agent : scene.agents) finder.find(agent);
  }
  state.counters["megabytes"] = static_cast<double>(prepared.bytes() + finder.bytes()) / 1e6;
}

std::size_t repeat(CrowdWalk& crowd, int ticks) {
  std::size_t done = 0;
  for (int tick = 0; tick < ticks; ++tick) done += crowd.step();
  return done;
}

void walkOnMap(benchmark::State& state) {
  Scene scene = makeMapCrowd(benchmarkMap(), AGENTS);
  CrowdWalk with_walls(scene);
  scene.walls.clear();
  CrowdWalk without_walls(scene);
  repeat(with_walls, WARM_UP);
  repeat(without_walls, WARM_UP);
  takeTurns(
      state, Clock::OF_THREAD, [&] { return repeat(with_walls, TICKS); }, [&] { return repeat(without_walls, TICKS); });
}

}  // namespace

BENCHMARK(findWays)->Name("way_to_goal")->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(prepareMap)->Name("way_preparation")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(rememberMap)->Name("way_memory")->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(walkOnMap)->Name("crowd_step_map_1000")->Iterations(TURNS)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
