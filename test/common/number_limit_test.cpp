#include "common/text/number_limit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::number_limit_test {
namespace {

constexpr double NO_LIMIT = std::numeric_limits<double>::infinity();

TEST(NumberLimit, SaysWhatWasExpected) {
  constexpr NumberLimit SPEED{NumberRule::POSITIVE, 1000.0, "m/s"};
  EXPECT_EQ(refusalOf(1000.0, SPEED), "");
  EXPECT_EQ(refusalOf(1e300, SPEED), "at most 1000 m/s");
  EXPECT_EQ(refusalOf(0.0, SPEED), "a number above 0");
  EXPECT_EQ(refusalOf(NO_LIMIT, SPEED), "a number above 0");
  EXPECT_EQ(refusalOf(11.0, NumberLimit(NumberRule::NOT_NEGATIVE, 10.0, "")), "at most 10");
  constexpr NumberLimit OFFSET{NumberRule::ANY, 5.0, "m"};
  EXPECT_EQ(refusalOf(-5.0, OFFSET), "");
  EXPECT_EQ(refusalOf(-5.1, OFFSET), "a number from -5 to 5 m");
}

TEST(NumberLimit, OfARuleAloneIsAnyMagnitude) {
  EXPECT_EQ(refusalOf(1e308, NumberRule::POSITIVE), "");
  EXPECT_EQ(refusalOf(-1e308, NumberRule::ANY), "");
  EXPECT_EQ(refusalOf(std::nan(""), NumberRule::ANY), "a number");
}

}  // namespace
}  // namespace crowd::number_limit_test
