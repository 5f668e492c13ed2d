#include "robots/controllers/social_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/random.h"
#include "support/seeds.h"

namespace crowd::social_force_test {
namespace {

constexpr double TINY = 1e-12;

TEST(SocialForce, DrivesToTheWantedVelocityInHalfASecond) {
  EXPECT_EQ(social_force::drivingForce({0.5, 0.0}, {1.0, 0.0}), Vector2(1.0, 0.0));
  EXPECT_EQ(social_force::drivingForce({0.0, 1.0}, {1.0, 0.0}), Vector2(2.0, -2.0));
}

TEST(SocialForce, OfSomebodyWhoStands) {
  // 1 m between the rims of discs of 0.3 m and 0.25 m: b = 1 m, V0 / sigma = 7 m/s^2.
  const Neighbour person{{1.55, 0.0}, {0.0, 0.0}, 0.25, NeighbourKind::AGENT};
  const Vector2 force = social_force::bodyForce(person, 0.3);
  EXPECT_NEAR(force.x(), -7.0 * std::exp(-1.0 / 0.3), TINY);
  EXPECT_NEAR(force.x(), -0.2497, 1e-4);
  EXPECT_EQ(force.y(), 0.0);
}

TEST(SocialForce, OfSomebodyWhoComes) {
  // 2 m between the rims; in 2 s he comes 1 m nearer: 2 b = sqrt((2 + 1)^2 - 1^2), b = sqrt(2), and the gradient of b
  // is (2 + 1) / (4 sqrt(2)) * 2.
  const Neighbour person{{0.0, 2.5}, {0.0, -0.5}, 0.2, NeighbourKind::AGENT};
  const Vector2 force = social_force::bodyForce(person, 0.3);
  EXPECT_NEAR(force.y(), -7.0 * std::exp(-std::sqrt(2.0) / 0.3) * 3.0 / (2.0 * std::sqrt(2.0)), TINY);
  EXPECT_NEAR(force.x(), 0.0, TINY);
}

TEST(SocialForce, OfOneWhoseStepsLeadThroughTheRobot) {
  // It is on the line between both foci: b = 0.
  const Neighbour person{{1.0, 0.0}, {-1.0, 0.0}, 0.0, NeighbourKind::AGENT};
  EXPECT_NEAR(social_force::bodyForce(person, 0.0).x(), -7.0, TINY);
  const Neighbour inside{{0.0, 0.0}, {0.0, 0.0}, 0.25, NeighbourKind::AGENT};
  EXPECT_TRUE(social_force::bodyForce(inside, 0.3).allFinite());
}

/// V0 exp(-b / sigma) of a point at a place [m^2/s^2].
double potential(const Vector2& from_body, const Vector2& step) {
  const double sum = from_body.norm() + (from_body - step).norm();
  return 2.1 * std::exp(-0.5 * std::sqrt(sum * sum - step.squaredNorm()) / 0.3);
}

TEST(SocialForce, IsTheGradientOfThePotential) {
  constexpr double H = 1e-6;
  forSeeds(100, KeyedRandom::EXPLORATION, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const Vector2 place = random.uniform(0.5, 3.0) * unitVector(random.uniform(-PI, PI));
    const Vector2 velocity = random.uniform(0.0, 0.2) * unitVector(random.uniform(-PI, PI));
    const Vector2 force = social_force::bodyForce({place, velocity, 0.0, NeighbourKind::AGENT}, 0.0);
    const Vector2 step = 2.0 * velocity;
    for (int axis = 0; axis < 2; ++axis) {
      const Vector2 h = axis == 0 ? Vector2(H, 0.0) : Vector2(0.0, H);
      const double slope = (potential(-place + h, step) - potential(-place - h, step)) / (2.0 * H);
      EXPECT_NEAR(force[axis], -slope, 1e-6);
    }
  });
}

TEST(SocialForce, OfAWall) {
  // U0 / R = 50 m/s^2.
  const Vector2 beside = social_force::wallForce({{0.4, -1.0}, {0.4, 1.0}});
  EXPECT_NEAR(beside.x(), -50.0 * std::exp(-2.0), TINY);
  EXPECT_NEAR(beside.y(), 0.0, TINY);
  const Vector2 end = social_force::wallForce({{0.3, 0.4}, {5.0, 0.4}});
  EXPECT_NEAR(end.norm(), 50.0 * std::exp(-2.5), TINY);
  EXPECT_NEAR(end.x() / end.y(), 0.75, TINY);
}

TEST(SocialForce, WhatIsBehindHasHalfTheWeight) {
  const Vector2 ahead(2.0, 0.0);
  EXPECT_EQ(social_force::sightWeight(ahead, {-1.0, 0.0}), 1.0);
  EXPECT_EQ(social_force::sightWeight(ahead, {1.0, 0.0}), 0.5);
  EXPECT_EQ(social_force::sightWeight(ahead, -unitVector(toRadians(99.0))), 1.0);
  EXPECT_EQ(social_force::sightWeight(ahead, -unitVector(toRadians(101.0))), 0.5);
}

}  // namespace
}  // namespace crowd::social_force_test
