#include "scenario/person_kind.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/random.h"

namespace crowd::person_kind_test {
namespace {

constexpr std::uint64_t SEED = 7;
constexpr int DRAWS = 10'000;

std::vector<PersonKind> threeKinds() {
  std::vector<PersonKind> kinds(3);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    kinds[i].speed.range = {1.0 + static_cast<double>(i), 1.5 + static_cast<double>(i)};
    kinds[i].radius = {0.2, 0.3};
    kinds[i].figure = static_cast<Figure>(i);
  }
  return kinds;
}

AgentGroup mixed() {
  AgentGroup group;
  group.kinds = {{0, 7.0}, {1, 2.0}, {2, 1.0}};
  group.speed_of_kind = group.radius_of_kind = true;
  return group;
}

KeyedRandom randomOf(int agent) { return {SEED, KeyedRandom::KIND, {static_cast<std::uint64_t>(agent)}}; }

TEST(PersonKind, IsDrawnByItsShareThenItsRadiusAndSpeed) {
  for (int agent = 0; agent < 100; ++agent) {
    AgentStart start;
    drawKind(mixed(), threeKinds(), randomOf(agent), start);
    KeyedRandom random = randomOf(agent);
    const double place = 10.0 * random.uniform();
    ASSERT_EQ(start.kind, place < 7.0 ? 0 : place < 9.0 ? 1 : 2);
    EXPECT_EQ(start.figure, static_cast<Figure>(start.kind));
    EXPECT_EQ(start.radius, random.uniform(0.2, 0.3));
    EXPECT_EQ(start.max_speed, random.uniform(1.0 + start.kind, 1.5 + start.kind));
  }
}

TEST(PersonKind, SharesAreKept) {
  std::array<int, 3> counts = {};
  for (int agent = 0; agent < DRAWS; ++agent) {
    AgentStart start;
    drawKind(mixed(), threeKinds(), randomOf(agent), start);
    ++counts.at(static_cast<std::size_t>(start.kind));
  }
  // Within four standard deviations of a binomial distribution.
  for (const auto& [kind, share] : {std::pair(0, 0.7), std::pair(1, 0.2), std::pair(2, 0.1)}) {
    EXPECT_NEAR(counts.at(kind), DRAWS * share, 4.0 * std::sqrt(DRAWS * share * (1.0 - share)));
  }
}

TEST(PersonKind, GivenValuesStay) {
  AgentGroup group = mixed();
  group.speed_of_kind = group.radius_of_kind = false;
  AgentStart start;
  start.max_speed = 5.0;
  start.radius = 0.4;
  drawKind(group, threeKinds(), randomOf(0), start);
  EXPECT_EQ(start.max_speed, 5.0);
  EXPECT_EQ(start.radius, 0.4);
  AgentStart other;
  drawKind({}, threeKinds(), randomOf(0), other);
  EXPECT_EQ(other.kind, NO_KIND);
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments momentsOf(const Distribution& distribution) {
  KeyedRandom random(SEED, KeyedRandom::KIND, {});
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < DRAWS; ++i) {
    const double value = distribution.draw(random);
    EXPECT_GE(value, distribution.range.low);
    EXPECT_LE(value, distribution.range.high);
    sum += value;
    squares += value * value;
  }
  return {sum / DRAWS, std::sqrt(squares / DRAWS - sum / DRAWS * sum / DRAWS)};
}

TEST(PersonKind, SpeedsAreNormalWithinTheRange) {
  // Cut at two and a half standard deviations, a normal distribution has 0.9546 of its deviation.
  const Moments wide = momentsOf({{1.34 - 0.65, 1.34 + 0.65}, Distribution::Normal{1.34, 0.26}});
  EXPECT_NEAR(wide.mean, 1.34, 0.01);
  EXPECT_NEAR(wide.deviation, 0.9546 * 0.26, 0.01);
  // Cut at its mean, it is a half-normal one: the mean is sqrt(2 / pi) deviations above.
  const Moments half = momentsOf({{1.0, 3.0}, Distribution::Normal{1.0, 0.2}});
  EXPECT_NEAR(half.mean, 1.0 + 0.2 * std::sqrt(2.0 / 3.14159265), 0.01);
}

TEST(PersonKind, SpeedsInANarrowRangeAreUniform) {
  const Moments narrow = momentsOf({{1.0, 1.0002}, Distribution::Normal{1.0001, 1.0}});
  EXPECT_NEAR(narrow.mean, 1.0001, 1e-5);
  EXPECT_NEAR(narrow.deviation, 0.0002 / std::sqrt(12.0), 1e-5);
}

}  // namespace
}  // namespace crowd::person_kind_test
