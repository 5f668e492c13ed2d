#pragma once

#include <array>
#include <cstddef>

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief A move that an agent could make in the next tick.
struct CandidateMove {
  Vector2 direction = Vector2::UnitX();  ///< unit vector in the agent's frame
  double wanted = 0.0;                   ///< fraction of the maximum speed that the action asks for, 0 to 1
  double fraction = 0.0;                 ///< fraction that is admissible, 0 to `wanted`
};

/// @brief What an agent does that makes the move, as far as it is admissible.
inline RelativeAction toAction(const CandidateMove& move) { return {bearingOf(move.direction), move.fraction}; }

/// @brief Some candidate moves side by side, so that vector instructions work on all of them. Lanes that hold no move
/// of their own repeat one.
struct MoveBlock {
  static constexpr std::size_t SIZE = 24;
  using Lanes = std::array<double, SIZE>;

  alignas(64) Lanes x;  ///< of the directions
  alignas(64) Lanes y;
  alignas(64) Lanes wanted;  ///< as in CandidateMove
  alignas(64) Lanes fraction;

  /// @brief The move in a lane.
  CandidateMove move(std::size_t lane) const { return {{x[lane], y[lane]}, wanted[lane], fraction[lane]}; }
  void set(std::size_t lane, const CandidateMove& move) {
    x[lane] = move.direction.x();
    y[lane] = move.direction.y();
    wanted[lane] = move.wanted;
    fraction[lane] = move.fraction;
  }
};

/// @brief How many blocks hold so many moves.
constexpr std::size_t blocksOf(std::size_t moves) { return (moves + MoveBlock::SIZE - 1) / MoveBlock::SIZE; }

/// @brief One of the moves of a list of blocks: reads it, and writes it.
inline CandidateMove moveAt(const MoveBlock* blocks, std::size_t i) {
  return blocks[i / MoveBlock::SIZE].move(i % MoveBlock::SIZE);
}
inline void setMove(MoveBlock* blocks, std::size_t i, const CandidateMove& move) {
  blocks[i / MoveBlock::SIZE].set(i % MoveBlock::SIZE, move);
}
/// @brief Fills the lanes behind the first `count` moves with the last of these.
inline void repeatLast(MoveBlock* blocks, std::size_t count) {
  const CandidateMove last = moveAt(blocks, count - 1);
  for (std::size_t i = count; i < blocksOf(count) * MoveBlock::SIZE; ++i) setMove(blocks, i, last);
}

}  // namespace crowd
