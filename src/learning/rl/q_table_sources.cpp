// The sources of the visits of a Q-table.

#include <algorithm>

#include "common/random.h"
#include "common/text/numbers.h"
#include "learning/rl/q_table.h"

namespace crowd {
namespace {

bool comesBefore(const Contribution& a, const Contribution& b) { return a.source < b.source; }

}  // namespace

template <typename Use>
void QTable::forEachOwnRow(const Use& use) const {
  std::vector<VisitCursor> others;
  for (const Contribution& other : foreign_) others.emplace_back(other.visits.get());
  std::vector<std::uint32_t> own(actions_);
  for (Row row = 0; row < rows_; ++row) {
    if (!isVisited(row)) continue;
    std::copy_n(&visits_[index(row, 0)], actions_, own.begin());
    for (VisitCursor& other : others) {
      const std::uint32_t* const visits = other.at(row);
      if (visits == nullptr) continue;
      // Foreign visits may exceed the sum if the sum is saturated.
      for (Action action = 0; action < actions_; ++action) own[action] -= std::min(own[action], visits[action]);
    }
    if (!use(row, own.data())) return;
  }
}

VisitCounts QTable::ownVisits() const {
  VisitCounts own(actions_);
  forEachOwnRow([&](Row row, const std::uint32_t* visits) {
    own.add(row, visits);
    return true;
  });
  own.finish();
  return own;
}

bool QTable::hasOwnVisits() const {
  bool found = false;
  forEachOwnRow([&](Row /*row*/, const std::uint32_t* visits) {
    found = std::any_of(visits, visits + actions_, [](std::uint32_t count) { return count > 0; });
    return !found;
  });
  return found;
}

SourceId QTable::source() const {
  if (isNamed()) return source_;
  return hasOwnVisits() ? contentId() : NO_SOURCE;
}

void QTable::nameSource(SourceId name) {
  if (!isNamed() && hasOwnVisits()) source_ = name;
}

Contributions QTable::contributions() const {
  Contributions all = foreign_;
  auto own = std::make_shared<const VisitCounts>(ownVisits());
  if (own->isEmpty()) return all;
  const Contribution mine = {source(), std::move(own)};
  all.insert(std::upper_bound(all.begin(), all.end(), mine, comesBefore), mine);
  return all;
}

void QTable::beginSource() {
  foreign_ = contributions();
  source_ = NO_SOURCE;
}

void QTable::setSources(SourceId own, Contributions foreign) {
  source_ = own;
  foreign_ = std::move(foreign);
}

SourceId QTable::contentId() const {
  KeyedRandom sum(rows_, KeyedRandom::CONTENT, {actions_});
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const std::uint64_t value = bitsOf(values_[i]);
    if (visits_[i] > 0 || value != 0) sum = sum.with(i).with(visits_[i]).with(value);
  }
  return std::max<SourceId>(sum.next(), 1);
}

}  // namespace crowd
