// Included once for each instruction set.
#if defined(CROWD_NEARBY_DISCS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_NEARBY_DISCS_INL
#undef CROWD_NEARBY_DISCS_INL
#else
#define CROWD_NEARBY_DISCS_INL
#endif

#include <hwy/highway.h>

#include "simd/nearby_discs.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t MAX_DISC_LANES = 4;  // no more than PADDING; the table below doubles with each lane

/// For each mask of lanes, the indices of the two words of each marked lane, in order; the rest is unspecified.
struct CompressTable {
  static constexpr std::size_t WORDS = 2 * MAX_DISC_LANES;
  std::uint32_t words[1U << MAX_DISC_LANES][WORDS] = {};  // NOLINT(cppcoreguidelines-avoid-c-arrays)

  constexpr CompressTable() {
    for (std::size_t marks = 0; marks < sizeof(words) / sizeof(words[0]); ++marks) {
      std::size_t to = 0;
      for (std::uint32_t lane = 0; lane < MAX_DISC_LANES; ++lane) {
        if ((marks >> lane & 1U) == 0) continue;
        words[marks][to++] = 2 * lane;
        words[marks][to++] = 2 * lane + 1;
      }
    }
  }
};
constexpr CompressTable COMPRESS_TABLE;

/// Stores all lanes, the marked ones first.
/// @details With GCC 12, Highway's Compress() is slow for AVX2 and AVX-512, because it copies its table at each call.
template <typename D>
HWY_INLINE void storeCompressed(D d, hn::Vec<D> lanes, std::uint8_t marks, hn::TFromD<D>* to) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    hn::StoreU(lanes, d, to);
  } else {
    const hn::Repartition<std::uint32_t, D> words;
    const auto order = hn::SetTableIndices(words, COMPRESS_TABLE.words[marks]);
    hn::StoreU(hn::BitCast(d, hn::TableLookupLanes(hn::BitCast(words, lanes), order)), d, to);
  }
}

/// Compares one register of discs with a circle.
template <std::size_t MAX_LANES>
class NearbyDiscs {
 public:
  using Tag = hn::CappedTag<double, MAX_LANES>;
  using Numbers = hn::Vec<Tag>;
  using Mask = hn::Mask<Tag>;

  HWY_INLINE NearbyDiscs(const DiscArrays& arrays, DiscRange range, const Circle& circle)
      : arrays_(arrays), end_(range.end), except_(circle.except), x_(circle.x), y_(circle.y), radius_(circle.radius) {}

  /// Compares the discs from number `i` on. @return mask of those within the circle
  HWY_INLINE Mask compare(std::size_t i, Numbers& squares, Numbers& radii, Numbers& limits) const {
    const Tag d;
    const hn::RebindToUnsigned<Tag> du;
    const auto dx = hn::Sub(hn::LoadU(d, arrays_.xs + i), hn::Set(d, x_));
    const auto dy = hn::Sub(hn::LoadU(d, arrays_.ys + i), hn::Set(d, y_));
    squares = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    radii = hn::LoadU(d, arrays_.radii + i);
    limits = hn::Add(hn::Set(d, radius_), radii);
    const auto neighbours = hn::PromoteTo(du, hn::LoadU(hn::Rebind<std::uint32_t, Tag>(), arrays_.neighbours + i));
    const auto others = hn::RebindMask(d, hn::Ne(neighbours, hn::Set(du, except_)));
    const auto near = hn::And(hn::Le(squares, hn::Mul(limits, limits)), hn::FirstN(d, end_ - i));
    return hn::And(near, others);
  }

 private:
  const DiscArrays& arrays_;
  std::size_t end_;
  std::uint32_t except_;
  double x_;
  double y_;
  double radius_;
};

/// Discs within the circle are moved to the front of the register, which is stored as a whole; the next store
/// overwrites the others.
inline std::size_t collectNearby(const DiscArrays& arrays, DiscRange range, const Circle& circle, std::size_t count,
                                 const CollectedDiscs& collected) {
  using Discs = NearbyDiscs<MAX_DISC_LANES>;
  const Discs::Tag d;
  const hn::RebindToUnsigned<Discs::Tag> du;
  const Discs discs(arrays, range, circle);
  const auto step = hn::Set(du, hn::Lanes(d));
  auto places = hn::Add(hn::Set(du, range.begin), hn::Iota(du, 0));
  for (std::size_t i = range.begin; i < range.end; i += hn::Lanes(d), places = hn::Add(places, step)) {
    Discs::Numbers squares;
    Discs::Numbers radii;
    Discs::Numbers limits;
    const auto near = discs.compare(i, squares, radii, limits);
    const auto rims = hn::Sub(hn::Sqrt(squares), radii);
    std::uint8_t marks[8] = {};  // NOLINT(cppcoreguidelines-avoid-c-arrays): maximum that is written
    hn::StoreMaskBits(d, near, marks);
    storeCompressed(du, places, marks[0], collected.discs + count);
    storeCompressed(d, rims, marks[0], collected.rims + count);
    count += hwy::PopCount(marks[0]);
  }
  return count;
}

inline bool isAnyNearby(const DiscArrays& arrays, DiscRange range, const Circle& circle) {
  using Discs = NearbyDiscs<8>;  // a run near an agent seldom contains more
  const Discs::Tag d;
  const Discs discs(arrays, range, circle);
  auto any = hn::Zero(d);
  for (std::size_t i = range.begin; i < range.end; i += hn::Lanes(d)) {
    Discs::Numbers squares;
    Discs::Numbers radii;
    Discs::Numbers limits;
    const auto near = discs.compare(i, squares, radii, limits);
    any = hn::Or(any, hn::VecFromMask(d, hn::And(near, hn::Ge(limits, hn::Zero(d)))));
  }
  return !hn::AllFalse(d, hn::MaskFromVec(any));
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
