#pragma once

#include <string>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/avoidance/decision_context.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief How two agents share out the gap between their bodies, before both move at once.
enum class GapSharing {
  NONE,    ///< no rule: moves are not cut
  HALF,    ///< half of it each
  MOVING,  ///< the line between them moves along with both: who follows may use what the other leaves
};

/// @brief The names used in files. @throws InputError naming what was expected.
GapSharing parseGapSharing(const std::string& text);
std::string toText(GapSharing sharing);

/// @brief Cuts moves short so that nobody who follows the rule ever touches another one who does, a wall, or a thing at
/// rest (docs/separation_rule.md has the proof), and that moving obstacles are kept clear of (see EscapePlanner).
///
/// Along the line between two agents each advances by no more than its share of the gap; both work out the same shares
/// from what both know: their places, radii and last velocities. Of the gap to a wall or an obstacle at rest all may be
/// used.
class SeparationRule {
 public:
  /// @param lookout how far ahead a way clear of moving obstacles is kept [s], see EscapePlanner; 0: they are not kept
  /// clear of
  SeparationRule(GapSharing sharing, double lookout) : sharing_(sharing), lookout_(lookout) {}

  GapSharing sharing() const { return sharing_; }
  /// @brief Sets the admissible fraction of each of the first `count` moves, at most the wanted one. Where an escape
  /// from moving obstacles asks for another move, that takes its place. To stay is always admissible.
  /// @param moves blocksOf(count) blocks
  void cut(const Perception& perception, MoveBlock* moves, std::size_t count) const;
  /// @brief The same for the moves of several agents.
  void cut(const DecisionBatch& contexts, std::size_t count) const;

 private:
  void cutAmongAgents(const DecisionBatch& contexts, std::size_t count) const;
  void cutToGaps(const Perception& perception, MoveBlock* moves, std::size_t count) const;

  GapSharing sharing_;
  double lookout_;
};

}  // namespace crowd
