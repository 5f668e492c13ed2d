#pragma once

#include <vector>

#include "simd/following_moves.h"
#include "simd/near_neighbours.h"
#include "simd/nearby_discs.h"
#include "simd/ranks.h"
#include "simd/row_numbers.h"
#include "simd/segment_gaps.h"
#include "simd/stopping_moves.h"
#include "simd/time_to_collision.h"

namespace crowd::simd {

/// @brief One implementation of all kernels. All implementations give bit-identical results.
struct Kernels {
  const char* target;  ///< "reference", or Highway's name of the instruction set
  CollectNearby* collect_nearby;
  IsAnyNearby* is_any_nearby;
  RankAscending* rank_ascending;
  FindNear* find_near;
  FindNearStop* find_near_stop;
  AccumulateTimeToCollision* accumulate_time_to_collision;
  FindRowNumbers* find_row_numbers;
  CutStops* cut_stops;
  CutFollowing* cut_following;
  FindGaps* find_gaps;
};

/// @brief Scalar implementation, which defines the results.
extern const Kernels REFERENCE;

/// @brief All implementations that this processor can run, fastest first, the reference last.
std::vector<Kernels> availableKernels();

/// @brief The fastest of availableKernels(), or those for the target in the environment variable SOCIAL_CROWD_SIMD.
/// @throws InputError if that target is not available
Kernels chooseKernels();

/// @brief The kernels in use; chosen by chooseKernels() at the first call. Thread-safe. @throws InputError as above
const Kernels& kernels();

}  // namespace crowd::simd
