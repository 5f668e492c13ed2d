#include "tools/terminal/episode_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crowd {

void EpisodeCurve::add(double value) {
  if (episodes_ == most_ * bin_size_) joinNeighbours();
  if (episodes_ % bin_size_ == 0) bins_.emplace_back();
  ++episodes_;
  if (std::isnan(value)) return;
  bins_.back().sum += value;
  ++bins_.back().count;
}

void EpisodeCurve::joinNeighbours() {
  for (std::size_t i = 0; i < bins_.size() / 2; ++i) {
    const Bin& first = bins_[2 * i];
    const Bin& second = bins_[2 * i + 1];
    bins_[i] = {first.sum + second.sum, first.count + second.count};
  }
  bins_.resize(bins_.size() / 2);
  bin_size_ *= 2;
}

std::vector<double> EpisodeCurve::means(std::size_t points) const {
  std::vector<double> means(points, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t point = 0; point < points && !bins_.empty(); ++point) {
    const std::size_t begin = point * bins_.size() / points;
    const std::size_t end = std::max(begin + 1, (point + 1) * bins_.size() / points);
    Bin sum;
    for (std::size_t i = begin; i < end; ++i) {
      sum.sum += bins_[i].sum;
      sum.count += bins_[i].count;
    }
    if (sum.count > 0) means[point] = sum.sum / static_cast<double>(sum.count);
  }
  return means;
}

}  // namespace crowd
