#include "simulation/agent_mind.h"

#include <algorithm>
#include <utility>

#include "world/perceiver.h"
#include "world/viewers.h"

namespace crowd {
namespace {

constexpr double SAME_PLACE = 1e-6;  // [m]

/// Perceptions have places, not ids.
std::vector<AgentId> neighboursOf(const World& world, const Perception& seen) {
  const Rotation rotation(seen.self.pose.heading);
  std::vector<Vector2> places;
  for (std::size_t i = 0; i < seen.neighbours.size(); ++i) {
    places.emplace_back(seen.self.pose.position + rotation.outOfFrame(seen.neighbours[i].position));
  }
  std::vector<AgentId> ids;
  for (const Agent& agent : world.agents()) {
    const auto is_there = [&](const Vector2& place) {
      return (agent.pose.position - place).lpNorm<Eigen::Infinity>() < SAME_PLACE;
    };
    if (agent.isPresent() && std::any_of(places.begin(), places.end(), is_there)) ids.push_back(agent.id);
  }
  return ids;
}

}  // namespace

std::optional<AgentMind> mindOf(const Episode& episode, Learner& learner, AgentId agent) {
  const World& world = episode.world();
  if (episode.isOver() || !world.isActive(agent) || !world.isPerceiving(*world.agents().find(agent))) {
    return std::nullopt;
  }
  Viewers viewers;
  Perceptions seen;
  Perceiver().perceive(world, episode.vision(), viewers.one(world, agent), seen);
  seen.episode = episode.number();
  seen.turn = episode.scene().order == Order::SEQUENTIAL ? agent : 0;
  RelativeActions actions;
  learner.decide(seen, actions);
  auto values = learner.valuesOf(seen, actions, agent);
  if (!values) return std::nullopt;
  const Perception perception(seen, 0);
  return AgentMind{std::move(*values), perception.self.max_speed, neighboursOf(world, perception)};
}

}  // namespace crowd
