#pragma once

#include <array>

#include "avoidance/candidate_move.h"
#include "world/perception.h"

namespace crowd {

/// @brief Whether the neighbour is a moving obstacle, which yields to no agent; a robot that agents yield to is one,
/// too.
inline bool isMovingObstacle(const Neighbour& neighbour) {
  return (neighbour.kind == NeighbourKind::OBSTACLE || neighbour.kind == NeighbourKind::ROBOT) &&
         neighbour.velocity != Vector2::Zero();
}

/// @brief Replaces moves after which an agent could not avoid moving obstacles (docs/separation_rule.md, Moving
/// obstacles).
///
/// A straight path is to walk straight on at full speed or to stay. A move is safe if, from its end, there is a
/// straight path that is clear of all moving obstacles for `lookout` seconds in each of three cases: they keep their
/// velocities; any one of the nearest of them reverses now; they keep their velocities and a larger clearance is kept.
/// An unsafe move is replaced by the nearest safe straight move or, if there is none, by the one that is clear for
/// longest.
///
/// Call contract: an object serves one decision of one agent on one thread. The fractions of straightMoves() are
/// limited first, then replaceUnsafe() is called. The perception must outlive the object.
class EscapePlanner {
 public:
  /// @param lookout time for which a path must be clear [s], above 0
  EscapePlanner(const Perception& perception, double lookout);

  /// @brief Whether a moving obstacle could reach the agent within the lookout. If not, replaceUnsafe() is not needed.
  bool isNeeded() const { return moving_obstacle_count_ > 0; }
  /// @brief The straight moves: straight on, staying, and headings measured from the directions of motion of the
  /// nearest moving obstacles; straightMoveCount() moves in blocks.
  MoveBlock* straightMoves() { return straight_moves_.data(); }
  std::size_t straightMoveCount() const { return straight_move_count_; }
  /// @brief Replaces the unsafe moves among the first `count` moves. The fractions of the straight moves must have been
  /// limited before.
  void replaceUnsafe(MoveBlock* moves, std::size_t count);

 private:
  static constexpr std::size_t MAX_MOVING_OBSTACLES = 4;  // those that could be met soonest
  static constexpr std::size_t NONE = SIZE_MAX;
  static constexpr std::size_t HEADINGS = 16;
  static constexpr std::size_t MAX_STRAIGHT_MOVES = 2 + MAX_MOVING_OBSTACLES * HEADINGS;

  /// A case that paths are checked in.
  struct Case {
    std::size_t turned = NONE;  // index of the neighbour that reverses now
    double clearance = 0.0;     // to moving obstacles [m]
    std::size_t last_path = 0;  // index of the straight move that was the last escape

    Vector2 velocityOf(std::size_t number, const Neighbour& moving_obstacle) const {
      return number == turned ? Vector2(-moving_obstacle.velocity) : moving_obstacle.velocity;
    }
  };

  void findMovingObstacles();
  void addStraightMoves();
  Vector2 velocityOf(const CandidateMove& move) const {
    return move.fraction * perception_.self.max_speed * move.direction;
  }
  double safety(const CandidateMove& move);
  double clearTime(const CandidateMove& move, Case& a_case);
  double timeToTouch(const Vector2& velocity, const Case& a_case) const;
  Vector2 lag(const Vector2& from, const Vector2& to) const;
  double clearTimeFrom(std::size_t path, const Vector2& start, const Vector2& velocity, const Case& a_case);
  double blockedAfter(const Vector2& start, const Vector2& velocity) const;
  CandidateMove straightMove(std::size_t i) const { return moveAt(straight_moves_.data(), i); }
  CandidateMove bestStraightMove(const Vector2& preferred_velocity) const;

  const Perception& perception_;
  double lookout_;
  std::size_t movers_begin_ = 0;  // all moving obstacles are among these neighbours
  std::size_t movers_end_ = 0;
  std::array<std::size_t, MAX_MOVING_OBSTACLES> moving_obstacles_{};  // indices of neighbours
  std::size_t moving_obstacle_count_ = 0;
  std::array<MoveBlock, blocksOf(MAX_STRAIGHT_MOVES)> straight_moves_;
  std::array<double, MAX_STRAIGHT_MOVES> safeties_{};
  std::size_t straight_move_count_ = 0;
  // Of the present move: how soon the straight paths from its end, and at last its own, are blocked, which is the same
  // in all cases [s]; NaN: not known yet.
  std::array<double, MAX_STRAIGHT_MOVES + 1> blocked_{};
  Case as_they_go_;
  std::array<Case, MAX_MOVING_OBSTACLES> if_turned_;
  Case with_space_;
};

}  // namespace crowd
