#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "social_crowd/learning/rl/rows.h"

namespace crowd {

/// @brief Names a source: one line of experience, to which one learner alone adds. So what two tables know of a source
/// is the same experience as far as it goes, and the larger number of visits holds the smaller one.
using SourceId = std::uint64_t;
constexpr SourceId NO_SOURCE = 0;

/// @brief A name that no source has yet, wherever it is; another one in each run.
SourceId newSource();

/// @brief Visits of some rows, of every action each: what a table holds of one source. Rows without visits take no
/// memory.
class VisitCounts {
 public:
  explicit VisitCounts(Action actions) : actions_(actions) {}

  /// @brief Adds the visits of a row, one number for each action; rows are added in rising order. One without any visit
  /// is left out.
  void add(Row row, const std::uint32_t* visits);

  bool isEmpty() const { return rows_.empty(); }
  Action actions() const { return actions_; }
  const std::vector<Row>& rows() const { return rows_; }
  /// @brief The visits of the row at that place among rows().
  const std::uint32_t* at(std::size_t place) const { return &visits_[place * actions_]; }
  /// @brief Of memory.
  std::size_t bytes() const {
    return sizeof *this + rows_.capacity() * sizeof(Row) + visits_.capacity() * sizeof(std::uint32_t);
  }
  /// @brief Gives back the memory that was kept for more rows.
  void finish();

 private:
  Action actions_;
  std::vector<Row> rows_;  // rising
  std::vector<std::uint32_t> visits_;
};

/// @brief What a table holds of one source. The visits never change: tables share them.
struct Contribution {
  SourceId source;
  std::shared_ptr<const VisitCounts> visits;
};

/// @brief By rising source, each of them once.
using Contributions = std::vector<Contribution>;

/// @brief Reads visit counts row after row.
class VisitCursor {
 public:
  /// @param visits null: there are none
  explicit VisitCursor(const VisitCounts* visits) : visits_(visits) {}

  /// @brief The visits of a row, null if there are none; must be asked for rising rows.
  const std::uint32_t* at(Row row) {
    if (visits_ == nullptr) return nullptr;
    const std::vector<Row>& rows = visits_->rows();
    while (place_ < rows.size() && rows[place_] < row) ++place_;
    return place_ < rows.size() && rows[place_] == row ? visits_->at(place_) : nullptr;
  }

 private:
  const VisitCounts* visits_;
  std::size_t place_ = 0;
};

}  // namespace crowd
