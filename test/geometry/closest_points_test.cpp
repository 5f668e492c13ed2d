#include "geometry/closest_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/scenes.h"

namespace crowd::closest_points_test {
namespace {

double distanceOf(const ClosestPoints& points) { return (points.of_second - points.of_first).norm(); }

void expectPoints(const ClosestPoints& points, const Vector2& of_first, const Vector2& of_second) {
  EXPECT_LT((points.of_first - of_first).norm(), 1e-12) << points.of_first.transpose();
  EXPECT_LT((points.of_second - of_second).norm(), 1e-12) << points.of_second.transpose();
}

/// Expects the same points in either order of the segments.
void expectClosest(const Segment& first, const Segment& second, const Vector2& of_first, const Vector2& of_second) {
  expectPoints(closestPoints(first, second), of_first, of_second);
  expectPoints(closestPoints(second, first), of_second, of_first);
}

TEST(ClosestPoints, EndAndFoot) {
  const Segment base{{0.0, 0.0}, {4.0, 0.0}};
  expectClosest(base, {{1.0, 2.0}, {3.0, 5.0}}, {1.0, 0.0}, {1.0, 2.0});
  expectClosest(base, {{3.0, -5.0}, {2.0, -1.0}}, {2.0, 0.0}, {2.0, -1.0});
  expectClosest({{0.0, 0.0}, {2.0, 2.0}}, {{2.0, 0.0}, {5.0, -1.0}}, {1.0, 1.0}, {2.0, 0.0});
}

TEST(ClosestPoints, TwoEnds) {
  expectClosest({{0.0, 0.0}, {4.0, 0.0}}, {{7.0, 4.0}, {9.0, 5.0}}, {4.0, 0.0}, {7.0, 4.0});
  EXPECT_DOUBLE_EQ(distanceOf(closestPoints({{0.0, 0.0}, {4.0, 0.0}}, {{7.0, 4.0}, {9.0, 5.0}})), 5.0);  // 3, 4, 5
}

TEST(ClosestPoints, TouchingSegments) {
  expectClosest({{0.0, 0.0}, {4.0, 0.0}}, {{3.0, 0.0}, {3.0, 2.0}}, {3.0, 0.0}, {3.0, 0.0});
  expectClosest({{0.0, 0.0}, {4.0, 0.0}}, {{4.0, 0.0}, {5.0, 2.0}}, {4.0, 0.0}, {4.0, 0.0});
}

TEST(ClosestPoints, SegmentsWithoutLengthArePoints) {
  const Segment point{{2.0, 3.0}, {2.0, 3.0}};
  expectClosest(point, {{5.0, 7.0}, {5.0, 7.0}}, {2.0, 3.0}, {5.0, 7.0});
  expectClosest(point, {{0.0, 0.0}, {4.0, 0.0}}, {2.0, 3.0}, {2.0, 0.0});
  expectClosest(point, {{5.0, 7.0}, {9.0, 8.0}}, {2.0, 3.0}, {5.0, 7.0});
  expectClosest(point, point, {2.0, 3.0}, {2.0, 3.0});
}

TEST(ClosestPoints, ParallelSegments) {
  const Segment base{{0.0, 0.0}, {4.0, 0.0}};
  // Side by side, all points of the common stretch are as near.
  const ClosestPoints beside = closestPoints(base, {{6.0, 1.0}, {1.0, 1.0}});
  EXPECT_DOUBLE_EQ(distanceOf(beside), 1.0);
  EXPECT_DOUBLE_EQ(beside.of_first.x(), beside.of_second.x());
  expectClosest(base, {{5.0, 1.0}, {8.0, 1.0}}, {4.0, 0.0}, {5.0, 1.0});
  expectClosest(base, {{9.0, 0.0}, {6.0, 0.0}}, {4.0, 0.0}, {6.0, 0.0});
  EXPECT_EQ(distanceOf(closestPoints(base, {{1.0, 0.0}, {2.0, 0.0}})), 0.0);
}

/// Whether each segment has its ends on both sides of the other.
bool cross(const Segment& first, const Segment& second) {
  const auto divides = [](const Segment& line, const Segment& other) {
    const Vector2 way = line.to - line.from;
    return crowd::cross(way, other.from - line.from) * crowd::cross(way, other.to - line.from) < 0.0;
  };
  return divides(first, second) && divides(second, first);
}

constexpr int SAMPLES = 200;

Vector2 sampleOf(const Segment& segment, int i) {
  return segment.from + static_cast<double>(i) / SAMPLES * (segment.to - segment.from);
}

TEST(ClosestPoints, LieOnTheSegmentsAndNoOthersAreCloser) {
  int parted = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Segment first{scenes::randomPoint(random, 3.0), scenes::randomPoint(random, 3.0)};
    const Segment second{scenes::randomPoint(random, 3.0), scenes::randomPoint(random, 3.0)};
    const ClosestPoints found = closestPoints(first, second);
    EXPECT_LT(distanceTo(first, found.of_first), 1e-12);
    EXPECT_LT(distanceTo(second, found.of_second), 1e-12);
    if (cross(first, second)) continue;  // any points
    ++parted;
    double smallest = INFINITE;
    for (int i = 0; i <= SAMPLES; ++i) {
      for (int k = 0; k <= SAMPLES; ++k) {
        smallest = std::min(smallest, (sampleOf(first, i) - sampleOf(second, k)).norm());
      }
    }
    EXPECT_LE(distanceOf(found), smallest + 1e-12);
    EXPECT_GE(distanceOf(found), smallest - 2.0 * 8.5 / SAMPLES);  // a step along each is up to 8.5 m / SAMPLES
  }
  EXPECT_GT(parted, 100);
}

}  // namespace
}  // namespace crowd::closest_points_test
