#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "common/random.h"
#include "simd/kernels.h"

namespace crowd::simd::near_neighbours_test {
namespace {

struct Neighbours {
  std::vector<double> xs, ys, vxs, vys, radii;

  void add(double x, double y, double vx, double vy, double radius) {
    xs.push_back(x);
    ys.push_back(y);
    vxs.push_back(vx);
    vys.push_back(vy);
    radii.push_back(radius);
  }

  std::uint32_t findNear(const Kernels& kernels, const Nearness& nearness) const {
    return find(kernels.find_near, nearness);
  }
  std::uint32_t findNearStop(const Kernels& kernels, const StoppingNearness& nearness) const {
    return find(kernels.find_near_stop, nearness);
  }

 private:
  template <typename Kernel, typename Criterion>
  std::uint32_t find(Kernel* kernel, const Criterion& criterion) const {
    Neighbours padded = *this;
    for (auto* list : {&padded.xs, &padded.ys, &padded.vxs, &padded.vys, &padded.radii}) {
      list->resize(xs.size() + NeighbourArrays::PADDING, std::numeric_limits<double>::quiet_NaN());
    }
    return kernel(
        {padded.xs.data(), padded.ys.data(), padded.vxs.data(), padded.vys.data(), padded.radii.data(), xs.size()},
        criterion);
  }
};

Neighbours randomNeighbours(KeyedRandom& random) {
  Neighbours neighbours;
  for (std::uint32_t left = random.below(20); left > 0; --left) {
    const double farthest = random.below(4) == 0 ? 0.01 : 2.0;
    const double x = random.uniform(-farthest, farthest);
    const double y = random.below(4) == 0 ? 0.0 : random.uniform(-farthest, farthest);
    const double vx = random.uniform(-1.6, 1.6);
    const double vy = random.below(4) == 0 ? 0.0 : random.uniform(-1.6, 1.6);
    neighbours.add(x, y, vx, vy, random.uniform(0.0, 0.4));
  }
  return neighbours;
}

TEST(FindNear, FindsNeighboursThatComeNearWithinATick) {
  Neighbours neighbours;
  neighbours.add(0.7, 0.0, 0.0, 0.0, 0.25);   // within 0.5 and its radius
  neighbours.add(0.8, 0.0, 0.0, 0.0, 0.25);   // beyond it
  neighbours.add(-0.8, 0.0, 1.0, 0.0, 0.25);  // approaches by 0.1 m
  neighbours.add(0.8, 0.0, 1.0, 0.0, 0.25);   // moves away
  neighbours.add(0.7, 0.0, 10.0, 0.0, 0.25);  // moves away, but is within the distance at the start
  neighbours.add(0.0, 0.0, 0.0, 0.0, 0.25);   // at the same position
  for (const Kernels& kernels : availableKernels()) {
    EXPECT_EQ(neighbours.findNear(kernels, {0.0, 0.0, 0.1, 0.5}), 0b110101U) << kernels.target;
    EXPECT_EQ(neighbours.findNear(kernels, {-1.0, 0.0, 0.1, 0.5}), 0b110011U) << kernels.target << ", walking back";
  }
}

TEST(FindNear, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Neighbours neighbours = randomNeighbours(random);
    const double vx = random.below(4) == 0 ? 0.0 : random.uniform(-1.6, 1.6);
    const Nearness nearness{vx, random.uniform(-1.6, 1.6), random.uniform(0.01, 0.5), random.uniform(0.1, 0.9)};
    const std::uint32_t expected = neighbours.findNear(REFERENCE, nearness);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(neighbours.findNear(kernels, nearness), expected) << kernels.target << ", seed " << seed;
    }
  }
}

TEST(FindNearStop, FindsNeighboursNearWhichBothStop) {
  Neighbours neighbours;
  neighbours.add(1.0, 0.0, 0.0, 0.0, 0.25);   // the agent stops 0.25 m ahead: 0.75 m are left, as admitted
  neighbours.add(1.1, 0.0, 0.0, 0.0, 0.25);   // beyond it
  neighbours.add(0.0, 1.1, 0.0, 0.0, 0.25);   // the agent does not come nearer
  neighbours.add(1.5, 0.0, -1.5, 0.0, 0.25);  // brakes from 1.5 m/s on 0.375 m, 0.15 m a tick: 0.725 m are left
  neighbours.add(1.5, 0.0, 1.5, 0.0, 0.25);   // moves away; its tick counts: 1.1 m are left
  neighbours.add(0.0, 0.0, 0.0, 0.0, 0.25);   // at the same position
  for (const Kernels& kernels : availableKernels()) {
    EXPECT_EQ(neighbours.findNearStop(kernels, {0.25, 0.0, 0.1, 1.0 / 6.0, 0.5}), 0b101001U) << kernels.target;
    EXPECT_EQ(neighbours.findNearStop(kernels, {0.0, 0.25, 0.1, 1.0 / 6.0, 0.625}), 0b100100U) << kernels.target;
  }
}

TEST(FindNearStop, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Neighbours neighbours = randomNeighbours(random);
    const double stop_x = random.below(4) == 0 ? 0.0 : random.uniform(-0.4, 0.4);
    const StoppingNearness nearness{stop_x, random.uniform(-0.4, 0.4), random.uniform(0.01, 0.5),
                                    0.5 / random.uniform(0.5, 6.0), random.uniform(0.1, 0.9)};
    const std::uint32_t expected = neighbours.findNearStop(REFERENCE, nearness);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(neighbours.findNearStop(kernels, nearness), expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::near_neighbours_test
