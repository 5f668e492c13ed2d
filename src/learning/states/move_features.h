#pragma once

#include <array>
#include <cstddef>

#include "avoidance/candidate_move.h"
#include "avoidance/perception_batch.h"
#include "common/text/enum_names.h"

namespace crowd {

/// @brief Features of up to LANES candidate moves of one agent, one array per feature and in single precision, so that
/// the compiler can vectorise each step. A collision later than the arrival at the goal counts as NEVER.
struct MoveFeatures {
  static constexpr std::size_t LANES = MoveBlock::SIZE;  ///< number of moves per block
  using Lanes = std::array<float, LANES>;

  alignas(64) Lanes reciprocal_times;         ///< reciprocal time to collision with an agent [s], or NEVER
  alignas(64) Lanes constant_velocity_times;  ///< time to collision with an agent that keeps its velocity [s], or NEVER
  alignas(64) Lanes static_times;             ///< time to collision with a wall or an obstacle [s], or NEVER
  alignas(64) Lanes admissible_fractions;     ///< admissible fraction of the wanted displacement
  alignas(64) Lanes turn_cosines;             ///< of the angle to the heading; 1 if the agent stood still
  float oncoming;  ///< fastest approach of another agent, for the preferred velocity [maximum speeds]

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): computeMoveFeatures() writes them all
  MoveFeatures() = default;
};

/// @brief At which speed of a move collisions are predicted.
enum class CandidateSpeeds {
  WANTED,      ///< that of the move
  ADMISSIBLE,  ///< the part of it that the time gap and the separation rule admit
};

inline constexpr EnumNames<CandidateSpeeds, 2> CANDIDATE_SPEEDS{"candidate_speeds", {"wanted", "admissible"}};

/// @brief How the collisions of moves are predicted.
struct CollisionPrediction {
  CandidateSpeeds speeds = CandidateSpeeds::WANTED;
  double min_fraction = 0.0;    ///< wanted speeds: a move with a smaller admissible fraction has the times of staying
  double personal_space = 0.0;  ///< see accumulateTimeToCollision() [m]
};

/// @brief Computes the features of one block of moves of each of several agents.
/// @param moves the block of the first agent; that of the next agent is `stride` blocks further
/// @param count number of moves of the block, 1 to LANES; the features of the other lanes are undefined
/// @param features output, one per agent
void computeMoveFeatures(const PerceptionBatch& batch, const MoveBlock* moves, std::size_t stride, std::size_t count,
                         const CollisionPrediction& prediction, MoveFeatures* features);

}  // namespace crowd
