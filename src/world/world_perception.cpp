#include <algorithm>

#include "social_crowd/world/world.h"

namespace crowd {
namespace {

constexpr std::size_t PREFETCH_AHEAD = 4;      // [bodies]
constexpr std::uint32_t NO_BODY = UINT32_MAX;  // in the grid

/// Loads an agent into the cache: those that are neighbours in the grid are anywhere in memory.
inline void prefetch(const Agent& agent) {
#if defined(__GNUC__)
  constexpr std::size_t CACHE_LINE = 64;  // [bytes]
  const auto* const first = reinterpret_cast<const char*>(&agent);
  for (std::size_t offset = 0; offset < sizeof(Agent); offset += CACHE_LINE) __builtin_prefetch(first + offset);
#endif
}

}  // namespace

template <typename Work>
inline void World::forEachInGrid(std::size_t first, std::size_t last, const Work& work) const {
  for (std::size_t disc = first; disc < last; ++disc) {
    if (disc + PREFETCH_AHEAD < grid_.size()) {
      const std::uint32_t next = grid_.body(disc + PREFETCH_AHEAD);
      if (next < agents_.size()) prefetch(agents_.nth(next));
    }
    const std::uint32_t body = grid_.body(disc);
    if (body < agents_.size() && agents_.nth(body).perceives) work(agents_.nth(body), body);
  }
}

void World::perceive(const Vision& vision, Perceptions& perceptions) {
  const std::size_t count = active_count_ + just_arrived_count_;
  perceptions.agents.resize(count);
  beginPerceptions(vision, count, workspace_, perceptions);
  std::uint32_t place = 0;
  std::size_t written = 0;
  for (std::uint32_t body = 0; body < agents_.size(); ++body) {
    const Agent& agent = agents_.nth(body);
    if (!isPerceiving(agent)) continue;
    AgentPerception& self = perceptions.agents[place];
    self.agent = agent.id;
    places_[body] = place++;
    if (agent.isWalking()) continue;
    perceiveOne(vision, agent, body, written++, workspace_, self, perceptions);  // not in the grid
  }
  forEachInGrid(0, grid_.size(), [&](const Agent& agent, std::uint32_t body) {
    perceiveOne(vision, agent, body, written++, workspace_, perceptions.agents[places_[body]], perceptions);
  });
  std::swap(perceptions.walls, workspace_.walls);
}

void World::perceiveAgent(const Vision& vision, std::optional<AgentId> id, Perceptions& perceptions) {
  perceptions.agents.resize(id ? 1 : 0);
  beginPerceptions(vision, perceptions.agents.size(), workspace_, perceptions);
  for (AgentPerception& self : perceptions.agents) {
    self.agent = *id;
    const auto body = static_cast<std::uint32_t>(agents_.positionOf(*id));
    perceiveOne(vision, agents_.nth(body), body, 0, workspace_, self, perceptions);
  }
  std::swap(perceptions.walls, workspace_.walls);
}

void World::perceiveRobot(const Vision& vision, RobotId id, const Vector2& goal, PerceptionWorkspace& workspace,
                          Perceptions& perceptions) const {
  const Robot& robot = robots_.at(id);
  Agent agent;
  agent.id = agentIdOf(id);
  agent.pose = robot.pose;
  agent.ahead = unitVector(robot.pose.heading);
  agent.velocity = robot.velocity;
  agent.max_speed = robot.start.limits.max_speed;
  agent.radius = robot.perceived_radius;
  agent.present_goal = goal;
  agent.acted = true;
  perceptions.agents.resize(1);
  perceptions.last = false;
  perceptions.agents.front().agent = agent.id;
  beginPerceptions(vision, 1, workspace, perceptions);
  perceiveOne(vision, agent, NO_BODY, 0, workspace, perceptions.agents.front(), perceptions);
  std::swap(perceptions.walls, workspace.walls);
}

inline void World::beginPerceptions(const Vision& vision, std::size_t agents, PerceptionWorkspace& workspace,
                                    Perceptions& perceptions) const {
  perceptions.tick = tick_;
  perceptions.tick_duration = tick_duration_;
  perceptions.neighbours.resize(vision.max_neighbours * agents);
  workspace.walls.clear();
}

void World::perceiveSome(const Vision& vision, std::size_t first, std::size_t last, PerceptionWorkspace& workspace,
                         Perceptions& perceptions) const {
  beginPerceptions(vision, last - first, workspace, perceptions);
  std::size_t count = 0;
  forEachInGrid(first, last, [&](const Agent& agent, std::uint32_t body) {
    // Grown on demand: sizing by the number of bodies, which include obstacles, would construct elements in each tick.
    if (count == perceptions.agents.size()) perceptions.agents.emplace_back();
    AgentPerception& self = perceptions.agents[count];
    self.agent = agent.id;
    perceiveOne(vision, agent, body, count++, workspace, self, perceptions);
  });
  perceptions.agents.resize(count);
  std::swap(perceptions.walls, workspace.walls);
}

inline void World::perceiveOne(const Vision& vision, const Agent& agent, std::uint32_t body, std::size_t before,
                               PerceptionWorkspace& workspace, AgentPerception& self, Perceptions& perceptions) const {
  // Without a limit the neighbours of all agents are contiguous.
  const std::size_t first = vision.max_neighbours > 0 ? vision.max_neighbours * before : perceptions.neighbours.size();
  // Occlusion needs all bodies in range to determine the visible ones.
  const std::size_t max_count = vision.occlusion ? 0 : vision.max_neighbours;
  const Rotation frame(agent.ahead);
  auto found = workspace.search.findNearest(grid_, agent.pose.position, vision.radius, max_count, body);
  if (hasRobots()) found = withRobots(found, vision, max_count, agent, workspace);
  self.first_neighbour = static_cast<std::uint32_t>(first);
  self.neighbour_count = static_cast<std::uint32_t>(found.size());
  self.first_wall = static_cast<std::uint32_t>(workspace.walls.size());
  perceiveSelf(agent, frame, self);
  if (!walls().empty()) findWalls(vision, agent, frame, workspace);
  if (vision.occlusion) {
    workspace.near.resize(found.size());
    writeNeighbours(found, agent, 0, workspace.near);
    applyOcclusion(vision, self, workspace);
  }
  self.wall_count = static_cast<std::uint32_t>(workspace.walls.size()) - self.first_wall;
  if (vision.max_neighbours == 0) perceptions.neighbours.resize(first + self.neighbour_count);
  if (!vision.occlusion) return writeNeighbours(found, agent, first, perceptions.neighbours);
  for (std::size_t i = 0; i < workspace.neighbours.size(); ++i)
    perceptions.neighbours.set(first + i, workspace.neighbours[i]);
}

Span<NearDisc> World::withRobots(const Span<NearDisc>& found, const Vision& vision, std::size_t max_count,
                                 const Agent& agent, PerceptionWorkspace& workspace) const {
  std::vector<NearDisc>& near = workspace.near_discs;
  near.assign(found.begin(), found.end());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Robot& robot = robots_[i];
    const NearDisc disc = {(robot.pose.position - agent.pose.position).norm() - robot.perceived_radius,
                           static_cast<std::uint32_t>(grid_.size() + i)};
    if (!robot.start.perceived || agent.id == agentIdOf(static_cast<RobotId>(i))) continue;
    if (disc.rim_distance > vision.radius) continue;
    const auto farther = [&](const NearDisc& other) { return other.rim_distance > disc.rim_distance; };
    near.insert(std::find_if(near.begin(), near.end(), farther), disc);
  }
  if (max_count > 0 && near.size() > max_count) near.resize(max_count);
  return {near.data(), near.size()};
}

