#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "common/random.h"

namespace crowd {

/// Calls check(seed, random) for the seeds 0 to count - 1, until it fails. Failures name the seed.
template <typename Check>
void forSeeds(std::uint64_t count, KeyedRandom::Stream stream, const Check& check) {
  for (std::uint64_t seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, stream, {});
    check(seed, random);
  }
}

}  // namespace crowd
