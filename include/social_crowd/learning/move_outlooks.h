#pragma once

#include <array>
#include <cstddef>

#include "social_crowd/learning/chooser.h"

namespace crowd {

/// @brief What would come of several moves, side by side and in single precision, so that the compiler makes vector
/// instructions of every step.
struct MoveOutlooks {
  static constexpr std::size_t LANES = MoveBlock::SIZE;  ///< moves that are looked at together
  using Lanes = std::array<float, LANES>;

  alignas(64) Lanes reciprocal_times;  ///< to contact with an agent that does its half [s]; NEVER if there is none
  alignas(64) Lanes selfish_times;     ///< to contact with an agent that goes on as it does [s]
  alignas(64) Lanes fixed_times;       ///< to contact with a wall or an obstacle [s]
  alignas(64) Lanes shares;            ///< of the wanted displacement
  alignas(64) Lanes turn_cosines;
  float oncoming;  ///< fastest approach of another agent if this one walked to its goal at full speed, in units of that

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): foresee() writes them, and zeroing first takes time
  MoveOutlooks() = default;
};

/// @brief What would come of moves of several agents.
/// @param choosers MAX_CHOOSERS at most
/// @param block which block of their moves
/// @param count the first so many moves of it, 1 to LANES; the other lanes hold anything
/// @param least_share a move of which the contact rule leaves less is to stay, wherever it was to lead
/// @param outlooks one for each agent, to be written
void foresee(const Choosers& choosers, std::size_t block, std::size_t count, double least_share,
             MoveOutlooks* outlooks);

}  // namespace crowd
