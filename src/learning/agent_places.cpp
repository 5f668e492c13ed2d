#include "social_crowd/learning/agent_places.h"

namespace crowd {

std::uint32_t AgentPlaces::findOther(AgentId agent) const {
  const auto found = others_.find(agent);
  return found == others_.end() ? NONE : found->second;
}

std::uint32_t AgentPlaces::add(AgentId agent) {
  const auto place = static_cast<std::uint32_t>(agents_.size());
  agents_.push_back(agent);
  if (agent >= FEW) {
    others_.emplace(agent, place);
  } else {
    if (agent >= listed_.size()) listed_.resize(std::size_t{agent} + 1, NONE);
    listed_[agent] = place;
  }
  return place;
}

}  // namespace crowd
