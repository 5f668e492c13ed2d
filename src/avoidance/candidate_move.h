#pragma once

#include <array>
#include <cstddef>

#include "geometry/geometry.h"
#include "world/relative_action.h"

namespace crowd {

/// @brief A move that an agent could make in the next tick, in the agent's frame (x ahead, y left).
struct CandidateMove {
  Vector2 direction = Vector2::UnitX();  ///< unit vector, agent frame
  double wanted = 0.0;                   ///< fraction of the maximum speed that the action requests, 0 to 1
  double fraction = 0.0;                 ///< admissible fraction of the maximum speed, 0 to `wanted`
};

/// @brief Converts a move, with its admissible fraction, to a relative action.
inline RelativeAction toAction(const CandidateMove& move) { return {bearingOf(move.direction), move.fraction}; }

/// @brief SIZE candidate moves, stored as one array per field for vector instructions. Unused lanes hold a copy of a
/// valid move, see repeatLast().
struct MoveBlock {
  static constexpr std::size_t SIZE = 24;
  using Lanes = std::array<double, SIZE>;

  alignas(64) Lanes x;       ///< x components of the directions
  alignas(64) Lanes y;       ///< y components of the directions
  alignas(64) Lanes wanted;  ///< as in CandidateMove
  alignas(64) Lanes fraction;

  /// @brief Returns the move in a lane.
  CandidateMove move(std::size_t lane) const { return {{x[lane], y[lane]}, wanted[lane], fraction[lane]}; }
  /// @brief Writes the move in a lane.
  void set(std::size_t lane, const CandidateMove& move) {
    x[lane] = move.direction.x();
    y[lane] = move.direction.y();
    wanted[lane] = move.wanted;
    fraction[lane] = move.fraction;
  }
};

/// @brief Returns the number of blocks that `moves` moves occupy.
constexpr std::size_t blocksOf(std::size_t moves) { return (moves + MoveBlock::SIZE - 1) / MoveBlock::SIZE; }

/// @brief Returns move `i` of a list of blocks.
inline CandidateMove moveAt(const MoveBlock* blocks, std::size_t i) {
  return blocks[i / MoveBlock::SIZE].move(i % MoveBlock::SIZE);
}
/// @brief Writes move `i` of a list of blocks.
inline void setMove(MoveBlock* blocks, std::size_t i, const CandidateMove& move) {
  blocks[i / MoveBlock::SIZE].set(i % MoveBlock::SIZE, move);
}
/// @brief Fills the unused lanes after the first `count` moves with the last of these moves.
/// @param count at least 1
inline void repeatLast(MoveBlock* blocks, std::size_t count) {
  const CandidateMove last = moveAt(blocks, count - 1);
  for (std::size_t i = count; i < blocksOf(count) * MoveBlock::SIZE; ++i) setMove(blocks, i, last);
}

}  // namespace crowd
