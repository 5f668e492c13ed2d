#pragma once

#include <utility>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Position of an obstacle as a function of time: at rest, on a straight line, or along waypoints. Evaluated in
/// closed form, so that it does not depend on the tick duration.
class ObstaclePath {
 public:
  enum class Kind { AT_REST, STRAIGHT, TO_AND_FRO, LOOP };

  static ObstaclePath atRest(const Vector2& position);
  /// @brief From `start` [m] with a constant velocity [m/s], without end.
  static ObstaclePath straight(const Vector2& start, const Vector2& velocity);
  /// @brief Along the points [m] and back, repeatedly, at constant speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath toAndFro(std::vector<Vector2> points, double speed);
  /// @brief Along the points [m] and from the last to the first, repeatedly, at constant speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath loop(std::vector<Vector2> points, double speed);

  struct Motion {
    Vector2 position = Vector2::Zero();  ///< [m], `map`
    Vector2 velocity = Vector2::Zero();  ///< [m/s], `map`
  };
  /// @brief Returns position and velocity t seconds after the start of the episode.
  Motion at(double t) const;
  Vector2 position(double t) const { return at(t).position; }
  Vector2 velocity(double t) const { return at(t).velocity; }
  /// @brief The path that begins where this one is after t seconds, and goes on as this one does. Of a path along
  /// waypoints it is a LOOP, also of one to and fro.
  ObstaclePath after(double t) const;
  Kind kind() const { return kind_; }
  bool moves() const { return kind_ != Kind::AT_REST; }
  /// @brief The points of the path in `map` [m]; the first is the start.
  const std::vector<Vector2>& points() const { return points_; }
  /// @brief The speed along TO_AND_FRO and LOOP paths [m/s].
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
};

}  // namespace crowd
