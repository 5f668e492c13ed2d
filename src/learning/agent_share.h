#pragma once

#include <cstdint>

#include "world/perception.h"

namespace crowd {

/// @brief One of several equal shares of all agents, also of those that come later: every `count`-th agent from `index`
/// on. Learners on several hosts divide a crowd so, whose size they need not know.
struct AgentShare {
  std::uint32_t index = 0;  ///< below `count`
  std::uint32_t count = 1;  ///< number of shares

  bool contains(AgentId agent) const { return count <= 1 || agent % count == index; }
  bool isWhole() const { return count <= 1; }
  bool operator==(const AgentShare& other) const { return index == other.index && count == other.count; }
};

}  // namespace crowd
