#include "robots/personal_space.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

Vector2 directionOf(const Vector2& velocity) {
  const double speed = velocity.norm();
  return speed > 0.0 ? Vector2(velocity / speed) : Vector2(1.0, 0.0);
}

double reachOf(const PersonalSpaceSpec& spec) {
  return spec.cutoff > spec.amplitude ? -1.0 : std::sqrt(2.0 * portable::log(spec.amplitude / spec.cutoff));
}

}  // namespace

bool PersonalSpaceSpec::operator==(const PersonalSpaceSpec& other) const {
  return amplitude == other.amplitude && cutoff == other.cutoff && spread == other.spread && stretch == other.stretch &&
         horizon == other.horizon;
}

PersonalSpace::PersonalSpace(const PersonalSpaceSpec& spec, const Vector2& place, const Vector2& velocity)
    : spec_(spec),
      place_(place),
      frame_(directionOf(velocity)),
      way_(velocity.norm() * spec.horizon),
      spread_ahead_(spec.spread * (1.0 + spec.stretch * velocity.norm())),
      reach_(reachOf(spec)) {}

double PersonalSpace::costAt(const Vector2& point) const {
  const Vector2 local = frame_.intoFrame(point - place_);
  const double along = local.x() < 0.0 ? local.x() / spec_.spread : std::max(0.0, local.x() - way_) / spread_ahead_;
  const double across = local.y() / spec_.spread;
  const double cost = spec_.amplitude * portable::exp(-0.5 * (along * along + across * across));
  return cost < spec_.cutoff ? 0.0 : cost;
}

Bounds PersonalSpace::bounds() const {
  if (reach_ < 0.0) return {place_ + Vector2::Ones(), place_ - Vector2::Ones()};
  const double back = -reach_ * spec_.spread;
  const double front = way_ + reach_ * spread_ahead_;
  const double side = reach_ * spec_.spread;
  Bounds bounds = {place_, place_};
  for (const Vector2& corner :
       {Vector2(back, side), Vector2(back, -side), Vector2(front, side), Vector2(front, -side)}) {
    const Vector2 point = place_ + frame_.outOfFrame(corner);
    bounds.low = bounds.low.cwiseMin(point);
    bounds.high = bounds.high.cwiseMax(point);
  }
  return bounds;
}

}  // namespace crowd
