#include "social_crowd/avoidance/escape_planner.h"

#include <algorithm>
#include <tuple>

#include "social_crowd/avoidance/time_to_collision.h"

namespace crowd {
namespace {

/// By how much a moving obstacle is to be cleared, and by how much where there is room, so that one more agent finds
/// place [m].
constexpr double CLEARANCE = 0.02;
constexpr double ROOM = 0.4;

/// Other agents count as so much wider: they will not be exactly where they seem to go [m].
constexpr double DOUBT = 0.2;

/// As the moving obstacles go, with one that turns round, and with room to spare.
constexpr double CASES = 3.0;

/// When an agent and a moving obstacle can touch if both make for each other [s].
double soonestContact(const AgentPerception& self, const Neighbour& moving_obstacle) {
  const double gap = moving_obstacle.position.norm() - self.radius - moving_obstacle.radius - CLEARANCE;
  return gap / (self.max_speed + moving_obstacle.velocity.norm());
}

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the straight moves that are counted mean anything
EscapePlanner::EscapePlanner(const Perception& perception, double lookout)
    : perception_(perception), lookout_(lookout) {
  findMovingObstacles();
  if (!isNeeded()) return;
  addStraightMoves();
  as_they_go_.clearance = CLEARANCE;
  with_room_.clearance = ROOM;
  for (std::size_t m = 0; m < moving_obstacle_count_; ++m) if_turned_[m] = {moving_obstacles_[m], CLEARANCE, 0};
}

void EscapePlanner::findMovingObstacles() {
  const auto later = [this](std::size_t a, std::size_t b) {
    return soonestContact(perception_.self, perception_.neighbours[a]) <
           soonestContact(perception_.self, perception_.neighbours[b]);
  };
  for (std::size_t i = 0; i < perception_.neighbours.size(); ++i) {
    const Neighbour neighbour = perception_.neighbours[i];
    if (!isMovingObstacle(neighbour) || soonestContact(perception_.self, neighbour) > lookout_) continue;
    const auto end = moving_obstacles_.begin() + static_cast<std::ptrdiff_t>(moving_obstacle_count_);
    const auto place = std::upper_bound(moving_obstacles_.begin(), end, i, later);
    if (place == moving_obstacles_.end()) continue;
    moving_obstacle_count_ = std::min(moving_obstacle_count_ + 1, MAX_MOVING_OBSTACLES);
    std::move_backward(place, moving_obstacles_.begin() + static_cast<std::ptrdiff_t>(moving_obstacle_count_ - 1),
                       moving_obstacles_.begin() + static_cast<std::ptrdiff_t>(moving_obstacle_count_));
    *place = i;
  }
}

void EscapePlanner::addStraightMoves() {
  const auto add = [this](const Vector2& direction, double fraction) {
    setMove(straight_moves_.data(), straight_move_count_++, {direction, fraction, fraction});
  };
  add(Vector2::UnitX(), 1.0);
  add(Vector2::UnitX(), 0.0);
  for (std::size_t m = 0; m < moving_obstacle_count_; ++m) {
    // Measured from a moving obstacle's way they stay the same from tick to tick, as long as it goes straight on.
    const Vector2 ahead = perception_.neighbours[moving_obstacles_[m]].velocity.normalized();
    const Vector2 left(-ahead.y(), ahead.x());
    add(ahead, 1.0);
    add(-ahead, 1.0);
    for (std::size_t h = 1; h < HEADINGS / 2; ++h) {
      const Vector2 turn = unitVector(2.0 * PI * static_cast<double>(h) / HEADINGS);
      add(turn.x() * ahead + turn.y() * left, 1.0);
      add(turn.x() * ahead - turn.y() * left, 1.0);
    }
  }
  repeatLast(straight_moves_.data(), straight_move_count_);
}

/// When whoever walks straight on from `start`, where it is in a tick, stands before an obstacle, a wall, or an agent
/// that goes on as it does or stops [s].
double EscapePlanner::blockedAfter(const Vector2& start, const Vector2& velocity) const {
  const double radius = perception_.self.radius;
  double time = NEVER;
  for (const Neighbour& neighbour : perception_.neighbours) {
    if (isMovingObstacle(neighbour)) continue;
    const Vector2 place = neighbour.position + perception_.tick_duration * neighbour.velocity - start;
    const double reach = radius + neighbour.radius + (neighbour.kind == NeighbourKind::AGENT ? DOUBT : 0.0);
    time = std::min(time, timeToCollision(place, velocity - neighbour.velocity, reach));
    time = std::min(time, timeToCollision(place, velocity, reach));
  }
  for (const Segment& wall : perception_.walls) {
    time = std::min(time, timeToCollision(Segment{wall.from - start, wall.to - start}, velocity, radius));
  }
  return time;
}

/// When a moving obstacle is touched by who makes a move [s].
double EscapePlanner::timeToTouch(const CandidateMove& move, const Case& a_case) const {
  double time = NEVER;
  for (std::size_t i = 0; i < perception_.neighbours.size(); ++i) {
    const Neighbour neighbour = perception_.neighbours[i];
    if (!isMovingObstacle(neighbour)) continue;
    const double reach = perception_.self.radius + neighbour.radius + CLEARANCE;
    time =
        std::min(time, timeToCollision(neighbour.position, velocityOf(move) - a_case.velocityOf(i, neighbour), reach));
  }
  return time;
}

/// How long it is clear of moving obstacles who walks straight on from `start`, where it is in a tick, and stops where
/// it must [s].
double EscapePlanner::clearTimeFrom(const Vector2& start, const Vector2& velocity, const Case& a_case) const {
  const double blocked = velocity == Vector2::Zero() ? NEVER : blockedAfter(start, velocity);
  double clear = NEVER;
  for (std::size_t i = 0; i < perception_.neighbours.size(); ++i) {
    const Neighbour neighbour = perception_.neighbours[i];
    if (!isMovingObstacle(neighbour)) continue;
    const double reach = perception_.self.radius + neighbour.radius + a_case.clearance;
    const Vector2 its = a_case.velocityOf(i, neighbour);
    const Vector2 place = neighbour.position + perception_.tick_duration * its - start;
    double time = timeToCollision(place, velocity - its, reach);
    if (time > blocked) time = blocked + timeToCollision(place + blocked * (its - velocity), -its, reach);
    clear = std::min(clear, time);
  }
  return clear;
}

/// How long there is a straight path on that is clear of moving obstacles, at most `lookout`.
double EscapePlanner::clearTime(const CandidateMove& move, Case& a_case) const {
  const double tick = perception_.tick_duration;
  const double touched = timeToTouch(move, a_case);
  if (touched < tick) return touched;
  const Vector2 velocity = velocityOf(move);
  const Vector2 end = tick * velocity;
  double longest = tick + clearTimeFrom(end, velocity, a_case);
  for (std::size_t i = 0; i < straight_move_count_ && longest < lookout_; ++i) {
    // What was the escape from a neighbouring place is likely to be one from here.
    const std::size_t next = (a_case.last_path + i) % straight_move_count_;
    const CandidateMove straight = straightMove(next);
    const Vector2 onwards = straight.wanted * perception_.self.max_speed * straight.direction;
    longest = std::max(longest, tick + clearTimeFrom(end, onwards, a_case));
    if (longest >= lookout_) a_case.last_path = next;
  }
  return std::min(longest, lookout_);
}

/// The sum of the clear times of the cases, one after another until one is not met: a move that lacks room is better
/// than one that is in the way of a moving obstacle that turns round, and that better than one in the way of a moving
/// obstacle as it goes.
double EscapePlanner::safety(const CandidateMove& move) {
  const double as_they_go = clearTime(move, as_they_go_);
  if (as_they_go < lookout_) return as_they_go;
  double if_one_turns = lookout_;
  for (std::size_t m = 0; m < moving_obstacle_count_; ++m) {
    if_one_turns = std::min(if_one_turns, clearTime(move, if_turned_[m]));
  }
  if (if_one_turns < lookout_) return lookout_ + if_one_turns;
  return 2.0 * lookout_ + clearTime(move, with_room_);
}

CandidateMove EscapePlanner::bestStraightMove(const Vector2& preferred_velocity) const {
  const auto rank = [&](std::size_t i) {
    const Vector2 velocity = velocityOf(straightMove(i));
    return std::make_tuple(safeties_[i], -(velocity - preferred_velocity).squaredNorm(), velocity.x(),
                           velocity.dot(perception_.self.goal));
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < straight_move_count_; ++i) {
    if (rank(i) > rank(best)) best = i;
  }
  return straightMove(best);
}

void EscapePlanner::replaceUnsafe(MoveBlock* moves, std::size_t count) {
  bool are_straight_moves_judged = false;
  for (std::size_t i = 0; i < count; ++i) {
    const CandidateMove move = moveAt(moves, i);
    if (safety(move) >= CASES * lookout_) continue;
    if (!are_straight_moves_judged) {
      for (std::size_t p = 0; p < straight_move_count_; ++p) safeties_[p] = safety(straightMove(p));
      are_straight_moves_judged = true;
    }
    setMove(moves, i, bestStraightMove(velocityOf(move)));
  }
}

}  // namespace crowd
