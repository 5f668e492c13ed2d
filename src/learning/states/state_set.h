#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "avoidance/candidate_move.h"
#include "avoidance/perception_batch.h"
#include "learning/actions/action_set.h"
#include "learning/part_types.h"
#include "learning/rl/rows.h"

namespace crowd {

/// @brief Maps the perception of an agent to rows of the Q-table. Immutable: any number of learners and threads may
/// share one object, and all functions may be called concurrently.
///
/// Call contract: the learner calls the action set first, then findRows(), for the agents of a batch.
///
/// Neighbours in a perception are ordered by the distance of their rims, nearest first (up to rounding); a state set
/// may rely on this. They are limited to maxNeighbours().
class StateSet {
 public:
  virtual ~StateSet() = default;

  /// @brief Number of rows of the Q-table. This includes the terminal row if the set has one, as the sets of the thesis
  /// do (their last row). The learner neither reads nor updates the values of a terminal row, because the update on
  /// arrival uses no next state; the row exists only to keep the thesis's numbering. A set without a terminal row is
  /// valid.
  virtual Row rowCount() const = 0;
  /// @brief Number of rows that a perception maps to: 1 (the same row for all actions) or one per action.
  virtual std::size_t rowsPerPerception() const { return 1; }
  /// @brief Writes the rows of each agent of a batch. The rows of an agent do not depend on the other agents. Called
  /// also for agents that have arrived, whose rows are not used. If maxNeighbours() is 0, the perceptions may hold
  /// neighbours beyond visionRadius().
  /// @param moves the candidate moves of the action set, blocksOf(number of actions) blocks per agent
  /// @param rows output, rowsPerPerception() row numbers per agent, each below rowCount()
  virtual void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const = 0;
  /// @brief Returns the row of the same perception with left and right exchanged; with one row per action, that of the
  /// mirrored action. A perception exactly on a limit of a sector may map to the row of the adjacent sector instead. A
  /// terminal row is its own mirror image. Called for every row when mirrored learning is switched on.
  virtual Row mirrored(Row row) const = 0;
  /// @brief Maximum distance from the agent's centre to the rim of a neighbour or a wall that the rows depend on [m].
  virtual double visionRadius() const = 0;
  /// @brief Maximum distance from the agent's rim to the walls in a perception [m]. Limits the perception as a whole,
  /// as maxNeighbours() does, but the learner does not truncate walls.
  virtual double wallDistance() const { return std::numeric_limits<double>::infinity(); }
  /// @brief Maximum number of neighbours in a perception, the nearest ones; 0: no limit.
  ///
  /// This limits the perception as a whole, not only this state set: the crowd controller perceives with it by default
  /// (see Model::vision()), and the learner truncates the neighbours to it, and to the radius of vision, before it
  /// calls the state set, the action set (with it the separation rule) and the reward. With 0 the learner passes on all
  /// neighbours that it receives, also those beyond the radius of vision.
  virtual std::uint32_t maxNeighbours() const { return 0; }
  /// @brief Name and parameters as one canonical line of YAML. Two sets with equal lines are the same set; Q-table
  /// files are checked by it.
  virtual std::string spec() const = 0;
};

/// @brief Creates the state set that a YAML map with the key `type` describes.
/// @param action_set the action set that the Q-table is for
/// @throws InputError if the type is unknown or a parameter is invalid
std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const ActionSet& action_set);

using StateSetType = PartType<StateSet, ActionSet>;
/// @brief The registered state sets; a new one is added here.
const std::vector<StateSetType>& stateSetTypes();

}  // namespace crowd
