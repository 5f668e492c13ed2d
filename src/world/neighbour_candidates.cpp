#include "social_crowd/world/neighbour_candidates.h"

#include <algorithm>
#include <cmath>

#include "eight_discs.h"
#include "social_crowd/common/vectorised.h"

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
  const EightDiscsReader reader(grid, point, distance, except);
  const __m256i steps = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  std::uint32_t* near_discs = candidates.discs.data();
  double* near_radii = candidates.radii.data();
  double* near_squares = candidates.squares.data();
  std::size_t count = 0;
  for (const NeighbourGrid::Run& run : runs) {
    for (std::uint32_t i = run.begin; i < run.end; i += EightDiscs::SIZE) {
      const EightDiscs eight = reader.read(i, run.end);
      const __m256i discs = _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(i)), steps);
      _mm512_storeu_pd(near_squares + count, _mm512_maskz_compress_pd(eight.near, eight.squares));
      _mm512_storeu_pd(near_radii + count, _mm512_maskz_compress_pd(eight.near, eight.radii));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(near_discs + count),
                          _mm256_maskz_compress_epi32(eight.near, discs));
      count += static_cast<std::size_t>(__builtin_popcount(eight.near));
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

Gather fastestGather() { return CROWD_FASTEST(gatherWithAvx512, gatherAnywhere); }

}  // namespace crowd
