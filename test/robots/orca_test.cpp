#include "robots/controllers/orca.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/random.h"
#include "support/seeds.h"

namespace crowd::orca_test {
namespace {

constexpr double TICK = 0.1;  // [s]
constexpr double TINY = 1e-12;

void expectHalfPlane(const HalfPlane& plane, const Vector2& point, const Vector2& normal) {
  EXPECT_NEAR((plane.point - point).norm(), 0.0, TINY) << plane.point.transpose();
  EXPECT_NEAR((plane.normal - normal).norm(), 0.0, TINY) << plane.normal.transpose();
}

double depth(const HalfPlane& plane, const Vector2& velocity) { return (plane.point - velocity).dot(plane.normal); }

double deepest(const std::vector<HalfPlane>& planes, std::size_t first, const Vector2& velocity) {
  double worst = 0.0;
  for (std::size_t i = first; i < planes.size(); ++i) worst = std::max(worst, depth(planes[i], velocity));
  return worst;
}

TEST(Orca, TheDiscOfAVelocityObstacle) {
  // Within 2 s: relative velocities in the disc of 0.5 m/s about (3, 0). From (2, 0), u leads 0.5 m/s to its border.
  const Neighbour person{{6.0, 0.0}, {-1.0, 0.0}, 0.5, NeighbourKind::AGENT};
  expectHalfPlane(orca::avoid(person, 0.5, {1.0, 0.0}, 0.5, 2.0, TICK), {1.25, 0.0}, {-1.0, 0.0});
  expectHalfPlane(orca::avoid(person, 0.5, {1.0, 0.0}, 1.0, 2.0, TICK), {1.5, 0.0}, {-1.0, 0.0});
}

TEST(Orca, TheSidesOfAVelocityObstacle) {
  // A disc of 3 m at 5 m: the tangents are (0.8, 0.6) and (0.8, -0.6). The foot of (1, 0.2) on the left one is
  // 0.92 * (0.8, 0.6) = (0.736, 0.552).
  const Neighbour pillar{{5.0, 0.0}, {0.0, 0.0}, 1.5, NeighbourKind::OBSTACLE};
  expectHalfPlane(orca::avoid(pillar, 1.5, {1.0, 0.2}, 0.5, 10.0, TICK), {0.868, 0.376}, {-0.6, 0.8});
  expectHalfPlane(orca::avoid(pillar, 1.5, {1.0, 0.2}, 1.0, 10.0, TICK), {0.736, 0.552}, {-0.6, 0.8});
  expectHalfPlane(orca::avoid(pillar, 1.5, {1.0, -0.2}, 1.0, 10.0, TICK), {0.736, -0.552}, {-0.6, -0.8});
}

TEST(Orca, BodiesThatOverlapPartWithinATick) {
  const Neighbour person{{0.5, 0.0}, {0.0, 0.0}, 0.5, NeighbourKind::AGENT};
  expectHalfPlane(orca::avoid(person, 0.5, {0.0, 0.0}, 1.0, 3.0, TICK), {-5.0, 0.0}, {-1.0, 0.0});
}

TEST(Orca, Walls) {
  expectHalfPlane(orca::avoid({{2.0, -1.0}, {2.0, 1.0}}, 0.5, 1.5, TICK), {1.0, 0.0}, {-1.0, 0.0});
  expectHalfPlane(orca::avoid({{0.3, -1.0}, {0.3, 1.0}}, 0.5, 1.5, TICK), {-2.0, 0.0}, {-1.0, 0.0});
  // The end of a wall at (3, 4).
  expectHalfPlane(orca::avoid({{3.0, 4.0}, {9.0, 4.0}}, 1.0, 2.0, TICK), {1.2, 1.6}, {-0.6, -0.8});
}

TEST(Orca, NearestVelocities) {
  const HalfPlane slow{{0.5, 0.0}, {-1.0, 0.0}};    // x <= 0.5
  const HalfPlane right{{0.0, 0.25}, {0.0, -1.0}};  // y <= 0.25
  EXPECT_EQ(orca::nearestVelocity({}, 0, 1.0, {0.3, 0.4}), Vector2(0.3, 0.4));
  EXPECT_EQ(orca::nearestVelocity({}, 0, 1.0, {3.0, 0.0}), Vector2(1.0, 0.0));
  EXPECT_NEAR((orca::nearestVelocity({slow}, 0, 1.0, {1.0, 0.0}) - Vector2(0.5, 0.0)).norm(), 0.0, TINY);
  EXPECT_NEAR((orca::nearestVelocity({slow, right}, 0, 2.0, {1.0, 1.0}) - Vector2(0.5, 0.25)).norm(), 0.0, TINY);
  // x <= 0.6 cuts the unit circle at y = 0.8.
  const HalfPlane chord{{0.6, 0.0}, {-1.0, 0.0}};
  EXPECT_NEAR((orca::nearestVelocity({chord}, 0, 1.0, {3.0, 3.0}) - Vector2(0.6, 0.8)).norm(), 0.0, TINY);
}

TEST(Orca, TheLeastViolation) {
  const HalfPlane back{{-1.0, 0.0}, {-1.0, 0.0}};  // x <= -1
  const HalfPlane ahead{{0.5, 0.0}, {1.0, 0.0}};   // x >= 0.5
  const Vector2 between = orca::nearestVelocity({back, ahead}, 0, 1.0, {0.0, 0.5});
  EXPECT_NEAR(between.x(), -0.25, TINY);
  EXPECT_NEAR(orca::nearestVelocity({back, ahead}, 1, 1.0, {0.0, 0.5}).x(), -1.0, 1e-9);  // the first one holds
}

/// A few half-planes; the first `walls` permit to stand still.
std::vector<HalfPlane> randomPlanes(KeyedRandom& random, std::size_t walls) {
  std::vector<HalfPlane> planes;
  for (std::size_t i = 0; i < 2 + walls + random.below(6); ++i) {
    const Vector2 normal = unitVector(random.uniform(-PI, PI));
    planes.push_back({random.uniform(i < walls ? -1.0 : -1.2, i < walls ? 0.0 : 0.6) * normal, normal});
  }
  return planes;
}

TEST(Orca, NoVelocityIsBetter) {
  std::size_t possible = 0;
  std::size_t impossible = 0;
  forSeeds(400, KeyedRandom::EXPLORATION, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const std::size_t walls = random.below(3);
    const std::vector<HalfPlane> planes = randomPlanes(random, walls);
    const Vector2 wanted = random.uniform(0.0, 1.5) * unitVector(random.uniform(-PI, PI));
    const Vector2 velocity = orca::nearestVelocity(planes, walls, 1.0, wanted);
    EXPECT_LE(velocity.norm(), 1.0 + 1e-9);
    const bool is_possible = deepest(planes, 0, velocity) < 1e-9;
    ++(is_possible ? possible : impossible);
    for (int i = 0; i < 2000; ++i) {
      const Vector2 other = std::sqrt(random.uniform()) * unitVector(random.uniform(-PI, PI));
      if (is_possible) {
        if (deepest(planes, 0, other) > 0.0) continue;
        EXPECT_LE((velocity - wanted).norm(), (other - wanted).norm() + 1e-9);
      } else {
        EXPECT_GT(deepest(planes, 0, other), 0.0);
        bool holds = true;
        for (std::size_t w = 0; w < walls; ++w) holds = holds && depth(planes[w], other) <= 0.0;
        if (!holds) continue;
        EXPECT_LE(deepest(planes, walls, velocity), deepest(planes, walls, other) + 1e-9);
      }
    }
    for (std::size_t w = 0; w < walls; ++w) EXPECT_LE(depth(planes[w], velocity), 1e-9);
  });
  EXPECT_GT(possible, 50U);
  EXPECT_GT(impossible, 50U);
}

struct Walker {
  Vector2 position;
  Vector2 goal;
  Vector2 velocity = Vector2::Zero();
  double radius;
};

TEST(Orca, TwoThatAvoidEachOtherNeverTouch) {
  forSeeds(200, KeyedRandom::EXPLORATION, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const double angle = random.uniform(-PI, PI);
    std::vector<Walker> both;
    for (const double side : {angle, angle + random.uniform(0.5, 2.0 * PI - 0.5)}) {
      Walker& walker = both.emplace_back();
      walker.position = 5.0 * unitVector(side);
      walker.goal = -5.0 * unitVector(side + random.uniform(-0.2, 0.2));
      walker.radius = random.uniform(0.2, 0.6);
    }
    for (int tick = 0; tick < 150; ++tick) {
      std::vector<Vector2> velocities;
      for (std::size_t i = 0; i < 2; ++i) {
        const Walker& one = both[i];
        const Walker& other = both[1 - i];
        const Neighbour seen{other.position - one.position, other.velocity, other.radius, NeighbourKind::AGENT};
        const Vector2 way = one.goal - one.position;
        const Vector2 wanted = way / std::max(1.0, way.norm());
        velocities.push_back(
            orca::nearestVelocity({orca::avoid(seen, one.radius, one.velocity, 0.5, 3.0, TICK)}, 0, 1.0, wanted));
      }
      for (std::size_t i = 0; i < 2; ++i) {
        both[i].velocity = velocities[i];
        both[i].position += TICK * velocities[i];
      }
      ASSERT_GE((both[0].position - both[1].position).norm(), both[0].radius + both[1].radius - 1e-9);
    }
    for (const Walker& walker : both) EXPECT_LT((walker.goal - walker.position).norm(), 1.0);
  });
}

}  // namespace
}  // namespace crowd::orca_test
