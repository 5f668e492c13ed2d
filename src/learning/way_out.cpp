#include "social_crowd/learning/way_out.h"

#include <algorithm>
#include <tuple>

#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

/// By how much a mover is to be cleared, and by how much where there is room, so that one more agent finds place [m].
constexpr double CLEARANCE = 0.02;
constexpr double ROOM = 0.4;

/// Other agents count as so much wider: they will not be exactly where they seem to go [m].
constexpr double DOUBT = 0.2;

/// As the movers go, with one that turns round, and with room to spare.
constexpr double CASES = 3.0;

/// When an agent and a mover can touch if both make for each other [s].
double soonestContact(const AgentPerception& self, const PerceivedBody& mover) {
  const double gap = mover.position.norm() - self.radius - mover.radius - CLEARANCE;
  return gap / (self.speed + mover.velocity.norm());
}

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the plain moves that are counted mean anything
WayOut::WayOut(const Perception& perception, double lookout) : perception_(perception), lookout_(lookout) {
  findMovers();
  if (!isNeeded()) return;
  addPlainMoves();
  as_they_go_.clearance = CLEARANCE;
  with_room_.clearance = ROOM;
  for (std::size_t m = 0; m < mover_count_; ++m) if_turned_[m] = {movers_[m], CLEARANCE, 0};
}

void WayOut::findMovers() {
  const auto later = [this](std::size_t a, std::size_t b) {
    return soonestContact(perception_.self, perception_.bodies[a]) <
           soonestContact(perception_.self, perception_.bodies[b]);
  };
  for (std::size_t i = 0; i < perception_.bodies.size(); ++i) {
    const PerceivedBody body = perception_.bodies[i];
    if (!isMover(body) || soonestContact(perception_.self, body) > lookout_) continue;
    const auto end = movers_.begin() + static_cast<std::ptrdiff_t>(mover_count_);
    const auto place = std::upper_bound(movers_.begin(), end, i, later);
    if (place == movers_.end()) continue;
    mover_count_ = std::min(mover_count_ + 1, MOST_MOVERS);
    std::move_backward(place, movers_.begin() + static_cast<std::ptrdiff_t>(mover_count_ - 1),
                       movers_.begin() + static_cast<std::ptrdiff_t>(mover_count_));
    *place = i;
  }
}

void WayOut::addPlainMoves() {
  const auto add = [this](const Vector2& direction, double share) {
    setMove(plain_moves_.data(), plain_move_count_++, {direction, share, share});
  };
  add(Vector2::UnitX(), 1.0);
  add(Vector2::UnitX(), 0.0);
  for (std::size_t m = 0; m < mover_count_; ++m) {
    // Measured from a mover's way they stay the same from tick to tick, as long as it goes straight on.
    const Vector2 ahead = perception_.bodies[movers_[m]].velocity.normalized();
    const Vector2 left(-ahead.y(), ahead.x());
    add(ahead, 1.0);
    add(-ahead, 1.0);
    for (std::size_t h = 1; h < HEADINGS / 2; ++h) {
      const Vector2 turn = unitVector(2.0 * PI * static_cast<double>(h) / HEADINGS);
      add(turn.x() * ahead + turn.y() * left, 1.0);
      add(turn.x() * ahead - turn.y() * left, 1.0);
    }
  }
  repeatLast(plain_moves_.data(), plain_move_count_);
}

/// When whoever walks straight on from `start`, where it is in a tick, stands before an obstacle, a wall, or an agent
/// that goes on as it does or stops [s].
double WayOut::blockedAfter(const Vector2& start, const Vector2& velocity) const {
  const double radius = perception_.self.radius;
  double time = NEVER;
  for (const PerceivedBody& body : perception_.bodies) {
    if (isMover(body)) continue;
    const Vector2 place = body.position + perception_.tick_duration * body.velocity - start;
    const double reach = radius + body.radius + (body.kind == BodyKind::AGENT ? DOUBT : 0.0);
    time = std::min(time, timeToContact(place, velocity - body.velocity, reach));
    time = std::min(time, timeToContact(place, velocity, reach));
  }
  for (const Segment& wall : perception_.walls) {
    time = std::min(time, timeToContact(Segment{wall.from - start, wall.to - start}, velocity, radius));
  }
  return time;
}

