#include "library/conversions.h"

#include <string>

#include "geometry/finite_checks.h"
#include "social_crowd/errors.h"

namespace crowd::library {
namespace {

/// Kinds have the same numbers in both lists.
template <typename Public, typename Own>
constexpr bool areSame(Public first, Own second) {
  return static_cast<int>(first) == static_cast<int>(second);
}
static_assert(areSame(NeighbourKind::AGENT, crowd::NeighbourKind::AGENT) &&
              areSame(NeighbourKind::OBSTACLE, crowd::NeighbourKind::OBSTACLE) &&
              areSame(NeighbourKind::ROBOT, crowd::NeighbourKind::ROBOT) &&
              areSame(NeighbourKind::UNYIELDED_ROBOT, crowd::NeighbourKind::UNYIELDED_ROBOT));

AgentPerception selfOf(const Perception& from) {
  AgentPerception self;
  self.agent = from.agent;
  self.pose = fromPublic(from.pose);
  self.velocity = fromPublic(from.velocity);
  self.max_speed = from.max_speed;
  self.radius = from.radius;
  self.goal = fromPublic(from.goal);
  self.goal_number = from.goal_number;
  self.arrived = from.arrived;
  self.acted = from.acted;
  self.held = from.held;
  return self;
}

void copyInto(Perception& to, const crowd::Perception& from) {
  const AgentPerception& self = from.self;
  to.agent = self.agent;
  to.pose = toPublic(self.pose);
  to.velocity = toPublic(self.velocity);
  to.max_speed = self.max_speed;
  to.radius = self.radius;
  to.goal = toPublic(self.goal);
  to.goal_number = self.goal_number;
  to.arrived = self.arrived;
  to.acted = self.acted;
  to.held = self.held;
  to.neighbours.clear();
  for (const crowd::Neighbour& other : from.neighbours) {
    to.neighbours.push_back({toPublic(other.position), toPublic(other.velocity), other.radius,
                             static_cast<NeighbourKind>(other.kind), other.intent.comfort,
                             toPublic(other.intent.wanted)});
  }
  to.walls.clear();
  for (const Segment& wall : from.walls) to.walls.push_back(toPublic(wall));
}

/// Checks what a user says that an agent perceives.
void requireValid(const crowd::Perception& seen) {
  const AgentPerception& self = seen.self;
  const std::string whose = "agent " + std::to_string(self.agent) + ": ";
  requirePose(self.pose);
  requireFinite(whose + "velocity", self.velocity);
  requireFinite(whose + "goal", self.goal);
  requireFinite(whose + "max_speed", self.max_speed);
  requireFinite(whose + "radius", self.radius);
  double last = -INFINITE;
  for (const crowd::Neighbour& other : seen.neighbours) {
    requireFinite(whose + "position of a neighbour", other.position);
    requireFinite(whose + "velocity of a neighbour", other.velocity);
    requireFinite(whose + "radius of a neighbour", other.radius);
    requireFinite(whose + "comfort of a neighbour", other.intent.comfort);
    requireFinite(whose + "wanted velocity of a neighbour", other.intent.wanted);
    constexpr double ROUNDING = 1e-6;  // [m]; the order holds up to rounding, see StateSet
    if (rimDistance(other) < last - ROUNDING) {
      throw InputError(whose + "expected the neighbours in the order of the distance to their rims, nearest first");
    }
    last = rimDistance(other);
  }
  for (const Segment& wall : seen.walls) {
    requireFinite(whose + "wall", wall.from);
    requireFinite(whose + "wall", wall.to);
  }
}

}  // namespace

crowd::MotionLimits fromPublic(const MotionLimits& motion) {
  const crowd::MotionLimits limits{motion.acceleration, motion.braking, motion.turn_rate};
  const std::string refusal = refusalOf(limits);
  if (!refusal.empty()) throw InputError("motion: " + refusal);
  return limits;
}

EpisodeResult toPublic(const crowd::EpisodeResult& result) {
  return {result.scenario, result.ticks,
          result.count(),  {result.agents.begin(), result.agents.end()},
          result.robots,   result.way_finding_problem};
}

void toPublic(const World& world, AgentArrays& arrays) {
  const std::size_t count = world.agents().size();
  for (auto* const numbers : {&arrays.heading, &arrays.max_speed, &arrays.radius}) numbers->resize(count);
  for (auto* const points : {&arrays.position, &arrays.velocity, &arrays.goal}) points->resize(2 * count);
  arrays.id.resize(count);
  arrays.status.resize(count);
  arrays.in_contact.resize(count);
  std::size_t i = 0;
  const auto put = [&](std::vector<double>& points, const crowd::Vector2& point) {
    points[2 * i] = point.x();
    points[2 * i + 1] = point.y();
  };
  for (const Agent& agent : world.agents()) {
    arrays.id[i] = agent.id;
    arrays.status[i] = static_cast<std::uint8_t>(agent.status);
    put(arrays.position, agent.pose.position);
    arrays.heading[i] = agent.pose.heading;
    put(arrays.velocity, agent.velocity);
    arrays.max_speed[i] = agent.max_speed;
    arrays.radius[i] = agent.radius;
    put(arrays.goal, agent.goal());
    arrays.in_contact[i] = agent.in_contact ? 1 : 0;
    ++i;
  }
}

void toPublic(const crowd::Perceptions& from, Perceptions& to) {
  to.episode = from.episode;
  to.tick = from.tick;
  to.turn = from.turn;
  to.tick_duration = from.tick_duration;
  to.motion = toPublic(from.motion);
  to.last = from.last;
  to.agents.resize(from.agents.size());
  for (std::size_t i = 0; i < from.agents.size(); ++i) copyInto(to.agents[i], crowd::Perception(from, i));
}

void fromPublic(const Perceptions& from, crowd::Perceptions& to) {
  requireFinite("tick_duration [s]", from.tick_duration);
  to.episode = from.episode;
  to.tick = from.tick;
  to.turn = from.turn;
  to.tick_duration = from.tick_duration;
  to.motion = fromPublic(from.motion);
  to.last = from.last;
  to.agents.clear();
  to.neighbours.clear();
  to.walls.clear();
  for (const Perception& seen : from.agents) {
    AgentPerception self = selfOf(seen);
    self.first_neighbour = static_cast<std::uint32_t>(to.neighbours.size());
    self.neighbour_count = static_cast<std::uint32_t>(seen.neighbours.size());
    self.first_wall = static_cast<std::uint32_t>(to.walls.size());
    self.wall_count = static_cast<std::uint32_t>(seen.walls.size());
    for (const Neighbour& other : seen.neighbours) {
      to.neighbours.push_back({fromPublic(other.position),
                               fromPublic(other.velocity),
                               other.radius,
                               static_cast<crowd::NeighbourKind>(other.kind),
                               {other.comfort, fromPublic(other.wanted)}});
    }
    for (const Wall& wall : seen.walls) to.walls.push_back(fromPublic(wall));
    to.agents.push_back(self);
    requireValid(crowd::Perception(to, to.agents.size() - 1));
  }
}

std::vector<Action> toPublic(const std::vector<AgentAction>& actions) {
  std::vector<Action> to;
  to.reserve(actions.size());
  for (const auto& [agent, action] : actions) to.push_back({agent, action.rotation, action.speed_fraction});
  return to;
}

void fromPublic(const std::vector<Action>& from, std::vector<AgentAction>& to) {
  to.clear();
  for (const Action& action : from) to.push_back({action.agent, {action.rotation, action.speed_fraction}});
}

}  // namespace crowd::library
