// Merging of Q-tables: common visits of a source count once.

#include <algorithm>
#include <functional>

#include "learning/rl/q_table.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

std::string shapeOf(const QTable& table) {
  return std::to_string(table.rows()) + " rows of " + std::to_string(table.actions()) + " actions";
}

/// Returns the weighted mean; exactly the second value for a weight of 1, and never outside the interval of both.
double meanOf(double first, double second, double weight_of_second) {
  const double mean = (1.0 - weight_of_second) * first + weight_of_second * second;
  return std::clamp(mean, std::min(first, second), std::max(first, second));
}

/// Visits of one row and action, summed over all sources.
struct Tally {
  std::uint64_t only_mine = 0;
  std::uint64_t only_theirs = 0;
  std::uint64_t all = 0;
};

/// The visits that two tables hold of one source; "mine" is the table that is merged into.
class SourcePair {
 public:
  using Visits = std::shared_ptr<const VisitCounts>;

  /// @param mine, theirs null if the table has no visits of the source
  /// @param is_mine whether it is the own source of my table: no other table has more visits of it, even if mine are
  /// saturated
  SourcePair(SourceId source, Visits mine, Visits theirs, bool is_mine)
      : source_(source),
        is_mine_(is_mine),
        mine_(std::move(mine)),
        theirs_(std::move(theirs)),
        my_cursor_(mine_.get()),
        their_cursor_(theirs_.get()) {}

  SourceId source() const { return source_; }

  /// Whether theirs may hold visits that mine do not.
  bool mayBringNews() const { return !is_mine_ && theirs_ != nullptr && theirs_ != mine_; }

  /// Selects a row; rows must be selected in ascending order.
  void goTo(Row row) {
    my_row_ = my_cursor_.at(row);
    their_row_ = their_cursor_.at(row);
  }

  // The following two functions refer to the selected row.

  bool bringsNews() {
    for (Action action = 0; their_row_ != nullptr && action < theirs_->actions(); ++action) {
      if (their_row_[action] > (my_row_ != nullptr ? my_row_[action] : 0)) return they_lead_ = true;
    }
    return false;
  }

  void addTo(Tally& tally, Action action) const {
    const std::uint32_t mine = my_row_ != nullptr ? my_row_[action] : 0;
    std::uint32_t theirs = their_row_ != nullptr ? their_row_[action] : 0;
    if (is_mine_) theirs = std::min(mine, theirs);
    tally.only_mine += mine - std::min(mine, theirs);
    tally.only_theirs += theirs - std::min(mine, theirs);
    tally.all += std::max(mine, theirs);
  }

  /// Returns the larger of both; valid after bringsNews() was called for all rows. One of them is later and includes
  /// the other, unless a file was forged.
  Visits larger() const {
    if (!they_lead_) return mine_ != nullptr ? mine_ : theirs_;
    return holdsAll(*theirs_, mine_.get()) ? theirs_ : largerOfEach();
  }

 private:
  static bool holdsAll(const VisitCounts& whole, const VisitCounts* part) {
    if (part == nullptr) return true;
    VisitCursor cursor(&whole);
    for (std::size_t i = 0; i < part->rows().size(); ++i) {
      const std::uint32_t* const more = cursor.at(part->rows()[i]);
      const std::uint32_t* const less = part->at(i);
      if (more == nullptr || !std::equal(less, less + part->actions(), more, std::less_equal<>())) return false;
    }
    return true;
  }

  Visits largerOfEach() const {
    auto both = std::make_shared<VisitCounts>(mine_->actions());
    VisitCursor mine(mine_.get());
    VisitCursor theirs(theirs_.get());
    const Row end = 1 + std::max(mine_->rows().back(), theirs_->rows().back());
    std::vector<std::uint32_t> visits(both->actions());
    for (Row row = 0; row < end; ++row) {
      std::fill(visits.begin(), visits.end(), 0);
      for (const std::uint32_t* one : {mine.at(row), theirs.at(row)}) {
        if (one == nullptr) continue;
        for (Action action = 0; action < both->actions(); ++action) {
          visits[action] = std::max(visits[action], one[action]);
        }
      }
      both->add(row, visits.data());
    }
    both->finish();
    return both;
  }

