#include "social_crowd/world/neighbour_look.h"

#include "eight_discs.h"
#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

#ifdef CROWD_AVX512
/// Mostly a run is eight discs at most.
CROWD_AVX512 bool lookWithAvx512(const NeighbourGrid& grid, const NeighbourGrid::Run& run, const Vector2& point,
                                 double distance, std::uint32_t except) {
  const EightDiscsReader reader(grid, point, distance, except);
  std::uint32_t any = 0;
  std::uint32_t i = run.begin;
  do {
    const EightDiscs eight = reader.read(i, run.end);
    any |= _mm512_mask_cmp_pd_mask(eight.near, eight.limits, _mm512_setzero_pd(), _CMP_GE_OQ);
    i += EightDiscs::SIZE;
  } while (i < run.end);
  return any != 0;
}
#endif

}  // namespace

bool lookAnywhere(const NeighbourGrid& grid, const NeighbourGrid::Run& run, const Vector2& point, double distance,
                  std::uint32_t except) {
  bool any = false;
  for (std::uint32_t i = run.begin; i < run.end; ++i) {
    const double limit = distance + grid.radius(i);
    any |= (limit >= 0.0) & ((grid.centre(i) - point).squaredNorm() <= limit * limit) & (grid.body(i) != except);
  }
  return any;
}

Look fastestLook() { return CROWD_FASTEST(lookWithAvx512, lookAnywhere); }

}  // namespace crowd
