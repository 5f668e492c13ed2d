#include "social_crowd/common/random.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr std::uint64_t GOLDEN_GAMMA = 0x9E3779B97F4A7C15ULL;

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

}  // namespace

KeyedRandom::KeyedRandom(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> key)
    : state_(mix(mix(seed + GOLDEN_GAMMA) + stream)) {
  for (const std::uint64_t part : key) state_ = mix(state_ + GOLDEN_GAMMA + part);
}

std::uint64_t KeyedRandom::next() {
  state_ += GOLDEN_GAMMA;
  return mix(state_);
}

double KeyedRandom::uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

double KeyedRandom::uniform(double low, double high) {
  const double drawn = low + (high - low) * uniform();
  return drawn < high ? drawn : std::max(low, std::nextafter(high, low));  // rounding may land on the upper limit
}

std::uint32_t KeyedRandom::below(std::uint32_t count) {
  // Lemire's multiply-shift; its bias of count / 2^32 does not show in what is drawn here.
  return static_cast<std::uint32_t>(((next() >> 32U) * count) >> 32U);
}

}  // namespace crowd
