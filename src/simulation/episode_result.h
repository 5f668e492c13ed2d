#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/agent_results.h"
#include "social_crowd/results.h"

namespace crowd {

/// @brief "2 agents have goals out of reach". @param agents above 0
std::string outOfReachText(std::size_t agents);
/// @brief The same with the numbers of the first ten: "2 agents have goals out of reach (0, 7)".
/// @param agents at least one
std::string outOfReachText(const std::vector<AgentId>& agents);

/// @brief Results of an episode.
struct EpisodeResult {
  std::string scenario;
  std::uint64_t ticks = 0;
  AgentResults agents;
  std::vector<RobotResult> robots;
  std::string way_finding_problem;  ///< why way-finding was left out from some tick on; empty: it was not

  using Counts = EpisodeCounts;
  Counts count() const;
  std::size_t agentCount() const { return count().agents; }
  std::size_t arrivedCount() const { return count().arrived; }
  std::size_t expectedCount() const { return count().expected; }
  std::size_t touchedCount() const { return count().touched; }
  std::size_t collidedCount() const { return count().collided; }
  std::uint64_t blockedMoves() const { return count().blocked_moves; }
  bool isClean() const { return count().isClean(); }
  /// @brief The agents that count and have goals out of reach, by ascending number.
  std::vector<AgentId> outOfReach() const;
  /// @brief Warning about the ways of this episode, such as "2 agents have goals out of reach (0, 7)"; empty if there
  /// is none.
  std::string wayWarning() const;
  /// @brief Headings of all agents at the end [rad], for keepHeadings() of the next episode.
  std::vector<double> headings() const;
};

}  // namespace crowd
