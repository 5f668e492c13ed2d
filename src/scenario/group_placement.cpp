#include "scenario/group_placement.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double LEAST_GAP = 0.1;  // between a follower and its leader at the start [m]
constexpr double MOST_GAP = 0.8;   // [m]

}  // namespace

std::optional<AgentId> Parties::next(AgentId agent, std::size_t left) {
  leads_ = false;
  if (const std::optional<AgentId> leader = leaderOfNext()) {
    --followers_left_;
    return leader;
  }
  const std::size_t size = std::min(left, groups_->drawSize(random_.with(agent)));
  leader_ = agent;
  followers_left_ = size - 1;
  leads_ = size > 1;
  return std::nullopt;
}

std::optional<Leader> leaderOf(const AgentGroup& entry, std::optional<AgentId> drawn) {
  if (drawn) return Leader{Leader::Kind::AGENT, *drawn};
  if (!entry.leader) return std::nullopt;
  if (entry.leader->robot.empty()) return Leader{Leader::Kind::AGENT, entry.leader->agent};
  return Leader{Leader::Kind::ROBOT, entry.leader->robot_number};
}

Region placesBeside(const Vector2& leader, double radius) {
  Region region;
  region.kind = Region::Kind::RING;
  region.first = leader;
  region.radius = {2.0 * radius + LEAST_GAP, 2.0 * radius + MOST_GAP};
  return region;
}

void assignGroups(const Scenario& scenario, Scene& scene) {
  for (AgentStart& agent : scene.agents) {
    if (!agent.leader) continue;
    agent.group = groupOf(*agent.leader);
    if (agent.leader->kind == Leader::Kind::AGENT) scene.agents[agent.leader->number].group = agent.group;
  }
  for (const GroupDescription& group : scenario.groups) {
    const AgentId first = *std::min_element(group.members.begin(), group.members.end());
    for (const AgentId member : group.members) scene.agents[member].group = first;
  }
}

}  // namespace crowd
