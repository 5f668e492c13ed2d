#include "common/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace crowd::random_test {
namespace {

std::vector<std::uint64_t> firstNumbers(KeyedRandom random) {
  std::vector<std::uint64_t> numbers(5);
  for (std::uint64_t& number : numbers) number = random.next();
  return numbers;
}

/// Requires mean and variance of uniform numbers in [0, 1), and a tenth of them in each tenth; within about five
/// standard deviations of `draws.size()` = 100,000 independent draws.
void expectEven(const std::vector<double>& draws) {
  ASSERT_EQ(draws.size(), 100000U);
  double sum = 0.0;
  double sum_of_squares = 0.0;
  std::array<int, 10> tenths{};
  for (const double draw : draws) {
    ASSERT_GE(draw, 0.0);
    ASSERT_LT(draw, 1.0);
    sum += draw;
    sum_of_squares += (draw - 0.5) * (draw - 0.5);
    ++tenths.at(static_cast<std::size_t>(draw * 10.0));
  }
  EXPECT_NEAR(sum / 1e5, 0.5, 0.005);
  EXPECT_NEAR(sum_of_squares / 1e5, 1.0 / 12.0, 0.0013);
  for (const int count : tenths) EXPECT_NEAR(count, 10000, 500);
}

TEST(KeyedRandom, AcceptsItsKeyAtOnceOrPartByPart) {
  const KeyedRandom whole(7, KeyedRandom::EXPLORATION, {11, 12, 13});
  const KeyedRandom begun(7, KeyedRandom::EXPLORATION, {11});
  EXPECT_EQ(firstNumbers(begun.with(12).with(13)), firstNumbers(whole));
  EXPECT_NE(firstNumbers(begun.with(13).with(12)), firstNumbers(whole));
}

TEST(KeyedRandom, DrawsTheSameNumbersForTheSameKey) {
  EXPECT_EQ(firstNumbers({1, KeyedRandom::PLACEMENT, {2, 3}}), firstNumbers({1, KeyedRandom::PLACEMENT, {2, 3}}));
}

TEST(KeyedRandom, DoesNotDependOnOtherGenerators) {
  const auto alone = firstNumbers({1, KeyedRandom::EXPLORATION, {2, 3}});
  KeyedRandom random(1, KeyedRandom::EXPLORATION, {2, 3});
  KeyedRandom other(1, KeyedRandom::EXPLORATION, {2, 4});
  for (const std::uint64_t number : alone) {
    other.next();
    EXPECT_EQ(random.next(), number);
  }
}

TEST(KeyedRandom, DependsOnEveryPartOfTheKey) {
  std::set<std::uint64_t> firsts;
  std::size_t keys = 0;
  const std::array<std::uint64_t, 5> parts = {0, 1, 2, 1ULL << 32U, UINT64_MAX};
  const std::array<KeyedRandom::Stream, 3> streams = {KeyedRandom::PLACEMENT, KeyedRandom::EXPLORATION,
                                                      KeyedRandom::SCENARIO_CHOICE};
  for (const std::uint64_t seed : parts) {
    for (const KeyedRandom::Stream stream : streams) {
      firsts.insert(KeyedRandom(seed, stream, {}).next());
      ++keys;
      for (const std::uint64_t episode : parts) {
        firsts.insert(KeyedRandom(seed, stream, {episode}).next());
        ++keys;
        for (const std::uint64_t tick : parts) {
          firsts.insert(KeyedRandom(seed, stream, {episode, tick}).next());
          ++keys;
        }
      }
    }
  }
  EXPECT_EQ(firsts.size(), keys);  // the order of parts and their number included
}

TEST(KeyedRandom, DrawsTheReferenceNumbers) {
  // From a second implementation of splitmix64, in Python. Recorded runs depend on these numbers.
  KeyedRandom plain(0, KeyedRandom::PLACEMENT, {});
  EXPECT_EQ(plain.next(), 0x01D614F74E2A26C6U);
  EXPECT_EQ(plain.next(), 0x31ACE0C257119B01U);
  KeyedRandom keyed(1, KeyedRandom::EXPLORATION, {3, 4, 5});
  EXPECT_EQ(keyed.next(), 0x7059DD930BA11571U);
  EXPECT_EQ(keyed.next(), 0x3E45CB92BE7AF3BFU);
  KeyedRandom extreme(UINT64_MAX, KeyedRandom::SCENARIO_CHOICE, {UINT64_MAX});
  EXPECT_EQ(extreme.next(), 0x69E742A41B4F6B23U);
  EXPECT_EQ(extreme.next(), 0xD10F891E57A37348U);
}

TEST(KeyedRandom, ComputesFractionsAndChoicesFromTheHighBits) {
  // 0x7059DD930BA11571 / 2^64 = 0.43887..., times 8 = 3.51...
  KeyedRandom share(1, KeyedRandom::EXPLORATION, {3, 4, 5});
  EXPECT_NEAR(share.uniform(), 0.43887124, 1e-8);
  KeyedRandom choice(1, KeyedRandom::EXPLORATION, {3, 4, 5});
  EXPECT_EQ(choice.below(8), 3U);
  KeyedRandom between(1, KeyedRandom::EXPLORATION, {3, 4, 5});
  EXPECT_NEAR(between.uniform(-1.0, 1.0), -0.12225752, 1e-8);
}

TEST(KeyedRandom, IsUniformAlongASequence) {
  KeyedRandom random(7, KeyedRandom::PLACEMENT, {});
  std::vector<double> draws(100000);
  for (double& draw : draws) draw = random.uniform();
  expectEven(draws);
}

TEST(KeyedRandom, IsUniformAndUncorrelatedOverNeighbouringKeys) {
  // The learner draws once or twice for each (episode, tick, agent), so the first draws matter most.
  std::vector<double> draws;
  double products = 0.0;
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    for (std::uint64_t agent = 0; agent < 100; ++agent) {
      KeyedRandom random(7, KeyedRandom::EXPLORATION, {3, tick, agent});
      KeyedRandom later(7, KeyedRandom::EXPLORATION, {3, tick + 1, agent});
      draws.push_back(random.uniform());
      products += (draws.back() - 0.5) * (later.uniform() - 0.5);
    }
  }
  expectEven(draws);
  EXPECT_NEAR(products / 1e5 * 12.0, 0.0, 0.016);  // correlation; five standard deviations
}

