#include "social_crowd/learning/wide_contact_times.h"

#include "social_crowd/common/vectorised.h"

#ifdef CROWD_AVX512
// The compiler's own header leaves undefined what is not used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <immintrin.h>
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <array>
#include <cstdint>

namespace crowd {
#ifdef CROWD_AVX512
namespace {

using Lanes = MoveOutlooks::Lanes;
using Masks = std::array<std::uint16_t, MoveOutlooks::LANES>;
constexpr std::size_t WIDTH = 16;
static_assert(Discs::SIZE == WIDTH && MoveOutlooks::LANES == WIDTH + WIDTH / 2, "discs and moves in so many registers");

/// Discs in registers. The velocities of the second kind are the means of theirs and the agent's.
struct WideDiscs {
  __m512 px, py, vx, vy, mean_vx, mean_vy, apart, per_root;
};

/// For each move a bit for every disc that it might touch.
struct Hits {
  alignas(64) Masks selfish;
  alignas(64) Masks reciprocal;
};

/// Of a disc that moves with v a velocity u leads into the cone round p whose sine is reach / |p| if u - v is to the
/// left of its right edge and to the right of its left one: reach p.(u - v) +- root of apart p x (u - v) >= 0. Rounding
/// opens that cone by up to 0.0015 [rad] where a time is worked out, and by 0.0001 here: it is opened by more than
/// both. A pair too many costs time, but changes nothing; so products and sums may be fused here.
struct Cones {
  __m512 right_x, right_y;  // reach p + root of apart p, turned to the left
  __m512 left_x, left_y;    // the one less the other
  __m512 opening;
};

/// What v is to a Cones.
struct Apexes {
  __m512 right, left;
};

/// The root but for 2^-14 of it; for what is less than 1e-30 that of 1e-30.
CROWD_AVX512 inline __m512 roughRoot(__m512 value) {
  const __m512 positive = _mm512_max_ps(value, _mm512_set1_ps(1e-30F));
  return positive * _mm512_rsqrt14_ps(positive);
}

CROWD_AVX512 inline __m512 join(const float* low, const float* high) {
  return _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(low)), _mm256_load_ps(high), 1);
}

/// The scalar product.
CROWD_AVX512 inline __m512 dot(__m512 ax, __m512 ay, __m512 bx, __m512 by) { return _mm512_fmadd_ps(ax, bx, ay * by); }

CROWD_AVX512 inline Cones conesOf(const WideDiscs& discs) {
  const __m512 square = discs.px * discs.px + discs.py * discs.py;
  const __m512 reach = roughRoot(square - discs.apart);
  const __m512 root = roughRoot(discs.apart);
  const __m512 along_x = reach * discs.px;
  const __m512 along_y = reach * discs.py;
  const __m512 across_x = root * -discs.py;
  const __m512 across_y = root * discs.px;
  return {along_x + across_x, along_y + across_y, along_x - across_x, along_y - across_y, square / 256.0F};
}

/// @param speed no move is faster [m/s]
CROWD_AVX512 inline Apexes apexesOf(const Cones& cones, __m512 vx, __m512 vy, float speed) {
  constexpr float TINY = 1e-15F;  // products of less lose digits
  const __m512 fastest = std::max(speed, 1e-12F) + _mm512_max_ps(_mm512_abs_ps(vx), _mm512_abs_ps(vy));
  const __m512 slack = cones.opening * fastest + TINY;
  return {dot(cones.right_x, cones.right_y, vx, vy) - slack, dot(cones.left_x, cones.left_y, vx, vy) - slack};
}

CROWD_AVX512 inline __mmask16 hitsOf(__m512 right, __m512 left, const Apexes& apexes) {
  const __mmask16 inside = _mm512_cmp_ps_mask(right, apexes.right, _CMP_NLT_UQ);
  return _mm512_mask_cmp_ps_mask(inside, left, apexes.left, _CMP_NLT_UQ);
}