Neighbour World::seenRobot(const Robot& robot, const Agent& agent) {
  const Rotation frame(agent.ahead);
  return {frame.intoFrame(robot.pose.position - agent.pose.position), frame.intoFrame(robot.velocity),
          robot.perceived_radius,
          doesCrowdYield(robot.start.yields) ? NeighbourKind::ROBOT : NeighbourKind::UNYIELDED_ROBOT};
}

inline void World::perceiveSelf(const Agent& agent, const Rotation& frame, AgentPerception& self) const {
  self.pose = agent.pose;
  self.velocity = frame.intoFrame(agent.velocity);
  self.max_speed = agent.max_speed;
  self.radius = agent.radius;
  self.goal = frame.intoFrame(agent.perceivedGoal() - agent.pose.position);
  self.goal_number = agent.goal_number;
  self.arrived = agent.hasArrived();
  self.acted = agent.acted;
}

inline void World::writeNeighbours(const Span<NearDisc>& found, const Agent& agent, std::size_t first,
                                   NeighbourList& neighbours) const {
  // Copies, because the compiler must assume that each store changes what references and members refer to.
  const Vector2 place = agent.pose.position;
  const Vector2 ahead = agent.ahead;
  const NeighbourGrid::Motion* const motions = grid_.motions();
  const double* const disc_radii = grid_.radii();
  const std::uint32_t* const bodies = grid_.bodies();
  const NearDisc* const discs = found.begin();
  const std::size_t count = found.size();
  const std::size_t agents = agents_.size();
  const std::size_t size = grid_.size();
  double* const xs = neighbours.xs() + first;
  double* const ys = neighbours.ys() + first;
  double* const vxs = neighbours.vxs() + first;
  double* const vys = neighbours.vys() + first;
  double* const radii = neighbours.radii() + first;
  NeighbourKind* const kinds = neighbours.kinds() + first;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t disc = discs[i].disc;
    if (disc >= size) {
      neighbours.set(first + i, seenRobot(robots_[disc - size], agent));
      continue;
    }
    const NeighbourGrid::Motion motion = motions[disc];
    const double dx = motion.x - place.x();
    const double dy = motion.y - place.y();
    xs[i] = dx * ahead.x() + dy * ahead.y();
    ys[i] = dy * ahead.x() - dx * ahead.y();
    vxs[i] = motion.vx * ahead.x() + motion.vy * ahead.y();
    vys[i] = motion.vy * ahead.x() - motion.vx * ahead.y();
    radii[i] = disc_radii[disc];
    kinds[i] = bodies[disc] < agents ? NeighbourKind::AGENT : NeighbourKind::OBSTACLE;
  }
}

inline void World::findWalls(const Vision& vision, const Agent& agent, const Rotation& frame,
                             PerceptionWorkspace& workspace) const {
  workspace.near_walls.clear();
  walls_.findNear(agent.pose.position, std::min(wall_reach_, vision.radius), workspace.near_walls);
  for (const std::uint32_t number : workspace.near_walls) {
    const Segment& wall = walls()[number];
    workspace.walls.push_back(
        {frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

inline void World::applyOcclusion(const Vision& vision, AgentPerception& self, PerceptionWorkspace& workspace) const {
  const NeighbourSpan near(workspace.near, 0, workspace.near.size());
  workspace.neighbours.assign(near.begin(), near.end());
  workspace.occlusion.apply(workspace.neighbours, 0, workspace.walls, self.first_wall, vision.radius);
  const bool too_many = vision.max_neighbours > 0 && workspace.neighbours.size() > vision.max_neighbours;
  if (too_many) workspace.neighbours.resize(vision.max_neighbours);
  self.neighbour_count = static_cast<std::uint32_t>(workspace.neighbours.size());
}

}  // namespace crowd
