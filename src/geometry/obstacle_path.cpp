#include "geometry/obstacle_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr double SAME_POINT = 1e-9;  // [m]; a shorter leg would have no certain direction

}  // namespace

ObstaclePath ObstaclePath::atRest(const Vector2& position) { return {Kind::AT_REST, {position}, Vector2::Zero(), 0.0}; }

ObstaclePath ObstaclePath::straight(const Vector2& start, const Vector2& velocity) {
  const Kind kind = velocity.isZero(0.0) ? Kind::AT_REST : Kind::STRAIGHT;
  return {kind, {start}, velocity, 0.0};
}

ObstaclePath ObstaclePath::toAndFro(std::vector<Vector2> points, double speed) {
  return {Kind::TO_AND_FRO, std::move(points), Vector2::Zero(), speed};
}

ObstaclePath ObstaclePath::loop(std::vector<Vector2> points, double speed) {
  return {Kind::LOOP, std::move(points), Vector2::Zero(), speed};
}

ObstaclePath ObstaclePath::recorded(std::shared_ptr<const Track> track) {
  ObstaclePath path(Kind::RECORDED, {}, Vector2::Zero(), track->maxSpeed());
  path.track_ = std::move(track);
  return path;
}

ObstaclePath::ObstaclePath(Kind kind, std::vector<Vector2> points, const Vector2& velocity, double speed)
    : kind_(kind), points_(std::move(points)), velocity_(velocity), speed_(speed) {
  if (kind_ != Kind::TO_AND_FRO && kind_ != Kind::LOOP) return;
  // The way back is appended, so that both kinds are closed loops.
  std::vector<Vector2> round = points_;
  if (kind_ == Kind::TO_AND_FRO && points_.size() > 2) {
    round.insert(round.end(), points_.rbegin() + 1, points_.rend() - 1);
  }
  double length = 0.0;
  for (std::size_t i = 0; i < round.size(); ++i) {
    const Vector2 way = round[(i + 1) % round.size()] - round[i];
    const double leg_length = way.norm();
    if (leg_length > 0.0) {
      legs_.push_back({round[i], way / leg_length, length, length + leg_length});
      length += leg_length;
    }
  }
  if (legs_.empty()) {
    throw InputError("expected a path of at least two different points");
  }
  if (!(speed_ > 0.0)) {
    throw InputError("expected a speed above 0 along the path");
  }
}

std::pair<const ObstaclePath::Leg&, double> ObstaclePath::legAt(double t) const {
  const double distance = std::fmod(speed_ * t, legs_.back().end);
  const auto ends_after = [](double value, const Leg& candidate) { return value < candidate.end; };
  const auto found = std::upper_bound(legs_.begin(), legs_.end(), distance, ends_after);
  const Leg& leg = found == legs_.end() ? legs_.back() : *found;
  return {leg, distance - leg.begin};
}

ObstaclePath::Motion ObstaclePath::at(double t) const {
  if (track_ != nullptr) return track_->at(t);
  if (legs_.empty()) return {points_.front() + t * velocity_, velocity_};
  const auto [leg, way] = legAt(t);
  return {leg.from + way * leg.unit, speed_ * leg.unit};
}

ObstaclePath ObstaclePath::after(double t) const {
  if (track_ != nullptr) return recorded(std::make_shared<const Track>(track_->earlier(t)));
  const Vector2 place = position(t);
  if (legs_.empty()) return straight(place, velocity_);
  const auto [leg, way] = legAt(t);
  std::vector<Vector2> points;
  for (const Leg& one : legs_) points.push_back(one.from);
  const std::size_t passed = &leg - legs_.data();
  const std::size_t next = (passed + 1) % legs_.size();
  const bool is_at_next = leg.end - leg.begin - way < SAME_POINT;
  if (way >= SAME_POINT && !is_at_next) {
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(next), points.end());
    points.insert(points.begin(), place);
  } else {
    const std::size_t first = is_at_next ? next : passed;
    points[first] = place;
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  }
  return loop(std::move(points), speed_);
}

}  // namespace crowd
