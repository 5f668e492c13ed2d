#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <memory>
#include <string>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/avoidance/decision_context.h"
#include "social_crowd/common/yaml_reader.h"
#include "social_crowd/learning/rl/rows.h"
#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief What an agent can choose from at a tick. Immutable, so that any number of learners and threads may share one.
class ActionSet {
 public:
  virtual ~ActionSet() = default;

  /// @brief Number of actions.
  virtual Action size() const = 0;
  /// @brief The move that an action means to an agent that perceives this.
  RelativeAction relativeAction(const Perception& perception, Action action) const {
    RelativeAction relative;
    findAction(perception, action, relative);
    return relative;
  }
  /// @brief The same, written to where it stays: a copy would wait until what was just written is in the cache.
  /// @param relative all of it is written
  virtual void findAction(const Perception& perception, Action action, RelativeAction& relative) const = 0;
  /// @brief Writes the moves that all size() actions mean to an agent, blocksOf(size()) blocks.
  virtual void findMoves(const DecisionContext& context) const;
  /// @brief The same for several agents.
  virtual void findMovesOfAll(const DecisionBatch& contexts) const {
    for (const DecisionContext& context : contexts) findMoves(context);
  }
  /// @brief The action that means the same with left and right exchanged.
  virtual Action mirrored(Action action) const = 0;
  /// @brief Name and parameters as one canonical line of YAML; two sets are the same if these are.
  virtual std::string spec() const = 0;
};

/// @brief The action set that a YAML map with the key `type` describes.
/// @throws InputError if there is none of that name or a parameter is wrong.
std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place);

}  // namespace crowd
