#pragma once

#include <cstddef>

#include "avoidance/candidate_move.h"
#include "avoidance/gap_sharing.h"
#include "avoidance/move_limit.h"
#include "avoidance/near_agents.h"
#include "world/perception.h"
#include "world/relative_action.h"

namespace crowd {

class StoppingGaps;

/// @brief The separation rule for agents with motion limits (docs/separation_rule.md, Mass): wherever an agent goes in
/// a tick, it can brake afterwards without leaving its own side of the line that divides the gap.
///
/// The gap is that between the stopping regions of two bodies: what each covers if it brakes from now on. So braking is
/// always admissible. A body that appears within a stopping region is avoided by stopping faster than the motion limits
/// permit.
///
/// Call contract: an object serves one decision of one agent on one thread; the perception must outlive it.
class BrakingRule {
 public:
  /// @param seen with motion limits
  BrakingRule(const Perception& seen, GapSharing sharing);

  /// @brief Sets the admissible fraction of each of the first `count` moves, as if the agent could have their
  /// velocities at once.
  /// @param moves blocksOf(count) blocks
  void cut(MoveBlock* moves, std::size_t count) const;
  /// @brief The action that comes nearest to a move within the motion limits, and is admissible.
  RelativeAction actionTowards(const CandidateMove& move) const;
  /// @brief The action of a preferred move, as far as the motion limits permit it, if that is admissible; else that
  /// towards a fallback.
  RelativeAction actionTowards(const CandidateMove& preferred, const CandidateMove& fallback) const;

 private:
  /// A gap between the stopping regions of the agent and of another body; if they overlap, that between the bodies.
  struct Gap {
    Vector2 normal;  // towards the other; 0 if the centres coincide: then no direction increases the overlap
    double width;    // [m]
    double along;    // component along the normal of the point of the agent's way nearest to the other [m]
    bool is_sudden;  // it is that of the bodies
  };
  /// Upper bound of where the agent stops, in one direction; if it `is_sudden`, of where it is after the tick.
  struct Limit : MoveLimit {
    bool is_sudden = false;
  };

  /// Velocities between braking and the nearest to a wanted one that can be reached; what can be reached is convex.
  struct Reach {
    Vector2 reached;
    Vector2 braked;
    Vector2 at(double share) const { return braked + share * (reached - braked); }
  };

  template <typename Use>
  void forEachLimit(double reach, const Use& use) const;
  NeighbourSet findLimiting(std::size_t first, double reach) const;
  static bool limits(const Neighbour& other);
  Vector2 stopOf(const Neighbour& other) const;
  static Gap gapOf(const StoppingGaps& gaps, std::size_t number);
  Gap gapToBody(const Vector2& place, double its_radius) const;
  double shareOf(const Gap& gap, const Neighbour& other) const;
  RelativeAction actionWith(const Vector2& velocity, const CandidateMove& move) const;
  Reach reachTowards(const Vector2& wanted) const;
  Vector2 velocityTowards(const Vector2& wanted) const;
  Vector2 velocityOf(const CandidateMove& move) const { return move.fraction * seen_.self.max_speed * move.direction; }
  bool isWithin(const Limit& limit, const Vector2& velocity) const;

  const Perception& seen_;
  GapSharing sharing_;
  Segment stopping_;  // way of the agent's centre if it brakes from now on
};

}  // namespace crowd