CROWD_AVX512 inline void findHits(const Courses& courses, const WideDiscs& discs, Hits& hits) {
  const Cones cones = conesOf(discs);
  const Apexes selfish = apexesOf(cones, discs.vx, discs.vy, courses.speed);
  const Apexes reciprocal = apexesOf(cones, discs.mean_vx, discs.mean_vy, courses.speed);
  // Lanes behind the moves touch nothing; the first lanes are written below.
  for (Masks* masks : {&hits.selfish, &hits.reciprocal}) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(masks->data()), _mm256_setzero_si256());
    _mm_store_si128(reinterpret_cast<__m128i*>(&(*masks)[WIDTH]), _mm_setzero_si128());
  }
  for (std::size_t move = 0; move < courses.count; ++move) {
    const __m512 ux = _mm512_set1_ps(courses.ux[move]);
    const __m512 uy = _mm512_set1_ps(courses.uy[move]);
    const __m512 right = dot(cones.right_x, cones.right_y, ux, uy);
    const __m512 left = dot(cones.left_x, cones.left_y, ux, uy);
    hits.selfish[move] = hitsOf(right, left, selfish);
    hits.reciprocal[move] = hitsOf(right, left, reciprocal);
  }
}

/// Sixteen pairs of a move and a kind of contact, and the discs that are still to be looked at.
struct WideMoves {
  __m512 ux, uy, soonest;
  __m512i kind;  // 0: selfish, Discs::SIZE: reciprocal
  __m512i hits;
};

CROWD_AVX512 inline bool isAny(__m512i hits) { return _mm512_test_epi32_mask(hits, hits) != 0; }

/// Looks at the next disc of each move; at the last one where none is left, which changes nothing.
CROWD_AVX512 inline void noteNext(const WideDiscs& discs, WideMoves& moves) {
  const __m512i zeros = _mm512_lzcnt_epi32(moves.hits);
  moves.hits = _mm512_xor_si512(moves.hits, _mm512_srlv_epi32(_mm512_set1_epi32(INT32_MIN), zeros));
  // Disc 31 - zeros, and the kind.
  const __m512i disc = _mm512_or_si512(_mm512_andnot_si512(zeros, _mm512_set1_epi32(15)), moves.kind);
  const __m512 px = _mm512_permutexvar_ps(disc, discs.px);
  const __m512 py = _mm512_permutexvar_ps(disc, discs.py);
  const __m512 rx = moves.ux - _mm512_permutex2var_ps(discs.vx, disc, discs.mean_vx);
  const __m512 ry = moves.uy - _mm512_permutex2var_ps(discs.vy, disc, discs.mean_vy);
  // As inverseTime() does it.
  const __m512 closing = px * rx + py * ry;
  const __m512 square = rx * rx + ry * ry;
  const __m512 inside = closing * closing - square * _mm512_permutexvar_ps(disc, discs.apart);
  const __m512 soon = (closing + _mm512_sqrt_ps(inside)) * _mm512_permutexvar_ps(disc, discs.per_root);
  moves.soonest = _mm512_max_ps(soon, moves.soonest);  // the second if one is not a number
}

/// The first moves.
CROWD_AVX512 inline WideMoves loadFirst(const Courses& courses, const Lanes& soonest, const Masks& hits,
                                        std::uint32_t kind) {
  return {_mm512_load_ps(courses.ux.data()), _mm512_load_ps(courses.uy.data()), _mm512_load_ps(soonest.data()),
          _mm512_set1_epi32(static_cast<int>(kind)),
          _mm512_cvtepu16_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(hits.data())))};
}

/// The moves behind those, of both kinds.
CROWD_AVX512 inline WideMoves loadSecond(const Courses& courses, const Hits& hits) {
  const __m128i selfish = _mm_load_si128(reinterpret_cast<const __m128i*>(&hits.selfish[WIDTH]));
  const __m128i reciprocal = _mm_load_si128(reinterpret_cast<const __m128i*>(&hits.reciprocal[WIDTH]));
  return {join(&courses.ux[WIDTH], &courses.ux[WIDTH]), join(&courses.uy[WIDTH], &courses.uy[WIDTH]),
          join(&courses.selfish[WIDTH], &courses.reciprocal[WIDTH]),
          _mm512_inserti64x4(_mm512_setzero_si512(), _mm256_set1_epi32(Discs::SIZE), 1),
          _mm512_cvtepu16_epi32(_mm256_inserti128_si256(_mm256_castsi128_si256(selfish), reciprocal, 1))};
}

