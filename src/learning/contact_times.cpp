#include "social_crowd/learning/contact_times.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/wide_contact_times.h"

namespace crowd {
namespace {

using Lanes = MoveOutlooks::Lanes;
constexpr std::size_t LANES = MoveOutlooks::LANES;

using Eight = float __attribute__((vector_size(8 * sizeof(float))));
using Four = float __attribute__((vector_size(4 * sizeof(float))));

/// Of the first and the second half the higher values.
template <typename Half, typename Whole>
inline void fold(const Whole& values, Half& higher) {
  static_assert(sizeof(Whole) == 2 * sizeof(Half), "two halves");
  Half other;
  std::memcpy(&higher, &values, sizeof(Half));
  std::memcpy(&other, reinterpret_cast<const char*>(&values) + sizeof(Half), sizeof(Half));
  higher = higher > other ? higher : other;
}

inline float highest(const Discs::Floats& values) {
  Eight eight;
  Four four;
  fold(values, eight);
  fold(eight, four);
  return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
}

/// Of the roots of |p - t r| = reach, t = apart / (p.r + sqrt(inside)) is the smaller one. Returns its inverse; what is
/// not real, or behind (negative), fails in comparisons with what is above 0.
inline float inverseTime(float px, float py, float rx, float ry, float apart, float per_root) {
  const float closing = px * rx + py * ry;
  const float square = rx * rx + ry * ry;
  return (closing + std::sqrt(closing * closing - square * apart)) * per_root;
}

/// Notes contacts with the first `count` discs, one after the other for all moves side by side.
/// @param vx velocities of the discs instead of their own
inline void noteContacts(const Courses& courses, const Discs& discs, std::size_t count, const Discs::Floats& vx,
                         const Discs::Floats& vy, Lanes& soonest) {
  alignas(64) Discs::Floats per_root;
  for (std::size_t i = 0; i < Discs::SIZE; ++i) per_root[i] = discs.apart[i] > 0.0F ? 1.0F / discs.apart[i] : AT_ONCE;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t move = 0; move < LANES; ++move) {
      const float rx = courses.ux[move] - vx[i];
      const float ry = courses.uy[move] - vy[i];
      const float soon = inverseTime(discs.px[i], discs.py[i], rx, ry, discs.apart[i], per_root[i]);
      soonest[move] = soon > soonest[move] ? soon : soonest[move];
    }
  }
}

/// The square of the fastest approach of any disc, seen with a velocity [m2/s2].
inline float fastestApproach(const Discs& discs, const Vector2& velocity) {
  const auto x = static_cast<float>(velocity.x());
  const auto y = static_cast<float>(velocity.y());
  alignas(64) Discs::Floats squares;
  for (std::size_t i = 0; i < Discs::SIZE; ++i) {
    const float closing = discs.px[i] * (x - discs.vx[i]) + discs.py[i] * (y - discs.vy[i]);
    const float square = closing * closing / (discs.px[i] * discs.px[i] + discs.py[i] * discs.py[i]);
    squares[i] = closing > 0.0F ? square : 0.0F;
  }
  return highest(squares);
}

/// @param count so many of the discs are agents
CROWD_VECTORISED void noteEncounter(const Discs& agents, std::size_t count, Courses& courses) {
  noteContacts(courses, agents, count, agents.vx, agents.vy, courses.selfish);
  // At 2u - w - v contact comes in half of the time that it takes at u - (w + v) / 2.
  alignas(64) Discs::Floats mean_vx;
  alignas(64) Discs::Floats mean_vy;
  const auto wx = static_cast<float>(courses.velocity.x());
  const auto wy = static_cast<float>(courses.velocity.y());
  for (std::size_t i = 0; i < Discs::SIZE; ++i) mean_vx[i] = 0.5F * (wx + agents.vx[i]);
  for (std::size_t i = 0; i < Discs::SIZE; ++i) mean_vy[i] = 0.5F * (wy + agents.vy[i]);
  noteContacts(courses, agents, count, mean_vx, mean_vy, courses.reciprocal);
  courses.fastest = std::max(courses.fastest, fastestApproach(agents, courses.wish));
}

}  // namespace

void noteAgentsPlainly(const Encounters& encounters) {
  for (const Encounter& each : encounters) noteEncounter(each.discs, each.count, *each.courses);
}

CROWD_VECTORISED void noteFixed(const Discs& discs, std::size_t count, Courses& courses) {
  courses.any_fixed = true;
  noteContacts(courses, discs, count, discs.vx, discs.vy, courses.fixed);
}

void noteAgents(const Encounters& encounters) {
  static const NoteAgents FASTEST = fastestNoteAgents();
  FASTEST(encounters);
}

}  // namespace crowd
