#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "common/random.h"
#include "simd/kernels.h"

namespace crowd::simd::row_numbers_test {
namespace {

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

struct OwnedDigit {
  std::vector<float> values;
  float sign;
  std::vector<float> limits;
};

/// Row numbers, followed by one that must not change.
std::vector<std::uint32_t> find(const Kernels& kernels, const std::vector<OwnedDigit>& owned, std::size_t count,
                                LastDigit last = {1, 0}) {
  std::vector<ClassDigit> digits;
  for (const OwnedDigit& digit : owned) {
    digits.push_back({digit.values.data(), digit.sign, digit.limits.data(), digit.limits.size()});
  }
  std::vector<std::uint32_t> rows(count + 1, 77);
  kernels.find_row_numbers(digits.data(), digits.size(), last, count, rows.data());
  return rows;
}

std::vector<float> padded(std::vector<float> values) {
  values.resize((values.size() + VALUES_PADDED - 1) / VALUES_PADDED * VALUES_PADDED, NOT_A_NUMBER);
  return values;
}

TEST(FindRowNumbers, CombinesClasses) {
  const std::vector<OwnedDigit> digits = {{padded({0.0F, 1.0F, 1.5F}), 1.0F, {1.0F, 2.0F}},
                                          {padded({0.5F, 0.0F, -1.0F}), -1.0F, {-0.25F, 0.0F, 1.0F}},
                                          {padded({9.0F, 9.0F, 9.0F}), 1.0F, {}}};
  for (const Kernels& kernels : availableKernels()) {
    // First digits 0, 1, 1 of 3; second 0, 2, 3 of 4.
    EXPECT_EQ(find(kernels, digits, 3), (std::vector<std::uint32_t>{0, 6, 7, 77})) << kernels.target;
    EXPECT_EQ(find(kernels, digits, 3, {5, 2}), (std::vector<std::uint32_t>{2, 32, 37, 77})) << kernels.target;
    EXPECT_EQ(find(kernels, digits, 0), (std::vector<std::uint32_t>{77})) << kernels.target;
  }
}

TEST(FindRowNumbers, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const std::size_t count = random.below(50);
    const LastDigit last{1 + random.below(3), random.below(3)};
    std::vector<OwnedDigit> digits(random.below(7));
    for (OwnedDigit& digit : digits) {
      digit.sign = random.below(2) == 0 ? 1.0F : -1.0F;
      for (std::uint32_t limits = random.below(8); digit.limits.size() < limits;) {
        digit.limits.push_back(static_cast<float>(random.uniform(-1.0, 1.0)));
      }
      for (std::size_t i = 0; i < count; ++i) {
        const bool on_limit = !digit.limits.empty() && random.below(3) == 0;
        digit.values.push_back(on_limit ? digit.sign * digit.limits[0] : static_cast<float>(random.uniform(-1.0, 1.0)));
        if (random.below(20) == 0) digit.values.back() = NOT_A_NUMBER;
      }
      digit.values = padded(digit.values);
    }
    const auto expected = find(REFERENCE, digits, count, last);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(find(kernels, digits, count, last), expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::row_numbers_test
