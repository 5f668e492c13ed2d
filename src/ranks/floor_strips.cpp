#include "ranks/floor_strips.h"

#include <algorithm>
#include <limits>

#include "simulation/byte_archive.h"

namespace crowd {
namespace {

constexpr std::size_t BINS = 4096;

}  // namespace

FloorStrips::FloorStrips(const std::vector<Vector2>& places, int count)
    : borders_(static_cast<std::size_t>(count - 1), 0.0) {
  Vector2 low = Vector2::Constant(INFINITE);
  Vector2 high = Vector2::Constant(-INFINITE);
  for (const Vector2& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  axis_ = high.x() - low.x() >= high.y() - low.y() || places.empty() ? 0 : 1;
  SingleProcess alone;
  balance(places, alone);
}

void FloorStrips::balance(const std::vector<Vector2>& places, Communicator& communicator) {
  Histogram histogram{INFINITE, -INFINITE, std::vector<std::uint64_t>(BINS, 0)};
  for (const Vector2& place : places) {
    histogram.low = std::min(histogram.low, along(place));
    histogram.high = std::max(histogram.high, along(place));
  }
  Communicator::Bytes bytes;
  ByteWriter write(bytes);
  write(histogram.low);
  write(histogram.high);
  for (const Communicator::Bytes& others : communicator.gatherAll(bytes)) {
    ByteReader read(others);
    double low = 0.0;
    double high = 0.0;
    read(low);
    read(high);
    histogram.low = std::min(histogram.low, low);
    histogram.high = std::max(histogram.high, high);
  }
  if (histogram.low > histogram.high) return;  // there are no places
  count(places, histogram);
  communicator.sum(histogram.counts);
  divide(histogram);
}

void FloorStrips::count(const std::vector<Vector2>& places, Histogram& histogram) const {
  const double width = (histogram.high - histogram.low) / static_cast<double>(BINS);
  for (const Vector2& place : places) {
    const double bin = width > 0.0 ? (along(place) - histogram.low) / width : 0.0;
    ++histogram.counts[std::min(BINS - 1, static_cast<std::size_t>(bin))];
  }
}

void FloorStrips::divide(const Histogram& histogram) {
  std::uint64_t total = 0;
  for (const std::uint64_t count : histogram.counts) total += count;
  const double width = (histogram.high - histogram.low) / static_cast<double>(BINS);
  std::uint64_t before = 0;
  std::size_t bin = 0;
  for (std::size_t border = 0; border < borders_.size(); ++border) {
    const std::uint64_t wanted = total * (border + 1) / (borders_.size() + 1);
    while (bin < BINS && before + histogram.counts[bin] <= wanted) before += histogram.counts[bin++];
    borders_[border] = histogram.low + static_cast<double>(bin) * width;
  }
}

int FloorStrips::stripAt(double coordinate) const {
  return static_cast<int>(std::upper_bound(borders_.begin(), borders_.end(), coordinate) - borders_.begin());
}

double FloorStrips::distanceTo(int strip, const Vector2& place) const {
  const auto number = static_cast<std::size_t>(strip);
  const double low = number == 0 ? -INFINITE : borders_[number - 1];
  const double high = number == borders_.size() ? INFINITE : borders_[number];
  return std::max({0.0, low - along(place), along(place) - high});
}

}  // namespace crowd
