#include "common/random.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
double KeyedRandom::uniform(double low, double high) {
  const double drawn = low + (high - low) * uniform();
  return drawn < high ? drawn : std::max(low, std::nextafter(high, low));  // rounding may land on the upper limit
}

double KeyedRandom::normal() {
  constexpr double FULL_CIRCLE = 6.28318530717958647692;
  const double radius = std::sqrt(-2.0 * portable::log(1.0 - uniform()));
  return radius * portable::cos(FULL_CIRCLE * uniform());
}

std::uint32_t KeyedRandom::below(std::uint32_t count) {
  // Lemire's multiply-shift; its bias of count / 2^32 is negligible for the counts used here.
  return static_cast<std::uint32_t>(((next() >> 32U) * count) >> 32U);
}

}  // namespace crowd
