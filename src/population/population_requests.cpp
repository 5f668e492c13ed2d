// What users change, and what ends or interrupts what people do: other routes, gates, alarms, attractions and robots.

#include <algorithm>
#include <string>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "population/changes/route_check.h"
#include "population/population.h"
#include "social_crowd/errors.h"

namespace crowd {

void Population::setRoute(AgentId id, const std::string& route, WayLengths* ways, World& world,
                          RouteObserver& observer) {
  const auto index = findName(description_->routes, route);
  if (!index) throw InputError(unknownNameText("route", route, namesOf(description_->routes)));
  if (ways != nullptr && world.isActive(id)) {
    const Agent& agent = world.agents()[id];
    const std::string name = "agent " + std::to_string(id);
    RouteCheck(name, agent.radius, *description_, places_, *ways, world)
        .require(description_->routes[*index], agent.pose.position);
    Member candidate;
    candidate.route.emplace(description_->routes[*index], randomOfRoute(id, world.tick()));
    const Vector2 goal = goalOfLeg(candidate, agent.pose.position, agent.radius, world);
    ways->requireWay(name, world, agent.pose.position, goal, agent.radius);
  }
  hold(beginRoute(id, description_->routes[*index], world, observer), world);
}

Population::Member& Population::beginRoute(AgentId id, const RouteDescription& route, World& world,
                                           RouteObserver& observer) {
  world.walkingAgent(id);  // throws for unknown agents
  leaveGroup(id, world, observer);
  world.walkingAgent(id).leaves = false;
  attractions_.leave(id, false, world);
  reactions_.leave(id, false, world);
  for (Queue& queue : queues_) queue.leave(id);
  Member* member = find(id);
  if (member == nullptr) {
    const auto before = [](const Member& other, AgentId sought) { return other.id < sought; };
    member = &*members_.emplace(std::lower_bound(members_.begin(), members_.end(), id, before));
    member->id = id;
  }
  // The goal of another route is not that of a leg of this one.
  member->route.emplace(route, randomOfRoute(id, world.tick()));
  observer.setEndless(id, member->route->repeats());
  beginLeg(*member, world);
  observer.recordGoal(world.agents()[id], world.agents()[id].goal());
  return *member;
}

void Population::leaveGroup(AgentId id, World& world, RouteObserver& observer) {
  followers_.drop(id, world, observer);
  Agent& agent = world.walkingAgent(id);
  if (agent.group == NO_GROUP || followers_.leads(id, world)) return;
  agent.group = NO_GROUP;
  agent.setPace(Pace::GROUP, 1.0);
  agent.clearWaypoint();
}

void Population::dropRoute(AgentId id, World& world, RouteObserver& observer) {
  leaveGroup(id, world, observer);
  attractions_.leave(id, false, world);
  reactions_.leave(id, false, world);
  Member* const member = find(id);
  if (member == nullptr || !member->route) return;
  for (Queue& queue : queues_) queue.leave(id);
  member->route.reset();
  world.walkingAgent(id).leaves = true;
  observer.setEndless(id, false);
  hold(*member, world);
}

bool Population::setGate(const std::string& gate, bool open, World& world) {
  const auto index = findName(description_->gates, gate);
  if (!index) throw InputError(unknownNameText("gate", gate, namesOf(description_->gates)));
  gates_[*index].setOpen(open, world.time());
  gates_[*index].update(world);
  return gates_[*index].isOpen();
}

void Population::raiseAlarms(World& world, RouteObserver& observer) {
  for (const std::size_t number : alarms_.takeDue(world.time())) raise(number, world, observer);
}

std::size_t Population::raiseAlarm(AlarmDescription alarm, World& world, RouteObserver& observer) {
  for (const AgentId id : agentsOf(alarm, world)) {
    if (world.agents()[id].own_speed * alarm.speed_factor <= limits::SPEED.most) continue;
    throw InputError("speed_factor: expected one with which agent " + std::to_string(id) + " walks at most " +
                     toText(limits::SPEED.most) + " m/s, got " + toText(alarm.speed_factor));
  }
  return raise(alarms_.add(std::move(alarm)), world, observer);
}

std::size_t Population::raise(std::size_t number, World& world, RouteObserver& observer) {
  const AlarmDescription& alarm = alarms_[number];
  const KeyedRandom random(seed_, KeyedRandom::ALARMS, {number});
  const std::vector<AgentId> agents = agentsOf(alarm, world);
  for (const AgentId id : agents) {
    world.stopRequest().throwIfMade();
    Agent& agent = world.walkingAgent(id);
    reactions_.leave(id, alarm.route.has_value(), world);
    agent.setPace(Pace::HURRY, std::min(alarm.speed_factor, limits::SPEED.most / agent.own_speed));
    if (!alarm.route) continue;
    distraction_.end(id, world);
    Member& member = beginRoute(id, *alarm.route, world, observer);
    attractions_.leave(id, true, world);
    KeyedRandom of_agent = random.with(id);
    member.reacts_at = world.time() + alarm.reaction_time.draw(of_agent) - TIME_ROUNDING;
    hold(member, world);
  }
  for (AgentSource& source : sources_) {
    if (endsSource(alarm, source.description())) source.end();
  }
  return agents.size();
}

void Population::updateAttractions(World& world, RouteObserver& observer) {
  if (attractions_.empty()) return;
  const auto may_stop = [this](const Agent& agent) {
    // Followers stop where their leader does.
    return !followers_.contains(agent.id) && !reactions_.isReacting(agent.id) && !isQueuing(agent.id);
  };
  attractions_.update(world, places_, ways_.reachIn(world), may_stop, observer);
}

void Population::updateReactions(World& world) {
  if (reactions_.empty()) return;
  using Freedom = RobotReactions::Freedom;
  const auto freedom_of = [this](const Agent& agent) {
    if (isQueuing(agent.id)) return Freedom::NOTHING;
    return followers_.contains(agent.id) ? Freedom::STAY : Freedom::WALK;
  };
  reactions_.update(world, freedom_of, [&](AgentId id) { attractions_.leave(id, false, world); });
}

bool Population::isQueuing(AgentId id) {
  const Member* const member = find(id);
  return member != nullptr && member->route && member->route->waypoint().kind == WaypointDescription::Kind::QUEUE;
}

}  // namespace crowd
