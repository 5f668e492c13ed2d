#include "learning/states/obstacle_sectors.h"

namespace crowd {

ObstacleSectors::ObstacleSectors(int count, const std::vector<double>& limits) : even_(count), count_(count) {
  if (limits.empty()) return;
  limited_.emplace(limits);
  count_ = limited_->count();
}

int ObstacleSectors::mirrored(int sector) const {
  return limited_ ? limited_->mirrored(sector) : even_.mirrored(sector);
}

double ObstacleSectors::rightLimit(int sector) const {
  return limited_ ? limited_->rightLimit(sector) : even_.rightLimit(sector);
}

double ObstacleSectors::leftLimit(int sector) const {
  return limited_ ? limited_->leftLimit(sector) : even_.rightLimit(sector + 1);
}

}  // namespace crowd
