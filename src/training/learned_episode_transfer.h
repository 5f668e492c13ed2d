#pragma once

#include "simulation/agent_transfer.h"
#include "simulation/byte_archive.h"
#include "training/training_state.h"

namespace crowd {

/// Calls archive(field) for each field of the result of a robot, to write or to read it (byte_archive.h).
template <typename Archive, typename AResult>
void transferRobot(Archive& archive, AResult& result) {
  archive(result.name);
  const auto transfer = [&](const char* /*name*/, auto& value) { archive(value); };
  RobotResult::visitFields(transfer, result);
  transferAll(archive, result.goals, [&](auto& goal) { RobotGoalResult::visitFields(transfer, goal); });
}

inline void transferAgents(ByteWriter& write, const AgentResults& agents) {
  write(static_cast<std::uint64_t>(agents.size()));
  for (const AgentResult& agent : agents) transferResult(write, agent);
}

inline void transferAgents(ByteReader& read, AgentResults& agents) {
  std::vector<AgentResult> results;
  transferAll(read, results, [&](AgentResult& result) { transferResult(read, result); });
  agents = std::move(results);
}

/// The same for an episode of a training, with the results of its agents and robots.
template <typename Archive, typename AnEpisode>
void transferEpisode(Archive& archive, AnEpisode& episode) {
  archive(episode.scenario);
  archive(episode.ticks);
  archive(episode.way_finding_problem);
  archive(episode.decisions);
  archive(episode.reward);
  archive(episode.epsilon);
  archive(episode.visited_rows);
  transferAgents(archive, episode.agents);
  transferAll(archive, episode.robots, [&](auto& result) { transferRobot(archive, result); });
}

}  // namespace crowd
