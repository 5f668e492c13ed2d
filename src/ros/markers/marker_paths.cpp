#include "ros/markers/marker_paths.h"

#include <algorithm>
#include <iterator>

namespace crowd {
namespace {

/// Step that replaces a step of 0 (every movement is a point) when there are too many points [m].
constexpr double LEAST_STEP = 0.01;

// Readable for 50 walkers as well as for 1,000.
constexpr double WALKED_TIME = 600.0;    // of all paths together [s]
constexpr double LEAST_PATH_TIME = 2.5;  // [s]

/// Points are drawn again after this part of the time for which they are shown, with their new colours.
constexpr double FADING_STEP = 0.1;

}  // namespace

double pathTimeFor(std::size_t walkers) {
  return std::max(LEAST_PATH_TIME, WALKED_TIME / static_cast<double>(std::max<std::size_t>(walkers, 1)));
}

void WalkedPaths::setTimes(double now, double shown) {
  now_ = now;
  shown_ = shown;
}

double WalkedPaths::strengthAt(double time) const { return std::clamp(1.0 - (now_ - time) / shown_, 0.0, 1.0); }

bool WalkedPaths::isUnsettled() const { return unsettled_ || now_ - settled_time_ >= FADING_STEP * shown_; }

void WalkedPaths::clear() {
  paths_.clear();
  point_count_ = 0;
  step_ = first_step_;
  settled_time_ = 0.0;
  unsettled_ = true;
}

void WalkedPaths::add(std::uint32_t agent, const Vector2& position) {
  Path& path = paths_[agent];
  if (path.points.empty() || position != path.tip) path.tip_time = now_;
  path.tip = position;
  path.last_time = now_;
  if (!path.points.empty()) {
    const double moved = (position - path.points.back().position).norm();
    if (moved == 0.0 || moved < step_) return;
  }
  path.points.push_back({position, now_});
  if (++point_count_ > max_points_) thin();
}

void WalkedPaths::settle() {
  forgetOld();
  for (auto& [agent, path] : paths_) path.settled = path.points.size();
  unsettled_ = false;
  settled_time_ = now_;
}

void WalkedPaths::forgetOld() {
  const auto is_shown = [this](const Point& point) { return strengthAt(point.time) > 0.0; };
  for (auto next = paths_.begin(); next != paths_.end();) {
    Path& path = next->second;
    const auto old = std::find_if(path.points.begin(), path.points.end(), is_shown);
    const bool has_left = path.last_time < now_ && strengthAt(path.tip_time) == 0.0;
    const auto last = has_left ? path.points.end() : std::min(old, path.points.end() - 1);  // from which it goes on
    point_count_ -= static_cast<std::size_t>(last - path.points.begin());
    path.points.erase(path.points.begin(), last);
    next = has_left ? paths_.erase(next) : std::next(next);
  }
}

void WalkedPaths::thin() {
  step_ = std::max(2.0 * step_, LEAST_STEP);
  point_count_ = 0;
  for (auto& [agent, path] : paths_) {
    std::vector<Point>& points = path.points;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); i += 2) points[kept++] = points[i];
    points.resize(kept);
    path.settled = 0;
    point_count_ += kept;
  }
  unsettled_ = true;
}

}  // namespace crowd
