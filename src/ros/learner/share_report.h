#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "learning/learner.h"

namespace crowd {

/// @brief Result of taking a table, for the agents of one learner.
class TakeReport {
 public:
  explicit TakeReport(TakeMethod method) : method_(method) {}

  void note(AgentId agent, const AgentTables::Taken& taken);
  /// @brief Notes that the table was taken for agents that are not known yet.
  void noteNewcomers(const AgentTables::Taken& taken) { by_outcome_[{taken.visits, taken.new_visits}]; }

  std::vector<AgentId> agents() const;
  /// @brief Returns a text such as "merged into the table of agents 2, 3 (12 visits, 9 of them new)".
  std::string text() const;

 private:
  TakeMethod method_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<AgentId>> by_outcome_;  // visits, new ones
};

/// @brief Result of sharing a table with agents of one or more learners.
class ShareReport {
 public:
  /// @param text result
  void noteTaken(const std::vector<AgentId>& agents, const std::string& text);
  void noteProblem(const std::string& problem);
  bool isTakenBy(AgentId agent) const { return taken_.count(agent) > 0; }

  bool isFine() const { return is_fine_; }
  std::vector<AgentId> takenBy() const { return {taken_.begin(), taken_.end()}; }
  /// @brief Returns all notes as text.
  std::string text() const;

 private:
  void add(const std::string& text) { text_ += (text_.empty() ? "" : "; ") + text; }

  std::set<AgentId> taken_;
  std::string text_;
  bool is_fine_ = true;
};

}  // namespace crowd
