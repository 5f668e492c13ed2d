#include "social_crowd/world/neighbour_candidates.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/common/vectorised.h"

#ifdef CROWD_AVX512
#include <immintrin.h>
#endif

namespace crowd {
namespace {

/// By whole blocks, as a loop over the rest would cost more than what stands behind the last one.
CROWD_VECTORISED void subtractRadii(const double* __restrict squares, const double* __restrict radii, std::size_t count,
                                    double* __restrict rims) {
  constexpr std::size_t BLOCK = NeighbourCandidates::BLOCK;
  for (std::size_t block = 0; block < count; block += BLOCK) {
    for (std::size_t i = block; i < block + BLOCK; ++i) rims[i] = std::sqrt(squares[i]) - radii[i];
  }
}

#ifdef CROWD_AVX512

/// Eight discs at a time: those that are near move together in a register, which is stored whole; what comes next is
/// written over those that are not.
CROWD_AVX512 void gatherWithAvx512(const NeighbourGrid& grid, const View<NeighbourGrid::Run>& runs,
                                   const Vector2& point, double distance, std::uint32_t except,
                                   NeighbourCandidates& candidates) {
  constexpr std::uint32_t LANES = 8;
  const __m512d x = _mm512_set1_pd(point.x());
  const __m512d y = _mm512_set1_pd(point.y());
  const __m512d reach = _mm512_set1_pd(distance);
  const __m256i excepted = _mm256_set1_epi32(static_cast<int>(except));
  const __m256i steps = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const double* xs = grid.xs();
  const double* ys = grid.ys();
  const double* radii = grid.radii();
  const std::uint32_t* bodies = grid.bodies();
  std::uint32_t* near_discs = candidates.discs.data();
  double* near_radii = candidates.radii.data();
  double* near_squares = candidates.squares.data();
  std::size_t count = 0;
  for (const NeighbourGrid::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; i += LANES) {
      const auto there = static_cast<__mmask8>(_bzhi_u32(0xffU, std::min(LANES, run.end - i)));
      const __m512d dx = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, xs + i), x);
      const __m512d dy = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, ys + i), y);
      const __m512d radius = _mm512_maskz_loadu_pd(there, radii + i);
      const __m256i body = _mm256_maskz_loadu_epi32(there, bodies + i);
      const __m512d square = _mm512_add_pd(_mm512_mul_pd(dx, dx), _mm512_mul_pd(dy, dy));
      const __m512d limit = _mm512_add_pd(reach, radius);
      const __mmask8 other = _mm256_mask_cmpneq_epu32_mask(there, body, excepted);
      const __mmask8 near = _mm512_mask_cmp_pd_mask(other, square, _mm512_mul_pd(limit, limit), _CMP_LE_OQ);
      const __m256i disc = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(i)), steps);
      _mm512_storeu_pd(near_squares + count, _mm512_maskz_compress_pd(near, square));
      _mm512_storeu_pd(near_radii + count, _mm512_maskz_compress_pd(near, radius));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(near_discs + count), _mm256_maskz_compress_epi32(near, disc));
      count += static_cast<std::size_t>(__builtin_popcount(near));
    }
  }
  candidates.count = count;
}

#endif

}  // namespace

void NeighbourCandidates::makeRoom(std::size_t most) {
  if (discs.size() >= most + BLOCK) return;
  for (auto* list : {&radii, &squares, &rims}) list->resize(2 * most + BLOCK);
  discs.resize(2 * most + BLOCK);
}

void NeighbourCandidates::findRims() { subtractRadii(squares.data(), radii.data(), count, rims.data()); }

void gatherAnywhere(const NeighbourGrid& grid, const View<NeighbourGrid::Run>& runs, const Vector2& point,
                    double distance, std::uint32_t except, NeighbourCandidates& candidates) {
  std::uint32_t* discs = candidates.discs.data();
  double* radii = candidates.radii.data();
  double* squares = candidates.squares.data();
  std::size_t count = 0;
  for (const NeighbourGrid::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const double square = (grid.centre(i) - point).squaredNorm();
      const double limit = distance + grid.radius(i);
      // Written in any case and kept by counting on: a branch would be guessed wrong half of the time.
      discs[count] = i;
      radii[count] = grid.radius(i);
      squares[count] = square;
      count += static_cast<std::size_t>(square <= limit * limit) & static_cast<std::size_t>(grid.body(i) != except);
    }
  }
  candidates.count = count;
}

Gather fastestGather() {
#ifdef CROWD_AVX512
  if (hasAvx512()) return gatherWithAvx512;
#endif
  return gatherAnywhere;
}

}  // namespace crowd
