#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "social_crowd/learning/state_set.h"

namespace crowd {

/// @brief Values and visits of every row and action; rows * actions of each, all zero at first.
class QTable {
 public:
  /// @throws ShapeError unless there is at least one row and one action.
  QTable(Row rows, Action actions);

  Row rows() const { return rows_; }
  Action actions() const { return actions_; }

  double value(Row row, Action action) const { return values_[index(row, action)]; }
  /// @brief How many decisions the value was learned from; saturates.
  std::uint32_t visits(Row row, Action action) const { return visits_[index(row, action)]; }
  void set(Row row, Action action, double value, std::uint32_t visits);
  /// @brief Adds to a value.
  void addTo(Row row, Action action, double change) { values_[index(row, action)] += change; }
  /// @brief Counts a decision that the value is learned from. @return how many there are now
  std::uint32_t countVisit(Row row, Action action) {
    std::uint32_t& visits = visits_[index(row, action)];
    return visits += visits != UINT32_MAX ? 1 : 0;
  }

  /// @brief The action of the highest value; of equal ones the first, so that ties break the same way every time.
  Action greedyAction(const Rows& rows) const;
  /// @brief One of the actions of the highest value.
  /// @param tie in [0, 1), decides between them: with n of them, number tie * n, rounded down, counted from 0
  Action greedyAction(const Rows& rows, double tie) const;
  /// @brief The highest value.
  double greedyValue(const Rows& rows) const { return rows.isOne() ? highestOf(rows[0]) : highestAmong(rows); }

  /// @brief Whether any action of the row was ever decided on.
  bool isVisited(Row row) const;
  Row visitedRows() const;

  /// @brief Takes over what the other table knows: each value becomes the mean of both, weighted by visits; visits add
  /// up. Where neither was visited the value stays. @throws ShapeError if the shapes differ.
  void mergeByVisits(const QTable& other);

  /// @brief Same shape, same visits, same values bit for bit.
  friend bool operator==(const QTable& a, const QTable& b);
  friend bool operator!=(const QTable& a, const QTable& b) { return !(a == b); }

 private:
  std::size_t index(Row row, Action action) const { return static_cast<std::size_t>(row) * actions_ + action; }
  double value(Action action, const Rows& rows) const { return value(rows[action], action); }
  Action greedyAmong(const Rows& rows) const;
  double highestAmong(const Rows& rows) const {
    return highest([&](Action action) { return value(action, rows); });
  }
  double highestOf(Row row) const {
    return highest([values = &values_[index(row, 0)]](Action action) { return values[action]; });
  }
  /// The highest of the values that `value_of` tells of each action.
  template <typename ValueOf>
  double highest(const ValueOf& value_of) const {
    // Two that do not wait for each other, but one by one: one of the values has often just been written, and two at
    // once could not be read before that is in the cache.
    double even = value_of(actions_ - 1);
    double odd = even;
    for (Action action = 0; action + 1 < actions_; action += 2) {
      even = std::max(value_of(action), even);
      odd = std::max(value_of(action + 1), odd);
    }
    return std::max(even, odd);
  }

  Row rows_;
  Action actions_;
  std::vector<double> values_;
  std::vector<std::uint32_t> visits_;
};

}  // namespace crowd
