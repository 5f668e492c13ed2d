#include "geometry/track.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {

Track::Track(std::vector<double> times, std::vector<Vector2> places)
    : times_(std::move(times)), places_(std::move(places)) {
  if (times_.empty() || times_.size() != places_.size()) throw InputError("expected a place for each time of a track");
  if (std::adjacent_find(times_.begin(), times_.end(), std::greater_equal<>()) != times_.end()) {
    throw InputError("expected a track whose times ascend");
  }
  for (std::size_t i = 0; i < times_.size(); ++i) {
    max_speed_ = std::max(max_speed_, velocityAfter(i).norm());
    lengths_.push_back(i == 0 ? 0.0 : lengths_.back() + (places_[i] - places_[i - 1]).norm());
  }
}

std::size_t Track::indexAt(double t) const {
  const auto later = std::upper_bound(times_.begin(), times_.end(), t);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, later - times_.begin() - 1));
}

Vector2 Track::velocityAfter(std::size_t index) const {
  if (times_.size() == 1) return Vector2::Zero();
  const std::size_t i = std::min(index, times_.size() - 2);
  return (places_[i + 1] - places_[i]) / (times_[i + 1] - times_[i]);
}

PathMotion Track::at(double t) const {
  const std::size_t index = indexAt(t);
  const Vector2 velocity = velocityAfter(index);
  if (!isPresent(t) || index + 1 == times_.size()) return {places_[index], velocity};
  return {places_[index] + (t - times_[index]) * velocity, velocity};
}

double Track::walked(double t) const {
  const std::size_t index = indexAt(t);
  return lengths_[index] + (at(t).position - places_[index]).norm();
}

Track Track::earlier(double duration) const {
  std::vector<double> times = times_;
  for (double& time : times) time -= duration;
  return {std::move(times), places_};
}

}  // namespace crowd
