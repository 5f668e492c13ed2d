#include "common/portable_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace crowd::portable_math_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr long double PI = 3.14159265358979323846264338327950288L;

/// The error of a result in units in the last place of the true value.
double errorOf(double result, long double truth) {
  const double rounded = std::abs(static_cast<double>(truth));
  const double unit = std::nextafter(rounded, INFINITE) - rounded;
  return static_cast<double>(std::abs(result - truth)) / unit;
}

/// The largest error of a function of one argument among uniform ones, against long double.
template <typename Function, typename Truth>
double largestError(double low, double high, const Function& function, const Truth& truth) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(low, high);
  double largest = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double x = uniform(random);
    largest = std::max(largest, errorOf(function(x), truth(static_cast<long double>(x))));
  }
  return largest;
}

TEST(PortableMath, ErrsByLessThanTwoUnitsInTheLastPlace) {
  for (const double range : {0.7, 7.0, 1000.0}) {
    EXPECT_LT(largestError(-range, range, portable::sin, [](long double x) { return std::sin(x); }), 2.0) << range;
    EXPECT_LT(largestError(-range, range, portable::cos, [](long double x) { return std::cos(x); }), 2.0) << range;
  }
  EXPECT_LT(largestError(-1.5, 1.5, portable::tan, [](long double x) { return std::tan(x); }), 4.0);
  EXPECT_LT(largestError(-1.0, 1.0, portable::asin, [](long double x) { return std::asin(x); }), 4.0);
  for (const double range : {0.3, 20.0, 700.0})
    EXPECT_LT(largestError(-range, range, portable::exp, [](long double x) { return std::exp(x); }), 2.0) << range;
  for (const double high : {2.0, 1e-300, 1e10, 1e300})
    EXPECT_LT(largestError(0.0, high, portable::log, [](long double x) { return std::log(x); }), 2.0) << high;
  for (const double x : {-3.0, -1.0, -0.2, 0.01, 1.0, 5.0}) {
    const auto function = [&](double y) { return portable::atan2(y, x); };
    const auto truth = [&](long double y) { return std::atan2(y, static_cast<long double>(x)); };
    EXPECT_LT(largestError(-4.0, 4.0, function, truth), 2.0) << x;
  }
}

TEST(PortableMath, GivesKnownValues) {
  EXPECT_EQ(portable::sin(0.0), 0.0);
  EXPECT_EQ(portable::cos(0.0), 1.0);
  EXPECT_EQ(portable::cos(static_cast<double>(PI)), -1.0);
  EXPECT_EQ(portable::sin(static_cast<double>(PI / 2)), 1.0);
  EXPECT_EQ(portable::exp(0.0), 1.0);
  EXPECT_NEAR(portable::exp(1.0), std::exp(1.0), 1e-15);
  EXPECT_EQ(portable::log(1.0), 0.0);
  EXPECT_EQ(portable::log(2.0), static_cast<double>(std::log(2.0L)));
  EXPECT_EQ(portable::pow(100.0, 3.0), 1e6);
  EXPECT_EQ(portable::pow(5.0, -1.0), 0.2);
  EXPECT_EQ(portable::pow(0.3, 1.0), 0.3);
  EXPECT_EQ(portable::pow(0.3, 0.0), 1.0);
  EXPECT_NEAR(portable::pow(2.0, 0.5), std::sqrt(2.0), 1e-15);
}

TEST(PortableMath, GivesTheDirectionsOfTheAxesAndDiagonals) {
  const auto pi = static_cast<double>(PI);
  for (const double length : {1e-300, 0.1, 1.0, 3.0, 1e300}) {
    EXPECT_EQ(portable::atan2(0.0, length), 0.0);
    EXPECT_EQ(portable::atan2(length, length), pi / 4);
    EXPECT_EQ(portable::atan2(length, 0.0), pi / 2);
    EXPECT_EQ(portable::atan2(length, -length), static_cast<double>(3 * PI / 4));
    EXPECT_EQ(portable::atan2(0.0, -length), pi);
    EXPECT_EQ(portable::atan2(-length, -length), static_cast<double>(-3 * PI / 4));
    EXPECT_EQ(portable::atan2(-length, 0.0), -pi / 2);
    EXPECT_EQ(portable::atan2(-length, length), -pi / 4);
  }
  EXPECT_EQ(portable::atan2(0.0, 0.0), 0.0);
}

TEST(PortableMath, HasLimitsAndRefusesWhatHasNoValue) {
  EXPECT_EQ(portable::exp(710.0), INFINITE);
  EXPECT_EQ(portable::exp(-746.0), 0.0);
  EXPECT_EQ(portable::log(0.0), -INFINITE);
  EXPECT_EQ(portable::log(INFINITE), INFINITE);
  EXPECT_TRUE(std::isnan(portable::log(-1.0)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, INFINITE}) {
    EXPECT_TRUE(std::isnan(portable::sin(x)));
    EXPECT_TRUE(std::isnan(portable::cos(x)));
  }
  EXPECT_EQ(portable::atan2(INFINITE, 1.0), portable::atan2(1.0, 0.0));
  EXPECT_EQ(portable::atan2(1.0, -INFINITE), portable::atan2(0.0, -1.0));
  EXPECT_EQ(portable::atan2(INFINITE, INFINITE), portable::atan2(1.0, 1.0));
  EXPECT_TRUE(std::isnan(portable::atan2(nan, 1.0)));
  EXPECT_TRUE(std::isnan(portable::atan2(1.0, nan)));
  EXPECT_TRUE(std::isnan(portable::exp(nan)));
  EXPECT_TRUE(std::isnan(portable::log(nan)));
  EXPECT_TRUE(std::isnan(portable::pow(nan, 0.5)));
}

/// The bits of results, worked out with 60 decimal digits and rounded once where the functions round them so: they are
/// to be these on every processor, with every compiler and every level of optimization.
TEST(PortableMath, GivesTheSameBitsEverywhere) {
  EXPECT_EQ(portable::sin(0.5), 0x1.eaee8744b05fp-2);
  EXPECT_EQ(portable::cos(2.0), -0x1.aa22657537205p-2);
  EXPECT_EQ(portable::exp(-3.0), 0x1.97db0ccceb0afp-5);
  EXPECT_EQ(portable::log(10.0), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(portable::atan2(1.0, 3.0), 0x1.4978fa3269ee1p-2);
}

}  // namespace
}  // namespace crowd::portable_math_test
