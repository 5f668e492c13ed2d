#pragma once

#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Where an obstacle is at any time: at rest, on a straight line, or along waypoints. A closed
/// function of time, so that it does not depend on the tick.
class ObstaclePath {
 public:
  enum class Kind { AT_REST, STRAIGHT, TO_AND_FRO, LOOP };

  static ObstaclePath atRest(const Vector2& position);
  /// @brief From `start` with a constant velocity [m/s], for ever.
  static ObstaclePath straight(const Vector2& start, const Vector2& velocity);
  /// @brief Along the points and back, for ever, with a speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath toAndFro(std::vector<Vector2> points, double speed);
  /// @brief Along the points and from the last to the first, for ever, with a speed [m/s].
  /// @throws InputError unless two points differ and the speed is above 0.
  static ObstaclePath loop(std::vector<Vector2> points, double speed);

  /// @brief Position in `map` [m], t seconds after the episode's start.
  Vector2 position(double t) const;
  /// @brief Velocity in `map` [m/s], t seconds after the episode's start.
  Vector2 velocity(double t) const;
  Kind kind() const { return kind_; }
  bool moves() const { return kind_ != Kind::AT_REST; }
  /// @brief The points of the path; the first is the start [m].
  const std::vector<Vector2>& points() const { return points_; }

 private:
  ObstaclePath(Kind kind, std::vector<Vector2> points, const Vector2& velocity, double speed);
  /// A leg of the path: from where, which way, and how far along the path it begins and ends [m].
  struct Leg {
    Vector2 from;
    Vector2 unit;
    double begin = 0.0;
    double end = 0.0;
  };
  const Leg& legAt(double distance) const;
  double along(double t) const;

  Kind kind_ = Kind::AT_REST;
  std::vector<Vector2> points_;
  Vector2 velocity_ = Vector2::Zero();
  double speed_ = 0.0;
  std::vector<Leg> legs_;
};

}  // namespace crowd
