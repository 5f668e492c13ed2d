#include "social_crowd/ros/marker_paths.h"

#include <algorithm>

namespace crowd {
namespace {

/// Step that replaces a step of 0 (every movement is a point) when there are too many points [m].
constexpr double LEAST_STEP = 0.01;

}  // namespace

void WalkedPaths::clear() {
  paths_.clear();
  point_count_ = 0;
  step_ = first_step_;
  unsettled_ = true;
}

void WalkedPaths::add(std::uint32_t agent, const Vector2& position) {
  Path& path = paths_[agent];
  path.tip = position;
  if (!path.points.empty()) {
    const double moved = (position - path.points.back()).norm();
    if (moved == 0.0 || moved < step_) return;
  }
  path.points.push_back(position);
  if (++point_count_ > max_points_) thin();
}

void WalkedPaths::settle() {
  for (auto& [agent, path] : paths_) path.settled = path.points.size();
  unsettled_ = false;
}

void WalkedPaths::thin() {
  step_ = std::max(2.0 * step_, LEAST_STEP);
  point_count_ = 0;
  for (auto& [agent, path] : paths_) {
    std::vector<Vector2>& points = path.points;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); i += 2) points[kept++] = points[i];
    points.resize(kept);
    path.settled = 0;
    point_count_ += kept;
  }
  unsettled_ = true;
}

}  // namespace crowd
