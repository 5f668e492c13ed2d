// Included once for each instruction set.
#if defined(CROWD_FRAMES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_FRAMES_INL
#undef CROWD_FRAMES_INL
#else
#define CROWD_FRAMES_INL
#endif

#include <hwy/highway.h>

#include <cstring>

#include "simd/frames.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void turnIntoFrame(const WantedMotions& motions, const Frame& frame, const MotionArrays& turned) {
  constexpr std::size_t ROW = 4;
  const hn::CappedTag<double, WantedMotions::PADDING> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto px = hn::Set(d, frame.x);
  const auto py = hn::Set(d, frame.y);
  const auto ax = hn::Set(d, frame.ahead_x);
  const auto ay = hn::Set(d, frame.ahead_y);
  alignas(64) double rows[ROW * WantedMotions::PADDING];  // NOLINT(cppcoreguidelines-avoid-c-arrays)
  for (std::size_t i = 0; i < motions.count; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      std::memcpy(rows + ROW * k, motions.rows + ROW * motions.wanted[i + k], ROW * sizeof(double));
    }
    auto x = px;
    auto y = px;
    auto vx = px;
    auto vy = px;
    hn::LoadInterleaved4(d, rows, x, y, vx, vy);
    const auto dx = hn::Sub(x, px);
    const auto dy = hn::Sub(y, py);
    hn::StoreU(hn::Add(hn::Mul(dx, ax), hn::Mul(dy, ay)), d, turned.xs + i);
    hn::StoreU(hn::Sub(hn::Mul(dy, ax), hn::Mul(dx, ay)), d, turned.ys + i);
    hn::StoreU(hn::Add(hn::Mul(vx, ax), hn::Mul(vy, ay)), d, turned.vxs + i);
    hn::StoreU(hn::Sub(hn::Mul(vy, ax), hn::Mul(vx, ay)), d, turned.vys + i);
  }
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
