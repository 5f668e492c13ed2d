#pragma once

#include "geometry/drive.h"
#include "geometry/footprint.h"

namespace crowd {

/// @brief The motion of a robot's footprint in one tick: on an arc, or straight with a constant change of heading.
/// Times are shares of the tick.
class RobotSweep {
 public:
  /// @brief A motion at a constant twist. @param footprint must outlive it @param tick_duration [s]
  RobotSweep(const Footprint& footprint, const Pose& start, const Twist& twist, double tick_duration)
      : footprint_(&footprint), start_(start), twist_(twist), tick_duration_(tick_duration) {}
  /// @brief A straight motion from one pose to another.
  RobotSweep(const Footprint& footprint, const Pose& from, const Pose& to);

  const Footprint& footprint() const { return *footprint_; }
  Pose at(double share) const;
  /// @brief Upper bound of the displacement of any point of the footprint in a whole tick, from a time on [m].
  double pointSpeed(double from = 0.0) const;
  /// @brief Ends the motion at a time: the robot stands from then on.
  void stopAt(double share);
  /// @brief Time at which it was stopped; 1 if it was not.
  double stoppedAt() const { return stopped_at_; }

 private:
  const Footprint* footprint_;
  Pose start_;
  Twist twist_;
  double tick_duration_ = 0.0;
  bool is_straight_ = false;
  Vector2 way_ = Vector2::Zero();  // of a straight motion [m]
  double turn_ = 0.0;              // of a straight motion [rad]
  double stopped_at_ = 1.0;
};

/// @brief Time at which a sweep first touches a disc that moves straight, as firstTouch() of two discs: bodies in touch
/// touch at once if they get closer, and never if they do not. Found by conservative advancement on the exact
/// distance; contacts that begin and end within a thousandth of a tick may be missed.
/// @param position of the disc's centre at the time `from` [m] @param way displacement of the disc in a whole tick [m]
/// @param from [share of the tick] @return share of the tick from its start, at least `from`, or NO_IMPACT
double firstTouch(const RobotSweep& sweep, const Vector2& position, const Vector2& way, double radius, double from);
/// @brief The same for a segment that does not move.
double firstTouch(const RobotSweep& sweep, const Segment& segment, double from);
/// @brief The same for two robots.
double firstTouch(const RobotSweep& first, const RobotSweep& second, double from);

}  // namespace crowd
