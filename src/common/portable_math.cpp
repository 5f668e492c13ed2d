#include "common/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace crowd::portable {
namespace {

/// A constant as the sum of two numbers.
struct Sum {
  double high;
  double low;
};

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr Sum PI{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
// Of the high parts of the next two, 33 bits are used, so that products with whole numbers below 2^20 are exact.
constexpr std::array<double, 3> QUARTER_TURN{0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
constexpr Sum LN_2{0x1.62e42fefp-1, 0x1.473de6af278edp-34};
/// atan(i / 4).
constexpr std::array<Sum, 5> ARC_TANGENTS{{{0.0, 0.0},
                                           {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                           {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                           {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                           {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// Taylor series of exp, from x^2 on: 1 / i!; odd and even ones with alternating signs are those of sine and cosine.
template <std::size_t N>
constexpr std::array<double, N> factorials(std::size_t first, std::size_t step, double sign) {
  std::array<double, N> series{};
  double factorial = 1.0;
  std::size_t i = 1;
  double factor = 1.0;
  for (std::size_t k = 0; k < N; ++k) {
    for (; i <= first + k * step; ++i) factorial *= static_cast<double>(i);
    series[k] = factor / factorial;
    factor *= sign;
  }
  return series;
}

/// 1 / (3 + 2 k), with alternating signs if `sign` is -1.
template <std::size_t N>
constexpr std::array<double, N> oddParts(double sign) {
  std::array<double, N> series{};
  double factor = 1.0;
  for (std::size_t k = 0; k < N; ++k) {
    series[k] = factor / static_cast<double>(3 + 2 * k);
    factor *= sign;
  }
  return series;
}

// The first term left out is below 2^-54 of the sum: |x| is at most pi / 4, pi / 4, ln(2) / 2, 0.172 and 0.125.
constexpr auto SINE = factorials<8>(3, 2, -1.0);
constexpr auto COSINE = factorials<8>(4, 2, -1.0);
constexpr auto EXPONENTIAL = factorials<13>(2, 1, 1.0);
constexpr auto LOGARITHM = oddParts<10>(1.0);
constexpr auto ARC_TANGENT = oddParts<9>(-1.0);

template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x) {
  double sum = coefficients[N - 1];
  for (std::size_t i = N - 1; i > 0; --i) sum = sum * x + coefficients[i - 1];
  return sum;
}

/// Rounds to the nearest whole number, up to 2^51.
double nearest(double x) {
  constexpr double SHIFT = 0x1.8p+52;
  return (x + SHIFT) - SHIFT;
}

/// An angle within an eighth of a turn of 0, and the number of quarter turns before it, modulo 4.
struct PartOfTurn {
  double angle;
  unsigned quarter;
};

PartOfTurn partOfTurn(double angle) {
  constexpr double FAR = 1e6;
  if (std::abs(angle) > FAR) angle = std::remainder(angle, 2.0 * PI.high);
  const double quarters = nearest(angle * (2.0 / PI.high));
  const double part = angle - quarters * QUARTER_TURN[0] - quarters * QUARTER_TURN[1] - quarters * QUARTER_TURN[2];
  return {part, static_cast<unsigned>(static_cast<std::int64_t>(quarters) & 3)};
}

double sineOfPart(double x) {
  const double square = x * x;
  return x - x * square * polynomial(SINE, square);
}

double cosineOfPart(double x) {
  const double square = x * x;
  const double half = 0.5 * square;
  const double sum = 1.0 - half;
  return sum + ((1.0 - sum) - half + square * square * polynomial(COSINE, square));
}

/// atan(y / x) for 0 <= y <= x.
Sum arcTangent(double y, double x) {
  const double index = nearest(4.0 * y / x);
  const double part = (y - 0.25 * index * x) / (x + 0.25 * index * y);
  const double square = part * part;
  const Sum& start = ARC_TANGENTS[static_cast<std::size_t>(index)];
  return {start.high, start.low + part - part * square * polynomial(ARC_TANGENT, square)};
}

double wholePower(double base, unsigned exponent) {
  double power = 1.0;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) power *= base;
    base *= base;
  }
  return power;
}

}  // namespace

double sin(double angle) {
  if (!std::isfinite(angle)) return NOT_A_NUMBER;
  const PartOfTurn part = partOfTurn(angle);
  const double sine = part.quarter % 2 == 0 ? sineOfPart(part.angle) : cosineOfPart(part.angle);
  return part.quarter < 2 ? sine : -sine;
}

double cos(double angle) {
  if (!std::isfinite(angle)) return NOT_A_NUMBER;
  const PartOfTurn part = partOfTurn(angle);
  const double cosine = part.quarter % 2 == 0 ? cosineOfPart(part.angle) : sineOfPart(part.angle);
  return part.quarter == 0 || part.quarter == 3 ? cosine : -cosine;
}

double tan(double angle) { return sin(angle) / cos(angle); }

double atan2(double y, double x) {
  double shorter = std::abs(y);
  double longer = std::abs(x);
  if (std::isnan(shorter + longer)) return NOT_A_NUMBER;
  const bool is_steep = shorter > longer;
  if (is_steep) std::swap(shorter, longer);
  if (longer == 0.0) return y;
  if (longer == INFINITE) {
    shorter = shorter == INFINITE ? 1.0 : 0.0;
    longer = 1.0;
  }
  const Sum angle = arcTangent(shorter, longer);
  // A multiple of a quarter turn plus or minus the angle, small parts first.
  const double start = is_steep ? 0.5 : x < 0.0 ? 1.0 : 0.0;
  const double sign = is_steep == (x < 0.0) ? 1.0 : -1.0;
  const double turned = start == 0.0 ? angle.high + angle.low
                                     : (start * PI.high + sign * angle.high) + (start * PI.low + sign * angle.low);
  return std::copysign(turned, y);
}

double asin(double x) { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }

double exp(double x) {
  constexpr double LARGEST = 709.782712893384;  // beyond it, the result is infinite
  constexpr double LEAST = -745.133219101941;   // below it, the result is 0
  if (std::isnan(x)) return x;
  if (x > LARGEST) return INFINITE;
  if (x < LEAST) return 0.0;
  const double halvings = nearest(x / (LN_2.high + LN_2.low));
  const double part = x - halvings * LN_2.high - halvings * LN_2.low;
  return std::ldexp(1.0 + (part + part * part * polynomial(EXPONENTIAL, part)), static_cast<int>(halvings));
}

double log(double x) {
  constexpr double ROOT_OF_HALF = 0.70710678118654752;
  if (x == 0.0) return -INFINITE;
  if (!(x > 0.0)) return NOT_A_NUMBER;
  if (x == INFINITE) return x;
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);
  if (fraction < ROOT_OF_HALF) {
    fraction *= 2.0;
    --exponent;
  }
  // log((1 + s) / (1 - s)) = 2 (s + s^3 / 3 + s^5 / 5 ...)
  const double s = (fraction - 1.0) / (fraction + 1.0);
  const double square = s * s;
  const double small = 2.0 * s * square * polynomial(LOGARITHM, square) + exponent * LN_2.low;
  return exponent * LN_2.high + (2.0 * s + small);
}

double pow(double base, double exponent) {
  constexpr double LARGEST_WHOLE = 64.0;
  if (std::abs(exponent) > LARGEST_WHOLE || nearest(exponent) != exponent) return exp(exponent * log(base));
  const double power = wholePower(base, static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0.0 ? 1.0 / power : power;
}

}  // namespace crowd::portable
