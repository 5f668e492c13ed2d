#include "robots/scanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/seeds.h"

namespace crowd::scanner_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// A scanner with a ray at each degree, ray 180 ahead, up to 20 m.
ScanSpec oneRayPerDegree() {
  ScanSpec spec;
  spec.rays = 360;
  return spec;
}

Scan scanOf(const ScanSpec& spec, const Pose& sensor, const std::vector<ScanTarget>& targets,
            const std::vector<ScanEdge>& edges = {}, const std::vector<Segment>& walls = {}) {
  Scanner scanner(spec);
  return scanner.scan(sensor, {targets.data(), targets.size()}, {edges.data(), edges.size()}, WallIndex(walls));
}

std::size_t hitCount(const Scan& scan) {
  return scan.hits.size() - static_cast<std::size_t>(std::count(scan.hits.begin(), scan.hits.end(), NO_HIT));
}

TEST(Scanner, SeesADisc) {
  const Scan scan = scanOf(oneRayPerDegree(), Pose(), {{{2.0, 0.0}, 0.5, 3}});
  EXPECT_NEAR(scan.distances[180], 1.5, 1e-12);
  EXPECT_EQ(scan.hits[180], 3U);
  const double angle = toRadians(10.0);
  const double expected = 2.0 * std::cos(angle) - std::sqrt(0.25 - 4.0 * std::sin(angle) * std::sin(angle));
  EXPECT_NEAR(scan.distances[190], expected, 1e-12);
  EXPECT_NEAR(scan.distances[170], expected, 1e-12);
  EXPECT_EQ(hitCount(scan), 29U);  // the rim is at asin(0.25) = 14.48 degrees
  EXPECT_EQ(scan.distances[0], INFINITE);
}

TEST(Scanner, SeesBehindTheEndsOfAFullCircle) {
  const Scan scan = scanOf(oneRayPerDegree(), Pose(), {{{-2.0, 0.0}, 0.5, 3}});
  EXPECT_NEAR(scan.distances[0], 1.5, 1e-12);
  EXPECT_EQ(hitCount(scan), 29U);
  EXPECT_EQ(scan.hits[14], 3U);
  EXPECT_EQ(scan.hits[359 - 13], 3U);
}

TEST(Scanner, ReachesPointsBeforeWhatItHits) {
  ScanSpec spec = oneRayPerDegree();
  spec.max_range = 5.0;
  const std::vector<Segment> wall = {{{1.0, -1.0}, {1.0, 1.0}}};  // its ends are at 45 degrees
  for (const double last : {PI, PI / 2.0}) {
    spec.first_angle = -last;
    spec.last_angle = last;
    Scanner scanner(spec);
    scanner.scan(Pose(), {nullptr, 0}, {nullptr, 0}, WallIndex(wall));
    EXPECT_TRUE(scanner.reaches({0.9, 0.0}));
    EXPECT_FALSE(scanner.reaches({1.1, 0.0}));
    EXPECT_FALSE(scanner.reaches({3.0, 2.9}));
    EXPECT_TRUE(scanner.reaches({2.9, 3.1}));
    EXPECT_TRUE(scanner.reaches({0.0, -4.9}));
    EXPECT_FALSE(scanner.reaches({0.0, -5.1}));
    EXPECT_EQ(scanner.reaches({-2.0, 0.001}), last == PI);
    EXPECT_EQ(scanner.reaches({-2.0, -0.001}), last == PI);
  }
}

TEST(Scanner, LooksAlongItsHeadingFromItsPlace) {
  const Scan scan = scanOf(oneRayPerDegree(), {{5.0, 1.0}, PI / 2.0}, {{{5.0, 4.0}, 0.5, 0}});
  EXPECT_NEAR(scan.distances[180], 2.5, 1e-12);
}

TEST(Scanner, HasAFieldOfView) {
  ScanSpec spec;
  spec.rays = 181;
  spec.first_angle = -PI / 2.0;
  spec.last_angle = PI / 2.0;
  EXPECT_DOUBLE_EQ(angleIncrement(spec), toRadians(1.0));
  const Scan scan = scanOf(spec, Pose(), {{{0.0, 2.0}, 0.5, 0}, {{-2.0, 0.0}, 0.5, 1}});
  EXPECT_NEAR(scan.distances[180], 1.5, 1e-12);
  EXPECT_EQ(hitCount(scan), 15U);  // half of the disc on the left, nothing of the one behind
}

TEST(Scanner, SeesTheNearestBody) {
  const std::vector<ScanTarget> bodies = {{{4.0, 0.0}, 0.5, 0}, {{2.0, 0.0}, 0.5, 2}, {{2.0, 0.0}, 0.5, 1}};
  const Scan scan = scanOf(oneRayPerDegree(), Pose(), bodies, {}, {{{1.8, -5.0}, {1.8, 5.0}}});
  EXPECT_EQ(scan.hits[180], 1U);  // of two at one place, the lower number
  EXPECT_EQ(scan.hits[200], WALL_HIT);
  EXPECT_NEAR(scan.distances[180 + 45], 1.8 * std::sqrt(2.0), 1e-12);
}

