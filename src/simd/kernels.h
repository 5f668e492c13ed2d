#pragma once

#include <vector>

#include "simd/near_neighbours.h"
#include "simd/nearby_discs.h"
#include "simd/ranks.h"
#include "simd/row_numbers.h"
#include "simd/time_to_collision.h"

namespace crowd::simd {

/// @brief One implementation of all kernels. All implementations give the same bits.
struct Kernels {
  const char* target;  ///< "reference", or Highway's name of the instruction set
  CollectNearby* collect_nearby;
  RankAscending* rank_ascending;
  FindNear* find_near;
  AccumulateTimeToCollision* accumulate_time_to_collision;
  FindRowNumbers* find_row_numbers;
};

/// @brief The scalar implementation, which defines the results.
extern const Kernels REFERENCE;

/// @brief All implementations that this processor can run, the fastest first, the reference last.
std::vector<Kernels> availableKernels();

/// @brief The fastest of these, or those for the target that the environment variable SOCIAL_CROWD_SIMD names.
/// @throws InputError if there are none for it
Kernels chooseKernels();

/// @brief Those that were chosen at the first call.
const Kernels& kernels();

}  // namespace crowd::simd
