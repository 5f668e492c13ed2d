#pragma once

#include <cstddef>
#include <optional>

#include "common/random.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Draws which agents of an entry walk together (AgentGroup::groups): one after the other, a leader, then those
/// who follow it.
class Parties {
 public:
  /// @param random of this entry
  Parties(const GroupShare& groups, const KeyedRandom& random) : groups_(&groups), random_(random) {}

  /// @brief The leader of the next agent; absent if it walks alone or leads.
  /// @param agent its id @param left number of agents of the entry that are left, this one included
  std::optional<AgentId> next(AgentId agent, std::size_t left);
  /// @brief Whether the agent of the last call leads others.
  bool leads() const { return leads_; }
  /// @brief The leader of the agent of the next call; absent if it does not follow one.
  std::optional<AgentId> leaderOfNext() const {
    return followers_left_ > 0 ? std::optional<AgentId>(leader_) : std::nullopt;
  }
  /// @brief Nobody follows the last leader any more.
  void endParty() { followers_left_ = 0; }

 private:
  const GroupShare* groups_;
  KeyedRandom random_;
  AgentId leader_ = 0;
  std::size_t followers_left_ = 0;
  bool leads_ = false;
};

/// @brief The leader of an agent of an entry: that of the entry, or the drawn one.
std::optional<Leader> leaderOf(const AgentGroup& entry, std::optional<AgentId> drawn);

/// @brief Where a follower appears beside its leader, for a body of a radius [m].
Region placesBeside(const Vector2& leader, double radius);

/// @brief Sets the groups of the agents of a scene, by their leaders and by the groups of the scenario.
void assignGroups(const Scenario& scenario, Scene& scene);

}  // namespace crowd
