#pragma once

/// Elementary functions with the same bits on all processors, compilers and C libraries: they consist of operations
/// that IEEE 754 defines exactly. Those of <cmath> differ in their last digits between C libraries, and between
/// processors with and without fused operations; in a crowd, such a difference grows until agents walk other ways.
///
/// Errors are below 2 units in the last place (tan and asin: 4) for sine and cosine of up to a thousand. All
/// return NaN for NaN.
namespace crowd::portable {

/// @param angle [rad]
double sin(double angle);
double cos(double angle);
double tan(double angle);
/// @brief The direction of (x, y) [rad], in [-pi, pi]; 0 for (0, 0) and (-0, 0).
double atan2(double y, double x);
/// @param x -1 to 1
double asin(double x);
double exp(double x);
/// @brief The natural logarithm: minus infinity for 0, NaN below.
double log(double x);
/// @brief A power of a base above 0. Whole exponents up to 64 are multiplied out; of others, the error is that of
/// exp(exponent * log(base)).
double pow(double base, double exponent);

}  // namespace crowd::portable
