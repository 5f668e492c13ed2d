#include "social_crowd/world/neighbour_look.h"

#include <algorithm>

#include "social_crowd/common/vectorised.h"

#ifdef CROWD_AVX512
#include <immintrin.h>
#endif

namespace crowd {
namespace {

using Run = NeighbourGrid::Run;

bool isAnyIn(const NeighbourGrid& grid, const Run& run, const Vector2& point, double distance, std::uint32_t except) {
  bool any = false;
  for (std::uint32_t i = run.begin; i < run.end; ++i) {
    const double limit = distance + grid.radius(i);
    any |= (limit >= 0.0) & ((grid.centre(i) - point).squaredNorm() <= limit * limit) & (grid.body(i) != except);
  }
  return any;
}

#ifdef CROWD_AVX512
/// Eight discs at a time, mostly all of a run.
CROWD_AVX512 bool lookWithAvx512(const NeighbourGrid& grid, const Run& one, const Run& other, const Vector2& point,
                                 double distance, std::uint32_t except) {
  constexpr std::uint32_t LANES = 8;
  const __m512d x = _mm512_set1_pd(point.x());
  const __m512d y = _mm512_set1_pd(point.y());
  const __m512d reach = _mm512_set1_pd(distance);
  const __m256i excepted = _mm256_set1_epi32(static_cast<int>(except));
  std::uint32_t any = 0;
  for (const Run& run : {one, other}) {
    std::uint32_t i = run.begin;
    do {
      const auto there = static_cast<__mmask8>(_bzhi_u32(0xffU, std::min(LANES, run.end - i)));
      const __m512d dx = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, grid.xs() + i), x);
      const __m512d dy = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, grid.ys() + i), y);
      const __m512d limit = _mm512_add_pd(reach, _mm512_maskz_loadu_pd(there, grid.radii() + i));
      const __m256i body = _mm256_maskz_loadu_epi32(there, grid.bodies() + i);
      const __m512d square = _mm512_add_pd(_mm512_mul_pd(dx, dx), _mm512_mul_pd(dy, dy));
      const __mmask8 counted = _mm256_mask_cmpneq_epu32_mask(there, body, excepted);
      const __mmask8 reached = _mm512_mask_cmp_pd_mask(counted, limit, _mm512_setzero_pd(), _CMP_GE_OQ);
      any |= _mm512_mask_cmp_pd_mask(reached, square, _mm512_mul_pd(limit, limit), _CMP_LE_OQ);
      i += LANES;
    } while (i < run.end);
  }
  return any != 0;
}
#endif

}  // namespace

bool lookAnywhere(const NeighbourGrid& grid, const Run& one, const Run& other, const Vector2& point, double distance,
                  std::uint32_t except) {
  if (isAnyIn(grid, one, point, distance, except)) return true;
  return other.begin != one.begin && isAnyIn(grid, other, point, distance, except);
}

Look fastestLook() {
#ifdef CROWD_AVX512
  if (hasAvx512()) return lookWithAvx512;
#endif
  return lookAnywhere;
}

}  // namespace crowd
