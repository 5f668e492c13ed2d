#include "learning/rl/learning_rate_schedule.h"

#include <gtest/gtest.h>

namespace crowd::learning_rate_schedule_test {
namespace {

LearningParameters decaying(double alpha, double alpha_decay) {
  LearningParameters parameters;
  parameters.alpha = alpha;
  parameters.alpha_decay = alpha_decay;
  return parameters;
}

TEST(LearningRateSchedule, ByHand) {
  const LearningRateSchedule thirds(decaying(0.3, 1.0));
  EXPECT_EQ(thirds.at(1), 1.0);
  EXPECT_EQ(thirds.at(2), 0.5);
  EXPECT_EQ(thirds.at(3), 1.0 / 3.0);
  EXPECT_EQ(thirds.at(4), 0.3);
  EXPECT_EQ(thirds.at(UINT32_MAX), 0.3);
  EXPECT_EQ(LearningRateSchedule(decaying(0.1, 0.0)).at(1), 0.1);
}

TEST(LearningRateSchedule, AgreesWithTheParametersBitForBit) {
  for (const double alpha : {1e-9, 0.005, 0.5, 1.0}) {
    for (const double alpha_decay : {0.0, 0.1, 0.6, 1.0}) {
      SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", alpha_decay " << alpha_decay);
      const LearningParameters parameters = decaying(alpha, alpha_decay);
      const LearningRateSchedule learning_rates(parameters);
      // Beyond the size of the table.
      for (std::uint32_t visits = 1; visits < 40000; ++visits) {
        ASSERT_EQ(learning_rates.at(visits), parameters.learningRate(visits)) << visits << " visits";
      }
      EXPECT_EQ(learning_rates.at(UINT32_MAX), parameters.learningRate(UINT32_MAX));
    }
  }
}

}  // namespace
}  // namespace crowd::learning_rate_schedule_test
