#include <algorithm>

#include "social_crowd/world/world.h"

namespace crowd {

void World::perceive(const Vision& vision, Perceptions& perceptions, Workers& workers) {
  perceptions.tick = tick_;
  perceptions.tick_duration = tick_duration_;
  perceptions.bodies.clear();
  perceptions.walls.clear();
  listAgents(perceptions);
  lookers_.resize(std::max<std::size_t>(lookers_.size(), workers.count()));
  if (vision.max_bodies == 0) {
    // One list behind the other, however long: that takes a single worker.
    lookForSome(vision, 0, 0, watchers_.size(), perceptions);
    gatherWalls(1, perceptions);
    return;
  }
  perceptions.bodies.resize(vision.max_bodies * perceptions.agents.size());
  workers.run(watchers_.size(), [&](unsigned worker, std::size_t begin, std::size_t end) {
    lookForSome(vision, worker, begin, end, perceptions);
  });
  gatherWalls(workers.count(), perceptions);
}

void World::listAgents(Perceptions& perceptions) {
  perceptions.agents.clear();
  watchers_.clear();
  places_.resize(agents_.size());
  for (const Agent& agent : agents_) {
    const bool just_arrived = agent.hasArrived() && agent.arrival_tick == tick_;
    if (!agent.isWalking() && !just_arrived) continue;
    places_[agent.id] = static_cast<std::uint32_t>(perceptions.agents.size());
    if (just_arrived) watchers_.push_back(places_[agent.id]);  // not in the grid any more
    perceptions.agents.emplace_back().agent = agent.id;
  }
  disc_velocities_.resize(grid_.size());
  for (std::size_t disc = 0; disc < grid_.size(); ++disc) {
    const std::uint32_t body = grid_.body(disc);
    const bool is_agent = body < agents_.size();
    disc_velocities_[disc] = is_agent ? agents_[body].velocity : obstacle_velocities_[body - agents_.size()];
    if (is_agent) watchers_.push_back(places_[body]);
  }
}

void World::lookForSome(const Vision& vision, unsigned worker, std::size_t begin, std::size_t end,
                        Perceptions& perceptions) {
  Looker& looker = lookers_[worker];
  looker.begin = begin;
  looker.end = end;
  looker.walls.clear();
  for (std::size_t i = begin; i < end; ++i) {
    AgentPerception& self = perceptions.agents[watchers_[i]];
    look(vision, self, looker);
    std::size_t first = std::size_t{vision.max_bodies} * watchers_[i];
    if (vision.max_bodies == 0) {
      first = perceptions.bodies.size();
      perceptions.bodies.resize(first + looker.bodies.size());
    }
    self.first_body = static_cast<std::uint32_t>(first);
    std::copy(looker.bodies.begin(), looker.bodies.end(),
              perceptions.bodies.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

void World::gatherWalls(unsigned workers, Perceptions& perceptions) const {
  for (unsigned worker = 0; worker < workers; ++worker) {
    const Looker& looker = lookers_[worker];
    const auto before = static_cast<std::uint32_t>(perceptions.walls.size());
    perceptions.walls.insert(perceptions.walls.end(), looker.walls.begin(), looker.walls.end());
    if (before == 0) continue;
    for (std::size_t i = looker.begin; i < looker.end; ++i) perceptions.agents[watchers_[i]].first_wall += before;
  }
}

void World::look(const Vision& vision, AgentPerception& self, Looker& looker) const {
  const Agent& agent = agents_[self.agent];
  const Rotation frame(agent.pose.heading);
  self.pose = agent.pose;
  self.velocity = frame.intoFrame(agent.velocity);
  self.speed = agent.speed;
  self.radius = agent.radius;
  self.goal = frame.intoFrame(agent.goal() - agent.pose.position);
  self.goal_number = agent.goal_number;
  self.arrived = agent.hasArrived();
  self.acted = agent.acted;
  self.first_wall = static_cast<std::uint32_t>(looker.walls.size());
  findBodies(vision, agent, frame, looker);
  findWalls(vision, agent, frame, looker);
  if (vision.occlusion) {
    looker.occlusion.apply(looker.bodies, 0, looker.walls, self.first_wall, vision.radius);
    const bool too_many = vision.max_bodies > 0 && looker.bodies.size() > vision.max_bodies;
    if (too_many) looker.bodies.resize(vision.max_bodies);
  }
  self.body_count = static_cast<std::uint32_t>(looker.bodies.size());
  self.wall_count = static_cast<std::uint32_t>(looker.walls.size()) - self.first_wall;
}

void World::findBodies(const Vision& vision, const Agent& agent, const Rotation& frame, Looker& looker) const {
  // Where bodies hide each other, all of them are needed to tell whom one sees.
  const std::size_t most = vision.occlusion ? 0 : vision.max_bodies;
  looker.bodies.clear();
  for (const NearDisc& near : looker.search.findNearest(grid_, agent.pose.position, vision.radius, most, agent.id)) {
    looker.bodies.push_back({frame.intoFrame(grid_.centre(near.disc) - agent.pose.position),
                             frame.intoFrame(disc_velocities_[near.disc]), grid_.radius(near.disc),
                             grid_.body(near.disc) < agents_.size() ? BodyKind::AGENT : BodyKind::OBSTACLE});
  }
}

void World::findWalls(const Vision& vision, const Agent& agent, const Rotation& frame, Looker& looker) const {
  for (const Segment& wall : walls_) {
    if (distanceTo(wall, agent.pose.position) > vision.radius) continue;
    looker.walls.push_back(
        {frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

}  // namespace crowd
