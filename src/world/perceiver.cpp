#include "world/perceiver.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t PREFETCH_AHEAD = 4;  // [agents]

/// Loads an agent into the cache: those that are neighbours in the grid are anywhere in memory.
inline void prefetch(const Agent& agent) {
#if defined(__GNUC__)
  constexpr std::size_t CACHE_LINE = 64;  // [bytes]
  const auto* const first = reinterpret_cast<const char*>(&agent);
  for (std::size_t offset = 0; offset < sizeof(Agent); offset += CACHE_LINE) __builtin_prefetch(first + offset);
#endif
}

Neighbour seenRobot(const Robot& robot, const Agent& agent) {
  const Rotation frame(agent.ahead);
  return {frame.intoFrame(robot.pose.position - agent.pose.position),
          frame.intoFrame(robot.velocity),
          robot.perceived_radius,
          doesCrowdYield(robot.start.yields) ? NeighbourKind::ROBOT : NeighbourKind::UNYIELDED_ROBOT,
          {robot.start.comfort, frame.intoFrame(robot.wantedVelocity())}};
}

inline void perceiveSelf(const Agent& agent, AgentPerception& self) {
  const Rotation frame(agent.ahead);
  self.agent = agent.id;
  self.pose = agent.pose;
  self.velocity = frame.intoFrame(agent.velocity);
  self.max_speed = agent.max_speed;
  self.radius = agent.radius;
  self.goal = frame.intoFrame(agent.perceivedGoal() - agent.pose.position);
  self.goal_number = agent.goal_number;
  self.arrived = agent.hasArrived();
  self.acted = agent.acted;
  self.held = agent.isHeld() || agent.yielding;
}

/// Writes the bodies that were found in the agent's frame, from `first` on.
inline void writeNeighbours(const World& world, const Span<NearDisc>& found, const Agent& agent, std::size_t first,
                            NeighbourList& neighbours) {
  // Copies, because the compiler must assume that each store changes what references and members refer to.
  const Vector2 place = agent.pose.position;
  const Vector2 ahead = agent.ahead;
  const NeighbourGrid::Motion* const motions = world.grid().motions();
  const double* const disc_radii = world.grid().radii();
  const std::uint32_t* const bodies = world.grid().bodies();
  const NearDisc* const discs = found.begin();
  const std::size_t count = found.size();
  const std::size_t agents = world.agents().size();
  const std::size_t size = world.grid().size();
  double* const xs = neighbours.xs() + first;
  double* const ys = neighbours.ys() + first;
  double* const vxs = neighbours.vxs() + first;
  double* const vys = neighbours.vys() + first;
  double* const radii = neighbours.radii() + first;
  NeighbourKind* const kinds = neighbours.kinds() + first;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t disc = discs[i].disc;
    if (disc >= size) {
      neighbours.set(first + i, seenRobot(world.robots()[static_cast<RobotId>(disc - size)], agent));
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

}  // namespace

void Perceiver::perceive(const World& world, const Vision& vision, const Viewers& viewers, Perceptions& perceptions) {
  perceptions.tick = world.tick();
  perceptions.tick_duration = world.tickDuration();
  perceptions.motion = world.motion();
  perceptions.agents.resize(viewers.size());
  perceptions.neighbours.resize(vision.max_neighbours * viewers.size());
  perceptions.walls.clear();
  for (std::size_t i = 0; i < viewers.size(); ++i) {
    if (i + PREFETCH_AHEAD < viewers.size()) prefetch(*viewers[i + PREFETCH_AHEAD].agent);
    // Without a limit the neighbours of all agents are contiguous.
    const std::size_t first = vision.max_neighbours > 0 ? vision.max_neighbours * i : perceptions.neighbours.size();
    perceiveOne(world, vision, viewers[i], first, perceptions);
  }
}

inline void Perceiver::perceiveOne(const World& world, const Vision& vision, const Viewers::Viewer& viewer,
                                   std::size_t first, Perceptions& perceptions) {
  const Agent& agent = *viewer.agent;
  AgentPerception& self = perceptions.agents[viewer.place];
  const Span<NearDisc> found = findBodies(world, vision, viewer);
  perceiveSelf(agent, self);
  self.first_neighbour = static_cast<std::uint32_t>(first);
  self.neighbour_count = static_cast<std::uint32_t>(found.size());
  self.first_wall = static_cast<std::uint32_t>(perceptions.walls.size());
  findWalls(world, vision, agent, perceptions.walls);
  if (vision.occlusion) {
    near_.resize(found.size());
    writeNeighbours(world, found, agent, 0, near_);
    const NeighbourSpan near(near_, 0, near_.size());
    visible_.assign(near.begin(), near.end());
    occlusion_.apply(visible_, 0, perceptions.walls, self.first_wall, vision.radius);
    visible_.resize(vision.countOf(visible_));
    self.neighbour_count = static_cast<std::uint32_t>(visible_.size());
  }
  self.wall_count = static_cast<std::uint32_t>(perceptions.walls.size()) - self.first_wall;
  if (vision.max_neighbours == 0) perceptions.neighbours.resize(first + self.neighbour_count);
  if (!vision.occlusion) return writeNeighbours(world, found, agent, first, perceptions.neighbours);
  for (std::size_t i = 0; i < visible_.size(); ++i) perceptions.neighbours.set(first + i, visible_[i]);
}

inline Span<NearDisc> Perceiver::findBodies(const World& world, const Vision& vision, const Viewers::Viewer& viewer) {
  const Agent& agent = *viewer.agent;
  // Occlusion needs all bodies in range to determine the visible ones.
  const std::size_t max_count = vision.occlusion ? 0 : vision.max_neighbours;
  const Span<NearDisc> found =
      search_.findNearest(world.grid(), agent.pose.position, vision.radius, max_count, viewer.body);
  if (world.robots().empty()) return found;
  near_discs_.assign(found.begin(), found.end());
  for (RobotId id = 0; id < world.robots().size(); ++id) {
    const Robot& robot = world.robots()[id];
    const NearDisc disc = {(robot.pose.position - agent.pose.position).norm() - robot.perceived_radius,
                           static_cast<std::uint32_t>(world.grid().size() + id)};
    if (!robot.start.perceived || agent.id == agentIdOf(id) || disc.rim_distance > vision.radius) continue;
    const auto farther = [&](const NearDisc& other) { return other.rim_distance > disc.rim_distance; };
    near_discs_.insert(std::find_if(near_discs_.begin(), near_discs_.end(), farther), disc);
  }
  if (max_count > 0 && near_discs_.size() > max_count) near_discs_.resize(max_count);
  return {near_discs_.data(), near_discs_.size()};
}

inline void Perceiver::findWalls(const World& world, const Vision& vision, const Agent& agent,
                                 std::vector<Segment>& walls) {
  if (world.walls().list().empty()) return;
  const Rotation frame(agent.ahead);
  near_walls_.clear();
  const double reach = vision.wallReach(agent.radius, world.motion().reach(agent.max_speed, world.tickDuration()));
  world.walls().index().findNear(agent.pose.position, reach, near_walls_);
  for (const std::uint32_t number : near_walls_) {
    const Segment& wall = world.walls().list()[number];
    walls.push_back({frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

}  // namespace crowd