TEST(KeyedRandom, DrawsBetweenTheLimits) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  double lowest = 1e9;
  double highest = -1e9;
  for (int i = 0; i < 10000; ++i) {
    const double draw = random.uniform(-3.0, 5.0);
    ASSERT_GE(draw, -3.0);
    ASSERT_LT(draw, 5.0);
    lowest = std::min(lowest, draw);
    highest = std::max(highest, draw);
  }
  EXPECT_LT(lowest, -2.99);
  EXPECT_GT(highest, 4.99);
}

TEST(KeyedRandom, NeverDrawsTheUpperLimitOfANarrowRange) {
  const double high = std::nextafter(1.0, 2.0);  // nothing but 1 lies in [1, high)
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  for (int i = 0; i < 100; ++i) ASSERT_LT(random.uniform(1.0, high), high);
}

TEST(KeyedRandom, DrawsTheLimitIfBothAreEqual) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  for (const double limit : {0.1, -1e300, 0.0}) EXPECT_EQ(random.uniform(limit, limit), limit);
}

TEST(KeyedRandom, ChoosesEachNumberEquallyOften) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(random.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 470);  // five standard deviations
  for (int i = 0; i < 100; ++i) ASSERT_EQ(random.below(1), 0U);
}

TEST(KeyedRandom, ChoosesBelowTheLargestInteger) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  std::uint32_t highest = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::uint32_t choice = random.below(UINT32_MAX);
    ASSERT_LT(choice, UINT32_MAX);
    highest = std::max(highest, choice);
  }
  EXPECT_GT(highest, 4290000000U);
}

}  // namespace
}  // namespace crowd::random_test
