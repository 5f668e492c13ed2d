// What ends what people do, or interrupts it: alarms and attractions.

#include "population/population.h"

namespace crowd {

void Population::raiseAlarms(World& world, RouteObserver& observer) {
  for (const std::size_t number : alarms_.takeDue(world.time())) raise(number, world, observer);
}

std::size_t Population::raise(std::size_t number, World& world, RouteObserver& observer) {
  const AlarmDescription& alarm = alarms_[number];
  const KeyedRandom random(seed_, KeyedRandom::ALARMS, {number});
  const std::vector<AgentId> agents = agentsOf(alarm, world);
  for (const AgentId id : agents) {
    world.stopRequest().throwIfMade();
    world.walkingAgent(id).setPace(Pace::HURRY, alarm.speed_factor);
    if (!alarm.route) continue;
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
    const Member* const member = find(agent.id);
    return member == nullptr || !member->route || member->route->waypoint().kind != WaypointDescription::Kind::QUEUE;
  };
  attractions_.update(world, places_, ways_.reachIn(world), may_stop, observer);
}

}  // namespace crowd
