#include "learning/states/sectors.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace crowd {

MirroredSectors::MirroredSectors(std::vector<double> limits) : degrees_(std::move(limits)) {
  for (const double limit : degrees_) limits_.push_back(limit == 180.0 ? PI : toRadians(limit));
}

int MirroredSectors::positionOf(double angle) const {
  const auto beyond = std::upper_bound(limits_.begin(), limits_.end() - 1, std::abs(angle));
  const auto side_index = static_cast<int>(beyond - limits_.begin());
  return angle < 0.0 ? count() - 1 - side_index : side_index;
}

double MirroredSectors::rightLimit(int index) const {
  const auto side = static_cast<int>(limits_.size());
  return index < side ? inner(index) : -outer(index - side);
}

double MirroredSectors::leftLimit(int index) const {
  const auto side = static_cast<int>(limits_.size());
  return index < side ? outer(index) : -inner(index - side);
}

}  // namespace crowd
