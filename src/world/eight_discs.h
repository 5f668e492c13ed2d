#pragma once

#include "social_crowd/common/avx512.h"

#ifdef CROWD_AVX512
#include <algorithm>
#include <cstdint>

#include "social_crowd/world/neighbour_grid.h"

namespace crowd {

/// @brief Up to eight discs of a grid in registers, and which of them are near a point.
struct EightDiscs {
  static constexpr std::uint32_t SIZE = 8;

  __m512d squares;  ///< squared distances of their centres from the point [m2]
  __m512d radii;    ///< [m]
  __m512d limits;   ///< sums of the distance and their radii [m]
  __mmask8 near;    ///< those within the size of their limit (it may be negative), and not of the body that is left out
};

/// @brief Looks at discs of a grid by eights.
class EightDiscsReader {
 public:
  /// @brief As of NeighbourGrid::isAnyNear().
  CROWD_AVX512 EightDiscsReader(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except)
      : xs_(grid.xs()),
        ys_(grid.ys()),
        radii_(grid.radii()),
        bodies_(grid.bodies()),
        x_(_mm512_set1_pd(point.x())),
        y_(_mm512_set1_pd(point.y())),
        distance_(_mm512_set1_pd(distance)),
        except_(_mm256_set1_epi32(static_cast<int>(except))) {}

  /// @brief The discs from a number on, as far as they come before `end`.
  CROWD_AVX512 EightDiscs read(std::uint32_t begin, std::uint32_t end) const {
    const auto there = static_cast<__mmask8>(_bzhi_u32(0xffU, std::min(EightDiscs::SIZE, end - begin)));
    const __m512d dx = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, xs_ + begin), x_);
    const __m512d dy = _mm512_sub_pd(_mm512_maskz_loadu_pd(there, ys_ + begin), y_);
    const __m512d radii = _mm512_maskz_loadu_pd(there, radii_ + begin);
    const __m256i bodies = _mm256_maskz_loadu_epi32(there, bodies_ + begin);
    const __m512d squares = _mm512_add_pd(_mm512_mul_pd(dx, dx), _mm512_mul_pd(dy, dy));
    const __m512d limits = _mm512_add_pd(distance_, radii);
    const __mmask8 others = _mm256_mask_cmpneq_epu32_mask(there, bodies, except_);
    const __mmask8 near = _mm512_mask_cmp_pd_mask(others, squares, _mm512_mul_pd(limits, limits), _CMP_LE_OQ);
    return {squares, radii, limits, near};
  }

 private:
  const double* xs_;
  const double* ys_;
  const double* radii_;
  const std::uint32_t* bodies_;
  __m512d x_;
  __m512d y_;
  __m512d distance_;
  __m256i except_;
};

}  // namespace crowd
#endif
