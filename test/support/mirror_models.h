#pragma once

#include <string>
#include <vector>

#include "learning/model.h"
#include "learning/rl/mirror.h"

/// Models for tests of mirror images.
namespace crowd::mirror_models {

inline Model modelOf(const std::string& state_set, const std::string& action_set, const std::string& reward) {
  return parseModel("{state_set: " + state_set + ", action_set: " + action_set + ", reward: " + reward + "}");
}

/// Models with even and odd numbers of sectors and actions, with one row for all actions and with one row per action.
inline std::vector<Model> models() {
  const std::string thesis = "{goal: distance_gained, obstacle_cost: 10}";
  return {
      modelOf("{type: nearest_obstacle}", "{type: kings_moves}", thesis),
      modelOf("{type: nearest_obstacle, goal_sectors: 5, obstacle_sectors: [30, 180]}",
              "{type: kings_moves, rotations: 7}", thesis),
      modelOf("{type: occupancy}", "{type: kings_moves}", thesis),
      modelOf("{type: occupancy, sectors: 5}", "{type: kings_moves, rotations: 2}", thesis),
      modelOf("{type: occupancy}", "{type: goal_relative}", thesis),
      modelOf("{type: condensed_occupancy}", "{type: kings_moves, stay: true}", thesis),
      modelOf("{type: anticipation}", "{type: goal_relative}", "{type: progress}"),
      modelOf("{type: anticipation}", "{type: kings_moves}", "{type: progress}"),
      modelOf("{type: occupancy, obstacle_sectors: [15, 45, 90, 180]}", "{type: kings_moves}", thesis),
      modelOf("{type: condensed_occupancy, sectors: 5, obstacle_sectors: [20, 70, 180]}", "{type: kings_moves}",
              thesis),
  };
}

inline Mirror mirrorOf(const Model& model) { return {*model.state_set, *model.action_set}; }

}  // namespace crowd::mirror_models
