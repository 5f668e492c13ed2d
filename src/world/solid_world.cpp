// The motions of bodies in a solid world.

#include "world/world.h"

namespace crowd {

void World::computeSolidMotions(const BodyRange& moving) {
  discs_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_.nth(i);
    if (!agent.isPresent()) continue;
    const Vector2 way = moving.contains(i) ? Vector2(tick_duration_ * agent.velocity) : Vector2::Zero();
    discs_.push_back({agent.pose.position, way, agent.radius, true});
  }
  obstacles_.addDiscs(endOfTick(), moving.contains(agents_.size()), discs_);
  robots_.addDiscs(discs_);
  solid_motion_.move(discs_, walls_.index());
}

void World::carryOutSolidMotions(const BodyRange& moving) {
  const std::vector<SolidMotion::Outcome>& outcomes = solid_motion_.outcomes();
  auto outcome = outcomes.begin();
  robots_.noteSolidContacts(agents_.values(), discs_, solid_motion_);
  if (moving.contains(agents_.size())) robots_.noteRecordedContacts(recordedMotions(), solid_motion_);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    Agent& agent = agents_.nth(i);
    if (!agent.isPresent()) continue;
    if (outcome->diverted) {
      const Vector2 velocity = (outcome->position - agent.pose.position) / tick_duration_;
      if (moving.contains(i)) {
        agent.blocked = !agent.velocity.isZero(0.0);
        agent.blocked_moves += agent.blocked ? 1 : 0;
        agent.velocity = velocity;
      } else {
        agent.velocity += velocity;  // pushed after its own move
      }
    }
    agent.pose.position = outcome->position;
    agent.bumped = agent.bumped || outcome->touched;
    ++outcome;
  }
  robots_.replaceMotions(solid_motion_.sweeps());
}

}  // namespace crowd
