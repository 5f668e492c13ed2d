#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "social_crowd/learning/chooser.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Left free of every gap, so that what two agents work out in their own frames never adds up to more than it
/// [m].
constexpr double GAP_MARGIN = 1e-9;

/// @brief Bodies are looked at so many at a time.
constexpr std::size_t LOOKED_AT = PerceivedBodies::MARGIN;
/// @brief Some of so many bodies: bit i stands for body first + i.
using BodySet = std::uint32_t;

/// @brief Those of up to LOOKED_AT bodies which, as agents, are so near that the contact rule may leave less of a move
/// than the longest displacement of a tick; perhaps one too many.
BodySet findNear(const Perception& seen, std::size_t first);

/// @brief An agent that is near another one that is to choose.
struct NearAgent {
  std::uint32_t number;
  std::size_t chooser() const { return number / LOOKED_AT; }
  std::size_t body() const { return number % LOOKED_AT; }
};

/// @brief All that findNear() finds for agents that choose side by side.
class NearAgents {
 public:
  static constexpr std::size_t MOST = MAX_CHOOSERS * LOOKED_AT;

  /// @brief Looks at those that see agents alone, no more than LOOKED_AT, see isFor(); leaves out the others.
  /// @param choosers MAX_CHOOSERS at most
  explicit NearAgents(const Choosers& choosers);

  /// @brief Whether there are bodies to be looked at, and no others.
  static bool isFor(const Perception& seen) {
    return !seen.bodies.empty() && seen.bodies.size() <= LOOKED_AT && seen.isOfAgentsAlone();
  }

  /// @brief By agent that is to choose, nearest first.
  const NearAgent* begin() const { return list_.data(); }
  const NearAgent* end() const { return list_.data() + count_; }

 private:
  std::array<NearAgent, MOST> list_;
  std::size_t count_ = 0;
};

}  // namespace crowd
