#include "social_crowd/learning/wide_contact_times.h"

#include <algorithm>
#include <array>

#include "social_crowd/common/avx512.h"

namespace crowd {
#ifdef CROWD_AVX512
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t WIDTH = 16;
static_assert(Discs::SIZE == WIDTH && MoveOutlooks::LANES == WIDTH + WIDTH / 2, "discs and moves in so many registers");

/// What is needed of discs besides their own numbers.
struct Derived {
  alignas(64) Discs::Floats mean_vx;  // of theirs and the agent's [m/s]
  alignas(64) Discs::Floats mean_vy;
  alignas(64) Discs::Floats per_root;  // see inverseTimes()
};

CROWD_AVX512 inline __m512 load(const Discs::Floats& numbers) { return _mm512_load_ps(numbers.data()); }

CROWD_AVX512 inline void derive(const Discs& discs, const Vector2& velocity, Derived& derived) {
  const __m512 mean_vx = 0.5F * (static_cast<float>(velocity.x()) + load(discs.vx));
  const __m512 mean_vy = 0.5F * (static_cast<float>(velocity.y()) + load(discs.vy));
  const __m512 apart = load(discs.apart);
  const __mmask16 is_apart = _mm512_cmp_ps_mask(apart, _mm512_setzero_ps(), _CMP_GT_OQ);
  const __m512 per_root = _mm512_mask_div_ps(_mm512_set1_ps(AT_ONCE), is_apart, _mm512_set1_ps(1.0F), apart);
  _mm512_store_ps(derived.mean_vx.data(), mean_vx);
  _mm512_store_ps(derived.mean_vy.data(), mean_vy);
  _mm512_store_ps(derived.per_root.data(), per_root);
}

/// The square of the fastest approach of any disc, seen with a velocity [m2/s2].
CROWD_AVX512 inline float fastestApproach(const Discs& discs, const Vector2& velocity) {
  const __m512 px = load(discs.px);
  const __m512 py = load(discs.py);
  const __m512 closing = px * (static_cast<float>(velocity.x()) - load(discs.vx)) +
                         py * (static_cast<float>(velocity.y()) - load(discs.vy));
  const __m512 distance = px * px + py * py;  // squared
  const __mmask16 closes = _mm512_cmp_ps_mask(closing, _mm512_setzero_ps(), _CMP_GT_OQ);
  return _mm512_reduce_max_ps(_mm512_maskz_div_ps(closes, closing * closing, distance));
}

/// As inverseTime() does it: r is the velocity of a move less that of a disc.
CROWD_AVX512 inline __m512 inverseTimes(__m512 px, __m512 py, __m512 rx, __m512 ry, __m512 apart, __m512 per_root) {
  const __m512 closing = px * rx + py * ry;
  const __m512 square = rx * rx + ry * ry;
  return (closing + _mm512_sqrt_ps(closing * closing - square * apart)) * per_root;
}

/// Looks at one disc after the other for the first WIDTH moves, side by side.
CROWD_AVX512 inline void noteFirst(const Discs& discs, std::size_t count, const Derived& derived, Courses& courses) {
  const __m512 ux = _mm512_load_ps(courses.ux.data());
  const __m512 uy = _mm512_load_ps(courses.uy.data());
  __m512 selfish = _mm512_load_ps(courses.selfish.data());
  __m512 reciprocal = _mm512_load_ps(courses.reciprocal.data());
  for (std::size_t i = 0; i < count; ++i) {
    const __m512 px = _mm512_set1_ps(discs.px[i]);
    const __m512 py = _mm512_set1_ps(discs.py[i]);
    const __m512 apart = _mm512_set1_ps(discs.apart[i]);
    const __m512 per_root = _mm512_set1_ps(derived.per_root[i]);
    const __m512 alone = inverseTimes(px, py, ux - discs.vx[i], uy - discs.vy[i], apart, per_root);
    const __m512 both = inverseTimes(px, py, ux - derived.mean_vx[i], uy - derived.mean_vy[i], apart, per_root);
    selfish = _mm512_max_ps(alone, selfish);  // the second if one is not a number
    reciprocal = _mm512_max_ps(both, reciprocal);
  }
  _mm512_store_ps(courses.selfish.data(), selfish);
  _mm512_store_ps(courses.reciprocal.data(), reciprocal);
}

CROWD_AVX512 inline __m512 join(__m512 low, __m512 high) {
  return _mm512_insertf32x8(low, _mm512_castps512_ps256(high), 1);
}

/// The highest of each of two sets of numbers: that of the first in the lower half, that of the second in the upper.
CROWD_AVX512 inline __m512 highestOfBoth(__m512 first, __m512 second) {
  const __m512 upper = _mm512_shuffle_f32x4(first, second, _MM_SHUFFLE(3, 2, 3, 2));
  const __m512 eight = _mm512_max_ps(join(first, second), upper);
  const __m512 four = _mm512_max_ps(eight, _mm512_shuffle_f32x4(eight, eight, _MM_SHUFFLE(2, 3, 0, 1)));
  const __m512 two = _mm512_max_ps(four, _mm512_permute_ps(four, _MM_SHUFFLE(1, 0, 3, 2)));
  return _mm512_max_ps(two, _mm512_permute_ps(two, _MM_SHUFFLE(2, 3, 0, 1)));
}

/// Looks at all discs side by side for one after the other of the moves behind those.
CROWD_AVX512 inline void noteRest(const Discs& discs, const Derived& derived, Courses& courses) {
  const __m512 px = load(discs.px);
  const __m512 py = load(discs.py);
  const __m512 apart = load(discs.apart);
  const __m512 per_root = load(derived.per_root);
  const auto highest = [&](const Discs::Floats& vx, const Discs::Floats& vy, std::size_t move) CROWD_AVX512 {
    const __m512 rx = courses.ux[move] - load(vx);
    const __m512 ry = courses.uy[move] - load(vy);
    // The second if one is not a number.
    return _mm512_max_ps(inverseTimes(px, py, rx, ry, apart, per_root), _mm512_setzero_ps());
  };
  // Stored as a whole: what is written one by one could not be read as a whole before it is in the cache.
  __m512 rest = join(_mm512_castps256_ps512(_mm256_load_ps(&courses.selfish[WIDTH])),
                     _mm512_castps256_ps512(_mm256_load_ps(&courses.reciprocal[WIDTH])));
  for (std::size_t move = WIDTH; move < courses.count; ++move) {
    const __m512 soonest =
        highestOfBoth(highest(discs.vx, discs.vy, move), highest(derived.mean_vx, derived.mean_vy, move));
    const auto lanes = static_cast<__mmask16>(0x0101U << (move - WIDTH));
    rest = _mm512_mask_max_ps(rest, lanes, rest, soonest);
  }
  _mm256_store_ps(&courses.selfish[WIDTH], _mm512_castps512_ps256(rest));
  _mm256_store_ps(&courses.reciprocal[WIDTH], _mm512_extractf32x8_ps(rest, 1));
}

CROWD_AVX512 void noteAgentsWidely(const Encounters& encounters) {
  std::array<Derived, MAX_ENCOUNTERS> derived;  // NOLINT(cppcoreguidelines-pro-type-member-init): derive() writes them
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    const Discs& discs = encounters[i].discs;
    Courses& courses = *encounters[i].courses;
    derive(discs, courses.velocity, derived[i]);
    courses.fastest = std::max(courses.fastest, fastestApproach(discs, courses.wish));
  }
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    const Discs& discs = encounters[i].discs;
    Courses& courses = *encounters[i].courses;
    noteFirst(discs, encounters[i].count, derived[i], courses);
    if (courses.count > WIDTH) noteRest(discs, derived[i], courses);
  }
}

}  // namespace
#endif

NoteAgents fastestNoteAgents() { return CROWD_FASTEST(noteAgentsWidely, noteAgentsPlainly); }

}  // namespace crowd
