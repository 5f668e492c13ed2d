#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "world/world.h"

namespace crowd {

/// @brief List of the agents that a Perceiver perceives for. Each function replaces it. Use one object per thread.
class Viewers {
 public:
  /// @brief One of them.
  struct Viewer {
    const Agent* agent = nullptr;
    std::uint32_t body = 0;   ///< its own, which it does not perceive
    std::uint32_t place = 0;  ///< in Perceptions::agents
  };

  /// @brief All agents that are on their way or arrived in the last tick, in Perceptions by ascending id.
  const Viewers& all(const World& world);
  /// @brief The agents among the bodies first .. last - 1 of the world's grid, in the order of the bodies, which is
  /// spatial for large crowds; not those that have arrived.
  const Viewers& among(const World& world, std::size_t first, std::size_t last);
  /// @brief One agent, for which World::isPerceiving() must hold, or none.
  const Viewers& one(const World& world, std::optional<AgentId> id);
  /// @brief An agent in a robot's place: a disc of the radius that agents perceive, with the robot's maximum speed, and
  /// the id agentIdOf(id). @param goal that it perceives [m], `map`
  const Viewers& inPlaceOf(RobotId id, const World& world, const Vector2& goal);

  std::size_t size() const { return list_.size(); }
  const Viewer& operator[](std::size_t i) const { return list_[i]; }

 private:
  std::vector<Viewer> list_;
  std::vector<std::uint32_t> places_;  // of all agents, by position
  Agent robot_;
};

}  // namespace crowd
