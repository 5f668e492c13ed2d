#include "bodies_side_by_side.h"

#include <algorithm>
#include <cstring>

#include "social_crowd/common/avx512.h"

namespace crowd {
namespace {

using Motion = NeighbourGrid::Motion;
using Numbers = double __attribute__((vector_size(FOUR * sizeof(double))));
static_assert(sizeof(Motion) == sizeof(Numbers), "a motion fills a register");

inline void load(const Motion& motion, Numbers& row) { std::memcpy(&row, &motion, sizeof(row)); }
inline void store(const Numbers& numbers, double* where) { std::memcpy(where, &numbers, sizeof(numbers)); }

/// Where the bodies of an agent are to be written.
struct Columns {
  double* xs;
  double* ys;
  double* vxs;
  double* vys;
  double* radii;
  BodyKind* kinds;

  Columns(PerceivedBodies& bodies, std::size_t first)
      : xs(bodies.xs() + first),
        ys(bodies.ys() + first),
        vxs(bodies.vxs() + first),
        vys(bodies.vys() + first),
        radii(bodies.radii() + first),
        kinds(bodies.kinds() + first) {}
};

/// What does not depend on where the agent is, of the first `count` bodies.
inline void writeBodies(const SeenDiscs& seen, std::size_t count, const Columns& to) {
  const double* const radii = seen.grid.radii();
  for (std::size_t i = 0; i < count; ++i) to.radii[i] = radii[seen.discs[i].disc];
  if (seen.agents_alone) {
    std::fill(to.kinds, to.kinds + count, BodyKind::AGENT);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    to.kinds[i] = seen.grid.body(seen.discs[i].disc) < seen.agents ? BodyKind::AGENT : BodyKind::OBSTACLE;
  }
}

/// Writes motions by fours from number `i` on, as Rotation::intoFrame() does it, with the same bits. Returns how many
/// are done.
CROWD_VECTORISED std::size_t writeFours(const SeenDiscs& seen, std::size_t i, const Columns& to) {
  const Motion* const motions = seen.grid.motions();
  const NearDisc* const discs = seen.discs.begin();
  const std::size_t size = seen.discs.size();
  const double px = seen.position.x();
  const double py = seen.position.y();
  const double ax = seen.ahead.x();
  const double ay = seen.ahead.y();
  for (; i + FOUR <= size; i += FOUR) {
    Numbers a;
    Numbers b;
    Numbers c;
    Numbers d;
    load(motions[discs[i].disc], a);
    load(motions[discs[i + 1].disc], b);
    load(motions[discs[i + 2].disc], c);
    load(motions[discs[i + 3].disc], d);
    // From rows of x, y, vx and vy to columns, in two steps of what registers can do: ab_x is x and vx of a and b.
    const Numbers ab_x = {a[0], b[0], a[2], b[2]};
    const Numbers ab_y = {a[1], b[1], a[3], b[3]};
    const Numbers cd_x = {c[0], d[0], c[2], d[2]};
    const Numbers cd_y = {c[1], d[1], c[3], d[3]};
    const Numbers dx = Numbers{ab_x[0], ab_x[1], cd_x[0], cd_x[1]} - px;
    const Numbers dy = Numbers{ab_y[0], ab_y[1], cd_y[0], cd_y[1]} - py;
    const Numbers vx = {ab_x[2], ab_x[3], cd_x[2], cd_x[3]};
    const Numbers vy = {ab_y[2], ab_y[3], cd_y[2], cd_y[3]};
    store(dx * ax + dy * ay, to.xs + i);
    store(dy * ax - dx * ay, to.ys + i);
    store(vx * ax + vy * ay, to.vxs + i);
    store(vy * ax - vx * ay, to.vys + i);
  }
  return i;
}

using Write = std::size_t (*)(const SeenDiscs& seen, std::size_t i, const Columns& to);

#ifdef CROWD_AVX512
constexpr std::size_t EIGHT = 2 * FOUR;

CROWD_AVX512 inline __m512d loadTwo(const Motion& low, const Motion& high) {
  const __m256d first = _mm256_loadu_pd(reinterpret_cast<const double*>(&low));
  const __m256d second = _mm256_loadu_pd(reinterpret_cast<const double*>(&high));
  return _mm512_insertf64x4(_mm512_castpd256_pd512(first), second, 1);
}

/// As writeFours(), by eights as far as there are so many, with the same bits: fours in the halves of registers.
CROWD_AVX512 std::size_t writeEights(const SeenDiscs& seen, std::size_t i, const Columns& to) {
  const Motion* const motions = seen.grid.motions();
  const __m512d px = _mm512_set1_pd(seen.position.x());
  const __m512d py = _mm512_set1_pd(seen.position.y());
  const __m512d ax = _mm512_set1_pd(seen.ahead.x());
  const __m512d ay = _mm512_set1_pd(seen.ahead.y());
  const __m512i places = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i velocities = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  for (; i + EIGHT <= seen.discs.size(); i += EIGHT) {
    const NearDisc* const disc = &seen.discs[i];
    const __m512d a = loadTwo(motions[disc[0].disc], motions[disc[4].disc]);
    const __m512d b = loadTwo(motions[disc[1].disc], motions[disc[5].disc]);
    const __m512d c = loadTwo(motions[disc[2].disc], motions[disc[6].disc]);
    const __m512d d = loadTwo(motions[disc[3].disc], motions[disc[7].disc]);
    const __m512d ab_x = _mm512_unpacklo_pd(a, b);
    const __m512d ab_y = _mm512_unpackhi_pd(a, b);
    const __m512d cd_x = _mm512_unpacklo_pd(c, d);
    const __m512d cd_y = _mm512_unpackhi_pd(c, d);
    const __m512d dx = _mm512_permutex2var_pd(ab_x, places, cd_x) - px;
    const __m512d dy = _mm512_permutex2var_pd(ab_y, places, cd_y) - py;
    const __m512d vx = _mm512_permutex2var_pd(ab_x, velocities, cd_x);
    const __m512d vy = _mm512_permutex2var_pd(ab_y, velocities, cd_y);
    _mm512_storeu_pd(to.xs + i, dx * ax + dy * ay);
    _mm512_storeu_pd(to.ys + i, dy * ax - dx * ay);
    _mm512_storeu_pd(to.vxs + i, vx * ax + vy * ay);
    _mm512_storeu_pd(to.vys + i, vy * ax - vx * ay);
  }
  return i + FOUR <= seen.discs.size() ? writeFours(seen, i, to) : i;
}
#endif

}  // namespace

std::size_t writeSideBySide(const SeenDiscs& seen, std::size_t first, PerceivedBodies& bodies) {
  static const Write WRITE = CROWD_FASTEST(writeEights, writeFours);
  const Columns to(bodies, first);
  const std::size_t done = WRITE(seen, 0, to);
  writeBodies(seen, done, to);
  return done;
}

}  // namespace crowd
