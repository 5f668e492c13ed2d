#include "world/neighbours.h"

#include <algorithm>

namespace crowd {

void NeighbourList::grow(std::size_t size) {
  const std::size_t capacity = std::max(size + PADDING, 2 * kinds_.size());
  for (std::vector<double>* numbers : {&xs_, &ys_, &vxs_, &vys_, &radii_}) numbers->resize(capacity);
  kinds_.resize(capacity);
}

void NeighbourList::setIntent(std::size_t i, const RobotIntent& intent) {
  if (intents_.size() <= i) intents_.resize(kinds_.size());
  intents_[i] = intent;
}

}  // namespace crowd
