#pragma once

#include <array>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief A moving obstacle: it yields to nobody.
inline bool isMovingObstacle(const Neighbour& neighbour) {
  return neighbour.kind == NeighbourKind::OBSTACLE && neighbour.velocity != Vector2::Zero();
}

/// @brief Keeps an agent out of the way of moving obstacles (docs/separation_rule.md).
///
/// A move is safe if a straight path leads on from where it ends, straight on at full speed or to stay, that is clear
/// of all moving obstacles for the next `lookout` seconds: as they go, if any one of them turns round now, and with
/// room to spare. A move that is not safe becomes the straight move that is safe and nearest to it; if none is, the one
/// that is clear for longest.
class EscapePlanner {
 public:
  /// @param lookout how far ahead the way must be clear [s]
  EscapePlanner(const Perception& perception, double lookout);

  /// @brief Whether a moving obstacle is near enough to matter.
  bool isNeeded() const { return moving_obstacle_count_ > 0; }
  /// @brief To stay, straight on, and headings measured from the ways of the nearest moving obstacles; in blocks.
  MoveBlock* straightMoves() { return straight_moves_.data(); }
  std::size_t straightMoveCount() const { return straight_move_count_; }
  /// @brief Replaces those of the first `count` moves that are not safe. The fractions of the straight moves are to be
  /// cut before.
  void replaceUnsafe(MoveBlock* moves, std::size_t count);

 private:
  static constexpr std::size_t MAX_MOVING_OBSTACLES = 4;  // the nearest, in time
  static constexpr std::size_t NOBODY = SIZE_MAX;
  static constexpr std::size_t HEADINGS = 16;
  static constexpr std::size_t MAX_STRAIGHT_MOVES = 2 + MAX_MOVING_OBSTACLES * HEADINGS;

  /// What the way is to be clear of.
  struct Case {
    std::size_t turned = NOBODY;  // the number of the moving obstacle that turns round now
    double clearance = 0.0;       // [m]
    std::size_t last_path = 0;    // the straight move that was an escape when last asked

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
  double clearTime(const CandidateMove& move, Case& a_case) const;
  double timeToTouch(const CandidateMove& move, const Case& a_case) const;
  double clearTimeFrom(const Vector2& start, const Vector2& velocity, const Case& a_case) const;
  double blockedAfter(const Vector2& start, const Vector2& velocity) const;
  CandidateMove straightMove(std::size_t i) const { return moveAt(straight_moves_.data(), i); }
  CandidateMove bestStraightMove(const Vector2& preferred_velocity) const;

  const Perception& perception_;
  double lookout_;
  std::array<std::size_t, MAX_MOVING_OBSTACLES> moving_obstacles_{};  // their numbers among the neighbours
  std::size_t moving_obstacle_count_ = 0;
  std::array<MoveBlock, blocksOf(MAX_STRAIGHT_MOVES)> straight_moves_;
  std::array<double, MAX_STRAIGHT_MOVES> safeties_{};
  std::size_t straight_move_count_ = 0;
  Case as_they_go_;
  std::array<Case, MAX_MOVING_OBSTACLES> if_turned_;
  Case with_room_;
};

}  // namespace crowd
