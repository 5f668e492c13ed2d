#include "robots/ring_scan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robots/robot_senses.h"
#include "support/robots.h"

namespace crowd::robots::ring_scan_test {
namespace {

/// A scanner with one ray ahead in each ring, from -elevation to +elevation, or one at that.
ScanSpec scanner(double height, std::uint32_t rings, double elevation) {
  ScanSpec spec;
  spec.rays = 1;
  spec.first_angle = 0.0;
  spec.last_angle = 0.0;
  spec.min_range = 0.05;
  spec.rings = rings;
  spec.lowest_ring = rings == 1 ? toRadians(elevation) : -toRadians(elevation);
  spec.highest_ring = toRadians(elevation);
  spec.height = height;
  return spec;
}

std::vector<ScanPoint> pointsOf(const ScanSpec& spec, const std::vector<Column>& columns,
                                const std::vector<Segment>& walls = {}) {
  return scanRings(spec, Pose(), {columns.data(), columns.size()}, {nullptr, 0}, WallIndex(walls),
                   KeyedRandom(1, KeyedRandom::SENSOR, {}));
}

/// An adult 2 m ahead, whose front is at 1.75 m.
const Column ADULT{{2.0, 0.0}, 0.25, solids::ADULT_HEIGHT, 0.5};

void expectPoint(const ScanPoint& point, double x, double z, double intensity, int ring) {
  EXPECT_NEAR(static_cast<double>(point.x), x, 1e-5);
  EXPECT_NEAR(static_cast<double>(point.y), 0.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(point.z), z, 1e-5);
  EXPECT_NEAR(static_cast<double>(point.intensity), intensity, 1e-5);
  EXPECT_EQ(point.ring, ring);
}

TEST(RingScan, RingsMeetAPersonAndTheFloor) {
  const std::vector<ScanPoint> points = pointsOf(scanner(0.5, 3, 30.0), {ADULT});
  ASSERT_EQ(points.size(), 3U);
  const double slope = std::tan(PI / 6.0);
  expectPoint(points[0], 0.5 / slope, -0.5, 0.2 * std::sin(PI / 6.0), 0);  // the floor
  expectPoint(points[1], 1.75, 0.0, 0.5, 1);
  expectPoint(points[2], 1.75, 1.75 * slope, 0.5 * std::cos(PI / 6.0), 2);  // at 1.51 m above the floor
}

TEST(RingScan, RaysPassOverAPersonToTheWall) {
  Column child = ADULT;
  child.height = solids::CHILD_HEIGHT;
  const Segment wall{{3.0, -1.0}, {3.0, 1.0}};
  const std::vector<ScanPoint> points = pointsOf(scanner(0.5, 1, 30.0), {child}, {wall});
  ASSERT_EQ(points.size(), 1U);
  expectPoint(points[0], 3.0, 3.0 * std::tan(PI / 6.0), 0.8 * std::cos(PI / 6.0), 0);  // 2.23 m high
  // 5 m away it would be met at 3.4 m, above the wall.
  EXPECT_TRUE(pointsOf(scanner(0.5, 1, 30.0), {child}, {{{5.0, -1.0}, {5.0, 1.0}}}).empty());
}

TEST(RingScan, ASensorAboveMeetsTheTop) {
  const Column child{{1.0, 0.0}, 0.25, 1.2, 0.5};
  const std::vector<ScanPoint> points = pointsOf(scanner(2.0, 1, -45.0), {child});
  ASSERT_EQ(points.size(), 1U);
  expectPoint(points[0], 0.8, -0.8, 0.5 * std::sin(PI / 4.0), 0);
}

TEST(RingScan, TheHorizontalRingIsTheFlatScan) {
  RobotStart start = robot({0.0, 0.0});
  start.scan.rings = 1;
  start.scan.lowest_ring = 0.0;
  start.scan.height = 0.4;
  start.scan.rays = 90;
  RobotStart other = robot({-3.0, 1.0});
  other.footprint.corners = {{0.5, 0.2}, {-0.5, 0.2}, {-0.5, -0.2}, {0.5, -0.2}};
  Scene made =
      with({start, other}, scene({wanderer({2.0, 0.5}), wanderer({1.0, -2.0})}, {}, {{{4.0, -5.0}, {4.0, 5.0}}}));
  const World world(made);
  RobotSenses senses(made);
  const std::vector<float> ranges = senses.ranges(world, 0);
  const std::vector<ScanPoint> points = senses.points(world, 0);
  std::size_t next = 0;
  for (const float range : ranges) {
    if (!std::isfinite(range)) continue;
    ASSERT_LT(next, points.size());
    EXPECT_NEAR(std::hypot(points[next].x, points[next].y), range, 1e-4F);
    ++next;
  }
  EXPECT_EQ(next, points.size());
  EXPECT_GT(next, 20U);
}

TEST(RingScan, NoiseIsRepeatableAndRaysDropOut) {
  ScanSpec spec = scanner(0.5, 64, 10.0);
  spec.noise = 0.02;
  spec.dropout = 0.5;
  const std::vector<ScanPoint> points = pointsOf(spec, {ADULT});
  EXPECT_GT(points.size(), 15U);
  EXPECT_LT(points.size(), 50U);
  const std::vector<ScanPoint> again = pointsOf(spec, {ADULT});
  ASSERT_EQ(points.size(), again.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].x, again[i].x);
}

}  // namespace
}  // namespace crowd::robots::ring_scan_test
