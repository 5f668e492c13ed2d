// Included once for each instruction set.
#if defined(CROWD_RANKS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_RANKS_INL
#undef CROWD_RANKS_INL
#else
#define CROWD_RANKS_INL
#endif

#include <hwy/highway.h>

#include "simd/ranks.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RankKeys = hn::CappedTag<float, 16>;
using RankCounts = hn::RebindToUnsigned<RankKeys>;

/// Increments the counts of the lanes in which `key` is smaller than `own`.
HWY_INLINE hn::Vec<RankCounts> countSmaller(hn::Vec<RankCounts> counts, hn::Vec<RankKeys> key, hn::Vec<RankKeys> own) {
  const auto is_smaller = hn::BitCast(RankCounts(), hn::VecFromMask(RankKeys(), hn::Lt(key, own)));
  return hn::Sub(counts, is_smaller);  // true is -1
}

/// Writes a register of ranks to to[first...], and adds those with an index below `count` to `sum`.
HWY_INLINE hn::Vec<RankCounts> writeRanks(hn::Vec<RankCounts> ranks, std::size_t first, std::size_t count,
                                          std::uint32_t* to, hn::Vec<RankCounts> sum) {
  const RankCounts d;
  hn::StoreU(ranks, d, to + first);
  const auto counted = hn::FirstN(d, count > first ? count - first : 0);
  return hn::Add(sum, hn::IfThenElseZero(counted, ranks));
}

/// Loads a register of numbers in single precision.
/// @details The halves are combined in a register: storing them separately would prevent store-to-load forwarding.
HWY_INLINE hn::Vec<RankKeys> loadKeys(const double* numbers) {
  const RankKeys d;
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(d, static_cast<float>(*numbers));
#else
  const hn::Half<RankKeys> half;
  const hn::Rebind<double, hn::Half<RankKeys>> doubles;
  const auto low = hn::DemoteTo(half, hn::LoadU(doubles, numbers));
  return hn::Combine(d, hn::DemoteTo(half, hn::LoadU(doubles, numbers + hn::Lanes(doubles))), low);
#endif
}

inline std::uint32_t rankAscending(const double* numbers, std::size_t count, std::uint32_t* ranks) {
  const RankKeys d;
  const RankCounts du;
  const std::size_t lanes = hn::Lanes(d);
  alignas(64) float keys[MAX_RANKED];  // NOLINT(cppcoreguidelines-avoid-c-arrays): of any alignment
  for (std::size_t i = 0; i < count; i += lanes) hn::Store(loadKeys(numbers + i), d, keys + i);
  auto sum = hn::Zero(du);
  std::size_t i = 0;
  // Four registers at a time, so that each key is read only once for them.
  for (; i + 2 * lanes < count && i + 4 * lanes <= MAX_RANKED; i += 4 * lanes) {
    const auto a = hn::LoadU(d, keys + i);
    const auto b = hn::LoadU(d, keys + i + lanes);
    const auto c = hn::LoadU(d, keys + i + 2 * lanes);
    const auto e = hn::LoadU(d, keys + i + 3 * lanes);
    auto ranks_a = hn::Zero(du);
    auto ranks_b = ranks_a;
    auto ranks_c = ranks_a;
    auto ranks_e = ranks_a;
    for (std::size_t j = 0; j < count; ++j) {
      const auto key = hn::Set(d, keys[j]);
      ranks_a = countSmaller(ranks_a, key, a);
      ranks_b = countSmaller(ranks_b, key, b);
      ranks_c = countSmaller(ranks_c, key, c);
      ranks_e = countSmaller(ranks_e, key, e);
    }
    sum = writeRanks(ranks_a, i, count, ranks, sum);
    sum = writeRanks(ranks_b, i + lanes, count, ranks, sum);
    sum = writeRanks(ranks_c, i + 2 * lanes, count, ranks, sum);
    sum = writeRanks(ranks_e, i + 3 * lanes, count, ranks, sum);
  }
  for (; i < count; i += lanes) {
    const auto own = hn::LoadU(d, keys + i);
    auto smaller = hn::Zero(du);
    for (std::size_t j = 0; j < count; ++j) smaller = countSmaller(smaller, hn::Set(d, keys[j]), own);
    sum = writeRanks(smaller, i, count, ranks, sum);
  }
  return hn::GetLane(hn::SumOfLanes(du, sum));
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
