#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "common/random.h"
#include "learning/learner.h"
#include "support/perceptions.h"

/// Helpers for tests of learners: a model of 69 rows and 8 actions in which a single agent is in row 0 .. 3 if its goal
/// lies ahead, left, behind or right, and the reward is the distance gained [m].
namespace crowd::learners {

inline Model model() {
  return parseModel(
      "{state_set: {type: nearest_obstacle, goal_sectors: 4}, action_set: {type: kings_moves}, "
      "reward: {goal: distance_gained, obstacle_cost: 80}}");
}

inline QTable emptyTable() { return {69, 8}; }

/// With alpha 0.5 and gamma 0.5 the values are exact; no agent explores.
inline Learner::Options options(Mode mode, TableUse tables = TableUse::SHARED) {
  Learner::Options options;
  options.mode = mode;
  options.tables = tables;
  options.plan.parameters = {0.5, 0.5, 0.0, 0.0};
  options.plan.epsilon = EpsilonSchedule::constant(0.0);
  return options;
}

/// The goal of an agent in one of the rows 0 .. 3, exactly at a distance [m].
inline Vector2 goalIn(Row row, double distance) {
  const double along = row % 2 == 0 ? distance : 0.0;
  const double across = row % 2 == 1 ? distance : 0.0;
  return row < 2 ? Vector2(along, across) : Vector2(-along, -across);
}

/// One agent alone in one of the rows 0 .. 3.
inline PerceptionsBuilder tick(std::uint64_t tick, Row row, double distance, AgentId agent = 0) {
  return PerceptionsBuilder(0, tick).agent(agent, goalIn(row, distance));
}

inline RelativeActions decide(Learner& learner, const PerceptionsBuilder& perceptions) {
  RelativeActions actions;
  learner.decide(perceptions.all(), actions);
  return actions;
}

inline Action actionOf(const AgentAction& answer) {
  return static_cast<Action>(std::lround(toDegrees(answer.action.rotation) / 45.0));
}

/// The action of a single agent in one tick.
inline Action decideOne(Learner& learner, const PerceptionsBuilder& perceptions) {
  return actionOf(decide(learner, perceptions).agents.at(0));
}

/// Random values and visits for a model.
inline QTable randomTable(const Model& model, std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  QTable table(model.state_set->rowCount(), model.action_set->size());
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const double value = random.uniform(-100.0, 100.0);
      table.set(row, action, value, 1 + random.below(9));
    }
  }
  return table;
}

inline QTable randomTable(std::uint64_t seed) { return randomTable(model(), seed); }

/// Random perceptions of a number of agents; the last answers of some were not carried out. `backwards` lists the
/// agents in descending order.
inline PerceptionsBuilder randomTick(std::uint64_t seed, std::uint64_t episode, std::uint64_t tick, AgentId agents,
                                     bool backwards = false) {
  PerceptionsBuilder scene(episode, tick);
  for (AgentId i = 0; i < agents; ++i) {
    const AgentId agent = backwards ? agents - 1 - i : i;
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {episode, tick, agent});
    const double bearing = random.uniform(-180.0, 180.0);
    scene.agent(agent, polar(bearing, random.uniform(1.0, 3.0)));
    if (random.below(10) == 0) scene.missed();
    if (random.below(2) == 0) {
      const double side = random.uniform(-180.0, 180.0);
      scene.neighbour(polar(side, random.uniform(0.4, 1.2)), 0.2);
    }
  }
  return scene;
}

}  // namespace crowd::learners
