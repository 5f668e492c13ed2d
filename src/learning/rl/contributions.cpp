#include "learning/rl/contributions.h"

#include <algorithm>
#include <random>

namespace crowd {

SourceId newSource() {
  std::random_device chance;
  const SourceId high = chance();
  return std::max<SourceId>((high << 32U) ^ chance(), 1);
}

void VisitCounts::add(Row row, const std::uint32_t* visits) {
  if (std::all_of(visits, visits + actions_, [](std::uint32_t count) { return count == 0; })) return;
  rows_.push_back(row);
  visits_.insert(visits_.end(), visits, visits + actions_);
}

void VisitCounts::finish() {
  rows_.shrink_to_fit();
  visits_.shrink_to_fit();
}

}  // namespace crowd
