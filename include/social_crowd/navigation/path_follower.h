#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include "social_crowd/navigation/navigation_mesh.h"
#include "social_crowd/world/span.h"

namespace crowd {

/// @brief Leads one person to a goal: keeps the way, and returns the point to walk straight to, tick by tick.
///
/// The way is found once. From time to time, when the person has moved or some ticks have passed, it is checked
/// whether the next but one corner can be seen, and whether a person that was pushed still sees the way; if not, a new
/// one is found. The points depend on the positions only.
class PathFollower {
 public:
  enum class State {
    ON_THE_WAY,  ///< next() leads to the goal
    UNREACHABLE  ///< the mesh does not connect the last position with the goal; it is tried again from time to time
  };
  /// @brief Whether one can walk straight from one point to another.
  using IsClear = std::function<bool(const Vector2& from, const Vector2& to)>;

  /// @param goal [m]
  explicit PathFollower(const Vector2& goal) : goal_(goal) {}

  /// @brief The point to walk to: a corner of the way, and at last the goal; the position itself if it is unreachable.
  /// @param position [m] @param query on the mesh, the same at each call until replan() @param is_clear what counts as
  /// straight; Query::isStraight() if it is empty
  Vector2 next(const Vector2& position, NavigationMesh::Query& query, const IsClear& is_clear = nullptr);
  /// @brief The state after the last next().
  State state() const { return state_; }
  /// @brief Length of the way from a position to the goal [m]; infinite if it is unreachable or next() was not called.
  double remainingLength(const Vector2& position) const;

  /// @brief The corners from the present one to the goal; empty without a way. Valid until the next call of next().
  Span<Vector2> corners() const {
    return path_ ? Span<Vector2>(&path_->corners[corner_], path_->corners.size() - corner_) : Span<Vector2>(nullptr, 0);
  }
  const Vector2& goal() const { return goal_; }
  void setGoal(const Vector2& goal);
  /// @brief Finds a new way at the next call of next(), for example on another mesh.
  void replan();

 private:
  static constexpr double CHECK_DISTANCE = 0.25;  // [m]
  static constexpr int CHECK_TICKS = 10;
  static constexpr double REACHED = 0.1;  // distance at which a corner is reached [m]

  bool isCheckDue(const Vector2& position) const;
  void check(const Vector2& position, NavigationMesh::Query& query, const IsClear& is_clear);
  bool isAtGoal(const Vector2& position, double distance) const;
  /// Chooses the corner to walk to; returns false if none can be seen.
  bool chooseCorner(const Vector2& position, const IsClear& is_clear);
  void setCorner(std::size_t corner);

  Vector2 goal_;
  State state_ = State::ON_THE_WAY;
  std::optional<Path> path_;
  std::size_t corner_ = 0;                // index of the corner to walk to
  double length_behind_corner_ = 0.0;     // of the way [m]
  Vector2 checked_at_ = Vector2::Zero();  // position at the last check
  int ticks_ = 0;                         // since the last check
};

}  // namespace crowd
