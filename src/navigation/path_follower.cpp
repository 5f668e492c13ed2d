#include "social_crowd/navigation/path_follower.h"

namespace crowd {

Vector2 PathFollower::next(const Vector2& position, NavigationMesh::Query& query, const IsClear& is_clear) {
  ++ticks_;
  if (isCheckDue(position)) {
    if (is_clear) {
      check(position, query, is_clear);
    } else {
      check(position, query, [&](const Vector2& from, const Vector2& to) { return query.isStraight(from, to); });
    }
  }
  return path_ ? path_->corners[corner_] : position;
}

void PathFollower::check(const Vector2& position, NavigationMesh::Query& query, const IsClear& is_clear) {
  checked_at_ = position;
  ticks_ = 0;
  if (path_ && (isAtGoal(position, query.clearance()) || chooseCorner(position, is_clear))) return;
  path_ = query.findPath(position, goal_);
  state_ = path_ ? State::ON_THE_WAY : State::UNREACHABLE;
  if (!path_) return;
  setCorner(0);
  chooseCorner(position, is_clear);
}

bool PathFollower::isAtGoal(const Vector2& position, double distance) const {
  return corner_ + 1 == path_->corners.size() && (position - goal_).norm() <= distance;
}

bool PathFollower::isCheckDue(const Vector2& position) const {
  if (ticks_ >= CHECK_TICKS) return true;
  if (!path_) return state_ == State::ON_THE_WAY;
  if ((position - checked_at_).norm() >= CHECK_DISTANCE) return true;
  return corner_ + 1 < path_->corners.size() && (position - path_->corners[corner_]).norm() <= REACHED;
}

bool PathFollower::chooseCorner(const Vector2& position, const IsClear& is_clear) {
  const std::vector<Vector2>& corners = path_->corners;
  std::size_t farthest = corner_;
  while (farthest + 1 < corners.size() && is_clear(position, corners[farthest + 1])) ++farthest;
  if (farthest == corner_ && farthest + 1 < corners.size() && (position - corners[farthest]).norm() <= REACHED) {
    ++farthest;
  } else if (farthest == corner_ && !is_clear(position, corners[corner_])) {
    // Pushed back behind the last corner?
    if (corner_ == 0 || !is_clear(position, corners[corner_ - 1])) return false;
    --farthest;
  }
  setCorner(farthest);
  return true;
}

void PathFollower::setCorner(std::size_t corner) {
  corner_ = corner;
  length_behind_corner_ = 0.0;
  for (std::size_t i = corner; i + 1 < path_->corners.size(); ++i) {
    length_behind_corner_ += (path_->corners[i + 1] - path_->corners[i]).norm();
  }
}

double PathFollower::remainingLength(const Vector2& position) const {
  if (!path_) return std::numeric_limits<double>::infinity();
  return (position - path_->corners[corner_]).norm() + length_behind_corner_;
}

void PathFollower::setGoal(const Vector2& goal) {
  goal_ = goal;
  replan();
}

void PathFollower::replan() {
  path_.reset();
  state_ = State::ON_THE_WAY;
}

}  // namespace crowd
