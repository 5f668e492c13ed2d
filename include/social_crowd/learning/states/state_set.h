#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "social_crowd/avoidance/decision_context.h"
#include "social_crowd/common/yaml_reader.h"
#include "social_crowd/learning/actions/action_set.h"
#include "social_crowd/learning/rl/rows.h"

namespace crowd {

/// @brief An occupied sector around an agent and its distance class; for visualisation and recordings.
struct OccupiedSector {
  double from = 0.0;       ///< right limit, agent frame [rad]
  double to = 0.0;         ///< left limit, agent frame [rad]; not below `from`
  int distance_class = 0;  ///< 1 is the nearest
};

/// @brief Maps the perception of an agent to rows of the Q-table. Immutable: any number of learners and threads may
/// share one object, and all functions may be called concurrently.
///
/// Call contract: the learner calls findRows() or findRowsOfAll() for each agent that has to decide, never for an agent
/// that has arrived. If needsMoves(), it calls the action set first, so that the context holds the moves.
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
  /// @brief Whether findRows() reads the moves of the context. If so, the learner has the action set write them first.
  virtual bool needsMoves() const { return false; }
  /// @brief Writes rowsPerPerception() row numbers, each below rowCount(), to context.rows. context.moves is valid only
  /// if needsMoves().
  virtual void findRows(const DecisionContext& context) const = 0;
  /// @brief The same for several agents; must give the same rows as findRows().
  /// @param contexts at most MAX_BATCH
  virtual void findRowsOfAll(const DecisionBatch& contexts) const {
    for (const DecisionContext& context : contexts) findRows(context);
  }
  /// @brief Returns the row of the same perception with left and right exchanged; with one row per action, that of the
  /// mirrored action. A perception exactly on a limit of a sector may map to the row of the adjacent sector instead. A
  /// terminal row is its own mirror image. Called for every row when mirrored learning is switched on.
  virtual Row mirrored(Row row) const = 0;
  /// @brief Returns the distance classes that a row encodes, one per obstacle or sector that it distinguishes: 0
  /// (empty) to DistanceClasses::COUNT. Empty if the row encodes no obstacle, and for a terminal row. Used by
  /// ThesisReward, which calls it for every row when it is created.
  virtual std::vector<int> distanceClasses(Row row) const = 0;
  /// @brief Returns the sectors that are occupied in a perception. For visualisation and
  /// recordings.
  virtual std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const = 0;
  /// @brief Outer limits of the distance classes 1, 2, ..., ascending, at least one: distances from the agent's centre
  /// to the other's rim [m]. The last limit is the radius of vision.
  virtual std::vector<double> distanceLimits() const = 0;
  /// @brief Maximum number of neighbours in a perception, the nearest ones; 0: no limit.
  ///
  /// This limits the perception as a whole, not only this state set: the crowd controller perceives with it by default
  /// (see Model::vision()), and the learner truncates the neighbours to it, and to the radius of vision, before it
  /// calls the state set, the action set (with it the separation rule) and the reward. With 0 the learner passes on all
  /// neighbours that it receives, also those beyond the radius of vision. Walls are never truncated.
  virtual std::uint32_t maxNeighbours() const { return 0; }
  /// @brief Name and parameters as one canonical line of YAML. Two sets with equal lines are the same set; Q-table
  /// files are checked by it.
  virtual std::string spec() const = 0;
};

/// @brief Creates the state set that a YAML map with the key `type` describes.
/// @param action_set the action set that the Q-table is for
/// @throws InputError if the type is unknown or a parameter is invalid
std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const std::shared_ptr<const ActionSet>& action_set);

}  // namespace crowd
