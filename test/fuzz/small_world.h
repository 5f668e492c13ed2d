#pragma once

#include "learning/learner.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"

/// A small world with one of everything that services and topics change.
namespace crowd::fuzz {

inline Scene smallScene() {
  static const ScenarioList scenarios = parseScenarios(R"(
name: small
duration: 10
goal_tolerance: 0.3
contact: solid
agents:
  - {position: [-2, -2], goal: [2, 2], speed: 1, radius: 0.2}
  - {position: [2, -2], route: buy, speed: 1, radius: 0.2}
obstacles: [{position: [0, 2], radius: 0.3}]
walls: [[[-4, -4], [4, -4]], [[-4, -4], [-4, 4]], [[0, -4], [0, -1]]]
gates: {door: {wall: [[0, -1], [0, 1]], open: true}}
sinks: {exit: {area: {box: [[3, 3], [4, 4]]}}}
queues: {counter: {head: [-3, 3], direction: 270, spacing: 0.6, service: 1}}
routes: {buy: {waypoints: [{queue: counter}, {sink: exit}]}}
robots:
  - {name: robot, position: [-3, 0], goal: [3, 0], radius: 0.3, max_speed: 1}
)",
                                                       "small");
  return scenarios.scene(1, 0);
}

inline Learner makeLearner(Mode mode = Mode::DEMO) {
  Learner::Options options;
  options.mode = mode;
  return {parseModel("state_set: {type: nearest_obstacle}\naction_set: {type: kings_moves}\n"
                     "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"),
          options};
}

/// @brief Walks one tick.
inline void walk(Episode& episode) {
  static Learner learner = makeLearner();
  CrowdDecider decider(learner);
  if (!episode.isOver()) episode.walk(decider);
}

}  // namespace crowd::fuzz
