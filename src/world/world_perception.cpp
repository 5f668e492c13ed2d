#include <algorithm>

#include "social_crowd/common/prefetch.h"
#include "social_crowd/world/world.h"

namespace crowd {

void World::perceive(const Vision& vision, Perceptions& perceptions) {
  const std::size_t count = active_count_ + just_arrived_count_;
  perceptions.agents.resize(count);
  perceptions.order.clear();
  begin(vision, count, looker_, perceptions);
  if (grid_.isList()) {
    lookOneByOne(vision, perceptions);
  } else {
    lookInOrder(vision, perceptions);
  }
  std::swap(perceptions.walls, looker_.walls);
}

void World::perceiveAgent(const Vision& vision, std::optional<AgentId> id, Perceptions& perceptions) {
  perceptions.agents.resize(id ? 1 : 0);
  perceptions.order.clear();
  begin(vision, perceptions.agents.size(), looker_, perceptions);
  for (AgentPerception& self : perceptions.agents) {
    self.agent = *id;
    look(vision, agents_[*id], 0, looker_, self, perceptions);
  }
  std::swap(perceptions.walls, looker_.walls);
}

inline void World::lookOneByOne(const Vision& vision, Perceptions& perceptions) {
  AgentPerception* const perceived = perceptions.agents.data();
  std::size_t count = 0;
  for (const Agent& agent : agents_) {
    if (!isPerceiving(agent)) continue;
    perceived[count].agent = agent.id;
    look(vision, agent, count, looker_, perceived[count], perceptions);
    ++count;
  }
}

void World::lookInOrder(const Vision& vision, Perceptions& perceptions) {
  std::uint32_t listed = 0;
  for (const Agent& agent : agents_) {
    if (isPerceiving(agent)) perceptions.agents[listed++].agent = agent.id;
  }
  orderAgents(perceptions);
  const std::size_t count = perceptions.agents.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i + PREFETCH_AHEAD < count) {
      const AgentPerception& next = perceptions.agents[perceptions.order[i + PREFETCH_AHEAD]];
      prefetch(next);
      prefetch(agents_[next.agent]);
    }
    AgentPerception& self = perceptions.agents[perceptions.order[i]];
    look(vision, agents_[self.agent], i, looker_, self, perceptions);
  }
}

void World::orderAgents(Perceptions& perceptions) {
  perceptions.order.resize(perceptions.agents.size());
  std::uint32_t* ordered = perceptions.order.data();
  for (std::uint32_t place = 0; place < perceptions.agents.size(); ++place) {
    const AgentId agent = perceptions.agents[place].agent;
    places_[agent] = place;
    if (hasJustArrived(agents_[agent])) *ordered++ = place;  // not in the grid any more
  }
  const std::size_t agents = places_.size();
  for (std::size_t disc = 0; disc < grid_.size(); ++disc) {
    const std::uint32_t body = grid_.body(disc);
    if (body < agents) *ordered++ = places_[body];
  }
}

inline void World::begin(const Vision& vision, std::size_t agents, Looker& looker, Perceptions& perceptions) const {
  perceptions.tick = tick_;
  perceptions.tick_duration = tick_duration_;
  perceptions.bodies.resize(vision.max_bodies * agents);
  looker.walls.clear();
}

void World::perceiveSome(const Vision& vision, std::size_t first, std::size_t last, Looker& looker,
                         Perceptions& perceptions) const {
  perceptions.order.clear();
  begin(vision, last - first, looker, perceptions);
  std::size_t count = 0;
  for (std::size_t disc = first; disc < last; ++disc) {
    if (disc + PREFETCH_AHEAD < grid_.size()) {
      const std::uint32_t next = grid_.body(disc + PREFETCH_AHEAD);
      if (next < agents_.size()) prefetch(agents_[next]);
    }
    const std::uint32_t body = grid_.body(disc);
    if (body >= agents_.size()) continue;
    // Made when needed: obstacles are among the bodies, and agents made for these would be made again at every tick.
    if (count == perceptions.agents.size()) perceptions.agents.emplace_back();
    AgentPerception& self = perceptions.agents[count];
    self.agent = body;
    look(vision, agents_[body], count++, looker, self, perceptions);
  }
  perceptions.agents.resize(count);
  std::swap(perceptions.walls, looker.walls);
}

