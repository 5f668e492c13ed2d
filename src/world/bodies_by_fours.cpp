#include "bodies_by_fours.h"

#include <cstring>

#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

using Numbers = double __attribute__((vector_size(FOUR * sizeof(double))));

static_assert(sizeof(NeighbourGrid::Motion) == sizeof(Numbers), "a motion fills a register");
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
    // From rows of x, y, vx and vy to columns, in two steps of what registers can do: ab_x is x and vx of a and b.
    const Numbers ab_x = {a[0], b[0], a[2], b[2]};
    const Numbers ab_y = {a[1], b[1], a[3], b[3]};
    const Numbers cd_x = {c[0], d[0], c[2], d[2]};
    const Numbers cd_y = {c[1], d[1], c[3], d[3]};
    const Numbers dx = Numbers{ab_x[0], ab_x[1], cd_x[0], cd_x[1]} - px;
    const Numbers dy = Numbers{ab_y[0], ab_y[1], cd_y[0], cd_y[1]} - py;
    const Numbers vx = {ab_x[2], ab_x[3], cd_x[2], cd_x[3]};
    const Numbers vy = {ab_y[2], ab_y[3], cd_y[2], cd_y[3]};
    store(dx * ax + dy * ay, xs + i);
    store(dy * ax - dx * ay, ys + i);
    store(vx * ax + vy * ay, vxs + i);
    store(vy * ax - vx * ay, vys + i);
    for (std::size_t k = i; k < i + FOUR; ++k) {
      to_radii[k] = radii[discs[k].disc];
      kinds[k] = seen.grid.body(discs[k].disc) < seen.agents ? BodyKind::AGENT : BodyKind::OBSTACLE;
    }
  }
  return i;
}

}  // namespace crowd
