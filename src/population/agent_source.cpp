#include "population/agent_source.h"

namespace crowd {

std::optional<AgentStart> AgentSource::next(const World& world, const PlacePicker& places,
                                            const PlacePicker::Reach& can_reach) {
  if (schedule_.next() > world.time() + TIME_ROUNDING) return std::nullopt;
  const AgentGroup& group = source_->agents;
  const KeyedRandom random = random_.with(created_);
  KeyedRandom body = random.with(BODY);
  AgentStart start;
  start.max_speed = group.max_speed.draw(body);
  start.radius = group.radius.draw(body);
  start.hurry = group.hurry.drawUnlessFixed(body);
  const auto place = places.drawStart(group.position, start.radius, random.with(START).with(world.tick()), world);
  if (!place || !places.connects(*place, group, *population_)) return std::nullopt;
  start.position = *place;
  start.route = group.route;
  Vector2 from = start.position;
  for (const Region& goal : group.goals) {
    from = places.drawGoal(goal, from, start.radius, random.with(GOAL).with(start.goals.size()), world, can_reach);
    start.goals.push_back(from);
  }
  if (group.opposite) start.goals = {2.0 * *group.opposite - start.position};
  if (group.route) start.goals = {start.position};
  start.heading = bearingOf(start.goals.front() - start.position);
  ++created_;
  schedule_.advance();
  return start;
}

}  // namespace crowd
