#include "navigation/way_claims.h"

#include <algorithm>

namespace crowd {

void WayClaims::update(const World& world, const AgentMap<RemainingPath>& paths, const FloorRuler& floor) {
  claimants_.clear();
  claims_.clear();
  largest_radius_ = 0.0;
  grid_.clear();
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (agent.isWalking() && !agent.at_goal && !agent.isHeld()) addWay(agent, paths.nth(i), floor);
  }
  for (std::uint32_t i = 0; i < claims_.size(); ++i) grid_.add(claims_[i].place, 0.0, i);
  grid_.build(1.0);
}

void WayClaims::addWay(const Agent& agent, const RemainingPath& path, const FloorRuler& floor) {
  const double passing_width = passingWidth(agent.radius, agent.radius);
  Claimant claimant{agent.id, static_cast<std::uint32_t>(claims_.size())};
  Claim claim;
  claim.claimant = static_cast<std::uint32_t>(claimants_.size());
  bool has_narrow = false;
  bool is_first = true;  // narrow part
  Vector2 from = agent.pose.position;
  double passed = 0.0;  // length of the way to `from`
  const auto is_end = [&] { return claim.ahead > (claim.is_narrow ? MAX_LENGTH : LOOKAHEAD); };
  for (const Vector2& corner : path) {
    const double length = (corner - from).norm();
    for (; claim.ahead <= passed + length && !is_end(); claim.ahead += STEP) {
      if (length > 0.0) claim.direction = (corner - from) / length;
      claim.place = from + (claim.ahead - passed) * claim.direction;
      const bool was_narrow = claim.is_narrow;
      claim.is_narrow = false;
      if (!floor.hasClearance(claim.place, wideClearance(agent.radius))) {
        claim.width = floor.widthAt(claim.place, claim.direction, agent.radius, passing_width).total();
        claim.is_narrow = claim.width < passing_width;
      }
      if (claim.is_narrow && !was_narrow && claim.ahead > 0.0) ++claim.passage;
      if (claim.is_narrow && !has_narrow) claimant.distance = claim.ahead;
      if (claim.is_narrow && is_first) claimant.length = claim.ahead - claimant.distance;
      has_narrow = has_narrow || claim.is_narrow;
      is_first = is_first && (claim.is_narrow || !has_narrow);
      claims_.push_back(claim);
    }
    if (is_end()) break;
    passed += length;
    from = corner;
  }
  if (!has_narrow) {
    claims_.resize(claimant.first);
    return;
  }
  claimant.last = static_cast<std::uint32_t>(claims_.size());
  const auto heading_claim = claimant.first + static_cast<std::uint32_t>(HEADING_DISTANCE / STEP);
  const Vector2 offset = claims_[std::min(claimant.last - 1, heading_claim)].place - agent.pose.position;
  claimant.heading = offset.norm() > 0.0 ? Vector2(offset.normalized()) : claims_[claimant.first].direction;
  claimants_.push_back(claimant);
  largest_radius_ = std::max(largest_radius_, agent.radius);
}

const std::vector<const Claim*>& WayClaims::near(const Vector2& place, double distance) {
  found_.clear();
  near_.clear();
  grid_.findNear(place, distance, found_);
  for (const std::uint32_t claim : found_) near_.push_back(&claims_[claim]);
  return near_;
}

}  // namespace crowd
