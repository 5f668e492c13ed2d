#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Gives agents places 0, 1, 2 ... in the order in which they are first met, whatever their numbers.
class AgentPlaces {
 public:
  static constexpr std::uint32_t NONE = UINT32_MAX;

  /// @brief The agent's place; NONE if it was not met before.
  std::uint32_t find(AgentId agent) const {
    if (agent >= FEW) return findOther(agent);
    return agent < listed_.size() ? listed_[agent] : NONE;
  }
  /// @brief Gives a place to an agent that has none; the place.
  std::uint32_t add(AgentId agent);
  /// @brief Who has which place.
  const std::vector<AgentId>& agents() const { return agents_; }

 private:
  static constexpr AgentId FEW = 1U << 20U;  // numbers below this are looked up in a list, others in a hash table

  std::uint32_t findOther(AgentId agent) const;

  std::vector<AgentId> agents_;
  std::vector<std::uint32_t> listed_;
  std::unordered_map<AgentId, std::uint32_t> others_;
};

}  // namespace crowd
