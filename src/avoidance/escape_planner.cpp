#include "avoidance/escape_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "avoidance/time_to_collision.h"

namespace crowd {
namespace {

/// Clearance to a moving obstacle [m].
constexpr double CLEARANCE = 0.02;

/// Clearance where there is space, so that one more agent fits between [m].
constexpr double WIDE_CLEARANCE = 0.4;

/// Added to the radii of other agents, whose future positions are uncertain [m].
constexpr double AGENT_MARGIN = 0.2;

/// Number of cases that a safe move passes, see safety().
constexpr double CASES = 3.0;

/// Earliest time at which an agent and a moving obstacle can be within the clearance, if they approach each other head
/// on [s].
double soonestContact(const AgentPerception& self, const Neighbour& moving_obstacle) {
  const double gap = moving_obstacle.position.norm() - self.radius - moving_obstacle.radius - CLEARANCE;
  return gap / (self.max_speed + moving_obstacle.velocity.norm());
}

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first straight_move_count_ straight moves are read
EscapePlanner::EscapePlanner(const Perception& perception, double lookout)
    : perception_(perception), lookout_(lookout) {
  findMovingObstacles();
  if (!isNeeded()) return;
  addStraightMoves();
  as_they_go_.clearance = CLEARANCE;
  with_space_.clearance = WIDE_CLEARANCE;
  for (std::size_t m = 0; m < moving_obstacle_count_; ++m) if_turned_[m] = {moving_obstacles_[m], CLEARANCE, 0};
}

void EscapePlanner::findMovingObstacles() {
  const auto later = [this](std::size_t a, std::size_t b) {
    return soonestContact(perception_.self, perception_.neighbours[a]) <
           soonestContact(perception_.self, perception_.neighbours[b]);
  };
  for (std::size_t i = 0; i < perception_.neighbours.size(); ++i) {
    const Neighbour neighbour = perception_.neighbours[i];
    if (!isMovingObstacle(neighbour)) continue;
    if (movers_end_ == 0) movers_begin_ = i;
    movers_end_ = i + 1;
    if (soonestContact(perception_.self, neighbour) > lookout_) continue;
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
    // Headings relative to the obstacle's velocity are the same at every tick as long as the obstacle goes straight on,
    // so an escape that was found at one tick still exists at the next.
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

/// Time until an agent that walks straight on from `start`, its position after one tick, is blocked by a static
/// obstacle, a wall, or another agent, which keeps its velocity or stops [s].
double EscapePlanner::blockedAfter(const Vector2& start, const Vector2& velocity) const {
  const double radius = perception_.self.radius;
  double time = NEVER;
  for (const Neighbour& neighbour : perception_.neighbours) {
    if (isMovingObstacle(neighbour) || neighbour.kind == NeighbourKind::UNYIELDED_ROBOT) continue;
    const Vector2 place = neighbour.position + perception_.tick_duration * neighbour.velocity - start;
    const double reach = radius + neighbour.radius + (neighbour.kind == NeighbourKind::AGENT ? AGENT_MARGIN : 0.0);
    time = std::min(time, timeToCollision(place, velocity - neighbour.velocity, reach));
    time = std::min(time, timeToCollision(place, velocity, reach));
  }
  for (const Segment& wall : perception_.walls) {
    time = std::min(time, timeToCollision(Segment{wall.from - start, wall.to - start}, velocity, radius));
  }
  return time;
}

/// Time until the agent comes within the clearance of a moving obstacle at a velocity [s].
double EscapePlanner::timeToTouch(const Vector2& velocity, const Case& a_case) const {
  double time = NEVER;
  for (std::size_t i = movers_begin_; i < movers_end_; ++i) {
    const Neighbour neighbour = perception_.neighbours[i];
    if (!isMovingObstacle(neighbour)) continue;
    const double reach = perception_.self.radius + neighbour.radius + CLEARANCE;
    time = std::min(time, timeToCollision(neighbour.position, velocity - a_case.velocityOf(i, neighbour), reach));
  }
  return time;
}

/// Time for which an agent stays clear of moving obstacles if it walks straight on from `start`, its position after one
/// tick, and stops where it is blocked [s].
double EscapePlanner::clearTimeFrom(std::size_t path, const Vector2& start, const Vector2& velocity,
                                    const Case& a_case) {
  double& blocked = blocked_[path];
  if (std::isnan(blocked)) blocked = velocity == Vector2::Zero() ? NEVER : blockedAfter(start, velocity);
  double clear = NEVER;
  for (std::size_t i = movers_begin_; i < movers_end_; ++i) {
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

/// By how much an agent that changes its velocity stays behind one that has the new one at once [m].
Vector2 EscapePlanner::lag(const Vector2& from, const Vector2& to) const {
  const MotionLimits& motion = perception_.motion;
  const Vector2 change = from - to;
  return change.norm() / (2.0 * std::min(motion.acceleration, motion.braking)) * change;
}

/// Longest time for which a straight path after the move is clear of moving obstacles, at most `lookout` [s].
double EscapePlanner::clearTime(const CandidateMove& move, Case& a_case) {
  const double tick = perception_.tick_duration;
  const Vector2 wanted = velocityOf(move);
  const Vector2 velocity = perception_.motion.reachable(perception_.self.velocity, wanted, tick);
  const double touched = timeToTouch(velocity, a_case);
  if (touched < tick) return touched;
  const Vector2 end = tick * velocity;
  double longest = tick + clearTimeFrom(straight_move_count_, end + lag(velocity, wanted), wanted, a_case);
  for (std::size_t i = 0; i < straight_move_count_ && longest < lookout_; ++i) {
    // The last escape is likely to be one for this move, too: the positions differ little.
    const std::size_t next = (a_case.last_path + i) % straight_move_count_;
    const CandidateMove straight = straightMove(next);
    const Vector2 onwards = straight.wanted * perception_.self.max_speed * straight.direction;
    longest = std::max(longest, tick + clearTimeFrom(next, end + lag(velocity, onwards), onwards, a_case));
    if (longest >= lookout_) a_case.last_path = next;
  }
  return std::min(longest, lookout_);
}

/// Sum of the clear times of the cases, up to the first case in which the move is not clear [s]; CASES * lookout for a
/// safe move. So a violation of the wide clearance ranks above a collision with an obstacle that reverses, and this one
/// above a collision with an obstacle that keeps its velocity.
double EscapePlanner::safety(const CandidateMove& move) {
  std::fill_n(blocked_.begin(), straight_move_count_ + 1, std::numeric_limits<double>::quiet_NaN());
  const double as_they_go = clearTime(move, as_they_go_);
  if (as_they_go < lookout_) return as_they_go;
  double if_one_turns = lookout_;
  for (std::size_t m = 0; m < moving_obstacle_count_; ++m) {
    if_one_turns = std::min(if_one_turns, clearTime(move, if_turned_[m]));
  }
  if (if_one_turns < lookout_) return lookout_ + if_one_turns;
  return 2.0 * lookout_ + clearTime(move, with_space_);
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
