#include "navigation/way_claims.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double CELL = 1.0;  // of the grid [m]
constexpr double GAP = 1.2;   // between narrow places that belong together, as at the doors of a corridor [m]

}  // namespace

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
  grid_.build(CELL);
  sorted_.clear();
  for (std::size_t i = 0; i < claims_.size(); ++i) {
    const Claim& claim = claims_[grid_.body(i)];
    sorted_.push_back({claim.place, claim.direction, claim.ahead, claim.claimant, claim.is_narrow, claim.passage == 0});
  }
}

void WayClaims::addWay(const Agent& agent, const RemainingPath& path, const FloorRuler& floor) {
  Claimant claimant{agent.id, static_cast<std::uint32_t>(claims_.size())};
  addPlaces(agent, path, floor);
  tellDoors(claimant.first, agent.radius);
  bool has_narrow = false;
  bool is_first = true;  // narrow part
  std::uint32_t passage = 0;
  for (std::size_t i = claimant.first; i < claims_.size(); ++i) {
    Claim& claim = claims_[i];
    const bool begins = claim.is_narrow && i > claimant.first && !claims_[i - 1].is_narrow;
    if (begins) ++passage;
    claim.passage = passage;
    if (claim.is_narrow && !has_narrow) claimant.distance = claim.ahead;
    if (claim.is_narrow && is_first) claimant.length = claim.ahead - claimant.distance;
    has_narrow = has_narrow || claim.is_narrow;
    is_first = is_first && (claim.is_narrow || !has_narrow);
  }
  if (!has_narrow) {
    claims_.resize(claimant.first);
    return;
  }
  claimant.last = static_cast<std::uint32_t>(claims_.size());
  const auto heading_claim = claimant.first + static_cast<std::uint32_t>(HEADING_DISTANCE / STEP);
  const Vector2 offset = claims_[std::min(claimant.last - 1, heading_claim)].place - agent.pose.position;
  claimant.heading = offset.norm() > 0.0 ? Vector2(offset.normalized()) : claims_[claimant.first].direction;
  claimant.position = agent.pose.position;
  claimant.radius = agent.radius;
  claimants_.push_back(claimant);
  largest_radius_ = std::max(largest_radius_, agent.radius);
}

void WayClaims::addPlaces(const Agent& agent, const RemainingPath& path, const FloorRuler& floor) {
  const double passing_width = 2.0 * agent.radius + DOOR_ROOM;
  Claim claim;
  claim.claimant = static_cast<std::uint32_t>(claimants_.size());
  claim.room = DOOR_ROOM;
  Vector2 from = agent.pose.position;
  double passed = 0.0;  // length of the way to `from`
  const auto is_end = [&] { return claim.ahead > (claim.is_narrow ? MAX_LENGTH : LOOKAHEAD); };
  for (const Vector2& corner : path) {
    const double length = (corner - from).norm();
    for (; claim.ahead <= passed + length && !is_end(); claim.ahead += STEP) {
      if (length > 0.0) claim.direction = (corner - from) / length;
      claim.place = from + (claim.ahead - passed) * claim.direction;
      claim.is_narrow = false;
      if (!floor.hasClearance(claim.place, wideClearance(agent.radius))) {
        claim.width = floor.widthAt(claim.place, claim.direction, agent.radius, passing_width);
        claim.is_narrow = claim.width.total() < passing_width;
      }
      claims_.push_back(claim);
    }
    if (is_end()) break;
    passed += length;
    from = corner;
  }
}

/// In front of a door people of both sides come from all directions, and meet in the way of each other: they need more
/// room to pass than the lanes in a corridor. Doors are the short narrow parts.
void WayClaims::tellDoors(std::size_t first, double radius) {
  const auto is_narrow = [](const Claim& claim) { return claim.is_narrow; };
  auto begin = claims_.begin() + static_cast<std::ptrdiff_t>(first);
  while ((begin = std::find_if(begin, claims_.end(), is_narrow)) != claims_.end()) {
    auto end = begin + 1;
    for (auto next = end; next != claims_.end() && next->ahead - end->ahead <= GAP; ++next) {
      if (next->is_narrow) end = next + 1;
    }
    const bool is_door = static_cast<double>(end - begin) * STEP <= DOOR_LENGTH;
    for (; begin != end; ++begin) {
      if (is_door || !begin->is_narrow) continue;
      begin->room = PASSING_ROOM;
      begin->is_narrow = begin->width.total() < 2.0 * radius + PASSING_ROOM;
    }
  }
  const auto is_beyond = [](const Claim& claim) { return claim.ahead > LOOKAHEAD && !claim.is_narrow; };
  const auto of_agent = claims_.begin() + static_cast<std::ptrdiff_t>(first);
  claims_.erase(std::find_if(of_agent, claims_.end(), is_beyond), claims_.end());
}

}  // namespace crowd
