#include "navigation/turn_taking.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "navigation/crowding.h"

namespace crowd {
namespace {

constexpr double SAME = 0.3;            // cosine of the angle up to which the directions of two ways are the same
constexpr double CLAIM_MARGIN = 0.1;    // beyond the width of the floor, up to which claims are in each other's way [m]
constexpr double ASIDE_GAP = 0.15;      // an agent that waits steps aside if another one passes nearer than this [m],
constexpr double ASIDE_LEAVE = 0.3;     // and until none passes nearer than this [m]
constexpr double ASIDE_DISTANCE = 1.0;  // of the point that it walks to [m]
constexpr double TURNED_BACK = -0.7;    // cosine from which the direction aside leads back towards who passes

/// Whether a place near a narrow one is on the floor across it, not behind a wall beside it.
bool isOnFloorAcross(const Claim& claim, const Vector2& place) {
  const double to_left = cross(claim.direction, place - claim.place);
  return to_left < claim.width.left + CLAIM_MARGIN && -to_left < claim.width.right + CLAIM_MARGIN;
}

bool isRightBehind(const Claimant& claimant, const Claimant& other) {
  const Vector2 offset = other.position - claimant.position;
  const double radii = claimant.radius + other.radius;
  const bool is_ahead = offset.dot(claimant.heading) > 0.0 && std::abs(cross(claimant.heading, offset)) < radii;
  return is_ahead && offset.norm() - radii < TurnTaking::QUEUE_GAP;
}

}  // namespace

void TurnTaking::update(World& world, const AgentMap<RemainingPath>& paths) {
  approaches_.follow(world.agents());
  if (world.tick() >= decision_tick_) {
    decide(world, paths);
    const double ticks = std::max(1.0, std::round(DECISION_TIME / world.tickDuration()));
    decision_tick_ = world.tick() + static_cast<std::uint64_t>(ticks);
  }
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    const Approach& approach = approaches_.nth(i);
    if (!approach.waits || !agent.isWalking() || agent.at_goal || agent.isHeld()) continue;
    Agent& waiting = world.walkingAgent(agent.id);
    waiting.yielding = approach.aside == Vector2::Zero();
    if (!waiting.yielding) waiting.setWaypoint(agent.pose.position + ASIDE_DISTANCE * approach.aside);
  }
}

void TurnTaking::decide(const World& world, const AgentMap<RemainingPath>& paths) {
  claims_.update(world, paths, *floor_);
  auto claimant = claims_.claimants().begin();
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const bool has_claims = claimant != claims_.claimants().end() && claimant->agent == world.agents().nth(i).id;
    if (has_claims) {
      noteApproach(world, *claimant++, approaches_.nth(i));
    } else {
      approaches_.nth(i) = Approach();
    }
  }
  rank();
  for (const Claimant& own : claims_.claimants()) {
    Approach& approach = approaches_[own.agent];
    approach.waits = mustWait(own, trafficOf(own));
    approach.aside = approach.waits && !own.isInside() ? sideOf(world, own) : Vector2::Zero();
  }
}

/// The time begins anew behind each narrow part.
void TurnTaking::noteApproach(const World& world, const Claimant& claimant, Approach& approach) {
  if (approach.begin == NEVER || (approach.was_inside && !claimant.isInside())) {
    approach.begin = world.time();
    const auto people = static_cast<double>(countPeopleNear(world, claimant.position, CROWD_RADIUS, near_));
    approach.priority_time = approach.begin - CROWD_TIME * people;
  }
  approach.was_inside = claimant.isInside();
}

TurnTaking::Traffic TurnTaking::trafficOf(const Claimant& claimant) {
  Traffic traffic;
  (claimant.isInside() ? traffic.same_inside : traffic.same) = &claimant;
  bool is_narrow = false;
  for (const Claim& claim : claims_.of(claimant)) {
    if (is_narrow && !claim.is_narrow) break;  // the first narrow part only
    is_narrow = claim.is_narrow;
    if (is_narrow) addTraffic(claimant, claim, traffic);
  }
  return traffic;
}

