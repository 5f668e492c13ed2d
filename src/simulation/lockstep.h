#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "world/agent_map.h"
#include "world/relative_action.h"

namespace crowd {

/// @brief Identifier of a learner, assigned by the owner of the Lockstep.
using LearnerId = std::uint32_t;

/// @brief Reason why an answer is not executed.
enum class Refusal {
  NOT_ASKED,      ///< no answer was requested for the agent, ever or in the tick that the answer names
  BAD_ROTATION,   ///< not a finite number
  BAD_SPEED,      ///< speed_fraction is not within 0 to 1
  TOO_LATE,       ///< the tick or episode is over
  TOO_EARLY,      ///< the tick or episode has not begun
  SECOND_ANSWER,  ///< the learner has answered for this agent already, with another action
  OTHER_LEARNER,  ///< another learner has answered for this agent already
};

/// @brief An answer for one agent that is not executed.
struct RefusedAnswer {
  Refusal cause = Refusal::NOT_ASKED;
  AgentAction answer;
  std::uint64_t episode = 0;  ///< that the answer names
  std::uint64_t tick = 0;     ///< that the answer names
  LearnerId learner = 0;      ///< sender of the answer
  LearnerId other = 0;        ///< OTHER_LEARNER: the one whose answer counts
};

/// @brief Collects the answers to the perceptions of one tick (in a sequential scenario: of one turn) and records which
/// agents are answered for. It has no clock: its owner decides when to stop waiting. Not thread-safe.
///
/// The owner calls open(), then take() for each message of answers, then close(). An agent that misses several answers
/// in a row becomes absent; it is awaited again only after a further answer for it. A refused answer with valid numbers
/// still shows that the agent's learner is running. An answer that repeats the learner's last one for the agent, or
/// that belongs to an abandoned tick, is ignored and not counted.
class Lockstep {
 public:
  explicit Lockstep(int misses_until_absent) : misses_until_absent_(misses_until_absent) {}

  void setMissesUntilAbsent(int misses) { misses_until_absent_ = misses; }

  /// @brief Requests answers for these agents. A tick that is still open is abandoned.
  void open(std::uint64_t episode, std::uint64_t tick, const std::vector<AgentId>& agents);
  /// @brief Accepts the answers of a learner. @return the refused answers, valid until the next call
  const std::vector<RefusedAnswer>& take(const RelativeActions& answers, LearnerId learner);
  /// @brief Counts answers addressed to another controller as dropped.
  void drop(const RelativeActions& answers) { dropped_ += answers.agents.size(); }
  /// @brief Closes the tick and counts the missing answers. The answers are in answers().
  /// @return the agents that become absent
  std::vector<AgentId> close();

  /// @brief Whether no answer is awaited any more.
  bool isComplete() const { return awaited_ == 0; }
  /// @brief Whether all agents of the tick are absent.
  bool isDeserted() const { return present_ == 0 && !asked_.empty(); }
  /// @brief Whether an awaited agent has never been answered for.
  bool awaitsNewcomer() const;
  /// @brief Marks those of the agents as absent that have never been answered for, also outside the present tick.
  /// @return the agents that become absent
  std::vector<AgentId> giveUpOnNewcomers(const std::vector<AgentId>& agents);
  /// @brief Whether all of these agents are absent.
  bool areAbsent(const std::vector<AgentId>& agents) const;

  const std::vector<AgentAction>& answers() const { return answers_; }
  /// @brief Agents of the present tick without an answer, absent ones included.
  std::vector<AgentId> missing() const;
  /// @brief Number of missing answers since the last resetCounts().
  std::uint64_t missedCount() const { return missed_; }
  /// @brief Number of refused answers since the last resetCounts().
  std::uint64_t droppedCount() const { return dropped_; }
  void resetCounts();
  /// @brief Number of agents of which anything is known.
  std::size_t knownCount() const { return records_.size(); }

 private:
  using Moment = std::pair<std::uint64_t, std::uint64_t>;  // episode, tick

  struct TakenAnswer {
    LearnerId learner = 0;
    Moment moment;
    RelativeAction action;
  };
  struct AgentRecord {
    std::optional<Moment> asked_at;   // last request
    std::optional<TakenAnswer> last;  // last accepted answer
    bool heard = false;               // answered for at least once
    int misses = 0;                   // consecutive
    bool absent = false;
    bool asked = false;     // in the open tick
    bool answered = false;  // in the open tick
  };

  bool wasAsked(AgentId agent) const {
    const AgentRecord* const record = records_.find(agent);
    return record != nullptr && record->asked_at.has_value();
  }
  /// Forgets agents that are not asked any more, if there are many records.
  void forgetDeparted();
  void takeOne(const AgentAction& answer, const Moment& moment, LearnerId learner);
  void markPresent(AgentRecord& record);
  Refusal causeOf(const AgentRecord& record, const Moment& moment, LearnerId learner) const;
  void refuse(Refusal cause, const AgentAction& answer, const Moment& moment, LearnerId learner);

  int misses_until_absent_;
  Moment now_;
  bool open_ = false;
  std::optional<Moment> abandoned_;
  AgentMap<AgentRecord> records_;
  std::size_t most_records_ = FEW_AGENTS;  // with more, forgetDeparted() looks for agents that have left
  std::vector<AgentId> asked_;
  std::vector<AgentAction> answers_;
  std::vector<RefusedAnswer> refused_;
  std::size_t awaited_ = 0;  // agents of the tick that are present and not yet answered for
  std::size_t present_ = 0;  // agents of the tick that are not absent
  std::uint64_t missed_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace crowd