  SourceId source_;
  bool is_mine_;
  Visits mine_;
  Visits theirs_;
  VisitCursor my_cursor_;
  VisitCursor their_cursor_;
  const std::uint32_t* my_row_ = nullptr;
  const std::uint32_t* their_row_ = nullptr;
  bool they_lead_ = false;
};

using SourcePairs = std::vector<SourcePair>;

/// Pairs the sources of both tables; a source that only one of them has is paired with null.
SourcePairs pairUp(const QTable& mine, const QTable& theirs) {
  const SourceId own = mine.source();
  const Contributions mines = mine.contributions();
  SourcePairs pairs;
  auto next = mines.begin();
  for (const Contribution& other : theirs.contributions()) {
    for (; next != mines.end() && next->source < other.source; ++next) {
      pairs.emplace_back(next->source, next->visits, nullptr, false);
    }
    const bool both = next != mines.end() && next->source == other.source;
    const bool is_own = other.source == own;
    if (both || !is_own) pairs.emplace_back(other.source, both ? next->visits : nullptr, other.visits, is_own);
    if (both) ++next;
  }
  for (; next != mines.end(); ++next) pairs.emplace_back(next->source, next->visits, nullptr, false);
  return pairs;
}

/// Calls use(row, action, tally) for each row and action of which only their table has visits.
template <typename Use>
void forEachNews(const QTable& table, SourcePairs& pairs, const Use& use) {
  // Pairs without news only contribute to the weights.
  const auto rest = std::partition(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.mayBringNews(); });
  for (Row row = 0; rest != pairs.begin() && row < table.rows(); ++row) {
    bool any = false;
    std::for_each(pairs.begin(), rest, [&](SourcePair& pair) {
      pair.goTo(row);
      any = pair.bringsNews() || any;
    });
    if (!any) continue;
    std::for_each(rest, pairs.end(), [&](SourcePair& pair) { pair.goTo(row); });
    for (Action action = 0; action < table.actions(); ++action) {
      Tally tally;
      for (const SourcePair& pair : pairs) pair.addTo(tally, action);
      if (tally.only_theirs > 0) use(row, action, tally);
    }
  }
}

void requireSameShape(const QTable& mine, const QTable& theirs) {
  if (mine.rows() == theirs.rows() && mine.actions() == theirs.actions()) return;
  throw ShapeError("cannot merge a Q-table of " + shapeOf(theirs) + " into one of " + shapeOf(mine));
}

}  // namespace

std::uint64_t QTable::newVisitsOf(const QTable& other) const {
  requireSameShape(*this, other);
  SourcePairs pairs = pairUp(*this, other);
  std::uint64_t news = 0;
  forEachNews(*this, pairs, [&](Row /*row*/, Action /*action*/, const Tally& tally) { news += tally.only_theirs; });
  return news;
}

std::uint64_t QTable::merge(const QTable& other) {
  requireSameShape(*this, other);
  nameSource(contentId());  // an unnamed source is identified by the content, which is about to change
  SourcePairs pairs = pairUp(*this, other);
  std::uint64_t news = 0;
  forEachNews(*this, pairs, [&](Row row, Action action, const Tally& tally) {
    news += tally.only_theirs;
    const auto sum = static_cast<double>(tally.only_mine + tally.only_theirs);
    const double fraction = static_cast<double>(tally.only_theirs) / sum;
    const auto visits = static_cast<std::uint32_t>(std::min<std::uint64_t>(tally.all, UINT32_MAX));
    set(row, action, meanOf(value(row, action), other.value(row, action), fraction), visits);
  });
  foreign_.clear();
  for (const SourcePair& pair : pairs) {
    if (pair.source() != source_) foreign_.push_back({pair.source(), pair.larger()});
  }
  std::sort(foreign_.begin(), foreign_.end(), [](const auto& a, const auto& b) { return a.source < b.source; });
  return news;
}

}  // namespace crowd
