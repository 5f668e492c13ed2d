#include "social_crowd/learning/near_agents.h"

#include <algorithm>

#include "social_crowd/common/avx512.h"

namespace crowd {
namespace {

/// More than the rounding of a distance [m].
constexpr double ROUNDING = 1e-6;

/// The sets of one body each, to be read side by side.
constexpr std::array<BodySet, LOOKED_AT> setsOfOne() {
  std::array<BodySet, LOOKED_AT> sets{};
  for (std::size_t i = 0; i < LOOKED_AT; ++i) sets[i] = BodySet{1} << i;
  return sets;
}
constexpr std::array<BodySet, LOOKED_AT> ALONE = setsOfOne();

inline BodySet firstOnes(std::size_t count) { return (BodySet{1} << std::min(count, LOOKED_AT)) - 1; }

/// What an agent is near by: the gap less what the plane between both may come towards it is shorter than this and the
/// other's radius are together [m].
inline double roomOf(const Perception& seen) {
  const double reach = seen.self.speed * seen.tick_duration;
  return seen.self.radius + 2.0 * (reach + GAP_MARGIN) + ROUNDING;
}

/// A limit lies beyond the longest displacement if half of the gap does, less what the plane between both may come
/// towards this one. All is multiplied by the distance, so that no root is taken.
CROWD_VECTORISED BodySet findNearPlainly(const PerceivedBodiesView& bodies, std::size_t first, const Vector2& velocity,
                                         double room, double tick_duration) {
  const double* const xs = bodies.xs() + first;
  const double* const ys = bodies.ys() + first;
  const double* const vxs = bodies.vxs() + first;
  const double* const vys = bodies.vys() + first;
  const double* const radii = bodies.radii() + first;
  const double vx = velocity.x();
  const double vy = velocity.y();
  BodySet near = 0;
  for (std::size_t i = 0; i < LOOKED_AT; ++i) {
    const double receding = xs[i] * (vx + vxs[i]) + ys[i] * (vy + vys[i]);
    const double square = xs[i] * xs[i] + ys[i] * ys[i];
    const double rest = square + tick_duration * std::min(0.0, receding);
    const double apart = room + radii[i];
    const bool far = (rest > 0.0) & (rest * rest > apart * apart * square);
    near |= far ? BodySet{0} : ALONE[i];
  }
  return near;
}

/// Lists what all are near to; returns how many that is.
using ListNear = std::size_t (*)(const Choosers& choosers, NearAgent* list);

std::size_t listNearPlainly(const Choosers& choosers, NearAgent* list) {
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < choosers.size(); ++k) {
    const Perception& seen = choosers[k].seen;
    if (!NearAgents::isFor(seen)) continue;
    for (BodySet left = findNear(seen, 0); left != 0; left &= left - 1) {
      list[count++] = {k * static_cast<std::uint32_t>(LOOKED_AT) + static_cast<std::uint32_t>(__builtin_ctz(left))};
    }
  }
  return count;
}

#ifdef CROWD_AVX512
constexpr std::size_t EIGHT = 8;
static_assert(LOOKED_AT == 2 * EIGHT, "two registers of bodies");

/// Those of eight bodies that are not near. Products and sums may be fused: rounding is allowed for.
CROWD_AVX512 inline std::uint32_t findFar(const PerceivedBodiesView& bodies, std::size_t first, const Vector2& velocity,
                                          double room, double tick_duration) {
  const __m512d x = _mm512_loadu_pd(bodies.xs() + first);
  const __m512d y = _mm512_loadu_pd(bodies.ys() + first);
  const __m512d vx = velocity.x() + _mm512_loadu_pd(bodies.vxs() + first);
  const __m512d vy = velocity.y() + _mm512_loadu_pd(bodies.vys() + first);
  const __m512d apart = room + _mm512_loadu_pd(bodies.radii() + first);
  const __m512d receding = _mm512_fmadd_pd(x, vx, y * vy);
  const __m512d square = _mm512_fmadd_pd(x, x, y * y);
  const __m512d coming = _mm512_min_pd(_mm512_setzero_pd(), receding);
  const __m512d rest = _mm512_fmadd_pd(_mm512_set1_pd(tick_duration), coming, square);
  const __mmask8 positive = _mm512_cmp_pd_mask(rest, _mm512_setzero_pd(), _CMP_GT_OQ);
  return _mm512_mask_cmp_pd_mask(positive, rest * rest, apart * apart * square, _CMP_GT_OQ);
}

/// Sixteen numbers at a time, of which those that count move together in a register, so that no branch depends on them.
CROWD_AVX512 std::size_t listNearWidely(const Choosers& choosers, NearAgent* list) {
  static_assert(sizeof(NearAgent) == sizeof(std::int32_t), "sixteen in a register");
  const __m512i steps = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  std::size_t count = 0;
  for (std::size_t k = 0; k < choosers.size(); ++k) {
    const Perception& seen = choosers[k].seen;
    if (!NearAgents::isFor(seen)) continue;
    const double room = roomOf(seen);
    const Vector2& velocity = seen.self.velocity;
    const std::uint32_t far_low = findFar(seen.bodies, 0, velocity, room, seen.tick_duration);
    const std::uint32_t far_high = findFar(seen.bodies, EIGHT, velocity, room, seen.tick_duration);
    const auto near = static_cast<__mmask16>(~(far_low | far_high << EIGHT) & firstOnes(seen.bodies.size()));
    const __m512i numbers = _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(k * LOOKED_AT)), steps);
    _mm512_storeu_si512(list + count, _mm512_maskz_compress_epi32(near, numbers));
    count += static_cast<std::size_t>(__builtin_popcount(near));
  }
  return count;
}
#endif

}  // namespace

BodySet findNear(const Perception& seen, std::size_t first) {
  const BodySet near = findNearPlainly(seen.bodies, first, seen.self.velocity, roomOf(seen), seen.tick_duration);
  return near & firstOnes(seen.bodies.size() - first);
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first `count_` of the list mean anything
NearAgents::NearAgents(const Choosers& choosers) {
  static const ListNear LIST = CROWD_FASTEST(listNearWidely, listNearPlainly);
  count_ = LIST(choosers, list_.data());
}

}  // namespace crowd
