#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief Collects the answers to one tick's perceptions and keeps the books on who answers and who does not. Knows
/// nothing of clocks: whoever uses it decides when to wait no longer.
///
/// Who misses several ticks in a row is absent: it is not waited for until it answers again. Answers to another tick or
/// episode are dropped and counted, but show that somebody is there.
class Lockstep {
 public:
  explicit Lockstep(int misses_until_absent) : misses_until_absent_(misses_until_absent) {}

  /// @brief Opens a tick: these agents are to answer.
  void open(std::uint64_t episode, std::uint64_t tick, const std::vector<AgentId>& agents);
  /// @brief Takes in answers; those that do not belong to the open tick are dropped and counted.
  void take(const RelativeActions& answers);
  /// @brief Drops and counts answers that were meant for somebody else.
  void drop(const RelativeActions& answers) { dropped_ += answers.agents.size(); }
  /// @brief Whether nobody is to be waited for any more.
  bool isComplete() const { return awaited_ == 0; }
  /// @brief Whether everybody asked is absent, so that waiting for somebody means nothing.
  bool isDeserted() const { return present_ == 0 && !asked_.empty(); }
  /// @brief Whether an agent is awaited that has never answered since it came.
  bool awaitsNewcomer() const;
  /// @brief Closes the tick: counts who did not answer. The answers are in answers().
  void close();
  /// @brief From now on those of the agents that never answered are absent, whether they are asked now or not.
  void giveUpOnNewcomers(const std::vector<AgentId>& agents);
  /// @brief Whether all of these agents are absent.
  bool areAbsent(const std::vector<AgentId>& agents) const;

  const std::vector<AgentAction>& answers() const { return answers_; }
  /// @brief Agents of the open tick that have not answered, absent ones included.
  std::vector<AgentId> missing() const;
  /// @brief Answers that were awaited or could have come, and did not; since reset.
  std::uint64_t missedCount() const { return missed_; }
  /// @brief Answers that were dropped: another tick or episode, an unknown agent, a second answer, not a number.
  std::uint64_t droppedCount() const { return dropped_; }
  void resetCounts();

 private:
  struct Partner {
    bool known = false;  // was ever asked
    bool heard = false;  // has ever answered
    int misses = 0;      // in a row
    bool absent = false;
    bool asked = false;     // in the open tick
    bool answered = false;  // in the open tick
  };
  Partner& partner(AgentId agent);
  void takeOne(const AgentAction& answer, bool right_tick);
  void markPresent(Partner& partner);
  /// An answer while other agents are asked shows that somebody is there.
  void noteOutOfTurn(AgentId agent);

  int misses_until_absent_;
  std::uint64_t episode_ = 0;
  std::uint64_t tick_ = 0;
  bool open_ = false;
  std::vector<Partner> partners_;  // by agent
  std::vector<AgentId> asked_;
  std::vector<AgentAction> answers_;
  std::size_t awaited_ = 0;  // asked, present, not yet answered
  std::size_t present_ = 0;  // asked and not absent
  std::uint64_t missed_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace crowd
