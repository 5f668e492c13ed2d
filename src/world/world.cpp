#include "world/world.h"

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/impact.h"
#include "social_crowd/errors.h"

namespace crowd {

World::World(const Scene& scene, StopRequest stop)
    : stop_(std::move(stop)),
      tick_duration_(scene.tick_duration),
      goal_tolerance_(scene.goal_tolerance),
      collision_radius_(scene.collision_radius),
      contact_(scene.contact),
      obstacles_(scene.obstacles),
      robots_(scene) {
  walls_.replaceAll(scene.walls);
  std::vector<Agent> agents;
  agents.reserve(scene.agents.size());
  for (const AgentStart& start : scene.agents) {
    agents.emplace_back(static_cast<AgentId>(agents.size()), start);
    has_groups_ = has_groups_ || start.group != NO_GROUP;
  }
  lasting_count_ = entered_count_ = active_count_ = agents.size();
  agents_.replace(std::move(agents));
  rebuildGrid();
}

Agent& World::walkingAgent(AgentId id) {
  if (!isActive(id)) throw InputError("there is no agent " + std::to_string(id) + " on its way");
  return agents_[id];
}

bool World::isActive(AgentId id) const {
  const Agent* const agent = agents_.find(id);
  return agent != nullptr && agent->isWalking();
}

std::string World::blockerAt(const Vector2& centre, double radius, bool agents_only, std::optional<AgentId> except,
                             std::optional<RobotId> except_robot) const {
  const double overlap = contact_ == Contact::SOLID ? TOUCH_TOLERANCE : CONTACT_OVERLAP;
  std::vector<std::uint32_t> found;
  grid_.findNear(centre, radius - overlap, found);
  for (const std::uint32_t body : found) {
    if (body < agents_.size() && agents_.idAt(body) == except) continue;
    if (body < agents_.size()) return "agent " + std::to_string(agents_.idAt(body));
    if (!agents_only) return nameOf(obstacles()[body - agents_.size()], body - agents_.size());
  }
  std::string robot = robots_.blockerAt(centre, radius - overlap, except_robot);
  if (!robot.empty() || agents_only) return robot;
  return walls_.index().isAnyWithin(centre, radius - overlap) ? "a wall" : "";
}

void World::rebuildGrid() {
  grid_.clear();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_.nth(i);
    if (agent.isPresent()) {
      grid_.add(agent.pose.position, agent.radius, static_cast<std::uint32_t>(i), agent.velocity);
    }
  }
  obstacles_.addTo(grid_, agents_.size());
  grid_.build(CELL_SIZE);
}

void World::updateGrid() {
  std::size_t number = 0;
  for (const Agent& agent : agents_) {
    if (agent.isPresent()) grid_.move(number++, agent.pose.position, agent.velocity);
  }
  obstacles_.moveIn(grid_, number);
  grid_.update();
}

std::vector<PersonMotion> World::recordedMotions() const {
  if (robots_.empty()) return {};
  std::vector<PersonMotion> motions = obstacles_.recordedMotions(endOfTick());
  if (motions.empty()) return motions;
  const auto is_there = [](const Agent& agent) { return agent.isPresent(); };
  const auto agents = static_cast<std::uint32_t>(std::count_if(agents_.begin(), agents_.end(), is_there));
  for (PersonMotion& motion : motions) motion.disc += agents;
  return motions;
}

}  // namespace crowd
