// The kernels written with Highway, compiled once for each instruction set.

#include "simd/kernels.h"

// Vectors of SVE have no fixed size, and cannot be members of classes.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "simd/highway_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/following_moves_inl.h"
#include "simd/near_neighbours_inl.h"
#include "simd/nearby_discs_inl.h"
#include "simd/ranks_inl.h"
#include "simd/row_numbers_inl.h"
#include "simd/segment_gaps_inl.h"
#include "simd/stopping_moves_inl.h"
#include "simd/time_to_collision_inl.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

Kernels targetKernels() {
  return {hwy::TargetName(HWY_TARGET), collectNearby,  isAnyNearby, rankAscending, findNear, findNearStop,
          accumulateTimeToCollision,   findRowNumbers, cutStops,    cutFollowing,  findGaps};
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crowd::simd {

HWY_EXPORT(targetKernels);

std::vector<Kernels> highwayKernels() {
  std::vector<Kernels> kernels;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::GetChosenTarget().Update(target);
    kernels.push_back(HWY_DYNAMIC_DISPATCH(targetKernels)());
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return kernels;
}

}  // namespace crowd::simd
#endif
