#include "common/text/number_range.h"

#include <gtest/gtest.h>

namespace crowd::number_range_test {
namespace {

constexpr double NO_LIMIT = std::numeric_limits<double>::infinity();

TEST(NumberRange, ContainsItsLimitsUnlessTheyAreOpen) {
  const NumberRange closed{0.0, 1.0};
  EXPECT_TRUE(closed.contains(0.0) && closed.contains(1.0));
  EXPECT_FALSE(closed.contains(-0.001) || closed.contains(1.001));
  const NumberRange open{0.0, 1.0, "", true, true};
  EXPECT_TRUE(open.contains(0.5));
  EXPECT_FALSE(open.contains(0.0) || open.contains(1.0));
}

TEST(NumberRange, ContainsFiniteNumbersOnly) {
  const NumberRange any;
  EXPECT_TRUE(any.contains(-1e300));
  EXPECT_FALSE(any.contains(NO_LIMIT) || any.contains(std::nan("")));
}

TEST(NumberRange, TextNamesLimitsAndUnit) {
  EXPECT_EQ(toText(NumberRange{}), "a number");
  EXPECT_EQ(toText(NumberRange{0.001, 3600.0, "s"}), "a number from 0.001 to 3600 s");
  EXPECT_EQ(toText(NumberRange{0.0, 1.0, "", true, false}), "a number above 0, at most 1");
  EXPECT_EQ(toText(NumberRange{0.0, 1.0, "", true, true}), "a number above 0, below 1");
  EXPECT_EQ(toText(NumberRange{0.0, 1.0, "", false, true}), "a number from 0 to below 1");
  EXPECT_EQ(toText(NumberRange{0.0, NO_LIMIT, "m"}), "a number of at least 0 m");
  EXPECT_EQ(toText(NumberRange{-NO_LIMIT, 2.0}), "a number of at most 2");
}

}  // namespace
}  // namespace crowd::number_range_test
