#include "population/attractions.h"

#include <algorithm>

#include "population/facing.h"
#include "scenario/region_geometry.h"

namespace crowd {
namespace {

// An agent gives up if it is on the way to its place for longer than PATIENCE and DELAYS times what a straight walk
// takes.
constexpr double PATIENCE = 10.0;  // [s]
constexpr double DELAYS = 3.0;

bool includes(const std::vector<AgentId>& ids, AgentId id) { return std::binary_search(ids.begin(), ids.end(), id); }

void insert(AgentId id, std::vector<AgentId>& ids) {
  if (!includes(ids, id)) ids.insert(std::lower_bound(ids.begin(), ids.end(), id), id);
}

/// The part of an area in which somebody at a position looks for a place: people do not walk along a long window.
Region partNear(const Vector2& position, const AttractionDescription& attraction) {
  Region part = attraction.area;
  if (part.kind != Region::Kind::BOX) return part;
  const Vector2 reach = Vector2::Constant(2.0 * attraction.radius);
  part.first = part.first.cwiseMax(position - reach);
  part.second = part.second.cwiseMin(position + reach);
  return part;
}

/// The agents whose centre is within the radius of an area, by ascending id.
std::vector<AgentId> agentsNear(const AttractionDescription& attraction, const World& world) {
  const Region& area = attraction.area;
  const Vector2 middle = middleOf(area);
  const double extent = area.kind == Region::Kind::BOX ? (area.second - middle).norm() : area.radius.high;
  std::vector<std::uint32_t> bodies;
  world.grid().findNear(middle, extent + attraction.radius, bodies);
  std::vector<AgentId> near;
  for (const std::uint32_t body : bodies) {
    if (body >= world.agents().size()) continue;
    const Vector2& position = world.agents().nth(body).pose.position;
    if ((nearestPoint(area, position) - position).norm() <= attraction.radius)
      near.push_back(world.agents().idAt(body));
  }
  std::sort(near.begin(), near.end());
  return near;
}

}  // namespace

void Attractions::update(World& world, const PlacePicker& places, const PlacePicker::Reach& can_reach,
                         const MayStop& may_stop, RouteObserver& observer) {
  forget(world);
  const auto is_over = [&](Visit& visit) { return !goOn(visit, world); };
  visits_.erase(std::remove_if(visits_.begin(), visits_.end(), is_over), visits_.end());
  for (const Visit& visit : visits_) face(visit, world);
  std::vector<AgentId> visitors;
  for (const Visit& visit : visits_) visitors.push_back(visit.id);
  std::sort(visitors.begin(), visitors.end());
  for (std::size_t i = 0; i < attractions_.size(); ++i) {
    for (const AgentId id : agentsNear(attractions_[i], world)) {
      const Agent& agent = world.agents()[id];
      const bool is_on_its_way = agent.isWalking() && !agent.isHeld() && !agent.at_goal && may_stop(agent);
      if (!is_on_its_way || includes(known_[i], id) || includes(visitors, id) || !stops(i, agent, world)) continue;
      insert(id, known_[i]);
      if (begin(i, id, world, places, can_reach, observer)) insert(id, visitors);
    }
  }
}

void Attractions::forget(const World& world) {
  const auto is_gone = [&](AgentId id) { return !world.isActive(id); };
  for (std::vector<AgentId>& ids : known_) ids.erase(std::remove_if(ids.begin(), ids.end(), is_gone), ids.end());
}

bool Attractions::stops(std::size_t attraction, const Agent& agent, const World& world) const {
  const AttractionDescription& description = attractions_[attraction];
  KeyedRandom random = randomOf(attraction, agent.id, SHARE);
  if (random.uniform() >= description.share) return false;
  const Vector2& position = agent.pose.position;
  return world.walls().index().isClear(position, nearestPoint(description.area, position), 0.0);
}

bool Attractions::begin(std::size_t attraction, AgentId id, World& world, const PlacePicker& places,
                        const PlacePicker::Reach& can_reach, RouteObserver& observer) {
  Agent& agent = world.walkingAgent(id);
  const std::optional<Vector2> place = freePlace(attraction, agent, world, places, can_reach);
  if (!place) return false;
  observer.addDetour(agent, *place);
  agent.insertGoal(*place);
  const double straight = (*place - agent.pose.position).norm() / agent.max_speed;
  visits_.push_back({id, attraction, *place, false, world.time() + PATIENCE + DELAYS * straight});
  return true;
}

std::optional<Vector2> Attractions::freePlace(std::size_t attraction, const Agent& agent, const World& world,
                                              const PlacePicker& places, const PlacePicker::Reach& can_reach) const {
  const Region area = partNear(agent.pose.position, attractions_[attraction]);
  KeyedRandom random = randomOf(attraction, agent.id, PLACE);
  for (int tries = 0; tries < MAX_TRIES; ++tries) {
    const Vector2 place = area.draw(random);
    // An agent that is at its next goal there would go on, or leave, at once.
    if ((place - agent.goal()).norm() <= 2.0 * goal_tolerance_ || isTaken(place, agent, world)) continue;
    if (places.fits(place, agent.radius, world) && can_reach(agent.pose.position, place, agent.radius)) return place;
  }
  return std::nullopt;
}

bool Attractions::isTaken(const Vector2& place, const Agent& agent, const World& world) const {
  const auto overlaps = [&](const Vector2& other_place, const Agent& other) {
    return (other_place - place).norm() < agent.radius + other.radius + DRAWN_GAP;
  };
  const auto is_claimed = [&](const Visit& visit) { return overlaps(visit.place, world.agents()[visit.id]); };
  if (std::any_of(visits_.begin(), visits_.end(), is_claimed)) return true;
  std::vector<std::uint32_t> bodies;
  world.grid().findNear(place, agent.radius + DRAWN_GAP, bodies);
  return std::any_of(bodies.begin(), bodies.end(), [&](std::uint32_t body) {
    if (body >= world.agents().size()) return false;
    const Agent& other = world.agents().nth(body);
    const bool stands = other.isHeld() || !other.isWalking();
    return other.id != agent.id && stands && overlaps(other.pose.position, other);
  });
}

bool Attractions::goOn(Visit& visit, World& world) const {
  if (!world.isActive(visit.id)) return false;
  Agent& agent = world.walkingAgent(visit.id);
  const bool is_over = world.time() >= visit.end;
  if (visit.waits) {
    agent.setHeld(Hold::ATTRACTION, !is_over);
    return !is_over;
  }
  if (agent.goal() == visit.place) {
    if (is_over) agent.passGoal();
    return !is_over;
  }
  KeyedRandom random = randomOf(visit.attraction, visit.id, WAIT);
  visit.waits = true;
  visit.end = world.time() + attractions_[visit.attraction].wait.draw(random) - TIME_ROUNDING;
  agent.setHeld(Hold::ATTRACTION, true);
  return true;
}

void Attractions::face(const Visit& visit, World& world) const {
  if (!visit.waits) return;
  const AttractionDescription& attraction = attractions_[visit.attraction];
  if (attraction.face) return turnTowards(*attraction.face, visit.id, world);
  turnTowards(middleOf(attraction.area), visit.id, world);
}

void Attractions::leave(AgentId id, bool for_good, World& world) {
  for (std::vector<AgentId>& ids : known_) {
    if (for_good) insert(id, ids);
  }
  const auto found = std::find_if(visits_.begin(), visits_.end(), [id](const Visit& visit) { return visit.id == id; });
  if (found == visits_.end()) return;
  if (world.isActive(id)) {
    Agent& agent = world.walkingAgent(id);
    agent.setHeld(Hold::ATTRACTION, false);
    const bool walks_there = !found->waits && agent.goal() == found->place;
    if (walks_there && agent.next_goal + 1 < agent.goals.size()) agent.passGoal();  // else a user has set this goal
  }
  visits_.erase(found);
}

}  // namespace crowd
