// Included once for each instruction set.
#if defined(CROWD_SEGMENT_GAPS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CROWD_SEGMENT_GAPS_INL
#undef CROWD_SEGMENT_GAPS_INL
#else
#define CROWD_SEGMENT_GAPS_INL
#endif

#include <hwy/highway.h>

#include "simd/segment_gaps.h"

HWY_BEFORE_NAMESPACE();
namespace crowd::simd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Lanes of vectors of the plane.
template <typename V>
struct Vectors {
  V x;
  V y;
};

template <typename V>
HWY_INLINE Vectors<V> difference(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
}
template <typename V>
HWY_INLINE V dotProduct(const Vectors<V>& a, const Vectors<V>& b) {
  return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y));
}
template <typename V>
HWY_INLINE V crossProduct(const Vectors<V>& a, const Vectors<V>& b) {
  return hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x));
}
/// Limits a share to the length of a segment.
template <typename V>
HWY_INLINE V withinSegment(V share) {
  const hn::DFromV<V> d;
  return hn::Min(hn::Max(share, hn::Zero(d)), hn::Set(d, 1.0));
}
/// 1 / the square of a length; 0 for a length of 0.
template <typename V>
HWY_INLINE V perSquare(const Vectors<V>& way) {
  const hn::DFromV<V> d;
  const auto square = dotProduct(way, way);
  return hn::IfThenElseZero(hn::Gt(square, hn::Zero(d)), hn::Div(hn::Set(d, 1.0), square));
}

template <typename V>
HWY_INLINE Vectors<V> choose(hn::Mask<hn::DFromV<V>> mask, const Vectors<V>& yes, const Vectors<V>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y)};
}

/// Segments as places and ways from there.
template <typename V>
struct Ways {
  HWY_INLINE Ways(const Vectors<V>& start, const Vectors<V>& end)
      : from(start), to(end), way(difference(end, start)), per_square(perSquare(way)) {}
  HWY_INLINE Vectors<V> nearestTo(const Vectors<V>& place) const {
    const auto share = withinSegment(hn::Mul(dotProduct(difference(place, from), way), per_square));
    return at(share);
  }
  HWY_INLINE Vectors<V> at(V share) const {
    return {hn::Add(from.x, hn::Mul(share, way.x)), hn::Add(from.y, hn::Mul(share, way.y))};
  }
  /// Whether the ends of other segments are on different sides of the lines of these.
  HWY_INLINE hn::Mask<hn::DFromV<V>> separatesEnds(const Ways& other) const {
    const auto sides =
        hn::Mul(crossProduct(way, difference(other.from, from)), crossProduct(way, difference(other.to, from)));
    return hn::Lt(sides, hn::Zero(hn::DFromV<V>()));
  }

  Vectors<V> from;
  Vectors<V> to;
  Vectors<V> way;
  V per_square;
};

/// Points of two segments, the nearest so far.
template <typename V>
struct Pairs {
  Vectors<V> first;
  Vectors<V> second;

  HWY_INLINE V square() const {
    const auto between = difference(second, first);
    return dotProduct(between, between);
  }
  HWY_INLINE void take(const Pairs& other) {
    const auto is_nearer = hn::Lt(other.square(), square());
    first = choose(is_nearer, other.first, first);
    second = choose(is_nearer, other.second, second);
  }
};

/// See nearestPair().
template <typename V>
HWY_INLINE Pairs<V> nearestPairs(const Ways<V>& one, const Ways<V>& other) {
  Pairs<V> nearest{one.from, other.nearestTo(one.from)};
  nearest.take({one.to, other.nearestTo(one.to)});
  nearest.take({one.nearestTo(other.from), other.from});
  nearest.take({one.nearestTo(other.to), other.to});
  const auto denominator = crossProduct(one.way, other.way);
  const auto crossing = hn::And(hn::And(one.separatesEnds(other), other.separatesEnds(one)),
                                hn::Ne(denominator, hn::Zero(hn::DFromV<V>())));
  const auto ahead = crossProduct(difference(other.from, one.from), other.way);
  const auto common = one.at(withinSegment(hn::Div(ahead, denominator)));
  return {choose(crossing, common, nearest.first), choose(crossing, common, nearest.second)};
}

inline void findGaps(double to_x, double to_y, double radius, const RegionArrays& others, const GapArrays& gaps) {
  const hn::CappedTag<double, 8> d;
  using V = hn::Vec<decltype(d)>;
  const Ways<V> own({hn::Zero(d), hn::Zero(d)}, {hn::Set(d, to_x), hn::Set(d, to_y)});
  const auto own_radius = hn::Set(d, radius);
  for (std::size_t i = 0; i < others.count; i += hn::Lanes(d)) {
    const Ways<V> other({hn::LoadU(d, others.from_xs + i), hn::LoadU(d, others.from_ys + i)},
                        {hn::LoadU(d, others.to_xs + i), hn::LoadU(d, others.to_ys + i)});
    const Pairs<V> nearest = nearestPairs(own, other);
    const auto between = difference(nearest.second, nearest.first);
    const auto distance = hn::Sqrt(dotProduct(between, between));
    const auto is_apart = hn::Gt(distance, hn::Zero(d));
    const Vectors<V> normal{hn::IfThenElseZero(is_apart, hn::Div(between.x, distance)),
                            hn::IfThenElseZero(is_apart, hn::Div(between.y, distance))};
    hn::StoreU(normal.x, d, gaps.normal_xs + i);
    hn::StoreU(normal.y, d, gaps.normal_ys + i);
    hn::StoreU(hn::Sub(hn::Sub(distance, own_radius), hn::LoadU(d, others.radii + i)), d, gaps.widths + i);
    hn::StoreU(dotProduct(normal, nearest.first), d, gaps.alongs + i);
  }
}

}  // namespace crowd::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
