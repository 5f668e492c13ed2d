#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "common/random.h"
#include "simd/kernels.h"

namespace crowd::simd::ranks_test {
namespace {

using Numbers = std::array<double, MAX_RANKED>;

/// Ranks of the first `count` numbers, followed by their sum.
std::vector<std::uint32_t> rank(const Kernels& kernels, const Numbers& numbers, std::size_t count) {
  std::vector<std::uint32_t> ranks(MAX_RANKED);
  const std::uint32_t sum = kernels.rank_ascending(numbers.data(), count, ranks.data());
  ranks.resize(count);
  ranks.push_back(sum);
  return ranks;
}

TEST(RankAscending, CountsSmallerNumbers) {
  const Numbers numbers = {3.0, -1.0, 2.0, 3.0, 0.5};
  for (const Kernels& kernels : availableKernels()) {
    EXPECT_EQ(rank(kernels, numbers, 5), (std::vector<std::uint32_t>{3, 0, 2, 3, 1, 9})) << kernels.target;
    EXPECT_EQ(rank(kernels, numbers, 3), (std::vector<std::uint32_t>{2, 0, 1, 3})) << kernels.target;
    EXPECT_EQ(rank(kernels, numbers, 0), (std::vector<std::uint32_t>{0})) << kernels.target;
  }
}

TEST(RankAscending, ComparesInSinglePrecision) {
  const Numbers numbers = {1.0, 1.0 + 1e-12, 1.0 + 1e-6};
  for (const Kernels& kernels : availableKernels()) {
    EXPECT_EQ(rank(kernels, numbers, 3), (std::vector<std::uint32_t>{0, 0, 2, 2})) << kernels.target;
  }
}

TEST(RankAscending, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const std::size_t count = random.below(MAX_RANKED + 1);
    Numbers numbers{};
    for (double& number : numbers) {
      number = random.below(8) == 0 ? numbers[0] : random.uniform(-1.0, 6.0);
      if (random.below(50) == 0) number = random.below(2) == 0 ? 0.0 : -0.0;
    }
    if (count < MAX_RANKED) numbers[count] = std::numeric_limits<double>::quiet_NaN();
    const auto expected = rank(REFERENCE, numbers, count);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(rank(kernels, numbers, count), expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::ranks_test
