#pragma once

#include "geometry/drive.h"
#include "geometry/footprint.h"
#include "geometry/wall_sliding.h"

namespace crowd {

/// @brief The motion of a robot's footprint in one tick: on an arc, or straight with a constant change of heading.
/// Times are shares of the tick. After slideAt() only times from then on are valid.
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
  /// @brief The same if it may slide along walls.
  double slidingSpeed(const WallSliding& sliding) const;
  /// @brief Ends the motion at a time: the robot stands from then on.
  void stopAt(double share);
  /// @brief Time at which it was stopped; 1 if it was not.
  double stoppedAt() const { return stopped_at_; }
  /// @brief Replaces the motion at a time by that along walls which it touches, see slideAlongWalls(). It must have
  /// been made from a twist.
  void slideAt(double share, const std::vector<WallContact>& contacts, const WallSliding& sliding);
  /// @brief Whether walls have changed the motion.
  bool hasSlid() const { return has_slid_; }
  /// @brief The motion at a time.
  BodyMotion motionAt(double share) const;

 private:
  const Footprint* footprint_;
  Pose start_;
  Twist twist_;
  double tick_duration_ = 0.0;
  bool is_straight_ = false;
  Vector2 way_ = Vector2::Zero();  // of a straight motion [m]
  double turn_ = 0.0;              // of a straight motion [rad]
  double since_ = 0.0;             // time of the start
  bool has_slid_ = false;
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
/// @brief The time of that contact with a segment if it lasts until `to`, however short it is, else `to`: a touch of
/// another body may be in the middle of it. @param to [share of the tick], at least `from`
double touchUntil(const RobotSweep& sweep, const Segment& segment, double from, double to);
/// @brief The same as firstTouch() for two robots.
double firstTouch(const RobotSweep& first, const RobotSweep& second, double from);

}  // namespace crowd
