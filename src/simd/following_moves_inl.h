// Included once for each instruction set.
#if defined(CROWD_FOLLOWING_MOVES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_FOLLOWING_MOVES_INL
#undef CROWD_FOLLOWING_MOVES_INL
#else
#define CROWD_FOLLOWING_MOVES_INL
#endif

#include <hwy/highway.h>

#include "simd/following_moves.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void cutFollowing(const Leader& leader, const double* xs, const double* ys, std::size_t count,
                         double* fractions) {
  const hn::CappedTag<double, 8> d;
  const auto zero = hn::Zero(d);
  const auto leader_x = hn::Set(d, leader.x);
  const auto leader_y = hn::Set(d, leader.y);
  const auto distance = hn::Set(d, leader.distance);
  const auto half_width = hn::Set(d, leader.half_width);
  const auto now = hn::Set(d, leader.now);
  const auto later_gap = hn::Set(d, leader.later_gap);
  const auto walked = hn::Set(d, leader.walked);
  const auto own_way = hn::Set(d, leader.own_way);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, xs + i);
    const auto y = hn::LoadU(d, ys + i);
    const auto fraction = hn::LoadU(d, fractions + i);
    const auto ahead = hn::Add(hn::Mul(x, leader_x), hn::Mul(y, leader_y));
    const auto aside = hn::Sub(hn::Mul(x, leader_y), hn::Mul(y, leader_x));
    const auto cosine = hn::Div(hn::Max(zero, ahead), distance);
    const auto most = hn::Max(now, hn::Div(later_gap, hn::Add(walked, hn::Mul(own_way, cosine))));
    const auto is_behind = hn::And(hn::Gt(ahead, zero), hn::Lt(hn::Abs(aside), half_width));
    hn::StoreU(hn::IfThenElse(hn::And(is_behind, hn::Gt(fraction, most)), most, fraction), d, fractions + i);
  }
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
