#pragma once

#include <vector>

#include "avoidance/separation_rule.h"
#include "learning/actions/action_set.h"
#include "learning/states/move_features.h"

namespace crowd {

/// @brief Moves laid out in blocks.
inline std::vector<MoveBlock> toBlocks(const std::vector<CandidateMove>& moves) {
  std::vector<MoveBlock> blocks(blocksOf(moves.size()));
  for (std::size_t i = 0; i < moves.size(); ++i) setMove(blocks.data(), i, moves[i]);
  repeatLast(blocks.data(), moves.size());
  return blocks;
}

/// @brief The moves of all actions, in blocks. @param limits output, see ActionSet::findMoves()
inline std::vector<MoveBlock> movesOf(const ActionSet& actions, const Perception& perception, BrakingLimits& limits) {
  std::vector<MoveBlock> blocks(blocksOf(actions.size()));
  actions.findMoves({&perception, 1}, blocks.data(), &limits);
  return blocks;
}
inline std::vector<MoveBlock> movesOf(const ActionSet& actions, const Perception& perception) {
  BrakingLimits limits;
  return movesOf(actions, perception, limits);
}

/// @brief The relative action of an action.
inline RelativeAction relativeAction(const ActionSet& actions, const Perception& perception, Action action) {
  BrakingLimits limits;
  const std::vector<MoveBlock> moves = movesOf(actions, perception, limits);
  return actions.relativeAction(perception, moves.data(), limits, action);
}

/// @brief Features of the first `count` moves of a block.
inline MoveFeatures featuresAlone(const Perception& perception, MoveBlock moves, std::size_t count,
                                  const CollisionPrediction& prediction) {
  MoveFeatures features;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  computeMoveFeatures({&perception, 1}, &moves, 1, count, prediction, &features);
  return features;
}

/// @brief The limits of an agent with motion limits.
inline BrakingLimits limitsOf(const Perception& perception, GapSharing sharing) {
  BrakingLimits limits;
  findBrakingLimits(perception, sharing, limits);
  return limits;
}

/// @brief Moves limited by a separation rule.
inline std::vector<CandidateMove> cut(const SeparationRule& rule, const Perception& perception,
                                      std::vector<CandidateMove> moves) {
  std::vector<MoveBlock> blocks = toBlocks(moves);
  BrakingLimits limits;
  rule.cut(perception, blocks.data(), moves.size(), limits);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = moveAt(blocks.data(), i);
  return moves;
}

}  // namespace crowd
