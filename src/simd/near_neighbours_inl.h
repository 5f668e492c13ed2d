// Included once for each instruction set.
#if defined(CROWD_NEAR_NEIGHBOURS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_NEAR_NEIGHBOURS_INL
#undef CROWD_NEAR_NEIGHBOURS_INL
#else
#define CROWD_NEAR_NEIGHBOURS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "simd/near_neighbours.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The lanes of a mask of up to 8 lanes as bits.
template <typename D>
HWY_INLINE std::uint32_t bitsOf(D d, hn::Mask<D> mask) {
  std::uint8_t bits[8] = {};  // NOLINT(cppcoreguidelines-avoid-c-arrays): maximum that is written
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}

inline std::uint32_t findNear(const NeighbourArrays& neighbours, const Nearness& nearness) {
  const hn::CappedTag<double, 8> d;  // so that the mask of a register fits a byte
  const auto zero = hn::Zero(d);
  const auto own_x = hn::Set(d, nearness.velocity_x);
  const auto own_y = hn::Set(d, nearness.velocity_y);
  const auto duration = hn::Set(d, nearness.tick_duration);
  const auto room = hn::Set(d, nearness.room);
  const std::size_t count = std::min(neighbours.count, MAX_LOOKED_AT);
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, neighbours.xs + i);
    const auto y = hn::LoadU(d, neighbours.ys + i);
    const auto vx = hn::Add(own_x, hn::LoadU(d, neighbours.vxs + i));
    const auto vy = hn::Add(own_y, hn::LoadU(d, neighbours.vys + i));
    const auto receding = hn::Add(hn::Mul(x, vx), hn::Mul(y, vy));
    const auto square = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
    const auto coming = hn::IfThenElseZero(hn::Lt(receding, zero), receding);
    const auto rest = hn::Add(square, hn::Mul(duration, coming));
    const auto apart = hn::Add(room, hn::LoadU(d, neighbours.radii + i));
    const auto far = hn::And(hn::Gt(rest, zero), hn::Gt(hn::Mul(rest, rest), hn::Mul(hn::Mul(apart, apart), square)));
    near |= bitsOf(d, hn::AndNot(far, hn::FirstN(d, count - i))) << i;
  }
  return near;
}

inline std::uint32_t findNearStop(const NeighbourArrays& neighbours, const StoppingNearness& nearness) {
  const hn::CappedTag<double, 8> d;
  const auto zero = hn::Zero(d);
  const auto stop_x = hn::Set(d, nearness.stop_x);
  const auto stop_y = hn::Set(d, nearness.stop_y);
  const auto duration = hn::Set(d, nearness.tick_duration);
  const auto per_braking = hn::Set(d, nearness.per_braking);
  const auto room = hn::Set(d, nearness.room);
  const std::size_t count = std::min(neighbours.count, MAX_LOOKED_AT);
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, neighbours.xs + i);
    const auto y = hn::LoadU(d, neighbours.ys + i);
    const auto vx = hn::LoadU(d, neighbours.vxs + i);
    const auto vy = hn::LoadU(d, neighbours.vys + i);
    const auto distance = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
    const auto speed = hn::Sqrt(hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy)));
    const auto own = hn::Max(zero, hn::Add(hn::Mul(x, stop_x), hn::Mul(y, stop_y)));
    const auto coming = hn::Neg(hn::Add(hn::Mul(x, vx), hn::Mul(y, vy)));
    const auto its = hn::Max(zero, hn::Mul(hn::Mul(coming, speed), per_braking));
    const auto apart =
        hn::Sub(hn::Sub(hn::Sub(distance, room), hn::Mul(duration, speed)), hn::LoadU(d, neighbours.radii + i));
    const auto beyond = hn::Sub(hn::Sub(hn::Mul(distance, apart), own), its);
    near |= bitsOf(d, hn::And(hn::Le(beyond, zero), hn::FirstN(d, count - i))) << i;
  }
  return near;
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
