#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief A learner that answers, as a number that the owner of a Lockstep hands out.
using LearnerId = std::uint32_t;

/// @brief Why an answer is not carried out.
enum class Refusal {
  NOT_ASKED,      ///< the agent was never asked, or not in the tick that the answer names
  BAD_ROTATION,   ///< not a finite number
  BAD_SPEED,      ///< speed_fraction is not within 0 to 1
  TOO_LATE,       ///< for a tick or an episode that is over
  TOO_EARLY,      ///< for a tick or an episode that has not begun
  SECOND_ANSWER,  ///< the learner has answered for this agent already, with another action
  OTHER_LEARNER,  ///< another learner has answered for this agent already
};

/// @brief An answer for one agent that is not carried out.
struct RefusedAnswer {
  Refusal cause = Refusal::NOT_ASKED;
  AgentAction answer;
  std::uint64_t episode = 0;  ///< that the answer names
  std::uint64_t tick = 0;     ///< that the answer names
  LearnerId learner = 0;      ///< that gave it
  LearnerId other = 0;        ///< OTHER_LEARNER: the one whose answer counts
};

/// @brief Collects the answers to one tick's perceptions (in a sequential scenario to one turn's) and records which
/// agents are answered for. It has no clock: its owner decides when to stop waiting. Not thread-safe.
///
/// An agent that misses several answers in a row is absent: it is not waited for until it is answered for again. A
/// refused answer with valid numbers still shows that the agent's learner is there. An answer that repeats the
/// learner's last one for the agent, or that is meant for a tick that was abandoned, is ignored and counts nowhere.
class Lockstep {
 public:
  explicit Lockstep(int misses_until_absent) : misses_until_absent_(misses_until_absent) {}

  /// @brief Asks these agents. A tick that is still open is abandoned.
  void open(std::uint64_t episode, std::uint64_t tick, const std::vector<AgentId>& agents);
  /// @brief Takes a learner's answers. Returns those it refuses; valid until the next call.
  const std::vector<RefusedAnswer>& take(const RelativeActions& answers, LearnerId learner);
  /// @brief Counts answers that are meant for another controller as dropped.
  void drop(const RelativeActions& answers) { dropped_ += answers.agents.size(); }
  /// @brief Closes the tick and counts the missing answers. The answers are in answers().
  /// @return agents that are absent from now on
  std::vector<AgentId> close();

  /// @brief Whether no agent is waited for any more.
  bool isComplete() const { return awaited_ == 0; }
  /// @brief Whether all agents that were asked are absent.
  bool isDeserted() const { return present_ == 0 && !asked_.empty(); }
  /// @brief Whether an agent is waited for that was never answered for.
  bool awaitsNewcomer() const;
  /// @brief Marks those of the agents as absent that were never answered for, whether they are asked now or not.
  /// @return those agents
  std::vector<AgentId> giveUpOnNewcomers(const std::vector<AgentId>& agents);
  /// @brief Whether all of these agents are absent.
  bool areAbsent(const std::vector<AgentId>& agents) const;

  const std::vector<AgentAction>& answers() const { return answers_; }
  /// @brief Agents of the open tick without an answer, absent ones included.
  std::vector<AgentId> missing() const;
  /// @brief Missing answers since the last reset of the counts.
  std::uint64_t missedCount() const { return missed_; }
  /// @brief Refused answers since the last reset of the counts.
  std::uint64_t droppedCount() const { return dropped_; }
  void resetCounts();

 private:
  using Moment = std::pair<std::uint64_t, std::uint64_t>;  // episode, tick

  struct TakenAnswer {
    LearnerId learner = 0;
    Moment moment;
    RelativeAction action;
  };
  struct AgentRecord {
    std::optional<Moment> asked_at;   // last
    std::optional<TakenAnswer> last;  // answer that was taken
    bool heard = false;               // was ever answered for
    int misses = 0;                   // in a row
    bool absent = false;
    bool asked = false;     // in the open tick
    bool answered = false;  // in the open tick
  };

  AgentRecord& record(AgentId agent);
  bool wasAsked(AgentId agent) const { return agent < records_.size() && records_[agent].asked_at.has_value(); }
  void takeOne(const AgentAction& answer, const Moment& moment, LearnerId learner);
  void markPresent(AgentRecord& record);
  Refusal causeOf(const AgentRecord& record, const Moment& moment, LearnerId learner) const;
  void refuse(Refusal cause, const AgentAction& answer, const Moment& moment, LearnerId learner);

  int misses_until_absent_;
  Moment now_;
  bool open_ = false;
  std::optional<Moment> abandoned_;
  std::vector<AgentRecord> records_;  // by agent
  std::vector<AgentId> asked_;
  std::vector<AgentAction> answers_;
  std::vector<RefusedAnswer> refused_;
  std::size_t awaited_ = 0;  // asked, present, not yet answered
  std::size_t present_ = 0;  // asked and not absent
  std::uint64_t missed_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace crowd
