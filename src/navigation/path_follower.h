#pragma once

#include <cstddef>
#include <vector>

#include "common/span.h"
#include "meshes/navigation_mesh.h"

namespace crowd {

/// @brief Leads one person to a goal: keeps the way, and returns the point to walk straight to, tick by tick.
///
/// The way is found once. Whether the next corners can be seen is checked where that can have changed: when the person
/// has left the straight line to its corner, or has moved near it, and from time to time. A person that was pushed to
/// where it does not see its corner returns to its way if that is near, a few times, and otherwise gets a new one. If
/// the mesh has none from there, as in a gap that is too narrow for it, it keeps the old one. The points depend on the
/// positions only.
class PathFollower {
 public:
  enum class State {
    ON_THE_WAY,  ///< next() leads to the goal
    IN_POCKET,   ///< there is a way, but the mesh has none from the last position; another mesh may have one
    UNREACHABLE  ///< there is no way yet, and the mesh has none; it is tried again from time to time
  };

  /// @param goal [m]
  explicit PathFollower(const Vector2& goal) : goal_(goal) {}

  /// @brief The point to walk to: a corner of the way, and at last the goal; the position itself if it is unreachable.
  /// @param position [m] @param query on the mesh, the same at each call until replan() or recheck()
  Vector2 next(const Vector2& position, NavigationMesh::Query& query);
  /// @brief The state after the last next().
  State state() const { return state_; }

  /// @brief The corners from the present one to the goal; empty without a way. Valid until the next call of next().
  Span<Vector2> corners() const { return {corners_.data() + corner_, corners_.size() - corner_}; }
  const Vector2& goal() const { return goal_; }
  /// @brief Finds a new way at the next call of next(), for example after gates have opened.
  void replan();
  /// @brief Checks at the next call of next() whether the way can be followed, for example on another mesh.
  void recheck() { ticks_ = CHECK_TICKS; }
  /// @brief Follows another way to the goal.
  void follow(Path path);

 private:
  static constexpr double CHECK_DISTANCE = 0.25;  // walked, or away from the straight line [m]
  static constexpr double CORNER_DISTANCE = 1.5;  // from here on the corner after the next one may come into sight [m]
  static constexpr double REACHED = 0.1;          // distance at which a corner is reached [m]
  static constexpr double DETOUR_SHARE = 1.2;     // a way back to the present corner may be longer than the straight
  static constexpr double DETOUR = 0.5;           // line by this factor and by this length [m]
  // In a crowd a person is pushed off its way many times; from where it is then, another exit may be nearer.
  static constexpr int MAX_RETURNS = 3;   // to the way, before a new one is found
  static constexpr int CHECK_TICKS = 10;  // it is checked after this time at the latest

  bool hasWay() const { return !corners_.empty(); }
  bool isAtLastCorner() const { return corner_ + 1 == corners_.size(); }
  bool isCheckDue(const Vector2& position) const;
  void check(const Vector2& position, NavigationMesh::Query& query);
  /// Finds a short way to the present corner, which costs much less than one to the goal, and keeps the rest of the
  /// way. Returns false if there is none.
  bool returnToWay(const Vector2& position, NavigationMesh::Query& query);
  /// Chooses the farthest corner that can be seen; returns false if it is not even the present one.
  bool chooseCorner(const Vector2& position, NavigationMesh::Query& query);

  Vector2 goal_;
  State state_ = State::ON_THE_WAY;
  std::vector<Vector2> corners_;          // of the way, empty without one [m]
  std::size_t corner_ = 0;                // index of the corner to walk to
  Vector2 checked_at_ = Vector2::Zero();  // position at the last check
  int returns_ = 0;                       // to the way, since it was found
  int ticks_ = 0;                         // since the last check
};

}  // namespace crowd
