#include "avoidance/braking_rule.h"

#include <algorithm>

#include "simd/kernels.h"

namespace crowd {
namespace {

/// Limits the place where each move of a block stops.
/// @param limit of where it stops
void cutStop(const MoveLimit& limit, const Perception& seen, MoveBlock& moves) {
  const simd::StopLimit stop{limit.normal.x(), limit.normal.y(), 2.0 * seen.motion.braking * limit.max_advance,
                             seen.motion.braking * seen.tick_duration, 1.0 / seen.self.max_speed};
  simd::kernels().cut_stops(stop, moves.x.data(), moves.y.data(), MoveBlock::SIZE, moves.fraction.data());
}

}  // namespace

/// Calls use(limit) for each limit below a reach [m]. There are none beyond the reach at maximum speed: an agent is not
/// faster after a tick, see actionWith(), so it does not come up to those.
template <typename Use>
void BrakingRule::forEachLimit(double reach, const Use& use) const {
  for (const BrakingLimit& limit : limits_) {
    if (limit.max_advance < reach) use(limit);
  }
}

void BrakingRule::cut(MoveBlock* moves, std::size_t count) const {
  for (std::size_t block = 0; block < blocksOf(count); ++block) admitAll(moves[block]);
  const double step = seen_.self.max_speed * seen_.tick_duration;
  for (const BrakingLimit& limit : limits_) {
    for (std::size_t block = 0; block < blocksOf(count); ++block) {
      limit.is_sudden ? cutDisplacement(limit, step, moves[block]) : cutStop(limit, seen_, moves[block]);
    }
  }
}

RelativeAction BrakingRule::actionTowards(const CandidateMove& move) const {
  return actionWith(velocityTowards(velocityOf(move)), move);
}

RelativeAction BrakingRule::actionTowards(const CandidateMove& preferred, const CandidateMove& fallback) const {
  const Vector2 velocity = reachTowards(velocityOf(preferred)).at(1.0);
  bool is_free = true;
  forEachLimit(seen_.motion.reach(velocity.norm(), seen_.tick_duration),
               [&](const BrakingLimit& limit) { is_free = is_free && isWithin(limit, velocity); });
  return is_free ? actionWith(velocity, preferred) : actionTowards(fallback);
}

RelativeAction BrakingRule::actionWith(const Vector2& velocity, const CandidateMove& move) const {
  if (velocity != Vector2::Zero()) return {bearingOf(velocity), std::min(1.0, velocity.norm() / seen_.self.max_speed)};
  if (move.fraction <= 0.0) return {0.0, 0.0};
  // It turns on the spot before it walks.
  const double most = std::min(PI, seen_.motion.turn_rate * seen_.tick_duration);
  return {std::clamp(bearingOf(move.direction), -most, most), 0.0};
}

BrakingRule::Reach BrakingRule::reachTowards(const Vector2& wanted) const {
  return {seen_.motion.reachable(seen_.self.velocity, wanted, seen_.tick_duration),
          seen_.motion.braked(seen_.self.velocity, seen_.tick_duration)};
}

Vector2 BrakingRule::velocityTowards(const Vector2& wanted) const {
  const Reach between = reachTowards(wanted);
  const double fastest = std::max(between.reached.norm(), between.braked.norm());
  const double reach = seen_.motion.reach(fastest, seen_.tick_duration);
  double share = 1.0;
  double checked_share = 0.0;
  bool is_any_sudden = false;
  while (share > 0.0 && checked_share != share) {  // a smaller share is not always within a limit that a larger one is
    checked_share = share;
    forEachLimit(reach, [&](const BrakingLimit& limit) {
      is_any_sudden = is_any_sudden || limit.is_sudden;
      while (share > 0.0 && !isWithin(limit, between.at(share))) share -= 0.25;
    });
  }
  Vector2 velocity = between.at(share);
  if (!is_any_sudden) return velocity;
  forEachLimit(reach, [&](const BrakingLimit& limit) {
    const double advance = seen_.tick_duration * limit.normal.dot(velocity);
    if (limit.is_sudden && advance > limit.max_advance) velocity *= limit.max_advance / advance;
  });
  return velocity;
}

bool BrakingRule::isWithin(const BrakingLimit& limit, const Vector2& velocity) const {
  if (limit.is_sudden) return limit.normal.dot(velocity) <= 0.0;  // else it brakes
  const Vector2 stop = seen_.tick_duration * velocity + seen_.motion.stoppingWay(velocity);
  return limit.normal.dot(stop) <= limit.max_advance;
}

}  // namespace crowd
