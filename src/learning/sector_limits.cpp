#include "social_crowd/learning/sector_limits.h"

#include <cmath>

#include "social_crowd/common/avx512.h"

namespace crowd {
namespace {

/// Limits are looked at so many at a time.
constexpr std::size_t BLOCK = 8;
using Block = std::array<std::uint64_t, BLOCK>;

/// Share of the distance by which a rim must miss a limit. The arc sine that an angle would be worked out with is off
/// by 1.5e-8 [rad] at most, where the rim is next to the origin.
constexpr double CLEAR = 1e-7;

// What is found out about limit i: bit i, and bits so much higher.
constexpr unsigned LEFT = 16;     // the centre is on its left
constexpr unsigned UNCLEAR = 32;  // the rim ends next to it, or next to what it is on the other side of the origin
static_assert(SectorLimits::MOST <= LEFT && SectorLimits::MOST == 2 * BLOCK, "bits do not overlap");

constexpr Block bitsFrom(unsigned first) {
  Block bits{};
  for (std::size_t i = 0; i < BLOCK; ++i) bits[i] = std::uint64_t{1} << (first + i);
  return bits;
}
constexpr Block TOUCHED_BITS = bitsFrom(0);
constexpr Block LEFT_BITS = bitsFrom(LEFT);
constexpr Block UNCLEAR_BITS = bitsFrom(UNCLEAR);

#ifdef CROWD_AVX512
CROWD_AVX512 std::uint64_t compareWithAvx512(const double* x, const double* y, const Vector2& centre, double radius,
                                             double clear) {
  const __m512d limit_x = _mm512_loadu_pd(x);
  const __m512d limit_y = _mm512_loadu_pd(y);
  const __m512d px = _mm512_set1_pd(centre.x());
  const __m512d py = _mm512_set1_pd(centre.y());
  const __m512d zero = _mm512_setzero_pd();
  const __m512d across = _mm512_sub_pd(_mm512_mul_pd(limit_x, py), _mm512_mul_pd(limit_y, px));
  const __m512d along = _mm512_add_pd(_mm512_mul_pd(limit_x, px), _mm512_mul_pd(limit_y, py));
  const __m512d beyond = _mm512_sub_pd(_mm512_set1_pd(radius), _mm512_abs_pd(across));
  const __mmask8 is_ahead = _mm512_cmp_pd_mask(along, zero, _CMP_GT_OQ);
  const std::uint64_t touched = _mm512_mask_cmp_pd_mask(is_ahead, beyond, zero, _CMP_GE_OQ);
  const std::uint64_t left = _mm512_cmp_pd_mask(across, zero, _CMP_GE_OQ);
  const std::uint64_t unclear = _mm512_cmp_pd_mask(_mm512_abs_pd(beyond), _mm512_set1_pd(clear), _CMP_NGT_UQ);
  return touched | left << LEFT | unclear << UNCLEAR;
}
#endif

}  // namespace

CROWD_VECTORISED std::uint64_t compareLimitsAnywhere(const double* x, const double* y, const Vector2& centre,
                                                     double radius, double clear) {
  const double px = centre.x();
  const double py = centre.y();
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < BLOCK; ++i) {
    const double across = x[i] * py - y[i] * px;
    const double along = x[i] * px + y[i] * py;
    const double beyond = radius - std::abs(across);
    const bool touched = (beyond >= 0.0) & (along > 0.0);
    const bool is_clear = std::abs(beyond) > clear;
    found |= (touched ? TOUCHED_BITS[i] : 0) | (across >= 0.0 ? LEFT_BITS[i] : 0) | (is_clear ? 0 : UNCLEAR_BITS[i]);
  }
  return found;
}

CompareLimits fastestCompareLimits() { return CROWD_FASTEST(compareWithAvx512, compareLimitsAnywhere); }

SectorLimits::SectorLimits(const EvenSectors& sectors, CompareLimits compare)
    : compare_(compare),
      all_((1U << static_cast<unsigned>(sectors.count())) - 1U),
      count_(static_cast<unsigned>(sectors.count())) {
  for (int sector = 0; sector < sectors.count(); ++sector) {
    const Vector2 limit = unitVector(sectors.rightLimit(sector));
    x_[static_cast<std::size_t>(sector)] = limit.x();
    y_[static_cast<std::size_t>(sector)] = limit.y();
  }
}

SectorSet SectorLimits::reachedBy(const Vector2& centre, double radius) const {
  // The sum of both coordinates is not less than the distance, and sooner at hand than a root.
  const double clear = CLEAR * centre.lpNorm<1>();
  std::uint64_t found = compare_(x_.data(), y_.data(), centre, radius, clear);
  if (count_ > BLOCK) found |= compare_(&x_[BLOCK], &y_[BLOCK], centre, radius, clear) << BLOCK;
  if ((found >> UNCLEAR & all_) != 0) return 0;
  const auto touched = static_cast<SectorSet>(found & all_);
  const auto left = static_cast<SectorSet>(found >> LEFT & all_);
  // Sector i lies between limit i and the next one: a touched limit is that of two sectors, and the centre is to the
  // left of the one and not of the other.
  const auto next = [this](SectorSet set) { return set >> 1U | (set & 1U) << (count_ - 1U); };
  return touched | next(touched) | (left & ~next(left));
}

}  // namespace crowd
