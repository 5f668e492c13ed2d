#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/robot_result.h"
#include "simulation/agent_results.h"

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

  /// @brief Numbers of agents that were not removed; metrics are about these.
  struct Counts {
    std::size_t agents = 0;
    std::size_t arrived = 0;
    std::size_t expected = 0;  ///< to arrive: without agents on routes that repeat
    std::size_t touched = 0;
    std::size_t collided = 0;
    std::uint64_t blocked_moves = 0;  ///< sum of all of them
    /// @brief Whether all expected agents arrived, and none was in contact.
    bool isClean() const { return arrived == expected && touched == 0; }
  };
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
