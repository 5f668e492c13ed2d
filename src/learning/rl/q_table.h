#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "learning/rl/contributions.h"
#include "learning/rl/rows.h"

namespace crowd {

/// @brief Values and visits of every pair of row and action, rows() x actions(), initially zero. Values have the unit
/// of the reward. Not thread-safe; indices are not checked.
///
/// A table records the sources of its visits (docs/q_tables.md, "Replacing and merging"), so that experience that two
/// tables have in common counts once when they are merged: its own source, to which everything learned in it belongs,
/// and foreign sources that it received. The visits of its own source are not stored; they are all visits less the
/// foreign ones.
class QTable {
 public:
  /// @throws ShapeError unless there is at least one row and one action.
  QTable(Row rows, Action actions);

  Row rows() const { return rows_; }
  Action actions() const { return actions_; }

  /// @brief Returns the value of a row and action.
  double value(Row row, Action action) const { return values_[index(row, action)]; }
  /// @brief Returns the number of decisions that the value was learned from; saturates.
  std::uint32_t visits(Row row, Action action) const { return visits_[index(row, action)]; }
  /// @brief Sets the value and the visits of a row and action.
  void set(Row row, Action action, double value, std::uint32_t visits);
  /// @brief Adds to a value.
  void addTo(Row row, Action action, double change) { values_[index(row, action)] += change; }
  /// @brief Increments the visits of a row and action. @return the new number of visits
  std::uint32_t countVisit(Row row, Action action) {
    std::uint32_t& visits = visits_[index(row, action)];
    visits += visits != UINT32_MAX ? 1 : 0;
    if (visits == 1) noteFirstVisit(row);
    return visits;
  }

  /// @brief Returns the action of the highest value; of equal values the first, so that ties are deterministic.
  Action greedyAction(const Rows& rows) const;
  /// @brief Returns one of the actions of the highest value.
  /// @param tie in [0, 1): of n such actions number floor(tie * n) is taken, counted from 0
  Action greedyAction(const Rows& rows, double tie) const;
  /// @brief Returns the highest value.
  double greedyValue(const Rows& rows) const { return rows.isOne() ? highestOf(rows[0]) : highestAmong(rows); }

  /// @brief Whether any action of the row has visits.
  bool isVisited(Row row) const;
  /// @brief Number of rows with visits; looks at all rows.
  Row visitedRows() const;
  /// @brief Number of rows whose first visit was counted by countVisit(), here and in the table that this one was
  /// copied from. The difference of two calls is the number of rows visited for the first time between them.
  Row newRows() const { return new_rows_; }

  /// @brief Sum of the visits of all rows and actions.
  std::uint64_t allVisits() const;

  /// @brief Merges the experience of another table into this one. Each value becomes the mean of both, weighted by the
  /// visits that only this table and only the other one has; if the other one has none of its own, the value stays. Of
  /// each source, the larger number of visits counts.
  /// @return number of visits that were new to this table
  /// @throws ShapeError if the shapes differ
  std::uint64_t merge(const QTable& other);
  /// @brief Returns the number of visits that only the other table has. @throws ShapeError if the shapes differ.
  std::uint64_t newVisitsOf(const QTable& other) const;

  /// @brief Returns the own source: its name or, without a name, contentId(); NO_SOURCE without own visits. So tables
  /// that were read from files of the same content have the same source.
  SourceId source() const;
  /// @brief Whether the own source has a name.
  bool isNamed() const { return source_ != NO_SOURCE; }
  /// @brief Names the own source, unless it has a name or no visits. Must be called before a copy of the table is given
  /// away while learning continues in this one.
  void nameSource(SourceId name);
  /// @brief Makes all present visits foreign and begins a new own source. Must be called before learning in a table of
  /// which other copies may exist.
  void beginSource();
  /// @brief Whether the own source has visits.
  bool hasOwnVisits() const;
  /// @brief The visits of foreign sources.
  const Contributions& foreign() const { return foreign_; }
  /// @brief Returns the visits of all sources, the own one included.
  Contributions contributions() const;
  /// @brief Sets the sources of the visits; used when a file is read. @param own name of the own source, NO_SOURCE:
  /// none
  void setSources(SourceId own, Contributions foreign);
  /// @brief Returns a checksum of visits and values, never 0.
  SourceId contentId() const;

  /// @brief Whether shapes, visits and values are equal, values bit for bit. Sources are not compared.
  friend bool operator==(const QTable& a, const QTable& b);
  friend bool operator!=(const QTable& a, const QTable& b) { return !(a == b); }

 private:
  /// Counts the row if it has a single visit.
  void noteFirstVisit(Row row);
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
  /// Returns the highest of value_of(action).
  template <typename ValueOf>
  double highest(const ValueOf& value_of) const {
    // Two independent chains of maxima, but scalar loads: one of the values has often just been written, and a vector
    // load that covers it would have to wait for the store.
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
  Row new_rows_ = 0;
  SourceId source_ = NO_SOURCE;  // name of the own source
  Contributions foreign_;
};

}  // namespace crowd
