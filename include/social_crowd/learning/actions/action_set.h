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

/// @brief The moves that an agent can choose from at a tick. Immutable: any number of learners and threads may share
/// one object, and all functions may be called concurrently.
///
/// Call contract: if the state set needs the moves, the learner calls findMoves() or findMovesOfAll() before the state
/// set, and takes the chosen move from there. If not, it calls findAction() for the chosen action. So both must
/// describe the same move.
///
/// Perceptions hold at most StateSet::maxNeighbours() neighbours, nearest rim first (up to rounding); an action set may
/// rely on this order, and does not perceive further neighbours.
class ActionSet {
 public:
  virtual ~ActionSet() = default;

  /// @brief Number of actions, at least 1; constant.
  virtual Action size() const = 0;
  /// @brief Returns the move of an action for an agent with this perception.
  RelativeAction relativeAction(const Perception& perception, Action action) const {
    RelativeAction relative;
    findAction(perception, action, relative);
    return relative;
  }
  /// @brief The same with an output parameter, which avoids a copy: its loads would wait for the stores that were just
  /// made.
  /// @param relative output; every field is written
  virtual void findAction(const Perception& perception, Action action, RelativeAction& relative) const = 0;
  /// @brief Writes the moves of all size() actions to context.moves, which has blocksOf(size()) blocks. Unused lanes
  /// must hold a valid move, too.
  virtual void findMoves(const DecisionContext& context) const;
  /// @brief The same for several agents; must give the same moves as findMoves().
  /// @param contexts at most MAX_BATCH
  virtual void findMovesOfAll(const DecisionBatch& contexts) const {
    for (const DecisionContext& context : contexts) findMoves(context);
  }
  /// @brief Returns the action that is the same move with left and right exchanged.
  virtual Action mirrored(Action action) const = 0;
  /// @brief Name and parameters as one canonical line of YAML. Two sets with equal lines are the same set; Q-table
  /// files are checked by it.
  virtual std::string spec() const = 0;
};

/// @brief Creates the action set that a YAML map with the key `type` describes.
/// @throws InputError if the type is unknown or a parameter is invalid
std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place);

}  // namespace crowd
