#include "learning/rl/q_table.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "social_crowd/errors.h"

namespace crowd {

QTable::QTable(Row rows, Action actions) : rows_(rows), actions_(actions) {
  if (rows == 0 || actions == 0) throw ShapeError("a Q-table needs at least one row and one action");
  const std::size_t size = static_cast<std::size_t>(rows) * actions;
  values_.assign(size, 0.0);
  visits_.assign(size, 0);
}

void QTable::set(Row row, Action action, double value, std::uint32_t visits) {
  values_[index(row, action)] = value;
  visits_[index(row, action)] = visits;
}

Action QTable::greedyAction(const Rows& rows) const {
  if (!rows.isOne()) return greedyAmong(rows);
  // A second pass is faster than tracking the index of the maximum.
  const double* values = &values_[index(rows[0], 0)];
  const double highest = highestOf(rows[0]);
  Action action = 0;
  while (values[action] < highest) ++action;
  return action;
}

Action QTable::greedyAction(const Rows& rows, double tie) const {
  const double highest = greedyValue(rows);
  Action equals = 0;
  for (Action action = 0; action < actions_; ++action) equals += value(action, rows) == highest ? 1 : 0;
  auto left = static_cast<Action>(tie * equals);  // below `equals`, because tie is below 1
  for (Action action = 0; action < actions_; ++action) {
    if (value(action, rows) == highest && left-- == 0) return action;
  }
  return 0;  // only if values are NaN
}

Action QTable::greedyAmong(const Rows& rows) const {
  Action best = 0;
  double highest = value(0, rows);
  for (Action action = 1; action < actions_; ++action) {
    const double candidate = value(action, rows);
    const bool higher = candidate > highest;
    highest = higher ? candidate : highest;
    best = higher ? action : best;
  }
  return best;
}

bool QTable::isVisited(Row row) const {
  const auto first = visits_.begin() + static_cast<std::ptrdiff_t>(index(row, 0));
  return std::any_of(first, first + actions_, [](std::uint32_t visits) { return visits > 0; });
}

Row QTable::visitedRows() const {
  Row count = 0;
  for (Row row = 0; row < rows_; ++row) count += isVisited(row) ? 1 : 0;
  return count;
}

void QTable::noteFirstVisit(Row row) {
  const std::uint32_t* const visits = &visits_[index(row, 0)];
  new_rows_ += std::accumulate(visits, visits + actions_, std::uint64_t{0}) == 1 ? 1 : 0;
}

std::uint64_t QTable::allVisits() const { return std::accumulate(visits_.begin(), visits_.end(), std::uint64_t{0}); }

bool operator==(const QTable& a, const QTable& b) {
  return a.rows_ == b.rows_ && a.actions_ == b.actions_ && a.visits_ == b.visits_ &&
         std::memcmp(a.values_.data(), b.values_.data(), a.values_.size() * sizeof(double)) == 0;
}

}  // namespace crowd
