#include "navigation/sliding.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::sliding_test {
namespace {

const double SQRT_HALF = std::sqrt(0.5);

TEST(SlideAlong, WithoutContactsThereIsNothingToSlideAlong) { EXPECT_FALSE(slideAlong({1.0, 0.0}, {}).has_value()); }

TEST(SlideAlong, TheDirectionIsTurnedToTheTangentOfTheContact) {
  const auto slid = slideAlong({1.0, 0.0}, {{SQRT_HALF, SQRT_HALF}});
  ASSERT_TRUE(slid.has_value());
  EXPECT_NEAR((*slid - Vector2(SQRT_HALF, -SQRT_HALF)).norm(), 0.0, 1e-12);
}

TEST(SlideAlong, ContactsBesideAndBehindAreNotInTheWay) {
  EXPECT_FALSE(slideAlong({0.0, 1.0}, {{1.0, 0.0}, {-1.0, 0.0}, {SQRT_HALF, -SQRT_HALF}}).has_value());
}

TEST(SlideAlong, AContactStraightAheadLeavesNoDirection) {
  EXPECT_FALSE(slideAlong({1.0, 0.0}, {{1.0, 0.0}}).has_value());
}

/// A corner of 90 degrees, entered along its bisector.
TEST(SlideAlong, ACornerLeavesNoDirection) {
  EXPECT_FALSE(slideAlong({1.0, 0.0}, {{SQRT_HALF, SQRT_HALF}, {SQRT_HALF, -SQRT_HALF}}).has_value());
}

}  // namespace
}  // namespace crowd::sliding_test
