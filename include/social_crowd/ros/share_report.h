#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "social_crowd/learning/learner.h"

namespace crowd {

/// @brief Which agents of a learner took a table, and what became of it.
class TakeReport {
 public:
  explicit TakeReport(TakeMethod method) : method_(method) {}

  void note(AgentId agent, const Learner::Taken& taken);
  /// @brief It was taken for agents that are not met yet.
  void noteNewcomers(const Learner::Taken& taken) { by_outcome_[{taken.visits, taken.new_visits}]; }

  std::vector<AgentId> agents() const;
  /// @brief Such as "merged into the table of agents 2, 3 (12 visits, 9 of them new)".
  std::string text() const;

 private:
  TakeMethod method_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<AgentId>> by_outcome_;  // visits, new ones
};

/// @brief Who took a shared table and who did not.
class ShareReport {
 public:
  /// @param text what became of it
  void noteTaken(const std::vector<AgentId>& agents, const std::string& text);
  void noteProblem(const std::string& problem);
  bool isTakenBy(AgentId agent) const { return taken_.count(agent) > 0; }

  bool isFine() const { return is_fine_; }
  std::vector<AgentId> takenBy() const { return {taken_.begin(), taken_.end()}; }
  /// @brief All that was noted.
  std::string text() const;

 private:
  void add(const std::string& text) { text_ += (text_.empty() ? "" : "; ") + text; }

  std::set<AgentId> taken_;
  std::string text_;
  bool is_fine_ = true;
};

}  // namespace crowd
