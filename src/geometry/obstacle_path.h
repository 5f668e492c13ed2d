#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "geometry/track.h"

namespace crowd {

/// @brief Position of an obstacle as a function of time: at rest, on a straight line, along waypoints, or on a
/// recorded track. Evaluated in closed form, so that it does not depend on the tick duration.
class ObstaclePath {
 public:
  enum class Kind { AT_REST, STRAIGHT, TO_AND_FRO, LOOP, RECORDED };

  static ObstaclePath atRest(const Vector2& position);
  /// @brief From `start` [m] with a constant velocity [m/s], without end.
  static ObstaclePath straight(const Vector2& start, const Vector2& velocity);
  /// @brief Along the points [m] and back, repeatedly, at constant speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath toAndFro(std::vector<Vector2> points, double speed);
  /// @brief Along the points [m] and from the last to the first, repeatedly, at constant speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath loop(std::vector<Vector2> points, double speed);

  /// @brief On a track, whose times are those since the start of the episode. The obstacle is in the world only during
  /// the track. @param track not null
  static ObstaclePath recorded(std::shared_ptr<const Track> track);

  using Motion = PathMotion;
  /// @brief Returns position and velocity t seconds after the start of the episode.
  Motion at(double t) const;
  Vector2 position(double t) const { return at(t).position; }
  Vector2 velocity(double t) const { return at(t).velocity; }
  /// @brief The path that begins where this one is after t seconds, and goes on as this one does. Of a path along
  /// waypoints it is a LOOP, also of one to and fro.
  ObstaclePath after(double t) const;
  Kind kind() const { return kind_; }
  bool moves() const { return kind_ != Kind::AT_REST; }
  /// @brief Whether the obstacle is in the world t seconds after the start of the episode.
  bool isPresent(double t) const { return track_ == nullptr || track_->isPresent(t); }
  /// @brief The points of the path in `map` [m]; the first is the start.
  const std::vector<Vector2>& points() const { return track_ == nullptr ? points_ : track_->places(); }
  /// @brief The track of a RECORDED path, else null.
  const Track* track() const { return track_.get(); }
  /// @brief The speed along TO_AND_FRO and LOOP paths, the greatest one of RECORDED paths [m/s].
  double speed() const { return speed_; }

 private:
  ObstaclePath(Kind kind, std::vector<Vector2> points, const Vector2& velocity, double speed);
  /// A leg of the path: start [m], direction, and the path lengths at its start and end [m].
  struct Leg {
    Vector2 from;
    Vector2 unit;
    double begin = 0.0;
    double end = 0.0;
  };
  /// The leg on which the obstacle is after t seconds, and how far it is on it [m].
  std::pair<const Leg&, double> legAt(double t) const;

  Kind kind_ = Kind::AT_REST;
  std::vector<Vector2> points_;
  Vector2 velocity_ = Vector2::Zero();
  double speed_ = 0.0;
  std::vector<Leg> legs_;
  std::shared_ptr<const Track> track_;
};

}  // namespace crowd
