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

/// @brief A sector around an agent and the distance class of what is in it; for pictures.
struct OccupiedSector {
  double from = 0.0;       ///< right limit, agent frame [rad]
  double to = 0.0;         ///< left limit, agent frame [rad]; not below `from`
  int distance_class = 0;  ///< 1 is the nearest
};

/// @brief Maps what an agent perceives to rows of the Q-table. Immutable, so that any number of learners and threads
/// may share one.
class StateSet {
 public:
  virtual ~StateSet() = default;

  /// @brief Number of rows of the Q-table, the terminal one included.
  virtual Row rowCount() const = 0;
  /// @brief How many rows a perception maps to: 1, the same for all actions, or one per action.
  virtual std::size_t rowsPerPerception() const { return 1; }
  /// @brief Whether findRows() looks at the moves.
  virtual bool needsMoves() const { return false; }
  /// @brief Writes rowsPerPerception() rows for what an agent on its way perceives; its moves are of no meaning unless
  /// needsMoves().
  virtual void findRows(const DecisionContext& context) const = 0;
  /// @brief The same for several agents.
  virtual void findRowsOfAll(const DecisionBatch& contexts) const {
    for (const DecisionContext& context : contexts) findRows(context);
  }
  /// @brief The row that a perception maps to if left and right are exchanged in it; of several rows, that of the
  /// mirrored action. A perception exactly on a limit of a sector may map to the neighbour of that row.
  virtual Row mirrored(Row row) const = 0;
  /// @brief The distance classes that a row stands for: of each obstacle or sector it tells apart; empty if it tells of
  /// no obstacle. For rewards.
  virtual std::vector<int> distanceClasses(Row row) const = 0;
  /// @brief The sectors a perception finds occupied. For pictures.
  virtual std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const = 0;
  /// @brief Outer limits of the distance classes 1, 2, ... to the other's rim [m]; the last is how far it looks.
  virtual std::vector<double> distanceLimits() const = 0;
  /// @brief The nearest so many neighbours are all it looks at; 0: no limit.
  virtual std::uint32_t maxNeighbours() const { return 0; }
  /// @brief Name and parameters as one canonical line of YAML; two sets are the same if these are.
  virtual std::string spec() const = 0;
};

/// @brief The state set that a YAML map with the key `type` describes, for the actions of a set.
/// @throws InputError if there is none of that name or a parameter is wrong.
std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const std::shared_ptr<const ActionSet>& action_set);

}  // namespace crowd
