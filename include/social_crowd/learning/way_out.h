#pragma once

#include <array>

#include "social_crowd/learning/candidate_move.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief An obstacle that moves: it yields to nobody.
inline bool isMover(const PerceivedBody& body) {
  return body.kind == BodyKind::OBSTACLE && body.velocity != Vector2::Zero();
}

/// @brief Keeps an agent out of the way of moving obstacles (docs/contact_rule.md).
///
/// A move is safe if a plain way leads on from where it ends, straight on at full speed or to stay, that is clear of
/// all movers for the next `lookout` seconds: as they go, if any one of them turns round now, and with room to spare. A
/// move that is not safe becomes the plain move that is safe and nearest to it; if none is, the one that is clear for
/// longest.
class WayOut {
 public:
  /// @param lookout how far ahead the way must be clear [s]
  WayOut(const Perception& perception, double lookout);

  /// @brief Whether a mover is near enough to matter.
  bool isNeeded() const { return mover_count_ > 0; }
  /// @brief To stay, straight on, and headings measured from the ways of the nearest movers; in blocks.
  MoveBlock* plainMoves() { return plain_moves_.data(); }
  std::size_t plainMoveCount() const { return plain_move_count_; }
  /// @brief Replaces those of the first `count` moves that are not safe. The shares of the plain moves are to be cut
  /// before.
  void replaceUnsafe(MoveBlock* moves, std::size_t count);

 private:
  static constexpr std::size_t MOST_MOVERS = 4;  // the nearest, in time
  static constexpr std::size_t NOBODY = SIZE_MAX;
  static constexpr std::size_t HEADINGS = 16;
  static constexpr std::size_t MOST_PLAIN_MOVES = 2 + MOST_MOVERS * HEADINGS;

  /// What the way is to be clear of.
  struct Case {
    std::size_t turned = NOBODY;  // the number of the mover that turns round now
    double clearance = 0.0;       // [m]
    std::size_t last_way = 0;     // the plain move that was a way out when last asked

    Vector2 velocityOf(std::size_t number, const PerceivedBody& mover) const {
      return number == turned ? Vector2(-mover.velocity) : mover.velocity;
    }
  };

  void findMovers();
  void addPlainMoves();
  Vector2 velocityOf(const CandidateMove& move) const { return move.share * perception_.self.speed * move.direction; }
  double safety(const CandidateMove& move);
  double clearTime(const CandidateMove& move, Case& a_case) const;
  double timeToTouch(const CandidateMove& move, const Case& a_case) const;
  double clearTimeFrom(const Vector2& start, const Vector2& velocity, const Case& a_case) const;
  double blockedAfter(const Vector2& start, const Vector2& velocity) const;
  CandidateMove plainMove(std::size_t i) const { return moveAt(plain_moves_.data(), i); }
  CandidateMove bestPlainMove(const Vector2& wish) const;

  const Perception& perception_;
  double lookout_;
  std::array<std::size_t, MOST_MOVERS> movers_{};  // their numbers among the bodies
  std::size_t mover_count_ = 0;
  std::array<MoveBlock, blocksOf(MOST_PLAIN_MOVES)> plain_moves_;
  std::array<double, MOST_PLAIN_MOVES> safeties_{};
  std::size_t plain_move_count_ = 0;
  Case as_they_go_;
  std::array<Case, MOST_MOVERS> if_turned_;
  Case with_room_;
};

}  // namespace crowd
