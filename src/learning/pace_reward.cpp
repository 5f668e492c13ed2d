#include "social_crowd/learning/pace_reward.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/common/numbers.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

bool touchesAnybody(const PerceivedBodiesView& bodies, double radius) {
  const double* const xs = bodies.xs();
  const double* const ys = bodies.ys();
  const double* const radii = bodies.radii();
  std::int64_t touches = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    touches |= std::sqrt(xs[i] * xs[i] + ys[i] * ys[i]) < radius + radii[i] ? 1 : 0;
  }
  return touches != 0;
}

}  // namespace

double PaceReward::conflictPart(const Perception& after) const {
  const double time = timeToContact(after, after.self.velocity);
  const bool arrives_first = time > after.self.goal.norm() / after.self.speed;
  if (arrives_first) return 0.0;
  return -parameters_.conflict_price * std::max(0.0, 1.0 - time / parameters_.conflict_time);
}

double PaceReward::operator()(const AgentPerception& before, const Perception& after, Row /*row*/) const {
  const AgentPerception& self = after.self;
  const double progress = distanceGained(before, self) / (self.speed * after.tick_duration);
  const double turn = std::abs(wrapAngle(self.pose.heading - before.pose.heading));
  const double rest = 1.0 - self.velocity.norm() / self.speed;
  double reward = progress - 1.0 - parameters_.turn_price * turn - parameters_.rest_price * rest;
  if (touchesAnybody(after.bodies, self.radius)) reward -= parameters_.contact_price;
  return self.arrived ? reward : reward + conflictPart(after);
}

std::string PaceReward::spec() const {
  return std::string("{type: ") + TYPE + ", turn_price: " + toText(parameters_.turn_price) +
         ", conflict_price: " + toText(parameters_.conflict_price) +
         ", conflict_time: " + toText(parameters_.conflict_time) + ", rest_price: " + toText(parameters_.rest_price) +
         ", contact_price: " + toText(parameters_.contact_price) + "}";
}

std::shared_ptr<const Reward> readPaceReward(YamlMap& map) {
  map.allow({"type", "turn_price", "conflict_price", "conflict_time", "rest_price", "contact_price"});
  PaceReward::Parameters parameters;
  const auto read_price = [&](const char* key, double& price) {
    price = map.number(key, NumberRule::NOT_NEGATIVE, price);
  };
  read_price("turn_price", parameters.turn_price);
  read_price("conflict_price", parameters.conflict_price);
  parameters.conflict_time = map.number("conflict_time", NumberRule::POSITIVE, parameters.conflict_time);
  read_price("rest_price", parameters.rest_price);
  read_price("contact_price", parameters.contact_price);
  return std::make_shared<PaceReward>(parameters);
}

}  // namespace crowd
