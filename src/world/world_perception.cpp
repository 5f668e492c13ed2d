#include <algorithm>

#include "social_crowd/world/world.h"

namespace crowd {

void World::perceive(const Vision& vision, Perceptions& perceptions) {
  perceptions.tick = tick_;
  perceptions.tick_duration = tick_duration_;
  perceptions.agents.clear();
  perceptions.bodies.clear();
  perceptions.walls.clear();
  for (const Agent& agent : agents_) {
    const bool just_arrived = agent.hasArrived() && agent.arrival_tick == tick_;
    if (!agent.isWalking() && !just_arrived) continue;
    const Rotation frame(agent.pose.heading);
    AgentPerception self;
    self.agent = agent.id;
    self.pose = agent.pose;
    self.velocity = frame.intoFrame(agent.velocity);
    self.speed = agent.speed;
    self.radius = agent.radius;
    self.goal = frame.intoFrame(agent.goal() - agent.pose.position);
    self.goal_number = agent.goal_number;
    self.arrived = agent.hasArrived();
    self.acted = agent.acted;
    self.first_body = static_cast<std::uint32_t>(perceptions.bodies.size());
    perceiveBodies(agent, frame, vision, perceptions);
    self.first_wall = static_cast<std::uint32_t>(perceptions.walls.size());
    perceiveWalls(agent, frame, vision, perceptions);
    if (vision.occlusion) {
      occlusion_.apply(perceptions.bodies, self.first_body, perceptions.walls, self.first_wall, vision.radius);
      const std::size_t most = self.first_body + vision.max_bodies;
      if (vision.max_bodies > 0 && perceptions.bodies.size() > most) perceptions.bodies.resize(most);
    }
    self.body_count = static_cast<std::uint32_t>(perceptions.bodies.size()) - self.first_body;
    self.wall_count = static_cast<std::uint32_t>(perceptions.walls.size()) - self.first_wall;
    perceptions.agents.push_back(self);
  }
}

void World::perceiveBodies(const Agent& agent, const Rotation& frame, const Vision& vision, Perceptions& perceptions) {
  found_.clear();
  grid_.findNear(agent.pose.position, vision.radius, found_);
  near_.clear();
  const auto is_agent = [&](std::uint32_t body) { return body < agents_.size(); };
  for (const std::uint32_t body : found_) {
    if (body == agent.id) continue;
    const Vector2& centre = is_agent(body) ? agents_[body].pose.position : obstacle_positions_[body - agents_.size()];
    const double radius = is_agent(body) ? agents_[body].radius : obstacles_[body - agents_.size()].radius;
    near_.push_back({(centre - agent.pose.position).norm() - radius, body});
  }
  const auto nearer = [](const NearBody& a, const NearBody& b) {
    return a.rim_distance < b.rim_distance || (a.rim_distance == b.rim_distance && a.body < b.body);
  };
  std::sort(near_.begin(), near_.end(), nearer);
  // Where bodies hide each other, all of them are needed to tell whom one sees.
  const bool limited = vision.max_bodies > 0 && !vision.occlusion;
  if (limited && near_.size() > vision.max_bodies) near_.resize(vision.max_bodies);
  for (const NearBody& near : near_) {
    PerceivedBody seen;
    if (is_agent(near.body)) {
      const Agent& other = agents_[near.body];
      seen = {frame.intoFrame(other.pose.position - agent.pose.position), frame.intoFrame(other.velocity), other.radius,
              BodyKind::AGENT};
    } else {
      const std::size_t other = near.body - agents_.size();
      seen = {frame.intoFrame(obstacle_positions_[other] - agent.pose.position),
              frame.intoFrame(obstacle_velocities_[other]), obstacles_[other].radius, BodyKind::OBSTACLE};
    }
    perceptions.bodies.push_back(seen);
  }
}

void World::perceiveWalls(const Agent& agent, const Rotation& frame, const Vision& vision,
                          Perceptions& perceptions) const {
  for (const Segment& wall : walls_) {
    if (distanceTo(wall, agent.pose.position) > vision.radius) continue;
    perceptions.walls.push_back(
        {frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

}  // namespace crowd
