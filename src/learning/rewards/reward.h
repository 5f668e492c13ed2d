#pragma once

#include <yaml-cpp/yaml.h>

#include <memory>
#include <string>
#include <vector>

#include "learning/part_types.h"
#include "learning/states/state_set.h"
#include "world/perception.h"

namespace crowd {

/// @brief The reward of a decision, computed from what the agent perceives one tick later. Immutable: any number of
/// learners and threads may share one object and call it concurrently.
///
/// Unit: that of the Q-values, which each reward defines: `thesis` has none, `progress` counts ticks. Penalties are
/// given as numbers from 0 up and are subtracted.
///
/// Call contract: in training mode the learner calls it once for each decision that was carried out, at the next tick,
/// on the thread that calls Learner::decide(); on arrival for the last time in the episode. Decisions that were not
/// carried out get no reward.
class Reward {
 public:
  virtual ~Reward() = default;

  /// @brief Returns the reward.
  /// @param before the agent's perception of itself when it decided; its indices of neighbours and walls are not valid
  /// any more
  /// @param after its perception now, with at most StateSet::maxNeighbours() neighbours, nearest rim first (up to
  /// rounding); neighbours beyond this number are not perceived, so they are not penalised either
  /// @param row the first row that `after` maps to; 0, and not to be used, if after.self.arrived
  virtual double operator()(const AgentPerception& before, const Perception& after, Row row) const = 0;
  /// @brief Parameters as one canonical line of YAML. It is kept in Q-table files, but tables learned for another
  /// reward are accepted.
  virtual std::string spec() const = 0;
};

/// @brief Returns the decrease of the distance to the goal [m]; 0 if the goal has changed, as in the tick in which the
/// agent reached an intermediate goal.
double distanceGained(const AgentPerception& before, const AgentPerception& after);

/// @brief Creates the reward that a YAML map describes; without the key `type` that of the thesis.
/// @param state_set the state set whose rows the reward receives
/// @throws InputError if the type is unknown or a parameter is invalid
std::shared_ptr<const Reward> makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set);

using RewardType = PartType<Reward, StateSet>;
/// @brief The registered rewards; a new one is added here.
const std::vector<RewardType>& rewardTypes();

}  // namespace crowd
