#include "bodies_by_fours.h"

#include <cstring>

#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

using Numbers = double __attribute__((vector_size(FOUR * sizeof(double))));
using Lanes = std::int64_t __attribute__((vector_size(FOUR * sizeof(double))));

inline void load(const NeighbourGrid::Motion& motion, Numbers& row) { std::memcpy(&row, &motion, sizeof(row)); }

inline void store(const Numbers& numbers, double* where) { std::memcpy(where, &numbers, sizeof(numbers)); }

}  // namespace

// As Rotation::intoFrame() does it, with the same bits.
CROWD_VECTORISED std::size_t writeFours(const SeenDiscs& seen, std::size_t first, PerceivedBodies& bodies) {
  const NeighbourGrid::Motion* const motions = seen.grid.motions();
  const double* const radii = seen.grid.radii();
  const NearDisc* const discs = seen.discs.begin();
  const std::size_t size = seen.discs.size();
  const double px = seen.position.x();
  const double py = seen.position.y();
  const double ax = seen.ahead.x();
  const double ay = seen.ahead.y();
  double* const xs = bodies.xs() + first;
  double* const ys = bodies.ys() + first;
  double* const vxs = bodies.vxs() + first;
  double* const vys = bodies.vys() + first;
  double* const to_radii = bodies.radii() + first;
  BodyKind* const kinds = bodies.kinds() + first;
  std::size_t i = 0;
  for (; i + FOUR <= size; i += FOUR) {
    Numbers a;
    Numbers b;
    Numbers c;
    Numbers d;
    load(motions[discs[i].disc], a);
    load(motions[discs[i + 1].disc], b);
    load(motions[discs[i + 2].disc], c);
    load(motions[discs[i + 3].disc], d);
    // Rows of x, y, vx and vy to columns.
    const Numbers ab_x = __builtin_shuffle(a, b, Lanes{0, 4, 2, 6});
    const Numbers ab_y = __builtin_shuffle(a, b, Lanes{1, 5, 3, 7});
    const Numbers cd_x = __builtin_shuffle(c, d, Lanes{0, 4, 2, 6});
    const Numbers cd_y = __builtin_shuffle(c, d, Lanes{1, 5, 3, 7});
    const Numbers dx = __builtin_shuffle(ab_x, cd_x, Lanes{0, 1, 4, 5}) - px;
    const Numbers dy = __builtin_shuffle(ab_y, cd_y, Lanes{0, 1, 4, 5}) - py;
    const Numbers vx = __builtin_shuffle(ab_x, cd_x, Lanes{2, 3, 6, 7});
    const Numbers vy = __builtin_shuffle(ab_y, cd_y, Lanes{2, 3, 6, 7});
    store(dx * ax + dy * ay, xs + i);
    store(dy * ax - dx * ay, ys + i);
    store(vx * ax + vy * ay, vxs + i);
    store(vy * ax - vx * ay, vys + i);
    for (std::size_t k = i; k < i + FOUR; ++k) to_radii[k] = radii[discs[k].disc];
    std::memset(kinds + i, static_cast<int>(BodyKind::AGENT), FOUR);
  }
  return i;
}

}  // namespace crowd
