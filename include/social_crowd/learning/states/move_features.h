#pragma once

#include <array>
#include <cstddef>

#include "social_crowd/avoidance/decision_context.h"

namespace crowd {

/// @brief What would come of several moves, side by side and in single precision, so that the compiler makes vector
/// instructions of every step.
struct MoveFeatures {
  static constexpr std::size_t LANES = MoveBlock::SIZE;  ///< moves that are looked at together
  using Lanes = std::array<float, LANES>;

  alignas(64) Lanes reciprocal_times;  ///< to collision with an agent that does its half [s]; NEVER if there is none
  alignas(64) Lanes constant_velocity_times;  ///< to collision with an agent that goes on as it does [s]
  alignas(64) Lanes static_times;             ///< to collision with a wall or an obstacle [s]
  alignas(64) Lanes admissible_fractions;     ///< of the wanted displacement
  alignas(64) Lanes turn_cosines;
  float oncoming;  ///< fastest approach of another agent if this one walked to its goal at full speed, in units of that

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): computeMoveFeatures() writes them all
  MoveFeatures() = default;
};

/// @brief What would come of moves of several agents.
/// @param contexts MAX_BATCH at most
/// @param block which block of their moves
/// @param count the first so many moves of it, 1 to LANES; the other lanes hold anything
/// @param min_fraction a move of which the separation rule leaves less is to stay, wherever it was to lead
/// @param features one for each agent, to be written
void computeMoveFeatures(const DecisionBatch& contexts, std::size_t block, std::size_t count, double min_fraction,
                         MoveFeatures* features);

}  // namespace crowd
