#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Maps agent ids to consecutive indices 0, 1, 2 ... (places), in the order in which agents are added.
class AgentPlaces {
 public:
  /// @brief Stands for no place.
  static constexpr std::uint32_t NONE = UINT32_MAX;

  /// @brief Returns the place of an agent; NONE if it was not added.
  std::uint32_t find(AgentId agent) const {
    if (agent >= FEW) return findOther(agent);
    return agent < listed_.size() ? listed_[agent] : NONE;
  }
  /// @brief Adds an agent that has no place yet. @return its place
  std::uint32_t add(AgentId agent);
  /// @brief The agents by place.
  const std::vector<AgentId>& agents() const { return agents_; }

 private:
  static constexpr AgentId FEW = 1U << 20U;  // ids below this are looked up in an array, others in a hash table

  std::uint32_t findOther(AgentId agent) const;

  std::vector<AgentId> agents_;
  std::vector<std::uint32_t> listed_;
  std::unordered_map<AgentId, std::uint32_t> others_;
};

}  // namespace crowd
