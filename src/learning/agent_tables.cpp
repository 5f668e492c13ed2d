#include "learning/agent_tables.h"

#include <algorithm>
#include <string>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {

void requireShape(const QTable& table, Row rows, Action actions) {
  if (table.rows() == rows && table.actions() == actions) return;
  throw ShapeError("expected a Q-table of " + std::to_string(rows) + " rows and " + std::to_string(actions) +
                   " actions, got " + std::to_string(table.rows()) + " and " + std::to_string(table.actions()));
}

std::vector<AgentId> AgentTables::agents() const {
  std::vector<AgentId> known;
  for (const auto& [agent, place] : places_) known.push_back(agent);
  std::sort(known.begin(), known.end());
  return known;
}

std::uint32_t AgentTables::add(AgentId agent) {
  const auto [known, is_new] = places_.try_emplace(agent, places_.size() + free_places_.size());
  if (!is_new) return known->second;
  if (!free_places_.empty()) {
    known->second = free_places_.back();
    free_places_.pop_back();
  } else {
    store_.addUser();
  }
  return known->second;
}

QTable AgentTables::toShare(AgentId agent) {
  store_.nameSource(placeOf(agent), newSource());
  return of(agent);
}

QTable AgentTables::toSave(AgentId agent) {
  store_.nameSource(placeOf(agent), of(agent).contentId());
  return of(agent);
}

AgentTables::TakenByAll AgentTables::take(QTable table, TakeMethod method) {
  requireShape(table, base().rows(), base().actions());
  const TableStore::TakenByAll taken = store_.take(std::move(table), method);
  TakenByAll by_agent{taken.base, {}};
  for (const auto& [agent, place] : places_) {
    if (use() == TableUse::OWN) by_agent.by_agent[agent] = taken.by_user[place];
  }
  return by_agent;
}

AgentTables::Taken AgentTables::take(AgentId agent, QTable table, TakeMethod method) {
  requireShape(table, base().rows(), base().actions());
  const std::uint32_t place = use() == TableUse::OWN ? add(agent) : TableStore::BASE;
  return store_.take(place, std::move(table), method);
}

void AgentTables::restart(QTable table) {
  requireShape(table, base().rows(), base().actions());
  store_.restart(std::move(table));
}

void AgentTables::restart(AgentId agent, QTable table) {
  if (use() == TableUse::SHARED) return restart(std::move(table));
  requireShape(table, base().rows(), base().actions());
  store_.restart(add(agent), std::move(table));
}

}  // namespace crowd
