#pragma once

#include <cstdint>
#include <optional>

#include "geometry/geometry.h"

namespace crowd {

/// @brief What is wrong with a pose of a robot that moves elsewhere.
enum class PoseProblem : std::uint8_t {
  NOT_FINITE = 0,  ///< or not within limits::PLACE; ignored
  BACKWARDS = 1,   ///< older than the last one; ignored, unless the last one is of a later clock
  JUMP = 2,        ///< too far from the last one for its greatest speed; used, without a motion between them
  GAP = 3,         ///< long after the last one; used, at a standstill, without a motion between them
};

/// @brief Numbers of poses of a robot that moves elsewhere, in an episode.
struct PoseCounts {
  std::uint64_t taken = 0;
  std::uint64_t not_finite = 0;
  std::uint64_t backwards = 0;
  std::uint64_t jumps = 0;
  std::uint64_t gaps = 0;
  std::uint64_t stale = 0;  ///< times at which poses ceased to arrive
};

/// @brief A robot that moves elsewhere (in Gazebo, or a real one): makes its pose at the end of a tick from the poses
/// that arrive. It has no clock. Not thread-safe.
class ExternalRobot {
 public:
  static constexpr double MAX_GAP = 0.5;         ///< between two poses, and until a pose is stale [s]
  static constexpr double JUMP_SPEED = 1.5;      ///< of its greatest speed; faster is a jump
  static constexpr double JUMP_TOLERANCE = 0.1;  ///< shorter is no jump [m]

  /// @brief Where the robot is at a time.
  struct State {
    Pose pose;                           ///< in `map`
    Vector2 velocity = Vector2::Zero();  ///< `map`, at most JUMP_SPEED times the greatest speed [m/s]
    bool jumped = false;                 ///< it did not move there since the last call
    bool stale = false;                  ///< the stamp of its last pose is not within MAX_GAP of the time
  };

  /// @param max_speed [m/s] @param tick_duration [s]
  ExternalRobot(double max_speed, double tick_duration) : max_speed_(max_speed), tick_duration_(tick_duration) {}

  /// @brief An episode begins: counts begin at zero, and the robot is put where its last pose is.
  /// @param max_speed [m/s] @param tick_duration [s]
  void begin(double max_speed, double tick_duration);
  /// @brief Takes a pose in `map` that was measured at `stamp` [s]. A pose with the stamp of the last one is ignored.
  /// @return what is wrong with it
  std::optional<PoseProblem> take(const Pose& pose, double stamp);
  /// @brief The state at a time [s]: the last pose, moved on with its velocity for at most one tick, unless that is
  /// beyond limits::PLACE; at a standstill if it is stale. Empty before the first pose.
  std::optional<State> at(double time);

  const PoseCounts& counts() const { return counts_; }
  /// @brief Whether the robot was stale at the last call of at(); without any pose, from MAX_GAP after the first call.
  bool isStale() const { return stale_; }
  /// @brief Stamp of the last pose [s]; empty: there was none.
  const std::optional<double>& stamp() const { return stamp_; }

 private:
  double max_speed_;
  double tick_duration_;
  std::optional<double> stamp_;  // of the last pose [s]
  std::optional<double> began_;  // time of the first call of at() in the episode [s]
  std::optional<double> asked_;  // time of the last call of at() [s]
  Pose pose_;
  Vector2 velocity_ = Vector2::Zero();
  bool jumped_ = true;  // since the last call of at(); the first pose is one
  bool stale_ = false;
  PoseCounts counts_;
};

}  // namespace crowd