TEST(Scanner, SeesNothingBeyondItsRange) {
  ScanSpec spec = oneRayPerDegree();
  spec.max_range = 1.5;
  EXPECT_EQ(hitCount(scanOf(spec, Pose(), {{{2.001, 0.0}, 0.5, 0}}, {}, {{{1.501, -9.0}, {1.501, 9.0}}})), 0U);
  EXPECT_GE(hitCount(scanOf(spec, Pose(), {{{1.999, 0.0}, 0.5, 0}})), 1U);
  EXPECT_EQ(hitCount(scanOf(spec, Pose(), {}, {}, {{{1.5, -9.0}, {1.5, 9.0}}})), 1U);
}

TEST(Scanner, InABodyAllRaysAreZero) {
  const Scan scan = scanOf(oneRayPerDegree(), Pose(), {{{0.1, 0.0}, 0.5, 0}});
  EXPECT_EQ(*std::max_element(scan.distances.begin(), scan.distances.end()), 0.0);
}

TEST(Scanner, SeesCornersOfWallsAndPolygons) {
  // The ray at 45 degrees hits the corner where both walls end.
  const std::vector<Segment> walls = {{{2.0, -1.0}, {2.0, 2.0}}, {{2.0, 2.0}, {-1.0, 2.0}}};
  const Scan of_walls = scanOf(oneRayPerDegree(), Pose(), {}, {}, walls);
  EXPECT_NEAR(of_walls.distances[225], std::sqrt(8.0), 1e-12);
  EXPECT_EQ(of_walls.hits[225], WALL_HIT);
  const Scan of_edges = scanOf(oneRayPerDegree(), Pose(), {}, {{walls[0], 7}, {walls[1], 7}});
  EXPECT_EQ(of_edges.hits[225], 7U);
  for (std::size_t i = 0; i < 360; ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(of_walls.distances[i], of_edges.distances[i]);
  }
}

/// What a scanner should see, from all bodies and walls for each ray.
Scan bruteForce(const ScanSpec& spec, const Pose& sensor, const std::vector<ScanTarget>& targets,
                const std::vector<ScanEdge>& edges, const std::vector<Segment>& walls) {
  Scan scan;
  const Rotation frame(sensor.heading);
  for (std::uint32_t i = 0; i < spec.rays; ++i) {
    const Ray ray{sensor.position,
                  frame.outOfFrame(unitVector(spec.first_angle + static_cast<double>(i) * angleIncrement(spec)))};
    std::vector<std::pair<double, BodyNumber>> found = {{INFINITE, NO_HIT}};
    for (const ScanTarget& target : targets) {
      found.emplace_back(distanceAlong(ray, target.centre, target.radius), target.body);
    }
    for (const ScanEdge& edge : edges) found.emplace_back(distanceAlong(ray, edge.edge), edge.body);
    for (const Segment& wall : walls) found.emplace_back(distanceAlong(ray, wall), WALL_HIT);
    const auto [distance, body] = *std::min_element(found.begin(), found.end());
    scan.distances.push_back(distance <= spec.max_range ? distance : INFINITE);
    scan.hits.push_back(distance <= spec.max_range ? body : NO_HIT);
  }
  return scan;
}

TEST(Scanner, EqualsTheMinimumOverAllBodies) {
  forSeeds(150, KeyedRandom::PLACEMENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    ScanSpec spec;
    spec.rays = 1 + random.below(500);
    spec.max_range = random.uniform(1.0, 20.0);
    if (random.below(2) == 0) {
      spec.first_angle = random.uniform(-PI, PI);
      spec.last_angle = spec.first_angle + random.uniform(0.01, 2.0 * PI);
    }
    const auto point = [&] {
      const double x = random.uniform(-10.0, 10.0);
      return Vector2(x, random.uniform(-10.0, 10.0));
    };
    std::vector<ScanTarget> targets;
    std::vector<ScanEdge> edges;
    std::vector<Segment> walls;
    for (std::uint32_t i = random.below(30); i > 0; --i) targets.push_back({point(), random.uniform(0.05, 2.0), i});
    for (std::uint32_t i = random.below(10); i > 0; --i) edges.push_back({{point(), point()}, 100 + i});
    for (std::uint32_t i = random.below(30); i > 0; --i) walls.push_back({point(), point()});
    Pose sensor{point(), random.uniform(-PI, PI)};
    // In a ghost world a robot may stand on a wall.
    if (!walls.empty() && random.below(4) == 0) sensor.position = 0.5 * (walls.front().from + walls.front().to);
    const Scan got = scanOf(spec, sensor, targets, edges, walls);
    const Scan expected = bruteForce(spec, sensor, targets, edges, walls);
    ASSERT_EQ(got.distances, expected.distances);
    ASSERT_EQ(got.hits, expected.hits);
  });
}

}  // namespace
}  // namespace crowd::scanner_test