void TurnTaking::addTraffic(const Claimant& claimant, const Claim& claim, Traffic& traffic) {
  const double width = claim.width.total();
  const double reach = std::max(2.0 * WayClaims::STEP, width + CLAIM_MARGIN);
  claims_.visitNear(claim.place, reach, [&](const NearClaim& other) {
    const Claimant& its = claims_.claimants()[other.claimant];
    if (&its == &claimant || !isOnFloorAcross(claim, other.place)) return;
    const double cosine = other.direction.dot(claim.direction);
    const bool is_inside = its.isInside() && other.is_first_passage;
    if (cosine < OPPOSITE) {
      if (!other.is_narrow || width >= claimant.radius + its.radius + claim.room) return;
      replaceIfFirst(is_inside ? traffic.opposite_inside : traffic.opposite, its);
    } else if (cosine > SAME) {
      const bool is_ahead =
          its.distance < claimant.distance || (its.distance == claimant.distance && its.agent < claimant.agent);
      if (is_ahead && !its.isInside() && !traffic.is_queued) traffic.is_queued = isRightBehind(claimant, its);
      if (is_inside) {
        replaceIfFirst(traffic.same_inside, its);
      } else if (other.is_narrow) {
        replaceIfFirst(traffic.same, its);
      }
    }
  });
}

/// Of two agents with the same priority time, the one with the lower id goes first.
void TurnTaking::rank() {
  const auto rank_of = [&](std::uint32_t claimant) {
    return std::make_pair(approaches_[claims_.claimants()[claimant].agent].priority_time, claimant);
  };
  order_.resize(claims_.claimants().size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return rank_of(a) < rank_of(b); });
  ranks_.resize(order_.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) ranks_[order_[i]] = i;
}

bool TurnTaking::hasPriority(const Claimant& a, const Claimant& b) const {
  const Claimant* first = claims_.claimants().data();
  return ranks_[static_cast<std::size_t>(&a - first)] < ranks_[static_cast<std::size_t>(&b - first)];
}

void TurnTaking::replaceIfFirst(const Claimant*& first, const Claimant& other) const {
  if (first == nullptr || hasPriority(other, *first)) first = &other;
}

bool TurnTaking::mustWait(const Claimant& claimant, const Traffic& traffic) const {
  if (claimant.isInside()) {
    return traffic.opposite_inside != nullptr && hasPriority(*traffic.opposite_inside, *traffic.same_inside);
  }
  if (traffic.is_queued) return true;
  if (claimant.distance >= WAITING_DISTANCE) return false;
  if (traffic.opposite_inside != nullptr) return true;
  if (traffic.opposite == nullptr) return false;
  if (traffic.same_inside == nullptr) return hasPriority(*traffic.opposite, *traffic.same);
  const double same_begin = approaches_[traffic.same->agent].begin;
  return approaches_[traffic.opposite->agent].begin < same_begin - TURN_TIME - claimant.length;
}

/// The direction in which an agent that waits clears the way of those who come towards it; zero if none comes. It keeps
/// the side that it chose.
Vector2 TurnTaking::sideOf(const World& world, const Claimant& claimant) {
  const Agent& agent = world.agents()[claimant.agent];
  const Vector2& aside = approaches_[agent.id].aside;
  const bool was_aside = aside != Vector2::Zero();
  const double reach = was_aside ? ASIDE_LEAVE : ASIDE_GAP;
  const NearClaim* nearest = nullptr;
  double least = reach;
  claims_.visitNear(agent.pose.position, agent.radius + claims_.largestRadius() + reach, [&](const NearClaim& other) {
    const Claimant& its = claims_.claimants()[other.claimant];
    const bool is_oncoming = other.direction.dot(claimant.heading) <= OPPOSITE && other.ahead <= WayClaims::LOOKAHEAD;
    if (&its == &claimant || !is_oncoming) return;
    const double gap = (other.place - agent.pose.position).norm() - agent.radius - its.radius;
    if (gap >= least || !world.walls().index().isClear(agent.pose.position, other.place, 0.0)) return;
    least = gap;
    nearest = &other;
  });
  if (nearest == nullptr) return Vector2::Zero();
  if (was_aside && aside.dot(nearest->direction) >= TURNED_BACK) return aside;
  const Vector2 offset = agent.pose.position - nearest->place;
  const Vector2 left(-nearest->direction.y(), nearest->direction.x());
  return offset.dot(left) > 0.0 ? left : Vector2(-left);
}

}  // namespace crowd
