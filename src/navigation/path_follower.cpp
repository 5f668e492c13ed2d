#include "navigation/path_follower.h"

namespace crowd {

Vector2 PathFollower::next(const Vector2& position, NavigationMesh::Query& query) {
  ++ticks_;
  if (isCheckDue(position)) check(position, query);
  return hasWay() ? corners_[corner_] : position;
}

bool PathFollower::isCheckDue(const Vector2& position) const {
  if (ticks_ >= CHECK_TICKS) return true;
  if (!hasWay()) return state_ == State::ON_THE_WAY;
  const Vector2& corner = corners_[corner_];
  const double distance = (position - corner).norm();
  if (isAtLastCorner() || distance > CORNER_DISTANCE) {
    return distanceTo(Segment{checked_at_, corner}, position) >= CHECK_DISTANCE;
  }
  return distance <= REACHED || (position - checked_at_).norm() >= CHECK_DISTANCE;
}

void PathFollower::check(const Vector2& position, NavigationMesh::Query& query) {
  checked_at_ = position;
  ticks_ = 0;
  if (!hasWay() || !(chooseCorner(position, query) || returnToWay(position, query))) {
    std::optional<Path> path = query.findPath(position, goal_);
    if (!path) {
      state_ = hasWay() ? State::IN_POCKET : State::UNREACHABLE;
      return;
    }
    follow(std::move(*path));
    chooseCorner(position, query);
  }
  state_ = State::ON_THE_WAY;
}

bool PathFollower::returnToWay(const Vector2& position, NavigationMesh::Query& query) {
  if (returns_ == MAX_RETURNS) return false;
  ++returns_;
  const double distance = (position - corners_[corner_]).norm();
  std::optional<Path> path = query.findPath(position, corners_[corner_], DETOUR_SHARE * distance + DETOUR);
  if (!path) return false;
  const auto present = corners_.begin() + static_cast<std::ptrdiff_t>(corner_);
  path->corners.insert(path->corners.end(), present + 1, corners_.end());
  corners_ = std::move(path->corners);
  corner_ = 0;
  chooseCorner(position, query);
  return true;
}

bool PathFollower::chooseCorner(const Vector2& position, NavigationMesh::Query& query) {
  const std::size_t before = corner_;
  while (!isAtLastCorner() && query.isStraight(position, corners_[corner_ + 1])) ++corner_;
  if (corner_ > before) return true;
  const double distance = (position - corners_[corner_]).norm();
  if (isAtLastCorner()) return distance <= query.clearance() || query.isStraight(position, goal_);
  if (distance <= REACHED) ++corner_;
  return corner_ > before || query.isStraight(position, corners_[corner_]);
}

void PathFollower::follow(Path path) {
  state_ = State::ON_THE_WAY;
  corners_ = std::move(path.corners);
  corner_ = 0;
  returns_ = 0;
}

void PathFollower::replan() {
  corners_.clear();
  corner_ = 0;
  state_ = State::ON_THE_WAY;
}

}  // namespace crowd
