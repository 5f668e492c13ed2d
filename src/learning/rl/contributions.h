#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "learning/rl/rows.h"

namespace crowd {

/// @brief Identifies a source: a line of experience to which only one learner adds. If two tables hold visits of the
/// same source, the larger number of visits includes the smaller one.
using SourceId = std::uint64_t;
/// @brief Stands for no source.
constexpr SourceId NO_SOURCE = 0;

/// @brief Returns a random identifier, unique with high probability, different in each run.
SourceId newSource();

/// @brief The visits that a table holds of one source, stored as the visited rows with one number per action.
class VisitCounts {
 public:
  explicit VisitCounts(Action actions) : actions_(actions) {}

  /// @brief Adds the visits of a row, one number per action. Rows must be added in ascending order. A row without
  /// visits is not stored.
  void add(Row row, const std::uint32_t* visits);

  bool isEmpty() const { return rows_.empty(); }
  Action actions() const { return actions_; }
  /// @brief The stored rows, ascending.
  const std::vector<Row>& rows() const { return rows_; }
  /// @brief The visits of rows()[place], one number per action; valid until the next add().
  const std::uint32_t* at(std::size_t place) const { return &visits_[place * actions_]; }
  /// @brief Memory in use [bytes].
  std::size_t bytes() const {
    return sizeof *this + rows_.capacity() * sizeof(Row) + visits_.capacity() * sizeof(std::uint32_t);
  }
  /// @brief Releases unused capacity; to be called after the last add().
  void finish();

 private:
  Action actions_;
  std::vector<Row> rows_;  // ascending
  std::vector<std::uint32_t> visits_;
};

/// @brief The visits that a table holds of one source. They are immutable, and tables share them.
struct Contribution {
  SourceId source;
  std::shared_ptr<const VisitCounts> visits;
};

/// @brief Sorted by source, without duplicates.
using Contributions = std::vector<Contribution>;

/// @brief Reads visit counts in ascending order of rows.
class VisitCursor {
 public:
  /// @param visits must outlive the cursor; null: no visits
  explicit VisitCursor(const VisitCounts* visits) : visits_(visits) {}

  /// @brief Returns the visits of a row, null if there are none. Rows must be requested in ascending order.
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
