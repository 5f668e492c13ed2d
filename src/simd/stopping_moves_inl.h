// Included once for each instruction set.
#if defined(CROWD_STOPPING_MOVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_STOPPING_MOVES_INL
#undef CROWD_STOPPING_MOVES_INL
#else
#define CROWD_STOPPING_MOVES_INL
#endif

#include <hwy/highway.h>

#include "simd/stopping_moves.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void cutStops(const StopLimit& limit, const double* xs, const double* ys, std::size_t count, double* fractions) {
  const hn::CappedTag<double, 8> d;
  const auto zero = hn::Zero(d);
  const auto normal_x = hn::Set(d, limit.normal_x);
  const auto normal_y = hn::Set(d, limit.normal_y);
  const auto square = hn::Set(d, limit.square);
  const auto lost = hn::Set(d, limit.lost);
  const auto lost_square = hn::Mul(lost, lost);
  const auto per_speed = hn::Set(d, limit.per_speed);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto closing = hn::Add(hn::Mul(normal_x, hn::LoadU(d, xs + i)), hn::Mul(normal_y, hn::LoadU(d, ys + i)));
    const auto root = hn::Sqrt(hn::Max(zero, hn::Add(lost_square, hn::Div(square, closing))));
    const auto left = hn::Max(zero, hn::Mul(hn::Sub(root, lost), per_speed));
    const auto fraction = hn::LoadU(d, fractions + i);
    const auto too_far = hn::And(hn::Gt(closing, zero), hn::Gt(fraction, left));
    hn::StoreU(hn::IfThenElse(too_far, left, fraction), d, fractions + i);
  }
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
