#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "world/perception.h"

namespace crowd {

/// @brief Action of an agent for one tick, in its own frame: it turns first, then walks straight ahead.
struct RelativeAction {
  double rotation = 0.0;        ///< of the heading, counterclockwise [rad]
  double speed_fraction = 0.0;  ///< of the maximum speed, 0 (stay) to 1

  bool hasValidRotation() const { return std::isfinite(rotation); }
  bool hasValidSpeed() const { return speed_fraction >= 0.0 && speed_fraction <= 1.0; }  // false for NaN
  bool isValid() const { return hasValidRotation() && hasValidSpeed(); }
};

/// @brief The answer for one agent.
struct AgentAction {
  AgentId agent = 0;
  RelativeAction action;
};

/// @brief Answers to the perceptions of one tick of one episode.
struct RelativeActions {
  std::uint64_t episode = 0;
  std::uint64_t tick = 0;
  std::vector<AgentAction> agents;
};

}  // namespace crowd
