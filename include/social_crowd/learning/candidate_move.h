#pragma once

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief A move that an agent could make in the next tick.
struct CandidateMove {
  Vector2 direction = Vector2::UnitX();  ///< unit vector in the agent's frame
  double wanted = 0.0;                   ///< share of the top speed that the action asks for, 0 to 1
  double share = 0.0;                    ///< share that is admissible, 0 to `wanted`
};

/// @brief What an agent does that makes the move, as far as it is admissible.
inline RelativeAction toAction(const CandidateMove& move) { return {bearingOf(move.direction), move.share}; }

}  // namespace crowd
