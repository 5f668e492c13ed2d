#pragma once

#include <string>

#include "social_crowd/learning/candidate_move.h"
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
/// rest (docs/contact_rule.md has the proof).
///
/// Along the line between two agents each advances by no more than its share of the gap; both work out the same shares
/// from what both know: their places, radii and last velocities. Of the gap to a wall or obstacle all may be used; an
/// obstacle's own displacement is taken off first.
class ContactRule {
 public:
  /// @param lane_time nobody enters the lane that a moving obstacle sweeps within this time [s]
  ContactRule(GapSharing sharing, double lane_time) : sharing_(sharing), lane_time_(lane_time) {}

  GapSharing sharing() const { return sharing_; }
  /// @brief Sets the admissible share of each move, at most the wanted one. To stay is always admissible.
  void cut(const Perception& perception, CandidateMove* moves, std::size_t count) const;

 private:
  GapSharing sharing_;
  double lane_time_;
};

}  // namespace crowd