/// When a mover is touched by who makes a move [s].
double WayOut::timeToTouch(const CandidateMove& move, const Case& a_case) const {
  double time = NEVER;
  for (std::size_t i = 0; i < perception_.bodies.size(); ++i) {
    const PerceivedBody body = perception_.bodies[i];
    if (!isMover(body)) continue;
    const double reach = perception_.self.radius + body.radius + CLEARANCE;
    time = std::min(time, timeToContact(body.position, velocityOf(move) - a_case.velocityOf(i, body), reach));
  }
  return time;
}

/// How long it is clear of movers who walks straight on from `start`, where it is in a tick, and stops where it must
/// [s].
double WayOut::clearTimeFrom(const Vector2& start, const Vector2& velocity, const Case& a_case) const {
  const double blocked = velocity == Vector2::Zero() ? NEVER : blockedAfter(start, velocity);
  double clear = NEVER;
  for (std::size_t i = 0; i < perception_.bodies.size(); ++i) {
    const PerceivedBody body = perception_.bodies[i];
    if (!isMover(body)) continue;
    const double reach = perception_.self.radius + body.radius + a_case.clearance;
    const Vector2 its = a_case.velocityOf(i, body);
    const Vector2 place = body.position + perception_.tick_duration * its - start;
    double time = timeToContact(place, velocity - its, reach);
    if (time > blocked) time = blocked + timeToContact(place + blocked * (its - velocity), -its, reach);
    clear = std::min(clear, time);
  }
  return clear;
}

/// How long there is a plain way on that is clear of movers, at most `lookout`.
double WayOut::clearTime(const CandidateMove& move, Case& a_case) const {
  const double tick = perception_.tick_duration;
  const double touched = timeToTouch(move, a_case);
  if (touched < tick) return touched;
  const Vector2 velocity = velocityOf(move);
  const Vector2 end = tick * velocity;
  double longest = tick + clearTimeFrom(end, velocity, a_case);
  for (std::size_t i = 0; i < plain_move_count_ && longest < lookout_; ++i) {
    // What was the way out from a neighbouring place is likely to be one from here.
    const std::size_t next = (a_case.last_way + i) % plain_move_count_;
    const CandidateMove plain = plainMove(next);
    const Vector2 onwards = plain.wanted * perception_.self.speed * plain.direction;
    longest = std::max(longest, tick + clearTimeFrom(end, onwards, a_case));
    if (longest >= lookout_) a_case.last_way = next;
  }
  return std::min(longest, lookout_);
}

/// The sum of the clear times of the cases, one after another until one is not met: a move that lacks room is better
/// than one that is in the way of a mover that turns round, and that better than one in the way of a mover as it goes.
double WayOut::safety(const CandidateMove& move) {
  const double as_they_go = clearTime(move, as_they_go_);
  if (as_they_go < lookout_) return as_they_go;
  double if_one_turns = lookout_;
  for (std::size_t m = 0; m < mover_count_; ++m) {
    if_one_turns = std::min(if_one_turns, clearTime(move, if_turned_[m]));
  }
  if (if_one_turns < lookout_) return lookout_ + if_one_turns;
  return 2.0 * lookout_ + clearTime(move, with_room_);
}

CandidateMove WayOut::bestPlainMove(const Vector2& wish) const {
  const auto rank = [&](std::size_t i) {
    const Vector2 velocity = velocityOf(plainMove(i));
    return std::make_tuple(safeties_[i], -(velocity - wish).squaredNorm(), velocity.x(),
                           velocity.dot(perception_.self.goal));
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < plain_move_count_; ++i) {
    if (rank(i) > rank(best)) best = i;
  }
  return plainMove(best);
}

void WayOut::replaceUnsafe(MoveBlock* moves, std::size_t count) {
  bool are_plain_moves_judged = false;
  for (std::size_t i = 0; i < count; ++i) {
    const CandidateMove move = moveAt(moves, i);
    if (safety(move) >= CASES * lookout_) continue;
    if (!are_plain_moves_judged) {
      for (std::size_t p = 0; p < plain_move_count_; ++p) safeties_[p] = safety(plainMove(p));
      are_plain_moves_judged = true;
    }
    setMove(moves, i, bestPlainMove(velocityOf(move)));
  }
}

}  // namespace crowd
