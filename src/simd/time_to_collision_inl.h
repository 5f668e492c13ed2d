// Included once for each instruction set.
#if defined(CROWD_TIME_TO_COLLISION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_TIME_TO_COLLISION_INL
#undef CROWD_TIME_TO_COLLISION_INL
#else
#define CROWD_TIME_TO_COLLISION_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "simd/time_to_collision.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Singles = hn::CappedTag<float, 16>;
using HalfSingles = hn::Half<Singles>;
using Doubles = hn::Rebind<double, HalfSingles>;

/// A block of neighbours in single precision.
struct NeighbourBlock {
  static constexpr std::size_t SIZE = 16;
  static_assert(SIZE <= NeighbourArrays::PADDING, "reads beyond the last neighbour");

  alignas(64) float x[SIZE];  // NOLINT(cppcoreguidelines-avoid-c-arrays): of any alignment
  alignas(64) float y[SIZE];
  alignas(64) float vx[SIZE];
  alignas(64) float vy[SIZE];
  alignas(64) float mean_vx[SIZE];  // of its velocity and the agent's
  alignas(64) float mean_vy[SIZE];
  alignas(64) float gap[SIZE];       // square of the distance less that of the sum of both radii, 0 if they overlap
  alignas(64) float per_root[SIZE];  // 1 / gap, or AT_ONCE
};

/// The greater value; `other` if `value` is NaN.
template <typename D>
HWY_INLINE hn::Vec<D> greater(D /*tag*/, hn::Vec<D> value, hn::Vec<D> other) {
  return hn::IfThenElse(hn::Gt(value, other), value, other);
}

/// Writes `count` neighbours from number `first` on to the block.
/// @return squares of the highest approach speeds, see AccumulateTimeToCollision
HWY_INLINE hn::Vec<HalfSingles> writeBlock(const NeighbourArrays& from, std::size_t first, std::size_t count,
                                           const Observer& self, NeighbourBlock& block) {
  const Doubles dd;
  const HalfSingles d;
  auto fastest = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto far_x = hn::LoadU(dd, from.xs + first + i);
    const auto far_y = hn::LoadU(dd, from.ys + first + i);
    const auto reach = hn::Add(hn::Set(dd, self.radius), hn::LoadU(dd, from.radii + first + i));
    const auto distance = hn::Add(hn::Mul(far_x, far_x), hn::Mul(far_y, far_y));
    const auto gap = hn::DemoteTo(d, greater(dd, hn::Sub(distance, hn::Mul(reach, reach)), hn::Zero(dd)));
    const auto per_gap = hn::Div(hn::Set(d, 1.0F), gap);
    const auto x = hn::DemoteTo(d, far_x);
    const auto y = hn::DemoteTo(d, far_y);
    const auto vx = hn::DemoteTo(d, hn::LoadU(dd, from.vxs + first + i));
    const auto vy = hn::DemoteTo(d, hn::LoadU(dd, from.vys + first + i));
    const auto approach = hn::Add(hn::Mul(x, hn::Sub(hn::Set(d, self.preferred_x), vx)),
                                  hn::Mul(y, hn::Sub(hn::Set(d, self.preferred_y), vy)));
    const auto square = hn::Div(hn::Mul(approach, approach), hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
    const auto counts = hn::And(hn::Gt(approach, hn::Zero(d)), hn::FirstN(d, count - i));
    fastest = greater(d, hn::IfThenElseZero(counts, square), fastest);
    hn::Store(x, d, block.x + i);
    hn::Store(y, d, block.y + i);
    hn::Store(vx, d, block.vx + i);
    hn::Store(vy, d, block.vy + i);
    hn::Store(hn::Mul(hn::Set(d, 0.5F), hn::Add(hn::Set(d, self.velocity_x), vx)), d, block.mean_vx + i);
    hn::Store(hn::Mul(hn::Set(d, 0.5F), hn::Add(hn::Set(d, self.velocity_y), vy)), d, block.mean_vy + i);
    hn::Store(gap, d, block.gap + i);
    hn::Store(hn::IfThenElse(hn::Gt(gap, hn::Zero(d)), per_gap, hn::Set(d, AT_ONCE)), d, block.per_root + i);
  }
  return fastest;
}

/// See inverseTime() in the reference.
template <typename V>
HWY_INLINE V inverseTimes(V x, V y, V vx, V vy, V gap, V per_root) {
  const auto closing = hn::Add(hn::Mul(x, vx), hn::Mul(y, vy));
  const auto square = hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy));
  const auto root = hn::Sqrt(hn::Sub(hn::Mul(closing, closing), hn::Mul(square, gap)));
  return hn::Mul(hn::Add(closing, root), per_root);
}

