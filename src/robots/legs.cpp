#include "robots/legs.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

constexpr double LEG_RADIUS = 0.06;  // [m]
constexpr double HALF_WIDTH = 0.1;   // between the legs [m]
constexpr double SWING = 0.15;       // [m]
constexpr double CYCLE = 1.3;        // way of one step with each leg [m]

}  // namespace

void addLegs(const Pose& pose, double walked, double radius, BodyNumber body, std::vector<ScanTarget>& targets) {
  const double leg = std::min(LEG_RADIUS, radius / 2.0);
  const double room = radius - leg;  // for the centres of the legs
  const double aside = std::min(HALF_WIDTH, room);
  const double swing = std::min(SWING, std::sqrt(std::max(0.0, room * room - aside * aside)));
  const double ahead = swing * portable::sin(2.0 * PI * walked / CYCLE);
  const Rotation frame(pose.heading);
  for (const double side : {1.0, -1.0}) {
    targets.push_back({pose.position + frame.outOfFrame({side * ahead, side * aside}), leg, body});
  }
}

void Gait::observe(const World& world) {
  walked_.follow(world.agents());
  for (std::size_t i = 0; i < walked_.size(); ++i) {
    walked_.nth(i) += world.agents().nth(i).velocity.norm() * world.tickDuration();
  }
}

}  // namespace crowd
