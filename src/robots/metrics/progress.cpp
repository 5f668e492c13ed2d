#include "robots/metrics/progress.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr double ROUNDING = 1e-9;             // of a time that is a multiple of a tick [ticks], and of distances [m]
constexpr std::size_t MOST_AT_ONCE = 10'000;  // positions for which there is space from the start

}  // namespace

Progress::Progress(const RobotMetricOptions& options, double tick_duration)
    : options_(options), span_(static_cast<std::size_t>(std::ceil(options.progress_time / tick_duration - ROUNDING))) {
  recent_.reserve(std::min(remembered(), MOST_AT_ONCE));
}

void Progress::beginGoal(double distance) {
  start_distance_ = distance;
  since_start_ = 0;
}

void Progress::add(const Vector2& place, double distance) {
  ++ticks_;
  if (recent_.size() < remembered()) {
    recent_.push_back(place);
  } else {
    recent_[(ticks_ - 1) % remembered()] = place;
  }
  if (std::isnan(distance)) return;
  ++since_start_;
  const bool gets_on = start_distance_ - distance >= options_.progress_distance - ROUNDING;
  const bool fails = !gets_on && since_start_ >= span_;
  failures_ += fails ? 1 : 0;
  if (gets_on || fails) beginGoal(distance);
}

bool Progress::isStuck() const {
  if (recent_.size() < remembered()) return false;
  const Vector2& earliest = recent_[ticks_ % remembered()];
  const Vector2& latest = recent_[(ticks_ - 1) % remembered()];
  return (latest - earliest).norm() < options_.progress_distance - ROUNDING;
}

}  // namespace crowd
