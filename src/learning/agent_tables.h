#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/agent_id.h"
#include "learning/rl/table_store.h"

namespace crowd {

/// @throws ShapeError unless the table has these numbers of rows and actions
void requireShape(const QTable& table, Row rows, Action actions);

/// @brief The Q-tables of the agents of a learner, which is told of agents by add(). Each has a place, a number from 0
/// up; new agents get the places of those that were forgotten. Not thread-safe, except that functions that are const
/// may run concurrently.
class AgentTables {
 public:
  AgentTables(QTable table, TableUse use) : store_(std::move(table), use) {}

  // Copies would write to the same table.
  AgentTables(const AgentTables&) = delete;
  AgentTables& operator=(const AgentTables&) = delete;
  AgentTables(AgentTables&&) = default;
  AgentTables& operator=(AgentTables&&) = default;
  ~AgentTables() = default;

  /// @brief Whether agents share one table or have their own.
  TableUse use() const { return store_.use(); }
  /// @brief The table that an agent uses; for an unknown agent, the table that it would begin with.
  const QTable& of(AgentId agent) const { return store_.table(placeOf(agent)); }
  /// @brief The table that unknown agents begin with; with shared tables, that of all agents.
  const QTable& base() const { return store_.table(TableStore::BASE); }
  /// @brief Returns a copy of an agent's table for other agents. Its experience is recognised when it is merged later.
  QTable toShare(AgentId agent);
  /// @brief Returns a copy of that table for a file. Its experience is recognised, too. The copy depends only on the
  /// table, so that the same training gives the same file.
  QTable toSave(AgentId agent);

  using Taken = TableStore::Taken;
  /// @brief Result of take() for all agents.
  struct TakenByAll {
    Taken newcomers;                    ///< for unknown agents; with shared tables for all agents
    std::map<AgentId, Taken> by_agent;  ///< for known agents, with own tables
  };
  /// @brief Gives a table to all present and future agents. @throws ShapeError; nothing has changed then
  TakenByAll take(QTable table, TakeMethod method);
  /// @brief Gives a table to one agent; with shared tables, to all agents. @throws ShapeError; nothing has changed then
  Taken take(AgentId agent, QTable table, TakeMethod method);
  /// @brief Replaces the tables of all agents, as if this learner had learned the whole table. @throws ShapeError
  void restart(QTable table);
  /// @brief Replaces the table of one agent in the same way; with shared tables, that of all agents. @throws ShapeError
  void restart(AgentId agent, QTable table);

  /// @brief Separates what is learned from now on from the previous contents, see TableStore.
  void beginSources() { store_.beginSources(); }

  /// @brief The known agents, sorted by id.
  std::vector<AgentId> agents() const;
  /// @brief Number of known agents.
  std::size_t size() const { return places_.size(); }
  /// @brief Adds an agent unless it is known. Returns its place.
  std::uint32_t add(AgentId agent);
  /// @brief The place of an agent; TableStore::BASE if it is unknown.
  std::uint32_t placeOf(AgentId agent) const {
    const auto found = places_.find(agent);
    return found != places_.end() ? found->second : TableStore::BASE;
  }
  /// @brief The table of a place.
  const QTable& at(std::uint32_t place) const { return store_.table(place); }
  /// @brief The same for writing; valid until the next call of a function that is not const.
  QTable& writableAt(std::uint32_t place) { return store_.writable(place); }
  /// @brief Forgets the agents for whose places is_gone(place) holds; with shared tables only.
  template <typename IsGone>
  void forgetIf(const IsGone& is_gone) {
    for (auto known = places_.begin(); known != places_.end();) {
      if (!is_gone(known->second)) {
        ++known;
        continue;
      }
      free_places_.push_back(known->second);
      known = places_.erase(known);
    }
  }

 private:
  TableStore store_;  // by place
  std::unordered_map<AgentId, std::uint32_t> places_;
  std::vector<std::uint32_t> free_places_;  // of agents that were forgotten
};

}  // namespace crowd
