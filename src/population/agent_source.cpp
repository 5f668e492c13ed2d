#include "population/agent_source.h"

#include <limits>

namespace crowd {

std::optional<AgentStart> AgentSource::next(const World& world, const PlacePicker& places,
                                            const PlacePicker::Reach& can_reach) {
  if (parties_.leaderOfNext() && !world.isActive(*parties_.leaderOfNext())) parties_.endParty();
  const bool is_due = parties_.leaderOfNext() || schedule_.next() <= world.time() + TIME_ROUNDING;
  if (!is_due || schedule_.isOver()) return std::nullopt;
  const AgentGroup& group = source_->agents;
  const KeyedRandom random = random_.with(created_);
  KeyedRandom body = random.with(BODY);
  AgentStart start;
  start.max_speed = group.max_speed.draw(body);
  start.radius = group.radius.draw(body);
  drawKind(group, population_->kinds, random.with(KIND), start);
  drawReaction(group, random.with(REACTION), start);
  start.hurry = group.hurry.drawUnlessFixed(body);
  const auto place = drawPlace(start.radius, world, places);
  if (!place || !places.connects(*place, group, *population_)) return std::nullopt;
  start.position = *place;
  const auto id = static_cast<AgentId>(world.enteredCount());
  start.leader = leaderOf(group, parties_.next(id, std::numeric_limits<std::size_t>::max()));
  if (parties_.leads()) start.group = id;
  if (start.leader) {
    start.group = groupOf(*start.leader);
    start.leaves = false;
    start.goals = {start.position};
  } else {
    drawGoals(start, random, world, places, can_reach);
  }
  ++created_;
  schedule_.advance();
  return start;
}

/// In the area, or beside the leader if there is room.
std::optional<Vector2> AgentSource::drawPlace(double radius, const World& world, const PlacePicker& places) const {
  const KeyedRandom random = random_.with(created_).with(START).with(world.tick());
  if (const std::optional<AgentId> leader = parties_.leaderOfNext()) {
    const Vector2& beside = world.agents()[*leader].pose.position;
    auto place = places.drawStart(placesBeside(beside, radius), radius, random.with(PARTY), world);
    if (place && world.walls().index().isClear(beside, *place, 0.0)) return place;
  }
  return places.drawStart(source_->agents.position, radius, random, world);
}

void AgentSource::drawGoals(AgentStart& start, const KeyedRandom& random, const World& world, const PlacePicker& places,
                            const PlacePicker::Reach& can_reach) const {
  const AgentGroup& group = source_->agents;
  start.route = group.route;
  Vector2 from = start.position;
  for (const Region& goal : group.goals) {
    from = places.drawGoal(goal, from, start.radius, random.with(GOAL).with(start.goals.size()), world, can_reach);
    start.goals.push_back(from);
  }
  if (group.opposite) start.goals = {2.0 * *group.opposite - start.position};
  if (group.route) start.goals = {start.position};
}

}  // namespace crowd
