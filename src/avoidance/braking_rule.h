#pragma once

#include <cstddef>

#include "avoidance/braking_limits.h"
#include "avoidance/candidate_move.h"
#include "world/perception.h"
#include "world/relative_action.h"

namespace crowd {

/// @brief The separation rule for agents with motion limits (docs/separation_rule.md, Mass): wherever an agent goes in
/// a tick, it can brake afterwards without leaving its own side of the line that divides the gap.
///
/// The gap is that between the stopping regions of two bodies: what each covers if it brakes from now on. So braking is
/// always admissible. A body that appears within a stopping region is avoided by stopping faster than the motion limits
/// permit.
///
/// Call contract: an object serves one decision of one agent; the perception and the limits must outlive it.
class BrakingRule {
 public:
  /// @param seen with motion limits @param limits of findBrakingLimits()
  BrakingRule(const Perception& seen, const BrakingLimits& limits) : seen_(seen), limits_(limits) {}

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
  /// Velocities between braking and the nearest to a wanted one that can be reached; what can be reached is convex.
  struct Reach {
    Vector2 reached;
    Vector2 braked;
    Vector2 at(double share) const { return braked + share * (reached - braked); }
  };

  template <typename Use>
  void forEachLimit(double reach, const Use& use) const;
  RelativeAction actionWith(const Vector2& velocity, const CandidateMove& move) const;
  Reach reachTowards(const Vector2& wanted) const;
  Vector2 velocityTowards(const Vector2& wanted) const;
  Vector2 velocityOf(const CandidateMove& move) const { return move.fraction * seen_.self.max_speed * move.direction; }
  bool isWithin(const BrakingLimit& limit, const Vector2& velocity) const;

  const Perception& seen_;
  const BrakingLimits& limits_;
};

}  // namespace crowd
