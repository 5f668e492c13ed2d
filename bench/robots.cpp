// Robots with laser scanners in a crowd.

#include <benchmark/benchmark.h>

#include <string>

#include "crowd_walk.h"
#include "learning/q_table_file.h"
#include "measuring.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "simulation/robot_controller.h"

namespace crowd {
namespace {

constexpr std::size_t PEOPLE = 200;
constexpr std::size_t ROBOTS = 10;
constexpr int TICKS = 100;  // of 0.1 s

/// Robots that drive by their scans, of 720 rays in each tick, in places of further people.
Scene makeScene() {
  CrowdPlan plan;
  plan.agents = PEOPLE + ROBOTS;
  Scene scene = makeCrowd(plan);
  scene.contact = Contact::SOLID;
  while (scene.agents.size() > PEOPLE) {
    const AgentStart& place = scene.agents.back();
    RobotStart& robot = scene.robots.emplace_back();
    robot.name = "robot_" + std::to_string(scene.robots.size());
    robot.position = place.position;
    robot.heading = place.heading;
    robot.goals = place.goals;
    robot.limits.max_speed = 1.0;
    robot.footprint.radius = place.radius;
    robot.goal_tolerance = scene.goal_tolerance;
    scene.agents.pop_back();
  }
  return scene;
}

/// Simulated time per processor time of one thread.
void driveRobots(benchmark::State& state) {
  const Scene scene = makeScene();
  Learner learner = makeWalker();
  double simulated = 0.0;
  for (auto _ : state) {
    Episode episode(scene, 0, learner.model().vision());
    RobotDrivers robots("reactive", episode, learner);
    CrowdDecider decider(learner);
    state.SetIterationTime(timeOf(Clock::OF_THREAD, [&] {
      for (int tick = 0; tick < TICKS; ++tick) {
        robots.command(episode);
        episode.walk(decider);
      }
    }));
    simulated += TICKS * scene.tick_duration;
  }
  state.counters["rate"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

}  // namespace

BENCHMARK(driveRobots)->Name("robots_10")->Iterations(5)->UseManualTime();

}  // namespace crowd
