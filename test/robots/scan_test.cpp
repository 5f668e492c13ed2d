#include "robots/scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace crowd::scan_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
const KeyedRandom KEY(1, KeyedRandom::PLACEMENT, {2});

Scan scanWith(const std::vector<double>& distances) {
  return {distances, std::vector<BodyNumber>(distances.size(), NO_HIT)};
}

std::vector<float> rangesOf(const Scan& scan, const ScanSpec& spec, const KeyedRandom& key = KEY) {
  std::vector<float> ranges;
  writeRanges(scan, spec, key, ranges);
  return ranges;
}

TEST(Ranges, AreThoseOfRep117) {
  ScanSpec spec;
  spec.min_range = 0.5;
  spec.max_range = 10.0;
  constexpr float FAR = std::numeric_limits<float>::infinity();
  EXPECT_EQ(rangesOf(scanWith({0.49, 0.5, 3.0, 10.0, INFINITE}), spec),
            (std::vector<float>{-FAR, 0.5F, 3.0F, 10.0F, FAR}));
}

TEST(Ranges, HaveNormallyDistributedNoise) {
  constexpr std::size_t RAYS = 100000;
  ScanSpec spec;
  spec.noise = 0.02;
  double sum = 0.0;
  double squares = 0.0;
  for (const float range : rangesOf(scanWith(std::vector<double>(RAYS, 5.0)), spec)) {
    const double error = static_cast<double>(range) - 5.0;
    sum += error;
    squares += error * error;
  }
  // Four standard errors: of the mean 0.02 / sqrt(n), of the variance 0.02^2 sqrt(2 / n).
  EXPECT_NEAR(sum / RAYS, 0.0, 4.0 * 0.02 / std::sqrt(1.0 * RAYS));
  EXPECT_NEAR(squares / RAYS, 4e-4, 4.0 * 4e-4 * std::sqrt(2.0 / RAYS));
}

TEST(Ranges, DropOutAsNaN) {
  constexpr std::size_t RAYS = 100000;
  ScanSpec spec;
  spec.dropout = 0.1;
  std::size_t dropped = 0;
  for (const float range : rangesOf(scanWith(std::vector<double>(RAYS, 5.0)), spec)) {
    dropped += std::isnan(range) ? 1 : 0;
    ASSERT_TRUE(std::isnan(range) || range == 5.0F);
  }
  EXPECT_NEAR(1.0 * dropped, 0.1 * RAYS, 4.0 * std::sqrt(RAYS * 0.1 * 0.9));
}

TEST(Ranges, DependOnTheKeyOnly) {
  ScanSpec spec;
  spec.noise = 0.02;
  const Scan scan = scanWith(std::vector<double>(50, 5.0));
  EXPECT_EQ(rangesOf(scan, spec), rangesOf(scan, spec));
  EXPECT_NE(rangesOf(scan, spec), rangesOf(scan, spec, KeyedRandom(1, KeyedRandom::PLACEMENT, {3})));
}

TEST(VisibleBodies, AreThoseThatARayHits) {
  Scan scan = scanWith({1.0, 2.0, 3.0, INFINITE});
  scan.hits = {2, WALL_HIT, 0, NO_HIT};
  std::vector<bool> seen(4, false);
  markVisible(scan, seen);
  EXPECT_EQ(seen, (std::vector<bool>{true, false, true, false}));
}

}  // namespace
}  // namespace crowd::scan_test
