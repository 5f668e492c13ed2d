#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "common/random.h"
#include "geometry/geometry.h"
#include "simd/kernels.h"

namespace crowd::simd::time_to_collision_test {
namespace {

constexpr float NEVER = 1e-9F;  // [1/s]
using Lanes = std::array<float, CandidateArrays::MAX>;

/// Input and output of a kernel.
struct Case {
  std::vector<double> xs, ys, vxs, vys, radii;
  Observer self{};
  std::size_t count = 0;
  Lanes ux{}, uy{}, constant{}, reciprocal{};
  float fastest = 0.0F;

  void add(const Vector2& place, const Vector2& velocity, double radius) {
    xs.push_back(place.x());
    ys.push_back(place.y());
    vxs.push_back(velocity.x());
    vys.push_back(velocity.y());
    radii.push_back(radius);
  }

  Case accumulated(const Kernels& kernels, bool with_reciprocal = true) const {
    Case result = *this;
    for (auto* list : {&result.xs, &result.ys, &result.vxs, &result.vys, &result.radii}) {
      list->resize(xs.size() + NeighbourArrays::PADDING, std::numeric_limits<double>::quiet_NaN());
    }
    const NeighbourArrays neighbours{result.xs.data(),  result.ys.data(),    result.vxs.data(),
                                     result.vys.data(), result.radii.data(), xs.size()};
    result.fastest = kernels.accumulate_time_to_collision(
        neighbours, self,
        {count, ux.data(), uy.data(), result.constant.data(), with_reciprocal ? result.reciprocal.data() : nullptr});
    return result;
  }
};

bool areSame(const Case& a, const Case& b) {
  return std::equal(a.constant.begin(), a.constant.begin() + a.count, b.constant.begin()) &&
         std::equal(a.reciprocal.begin(), a.reciprocal.begin() + a.count, b.reciprocal.begin()) &&
         a.fastest == b.fastest;
}

/// Candidates straight ahead, back, and to stay.
Case threeCandidates() {
  Case one;
  one.count = 3;
  one.ux = {1.0F, -1.0F, 0.0F};
  one.constant.fill(NEVER);
  one.reciprocal.fill(NEVER);
  one.self = {0.25, 1.0F, 0.0F, 1.0F, 0.0F};
  return one;
}

TEST(TimeToCollision, OfAStandingNeighbour) {
  Case one = threeCandidates();
  one.add({3.5, 0.0}, {0.0, 0.0}, 0.25);  // 3 m between the rims
  for (const Kernels& kernels : availableKernels()) {
    const Case result = one.accumulated(kernels);
    SCOPED_TRACE(kernels.target);
    EXPECT_FLOAT_EQ(result.constant[0], 1.0F / 3.0F);
    EXPECT_EQ(result.constant[1], NEVER);
    EXPECT_EQ(result.constant[2], NEVER);
    EXPECT_FLOAT_EQ(result.reciprocal[0], 0.5F / 3.0F)
        << "at half of the velocity, of which the caller doubles the time";
    EXPECT_EQ(result.reciprocal[1], NEVER);
    EXPECT_FLOAT_EQ(result.fastest, 1.0F);
  }
}

TEST(TimeToCollision, OfAnApproachingAndAnOverlappingNeighbour) {
  Case one = threeCandidates();
  one.add({2.5, 0.0}, {-1.0, 0.0}, 0.25);
  one.add({-0.3, 0.0}, {0.0, 0.0}, 0.25);
  for (const Kernels& kernels : availableKernels()) {
    const Case result = one.accumulated(kernels);
    SCOPED_TRACE(kernels.target);
    EXPECT_FLOAT_EQ(result.constant[0], 1.0F);
    EXPECT_GT(result.constant[1], 1e29F) << "at once";
    EXPECT_FLOAT_EQ(result.constant[2], 0.5F);
    EXPECT_FLOAT_EQ(result.fastest, 4.0F);
  }
}

TEST(TimeToCollision, KeepsEarlierTimesAndUnrequestedResults) {
  Case one = threeCandidates();
  one.add({3.5, 0.0}, {0.0, 0.0}, 0.25);
  one.constant[0] = 2.0F;
  one.reciprocal.fill(7.0F);
  for (const Kernels& kernels : availableKernels()) {
    const Case result = one.accumulated(kernels, false);
    EXPECT_EQ(result.constant[0], 2.0F) << kernels.target;
    EXPECT_EQ(result.reciprocal, one.reciprocal) << kernels.target;
  }
}

TEST(TimeToCollision, WithoutNeighboursChangesNothing) {
  for (const Kernels& kernels : availableKernels()) {
    EXPECT_TRUE(areSame(threeCandidates().accumulated(kernels), threeCandidates())) << kernels.target;
  }
}

Vector2 anyVector(KeyedRandom& random, double longest) {
  return random.uniform(0.0, longest) * unitVector(random.uniform(-PI, PI));
}

/// A velocity of a pedestrian, a tiny one, or zero.
Vector2 anyVelocity(KeyedRandom& random) {
  constexpr std::array<double, 8> LONGEST = {1.6, 1.6, 1.6, 0.3, 1e-6, 1e-13, 1e-22, 0.0};
  return anyVector(random, LONGEST[random.below(LONGEST.size())]);
}

/// Neighbours near and far; some touch or overlap the agent, have its position, or have its velocity.
void addAnyNeighbours(KeyedRandom& random, Case& one) {
  constexpr std::array<double, 6> FARTHEST = {6.0, 6.0, 2.0, 300.0, 1e-6, 0.0};
  for (std::uint32_t left = random.below(40); left > 0; --left) {
    const Vector2 place = anyVector(random, FARTHEST[random.below(FARTHEST.size())]);
    const double reach = random.below(8) == 0 ? place.norm() : random.uniform(0.0, 0.6);
    const Vector2 velocity(one.self.velocity_x, one.self.velocity_y);
    one.add(place, random.below(8) == 0 ? velocity : anyVelocity(random), reach - one.self.radius);
  }
}

/// Candidates towards a neighbour, along its tangent, with its velocity, or random.
void addAnyCandidates(KeyedRandom& random, Case& one) {
  one.count = 1 + random.below(CandidateArrays::MAX);
  for (std::size_t k = 0; k < CandidateArrays::MAX; ++k) {
    Vector2 u = anyVelocity(random);
    if (!one.xs.empty()) {
      const std::size_t i = random.below(static_cast<std::uint32_t>(one.xs.size()));
      const Vector2 place(one.xs[i], one.ys[i]);
      const double edge = std::asin(std::min(1.0, (one.self.radius + one.radii[i]) / place.norm()));
      if (random.below(3) == 0 && place.norm() > 0.0) u = u.norm() * unitVector(bearingOf(place) + edge);
      if (random.below(6) == 0) u += Vector2(one.vxs[i], one.vys[i]);
    }
    one.ux[k] = static_cast<float>(u.x());
    one.uy[k] = static_cast<float>(u.y());
  }
}

TEST(TimeToCollision, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    Case one;
    const Vector2 velocity = anyVelocity(random);
    const Vector2 preferred = anyVelocity(random);
    one.self = {random.uniform(0.0, 0.3), static_cast<float>(velocity.x()), static_cast<float>(velocity.y()),
                static_cast<float>(preferred.x()), static_cast<float>(preferred.y())};
    one.constant.fill(NEVER);
    one.reciprocal.fill(NEVER);
    addAnyNeighbours(random, one);
    addAnyCandidates(random, one);
    const bool with_reciprocal = random.below(4) != 0;
    const Case expected = one.accumulated(REFERENCE, with_reciprocal);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_TRUE(areSame(one.accumulated(kernels, with_reciprocal), expected)) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::time_to_collision_test
