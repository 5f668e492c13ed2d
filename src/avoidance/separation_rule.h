#pragma once

#include "avoidance/braking_limits.h"
#include "avoidance/candidate_move.h"
#include "avoidance/gap_sharing.h"
#include "avoidance/perception_batch.h"
#include "world/perception.h"

namespace crowd {

/// @brief Limits moves so that agents that follow the rule never touch each other, walls, or static obstacles
/// (docs/separation_rule.md has the proof and its conditions), and replaces moves that moving obstacles make unsafe
/// (see EscapePlanner).
///
/// Along the line between two agents, each agent advances by at most its share of the gap. Both compute the same shares
/// without communication, from their positions, radii and last velocities. The whole gap to a wall or a static obstacle
/// may be used. Agents do not move into robots that they yield to, nor into their reach in the coming tick
/// (docs/separation_rule.md, Robots). For agents with motion limits it does what BrakingRule describes. Immutable: any
/// number of threads may call cut() with buffers of their own.
class SeparationRule {
 public:
  /// @param lookout time for which a path clear of moving obstacles is kept [s], see EscapePlanner; 0: moving obstacles
  /// are ignored
  SeparationRule(GapSharing sharing, double lookout) : sharing_(sharing), lookout_(lookout) {}

  GapSharing sharing() const { return sharing_; }
  /// @brief Sets the admissible fraction of each of the first `count` moves, at most the wanted fraction. A move that
  /// is unsafe because of moving obstacles is replaced by another move. Staying is always admissible.
  /// @param moves blocksOf(count) blocks
  /// @param limits output if the agent has motion limits: what BrakingRule needs for its action
  void cut(const Perception& perception, MoveBlock* moves, std::size_t count, BrakingLimits& limits) const;
  /// @brief The same for the moves of several agents; gives the same results as one call per agent.
  /// @param batch at most MAX_BATCH agents
  /// @param moves blocksOf(count) blocks per agent
  /// @param limits one list per agent
  void cut(const PerceptionBatch& batch, MoveBlock* moves, std::size_t count, BrakingLimits* limits) const;
  /// @brief Whether a moving obstacle comes so near that cut() considers escapes from it.
  bool mustEscape(const Perception& perception) const;

 private:
  void cutAmongAgents(const PerceptionBatch& batch, MoveBlock* moves, std::size_t count) const;
  void replaceUnsafe(const Perception& perception, MoveBlock* moves, std::size_t count,
                     const BrakingLimits& limits) const;
  void cutToGaps(const Perception& perception, MoveBlock* moves, std::size_t count, const BrakingLimits& limits) const;

  GapSharing sharing_;
  double lookout_;
};

}  // namespace crowd