inline void World::look(const Vision& vision, const Agent& agent, std::size_t before, Looker& looker,
                        AgentPerception& self, Perceptions& perceptions) const {
  // With no limit the bodies of all stand one behind the other, however many.
  const std::size_t first = vision.max_bodies > 0 ? vision.max_bodies * before : perceptions.bodies.size();
  // Where bodies hide each other, all of them are needed to tell whom one sees.
  const std::size_t most = vision.occlusion ? 0 : vision.max_bodies;
  const Rotation frame(agent.ahead);
  const auto found = looker.search.findNearest(grid_, agent.pose.position, vision.radius, most, agent.id);
  self.first_body = static_cast<std::uint32_t>(first);
  self.body_count = static_cast<std::uint32_t>(found.size());
  self.first_wall = static_cast<std::uint32_t>(looker.walls.size());
  lookAtSelf(agent, frame, self);
  if (!walls_.empty()) findWalls(vision, agent, frame, looker);
  if (vision.occlusion) {
    looker.near.resize(found.size());
    findBodies(found, agent, 0, looker.near);
    hide(vision, self, looker);
  }
  self.wall_count = static_cast<std::uint32_t>(looker.walls.size()) - self.first_wall;
  if (vision.max_bodies == 0) perceptions.bodies.resize(first + self.body_count);
  if (!vision.occlusion) return findBodies(found, agent, first, perceptions.bodies);
  for (std::size_t i = 0; i < looker.bodies.size(); ++i) perceptions.bodies.set(first + i, looker.bodies[i]);
}

inline void World::lookAtSelf(const Agent& agent, const Rotation& frame, AgentPerception& self) const {
  self.pose = agent.pose;
  self.velocity = frame.intoFrame(agent.velocity);
  self.speed = agent.speed;
  self.radius = agent.radius;
  self.goal = frame.intoFrame(agent.goal() - agent.pose.position);
  self.goal_number = agent.goal_number;
  self.arrived = agent.hasArrived();
  self.acted = agent.acted;
}

inline void World::findBodies(const View<NearDisc>& found, const Agent& agent, std::size_t first,
                              PerceivedBodies& bodies) const {
  const Vector2& place = agent.pose.position;
  const Vector2& ahead = agent.ahead;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::uint32_t disc = found[i].disc;
    const NeighbourGrid::Motion& motion = grid_.motions()[disc];
    const double dx = motion.x - place.x();
    const double dy = motion.y - place.y();
    bodies.xs()[first + i] = dx * ahead.x() + dy * ahead.y();
    bodies.ys()[first + i] = dy * ahead.x() - dx * ahead.y();
    bodies.vxs()[first + i] = motion.vx * ahead.x() + motion.vy * ahead.y();
    bodies.vys()[first + i] = motion.vy * ahead.x() - motion.vx * ahead.y();
    bodies.radii()[first + i] = grid_.radius(disc);
    bodies.kinds()[first + i] = grid_.body(disc) < agents_.size() ? BodyKind::AGENT : BodyKind::OBSTACLE;
  }
}

inline void World::findWalls(const Vision& vision, const Agent& agent, const Rotation& frame, Looker& looker) const {
  for (const Segment& wall : walls_) {
    if (distanceTo(wall, agent.pose.position) > vision.radius) continue;
    looker.walls.push_back(
        {frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

/// Leaves what is seen of the looker's bodies and walls.
inline void World::hide(const Vision& vision, AgentPerception& self, Looker& looker) const {
  const PerceivedBodiesView near(looker.near, 0, looker.near.size());
  looker.bodies.assign(near.begin(), near.end());
  looker.occlusion.apply(looker.bodies, 0, looker.walls, self.first_wall, vision.radius);
  const bool too_many = vision.max_bodies > 0 && looker.bodies.size() > vision.max_bodies;
  if (too_many) looker.bodies.resize(vision.max_bodies);
  self.body_count = static_cast<std::uint32_t>(looker.bodies.size());
}

}  // namespace crowd
