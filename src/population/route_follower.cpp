#include "population/route_follower.h"

namespace crowd {

RouteFollower::RouteFollower(const RouteDescription& route, const KeyedRandom& random)
    : route_(&route), random_(random) {
  choose();
}

bool RouteFollower::advance() {
  ++leg_;
  until_.reset();
  if (!route_->repeat && leg_ >= route_->waypoints.size()) return false;
  choose();
  return true;
}

void RouteFollower::choose() {
  waypoint_ = &route_->waypoints[leg_ % route_->waypoints.size()];
  if (waypoint_->kind != WaypointDescription::Kind::ONE_OF) return;
  const auto count = static_cast<std::uint32_t>(waypoint_->alternatives.size());
  waypoint_ = &waypoint_->alternatives[random_.with(leg_).with(ALTERNATIVE).below(count)];
}

void RouteFollower::beginWait(double now) {
  KeyedRandom random = random_.with(leg_).with(WAIT);
  until_ = now + waypoint_->wait.draw(random) - TIME_ROUNDING;
}

}  // namespace crowd
