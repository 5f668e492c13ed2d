#pragma once

#include <cstdint>
#include <optional>

#include "common/random.h"
#include "scenario/population_spec.h"

namespace crowd {

/// @brief Progress of one agent on its route. It does not know the world: its owner reports when a waypoint is reached.
///
/// A leg is the way to one waypoint. The owner reads waypoint(), calls beginWait() when the agent is there, and
/// advance() when it has waited or was served.
class RouteFollower {
 public:
  /// @param route must outlive the follower @param random of this agent and this route
  RouteFollower(const RouteDescription& route, const KeyedRandom& random);

  /// @brief The present waypoint; never a ONE_OF, but the alternative that was drawn.
  const WaypointDescription& waypoint() const { return *waypoint_; }
  /// @brief Generator for the place of the present leg.
  KeyedRandom random() const { return random_.with(leg_).with(PLACE); }
  /// @brief Goes on to the next waypoint. @return false if the route is over
  bool advance();

  /// @brief The agent has reached the place of its waypoint. @param now [s]
  void beginWait(double now);
  bool isWaiting() const { return until_.has_value(); }
  /// @brief Whether the wait is over. @param now [s]
  bool hasWaited(double now) const { return until_ && now >= *until_; }

  /// @brief Whether the route begins again after its last waypoint.
  bool repeats() const { return route_->repeat; }
  /// @brief Number of completed waypoints.
  std::uint64_t passed() const { return leg_; }

 private:
  enum Choice : std::uint64_t { ALTERNATIVE = 0, PLACE = 1, WAIT = 2 };

  void choose();

  const RouteDescription* route_;
  KeyedRandom random_;
  std::uint64_t leg_ = 0;  // since the first one, also of routes that repeat
  const WaypointDescription* waypoint_ = nullptr;
  std::optional<double> until_;  // end of the wait [s]
};

}  // namespace crowd
