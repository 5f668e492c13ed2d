#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "social_crowd/learning/rl/contributions.h"
#include "social_crowd/learning/rl/rows.h"

namespace crowd {

/// @brief Values and visits of every row and action; rows * actions of each, all zero at first.
///
/// A table knows which sources its visits come from (docs/learning.md, Replacing and merging): one of its own, to which
/// all that is learned in it belongs, and others that it was given. So what two tables have in common counts once when
/// they are merged. The visits of the own source are those that are left; learning does nothing for it.
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

  /// @brief Of all rows and actions.
  std::uint64_t allVisits() const;

  /// @brief Takes over what the other table knows and this one does not. Each value becomes the mean of both, weighted
  /// by the visits that only the one and only the other has; where only one of them has any, its value is taken, where
  /// none has, the value stays. Of each source the larger number of visits counts. @return the visits that were new to
  /// this table @throws ShapeError if the shapes differ.
  std::uint64_t merge(const QTable& other);
  /// @brief How many visits the other table has that this one has not. @throws ShapeError if the shapes differ.
  std::uint64_t newVisitsOf(const QTable& other) const;

  /// @brief The own source: its name, or where it has none, a checksum of what the table holds; NO_SOURCE if no visit
  /// is its own. So two tables that were read from files of the same content have the same source.
  SourceId source() const;
  bool isNamed() const { return source_ != NO_SOURCE; }
  /// @brief Gives the own source a name, unless it has one or no visits. To be done before somebody else is given the
  /// table while learning goes on in this one.
  void nameSource(SourceId name);
  /// @brief From now on learning belongs to a new source: all there is, is somebody's. To be done with a table that
  /// others may have, too, before anything is learned in it.
  void beginSource();
  /// @brief Whether there are visits of the own source.
  bool hasOwnVisits() const;
  /// @brief What the table holds of other sources.
  const Contributions& foreign() const { return foreign_; }
  /// @brief The same and what it holds of its own.
  Contributions contributions() const;
  /// @brief For readers of files: the sources of what was set. @param own NO_SOURCE: without a name
  void setSources(SourceId own, Contributions foreign);
  /// @brief Checksum of visits and values, never 0.
  SourceId contentId() const;

  /// @brief Same shape, same visits, same values bit for bit, whatever their sources.
  friend bool operator==(const QTable& a, const QTable& b);
  friend bool operator!=(const QTable& a, const QTable& b) { return !(a == b); }

 private:
  VisitCounts ownVisits() const;
  /// Calls use(row, visits of each action of the own source) for every visited row until it returns false.
  template <typename Use>
  void forEachOwnRow(const Use& use) const;
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
  SourceId source_ = NO_SOURCE;  // name of the own one
  Contributions foreign_;
};

}  // namespace crowd
