#pragma once

#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Where a body is at a time, and how it moves there.
struct PathMotion {
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  Vector2 velocity = Vector2::Zero();  ///< [m/s], `map`
};

/// @brief Places at ascending times, between which a body moves straight at constant speed; it is in the world from the
/// first time to the last one.
class Track {
 public:
  /// @param times [s] @param places [m], `map`; one for each time
  /// @throws InputError unless there are as many places as times, at least one, and the times ascend
  Track(std::vector<double> times, std::vector<Vector2> places);

  const std::vector<double>& times() const { return times_; }
  const std::vector<Vector2>& places() const { return places_; }
  bool isPresent(double t) const { return times_.front() <= t && t <= times_.back(); }
  /// @brief Place and velocity at a time; those of the first time before it, and of the last one after it.
  PathMotion at(double t) const;
  /// @brief Length of the way up to a time [m].
  double walked(double t) const;
  /// @brief The greatest speed between two times [m/s].
  double maxSpeed() const { return max_speed_; }
  /// @brief The same places earlier, by a duration [s].
  Track earlier(double duration) const;

 private:
  /// The index of the last time that is not after t, or 0.
  std::size_t indexAt(double t) const;
  /// The velocity after the time of that index, or before the last one.
  Vector2 velocityAfter(std::size_t index) const;

  std::vector<double> times_;
  std::vector<Vector2> places_;
  std::vector<double> lengths_;  // of the way up to each time [m]
  double max_speed_ = 0.0;
};

}  // namespace crowd
