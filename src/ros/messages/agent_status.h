#pragma once

#include <social_crowd/AgentState.h>

namespace crowd {

/// @brief Whether the agent of a message is a body of the world, see Agent::isPresent().
inline bool isPresent(const social_crowd::AgentState& agent) {
  return agent.status == social_crowd::AgentState::WALKING || agent.status == social_crowd::AgentState::STAYING;
}

}  // namespace crowd
