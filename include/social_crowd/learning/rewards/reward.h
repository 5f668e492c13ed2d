#pragma once

#include <yaml-cpp/yaml.h>

#include <memory>
#include <string>

#include "social_crowd/common/yaml_reader.h"
#include "social_crowd/learning/states/state_set.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief How much a decision was worth, judged by what the agent perceives after it. Immutable, so that any number of
/// learners and threads may share one.
class Reward {
 public:
  virtual ~Reward() = default;

  /// @param before what the agent knew of itself when it decided
  /// @param after what it perceives now
  /// @param row the first row that `after` maps to; not used on arrival
  virtual double operator()(const AgentPerception& before, const Perception& after, Row row) const = 0;
  /// @brief Parameters as one canonical line of YAML.
  virtual std::string spec() const = 0;
};

/// @brief By how much the distance to the goal has shrunk [m]; 0 if there is another goal now.
double distanceGained(const AgentPerception& before, const AgentPerception& after);

/// @brief The reward that a YAML map describes, for a state set; without the key `type` it is the thesis's.
/// @throws InputError if there is none of that name or a parameter is wrong.
std::shared_ptr<const Reward> makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set);

}  // namespace crowd
