#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "avoidance/braking_limits.h"
#include "avoidance/candidate_move.h"
#include "avoidance/perception_batch.h"
#include "learning/part_types.h"
#include "learning/rl/rows.h"
#include "world/relative_action.h"

namespace crowd {

/// @brief The moves that an agent can choose from at a tick. Immutable: any number of learners and threads may share
/// one object, and all functions may be called concurrently.
///
/// Call contract: the learner calls findMoves() before the state set, then relativeAction() for the chosen moves; in
/// training mode it calls both of whileLearning().
///
/// Perceptions hold at most StateSet::maxNeighbours() neighbours, nearest rim first (up to rounding); an action set may
/// rely on this order, and does not perceive further neighbours.
class ActionSet {
 public:
  virtual ~ActionSet() = default;

  /// @brief Number of actions, at least 1; constant.
  virtual Action size() const = 0;
  /// @brief Writes the moves of all actions of each agent of a batch. The moves of an agent do not depend on the other
  /// agents.
  /// @param moves output, blocksOf(size()) blocks per agent. Unused lanes must hold a valid move, too.
  /// @param limits output, one list per agent, for relativeAction(); of agents without motion limits it is not used
  virtual void findMoves(const PerceptionBatch& batch, MoveBlock* moves, BrakingLimits* limits) const = 0;
  /// @brief Whether findMoves() writes the same moves for all perceptions. Then the learner does not call it each tick.
  virtual bool hasConstantMoves() const { return false; }
  /// @brief Returns the relative action that carries out the move of an action.
  /// @param moves, limits those that findMoves() wrote for the perception `seen`
  virtual RelativeAction relativeAction(const Perception& /*seen*/, const MoveBlock* moves,
                                        const BrakingLimits& /*limits*/, Action action) const {
    return toAction(moveAt(moves, action));
  }
  /// @brief The set that agents use while they learn, for example without a gait; null if it is this one. Size, order
  /// and mirror images of the actions, hasConstantMoves() and motion limits are as in this one. It belongs to no model:
  /// its spec() is not used.
  virtual std::shared_ptr<const ActionSet> whileLearning() const { return nullptr; }
  /// @brief The limits of the changes of velocity that its agents are to have, see Vision::motion.
  virtual MotionLimits motion() const { return {}; }
  /// @brief Returns the action that is the same move with left and right exchanged.
  virtual Action mirrored(Action action) const = 0;
  /// @brief Name and parameters as one canonical line of YAML. Two sets of models with equal lines are the same set;
  /// Q-table files are checked by it.
  virtual std::string spec() const = 0;
};

/// @brief Creates the action set that a YAML map with the key `type` describes.
/// @throws InputError if the type is unknown or a parameter is invalid
std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place);

using ActionSetType = PartType<ActionSet>;
/// @brief The registered action sets; a new one is added here.
const std::vector<ActionSetType>& actionSetTypes();

}  // namespace crowd
