#include "simd/kernels.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "social_crowd/errors.h"

namespace crowd::simd::kernels_test {
namespace {

TEST(Kernels, HaveDistinctNamesAndEndWithTheReference) {
  std::set<std::string> names;
  for (const Kernels& kernels : availableKernels()) names.insert(kernels.target);
  EXPECT_EQ(names.size(), availableKernels().size());
  EXPECT_STREQ(availableKernels().back().target, "reference");
}

#ifdef CROWD_HIGHWAY
TEST(Kernels, UseTheInstructionsOfThisProcessor) {
  EXPECT_GT(availableKernels().size(), 1U);
#if defined(__x86_64__) && !defined(__AVX512F__)  // a build for AVX-512 alone has no kernels for AVX2
  std::set<std::string> names;
  for (const Kernels& kernels : availableKernels()) names.insert(kernels.target);
  const bool is_here = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                       __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  EXPECT_EQ(names.count("AVX2"), is_here ? 1U : 0U);
#endif
}
#endif

TEST(Kernels, CanBeChosenByAnEnvironmentVariable) {
  for (const Kernels& wanted : availableKernels()) {
    ASSERT_EQ(setenv("SOCIAL_CROWD_SIMD", wanted.target, 1), 0);
    EXPECT_STREQ(chooseKernels().target, wanted.target);
    EXPECT_EQ(chooseKernels().collect_nearby, wanted.collect_nearby);
  }
  ASSERT_EQ(unsetenv("SOCIAL_CROWD_SIMD"), 0);
  EXPECT_STREQ(chooseKernels().target, availableKernels().front().target);
}

TEST(Kernels, RefuseAnUnknownName) {
  ASSERT_EQ(setenv("SOCIAL_CROWD_SIMD", "AVX7", 1), 0);
  try {
    chooseKernels();
    FAIL() << "expected an error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'AVX7', expected one of"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("reference"), std::string::npos) << error.what();
  }
  ASSERT_EQ(unsetenv("SOCIAL_CROWD_SIMD"), 0);
}

}  // namespace
}  // namespace crowd::simd::kernels_test
