#pragma once

#include <vector>

#include "world/world.h"

namespace crowd {

class Episode;

/// @brief What decides in an episode, see Episode::walk().
class Decider {
 public:
  Decider() = default;
  Decider(const Decider&) = delete;
  Decider& operator=(const Decider&) = delete;
  virtual ~Decider() = default;

  /// @brief Writes the actions of the agents whose turn it is. It asks for Episode::perceptions(), or perceives for
  /// some agents at a time; once the episode is over, it can learn from the last ones.
  /// @param actions is overwritten
  /// @return whether the agents move; false ends the turn, and the episode need not be there any more
  virtual bool decide(Episode& episode, std::vector<AgentAction>& actions) = 0;
  /// @brief Called when the motions of a solid world are computed, before they are carried out.
  virtual void agree(World& /*world*/) {}
};

}  // namespace crowd