/// Vectorized over candidates: iterates over the neighbours for a register of candidates.
template <bool RECIPROCAL, typename D>
HWY_INLINE void accumulateOverNeighbours(D d, const NeighbourBlock& block, std::size_t count, std::size_t candidate,
                                         const CandidateArrays& candidates) {
  const auto ux = hn::LoadU(d, candidates.xs + candidate);
  const auto uy = hn::LoadU(d, candidates.ys + candidate);
  auto constant = hn::LoadU(d, candidates.constant_velocity + candidate);
  auto reciprocal = RECIPROCAL ? hn::LoadU(d, candidates.reciprocal + candidate) : constant;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = hn::Set(d, block.x[i]);
    const auto y = hn::Set(d, block.y[i]);
    const auto gap = hn::Set(d, block.gap[i]);
    const auto per_root = hn::Set(d, block.per_root[i]);
    const auto relative_x = hn::Sub(ux, hn::Set(d, block.vx[i]));
    const auto relative_y = hn::Sub(uy, hn::Set(d, block.vy[i]));
    constant = greater(d, inverseTimes(x, y, relative_x, relative_y, gap, per_root), constant);
    if (!RECIPROCAL) continue;
    const auto shared_x = hn::Sub(ux, hn::Set(d, block.mean_vx[i]));
    const auto shared_y = hn::Sub(uy, hn::Set(d, block.mean_vy[i]));
    reciprocal = greater(d, inverseTimes(x, y, shared_x, shared_y, gap, per_root), reciprocal);
  }
  hn::StoreU(constant, d, candidates.constant_velocity + candidate);
  if (RECIPROCAL) hn::StoreU(reciprocal, d, candidates.reciprocal + candidate);
}

/// Vectorized over neighbours: for one candidate.
HWY_INLINE void accumulateForCandidate(const NeighbourBlock& block, std::size_t count, const float* vxs,
                                       const float* vys, float ux, float uy, float& soonest) {
  const Singles d;
  auto highest = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto vx = hn::Sub(hn::Set(d, ux), hn::Load(d, vxs + i));
    const auto vy = hn::Sub(hn::Set(d, uy), hn::Load(d, vys + i));
    const auto times = inverseTimes(hn::Load(d, block.x + i), hn::Load(d, block.y + i), vx, vy,
                                    hn::Load(d, block.gap + i), hn::Load(d, block.per_root + i));
    highest = greater(d, hn::IfThenElseZero(hn::FirstN(d, count - i), times), highest);
  }
  soonest = std::max(soonest, hn::GetLane(hn::MaxOfLanes(d, highest)));
}

/// Processes registers of candidates from number `k` on, as long as the remaining candidates fill enough of a register
/// that fits into the arrays. @return number of the first candidate that is left
template <bool RECIPROCAL, typename D>
HWY_INLINE std::size_t accumulateRegisters(D d, const NeighbourBlock& block, std::size_t count, std::size_t k,
                                           const CandidateArrays& candidates) {
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t one_by_one = (count + hn::Lanes(Singles()) - 1) / hn::Lanes(Singles());  // registers per candidate
  const auto is_filled = [&](std::size_t left) { return left >= lanes || left * one_by_one >= count; };
  while (k < candidates.count && k + lanes <= CandidateArrays::MAX && is_filled(candidates.count - k)) {
    accumulateOverNeighbours<RECIPROCAL>(d, block, count, k, candidates);
    k += lanes;
  }
  return k;
}

template <bool RECIPROCAL>
HWY_INLINE float accumulate(const NeighbourArrays& neighbours, const Observer& self,
                            const CandidateArrays& candidates) {
  NeighbourBlock block;  // NOLINT(cppcoreguidelines-pro-type-member-init): writeBlock() writes what is read
  auto fastest = hn::Zero(HalfSingles());
  for (std::size_t first = 0; first < neighbours.count; first += NeighbourBlock::SIZE) {
    const std::size_t count = std::min(NeighbourBlock::SIZE, neighbours.count - first);
    fastest = greater(HalfSingles(), writeBlock(neighbours, first, count, self, block), fastest);
    std::size_t k = accumulateRegisters<RECIPROCAL>(Singles(), block, count, 0, candidates);
    k = accumulateRegisters<RECIPROCAL>(HalfSingles(), block, count, k, candidates);
    for (; k < candidates.count; ++k) {
      accumulateForCandidate(block, count, block.vx, block.vy, candidates.xs[k], candidates.ys[k],
                             candidates.constant_velocity[k]);
      if (!RECIPROCAL) continue;
      accumulateForCandidate(block, count, block.mean_vx, block.mean_vy, candidates.xs[k], candidates.ys[k],
                             candidates.reciprocal[k]);
    }
  }
  return hn::GetLane(hn::MaxOfLanes(HalfSingles(), fastest));
}

inline float accumulateTimeToCollision(const NeighbourArrays& neighbours, const Observer& self,
                                       const CandidateArrays& candidates) {
  return candidates.reciprocal == nullptr ? accumulate<false>(neighbours, self, candidates)
                                          : accumulate<true>(neighbours, self, candidates);
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
