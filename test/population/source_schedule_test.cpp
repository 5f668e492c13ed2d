#include "population/source_schedule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace crowd::source_schedule_test {
namespace {

KeyedRandom randomOf(std::uint64_t seed) { return {seed, KeyedRandom::POPULATION, {}}; }

std::vector<double> timesOf(const SourceDescription& source, std::uint64_t seed = 1, std::size_t most = 100000) {
  std::vector<double> times;
  for (SourceSchedule schedule(source, randomOf(seed)); !schedule.isOver() && times.size() < most; schedule.advance()) {
    times.push_back(schedule.next());
  }
  return times;
}

TEST(SourceSchedule, GivesTheTimesOfTheFile) {
  SourceDescription source;
  source.times = {1.0, 2.5, 2.5};
  EXPECT_EQ(timesOf(source), source.times);
  source.count = 2;
  EXPECT_EQ(timesOf(source), (std::vector<double>{1.0, 2.5}));
}

TEST(SourceSchedule, RegularIntervalsBeginAtFromAndEndBeforeUntil) {
  SourceDescription source;
  source.rate = 0.5;
  source.regular = true;
  source.from = 3.0;
  source.until = 9.0;
  EXPECT_EQ(timesOf(source), (std::vector<double>{3.0, 5.0, 7.0}));
  source.count = 2;
  EXPECT_EQ(timesOf(source), (std::vector<double>{3.0, 5.0}));
}

/// Mean and standard deviation of exponential intervals are 1 / rate; a share of exp(-2) is longer than twice that.
TEST(SourceSchedule, ExponentialIntervals) {
  SourceDescription source;
  source.rate = 4.0;
  source.from = 100.0;
  constexpr std::size_t COUNT = 20000;
  const std::vector<double> times = timesOf(source, 7, COUNT);
  double before = source.from;
  double squares = 0.0;
  std::size_t longer = 0;
  for (const double time : times) {
    const double interval = time - before;
    ASSERT_GE(interval, 0.0);
    squares += interval * interval;
    longer += interval > 2.0 / *source.rate ? 1 : 0;
    before = time;
  }
  const double mean = (times.back() - source.from) / COUNT;
  EXPECT_NEAR(mean, 0.25, 0.01);
  EXPECT_NEAR(std::sqrt(squares / COUNT - mean * mean), 0.25, 0.01);
  EXPECT_NEAR(static_cast<double>(longer) / COUNT, std::exp(-2.0), 0.01);
}

TEST(SourceSchedule, DependsOnTheSeedOnly) {
  SourceDescription source;
  source.rate = 1.0;
  source.until = 50.0;
  EXPECT_EQ(timesOf(source, 3), timesOf(source, 3));
  EXPECT_NE(timesOf(source, 3), timesOf(source, 4));
  for (const double time : timesOf(source, 3)) EXPECT_LT(time, 50.0);
}

}  // namespace
}  // namespace crowd::source_schedule_test
