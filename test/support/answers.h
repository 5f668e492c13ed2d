#pragma once

#include <cstdint>
#include <vector>

#include "simulation/lockstep.h"

/// Answers to perceptions, for tests of the lockstep.
namespace crowd::answers {

using Ids = std::vector<AgentId>;

constexpr std::uint64_t EPISODE = 5;
constexpr RelativeAction MOVE{0.5, 1.0};
constexpr LearnerId LEARNER = 0;

/// Answers of these agents to a tick.
inline RelativeActions answersOf(std::uint64_t tick, const Ids& agents, const RelativeAction& action = MOVE,
                                 std::uint64_t episode = EPISODE) {
  RelativeActions answers;
  answers.episode = episode;
  answers.tick = tick;
  for (const AgentId agent : agents) answers.agents.push_back({agent, action});
  return answers;
}

/// Opens a tick, takes the answers of some agents and closes it.
inline void playTick(Lockstep& lockstep, std::uint64_t tick, const Ids& asked, const Ids& answering) {
  lockstep.open(EPISODE, tick, asked);
  lockstep.take(answersOf(tick, answering), LEARNER);
  lockstep.close();
}

/// The agents of the answers.
inline Ids agentsOf(const std::vector<AgentAction>& answers) {
  Ids agents;
  for (const AgentAction& answer : answers) agents.push_back(answer.agent);
  return agents;
}

}  // namespace crowd::answers
