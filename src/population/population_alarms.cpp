// What ends what people do, or interrupts it: alarms, attractions and robots.

#include <algorithm>
#include <string>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "population/population.h"
#include "social_crowd/errors.h"

namespace crowd {

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
