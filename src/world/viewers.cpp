#include "world/viewers.h"

namespace crowd {

const Viewers& Viewers::all(const World& world) {
  list_.clear();
  places_.resize(world.agents().size());
  std::uint32_t place = 0;
  for (std::uint32_t body = 0; body < places_.size(); ++body) {
    const Agent& agent = world.agents().nth(body);
    if (!world.isPerceiving(agent)) continue;
    places_[body] = place++;
    if (!agent.isPresent()) list_.push_back({&agent, body, places_[body]});  // not in the grid
  }
  const NeighbourGrid& grid = world.grid();
  for (std::size_t disc = 0; disc < grid.size(); ++disc) {
    const std::uint32_t body = grid.body(disc);
    if (body >= places_.size()) continue;
    const Agent& agent = world.agents().nth(body);
    if (world.isPerceiving(agent)) list_.push_back({&agent, body, places_[body]});
  }
  return *this;
}

const Viewers& Viewers::among(const World& world, std::size_t first, std::size_t last) {
  list_.clear();
  for (std::size_t disc = first; disc < last; ++disc) {
    const std::uint32_t body = world.grid().body(disc);
    if (body >= world.agents().size()) continue;
    const Agent& agent = world.agents().nth(body);
    if (agent.perceives && agent.isWalking()) list_.push_back({&agent, body, static_cast<std::uint32_t>(list_.size())});
  }
  return *this;
}

const Viewers& Viewers::one(const World& world, std::optional<AgentId> id) {
  list_.clear();
  if (id) list_.push_back({&world.agents()[*id], static_cast<std::uint32_t>(world.agents().positionOf(*id)), 0});
  return *this;
}

const Viewers& Viewers::inPlaceOf(RobotId id, const World& world, const Vector2& goal) {
  constexpr std::uint32_t NO_BODY = UINT32_MAX;
  const Robot& robot = world.robots()[id];
  robot_.id = agentIdOf(id);
  robot_.pose = robot.pose;
  robot_.ahead = unitVector(robot.pose.heading);
  robot_.velocity = robot.velocity;
  robot_.max_speed = robot.start.limits.max_speed;
  robot_.radius = robot.perceived_radius;
  robot_.present_goal = goal;
  robot_.acted = true;
  list_.assign(1, {&robot_, NO_BODY, 0});
  return *this;
}

}  // namespace crowd
