#include "ros/messages/perception_routes.h"

#include <algorithm>
#include <tuple>

namespace crowd {

bool PerceptionRoutes::claim(const std::string& learner, const std::string& topic, const std::vector<AgentId>& agents,
                             const AgentShare& share) {
  if (topic.empty()) {
    if (claims_.erase(learner) == 0) return false;
  } else {
    Claim claim{topic, {}, share};
    if (share.isWhole()) claim.agents = {agents.begin(), agents.end()};
    const auto [found, is_new] = claims_.try_emplace(learner);
    const Claim& before = found->second;
    if (!is_new && before.topic == topic && before.agents == claim.agents && before.share == share) return false;
    found->second = std::move(claim);
  }
  update();
  return true;
}

void PerceptionRoutes::update() {
  topics_.clear();
  for (const auto& [learner, claim] : claims_) topics_.push_back(claim.topic);
  std::sort(topics_.begin(), topics_.end());
  topics_.erase(std::unique(topics_.begin(), topics_.end()), topics_.end());
  routes_.clear();
  shares_.clear();
  for (const auto& [learner, claim] : claims_) {
    const auto place = std::lower_bound(topics_.begin(), topics_.end(), claim.topic) - topics_.begin();
    for (const AgentId agent : claim.agents) routes_.push_back({agent, static_cast<std::uint32_t>(place)});
    if (!claim.share.isWhole()) shares_.push_back({claim.share, static_cast<std::uint32_t>(place)});
  }
  const auto key = [](const Route& route) { return std::tie(route.agent, route.topic); };
  std::sort(routes_.begin(), routes_.end(), [&](const Route& a, const Route& b) { return key(a) < key(b); });
  const auto equal = [&](const Route& a, const Route& b) { return key(a) == key(b); };
  routes_.erase(std::unique(routes_.begin(), routes_.end(), equal), routes_.end());
}

std::vector<PerceptionRows> PerceptionRoutes::split(const Perceptions& perceptions) const {
  std::vector<PerceptionRows> rows(topics_.size());
  const auto is_before = [](const Route& route, AgentId agent) { return route.agent < agent; };
  auto next = routes_.begin();
  for (std::size_t row = 0; row < perceptions.agents.size(); ++row) {
    const AgentId agent = perceptions.agents[row].agent;
    // Worlds perceive agents in ascending order; then `next` is there already, unless agents without a route follow.
    if (next != routes_.begin() && (next - 1)->agent >= agent) next = routes_.begin();
    if (next != routes_.end() && next->agent < agent) next = std::lower_bound(next, routes_.end(), agent, is_before);
    for (; next != routes_.end() && next->agent == agent; ++next) {
      rows[next->topic].push_back(static_cast<std::uint32_t>(row));
    }
    for (const ShareRoute& route : shares_) {
      PerceptionRows& its_rows = rows[route.topic];
      const bool is_there = !its_rows.empty() && its_rows.back() == row;  // by another claim of the topic
      if (route.share.contains(agent) && !is_there) its_rows.push_back(static_cast<std::uint32_t>(row));
    }
  }
  return rows;
}

PerceptionRows PerceptionRoutes::rowsOf(const std::string& topic, const Perceptions& perceptions) const {
  const auto found = std::lower_bound(topics_.begin(), topics_.end(), topic);
  if (found == topics_.end() || *found != topic) return {};
  return split(perceptions)[static_cast<std::size_t>(found - topics_.begin())];
}

}  // namespace crowd