CROWD_AVX512 inline WideDiscs load(const Discs& discs, const Vector2& velocity) {
  WideDiscs wide;
  wide.px = _mm512_load_ps(discs.px.data());
  wide.py = _mm512_load_ps(discs.py.data());
  wide.vx = _mm512_load_ps(discs.vx.data());
  wide.vy = _mm512_load_ps(discs.vy.data());
  wide.mean_vx = 0.5F * (static_cast<float>(velocity.x()) + wide.vx);
  wide.mean_vy = 0.5F * (static_cast<float>(velocity.y()) + wide.vy);
  wide.apart = _mm512_load_ps(discs.apart.data());
  const __mmask16 is_apart = _mm512_cmp_ps_mask(wide.apart, _mm512_setzero_ps(), _CMP_GT_OQ);
  wide.per_root = _mm512_mask_div_ps(_mm512_set1_ps(AT_ONCE), is_apart, _mm512_set1_ps(1.0F), wide.apart);
  return wide;
}

/// The square of the fastest approach of any disc, seen with a velocity [m2/s2].
CROWD_AVX512 inline float fastestApproach(const WideDiscs& discs, const Vector2& velocity) {
  const __m512 closing = discs.px * (static_cast<float>(velocity.x()) - discs.vx) +
                         discs.py * (static_cast<float>(velocity.y()) - discs.vy);
  const __m512 distance = discs.px * discs.px + discs.py * discs.py;  // squared
  const __mmask16 closes = _mm512_cmp_ps_mask(closing, _mm512_setzero_ps(), _CMP_GT_OQ);
  return _mm512_reduce_max_ps(_mm512_maskz_div_ps(closes, closing * closing, distance));
}

CROWD_AVX512 inline WideDiscs discsOf(const Encounter& encounter) {
  return load(encounter.discs, encounter.courses->velocity);
}

/// Finds who is touched how soon.
CROWD_AVX512 inline void noteHits(const WideDiscs& discs, const Hits& hits, Courses& courses) {
  WideMoves selfish = loadFirst(courses, courses.selfish, hits.selfish, 0);
  WideMoves reciprocal = loadFirst(courses, courses.reciprocal, hits.reciprocal, Discs::SIZE);
  WideMoves both = loadSecond(courses, hits);
  do {
    noteNext(discs, selfish);
    noteNext(discs, reciprocal);
    noteNext(discs, both);
  } while (isAny(selfish.hits | reciprocal.hits | both.hits));
  _mm512_store_ps(courses.selfish.data(), selfish.soonest);
  _mm512_store_ps(courses.reciprocal.data(), reciprocal.soonest);
  _mm256_store_ps(&courses.selfish[WIDTH], _mm512_castps512_ps256(both.soonest));
  _mm256_store_ps(&courses.reciprocal[WIDTH], _mm512_extractf32x8_ps(both.soonest, 1));
}

CROWD_AVX512 void noteAgentsWidely(const Encounters& encounters) {
  std::array<Hits, MAX_ENCOUNTERS> hits;  // NOLINT(cppcoreguidelines-pro-type-member-init): findHits() writes them
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    const Encounter& each = encounters[i];
    if (each.count <= FEW_DISCS) continue;
    const WideDiscs discs = discsOf(each);
    findHits(*each.courses, discs, hits[i]);
    each.courses->fastest = std::max(each.courses->fastest, fastestApproach(discs, each.courses->wish));
  }
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    const Encounter& each = encounters[i];
    if (each.count <= FEW_DISCS) {
      noteAgentsPlainly({&each, 1});
    } else {
      noteHits(discsOf(each), hits[i], *each.courses);
    }
  }
}

}  // namespace
#endif

NoteAgents fastestNoteAgents() { return CROWD_FASTEST(noteAgentsWidely, noteAgentsPlainly); }

}  // namespace crowd
