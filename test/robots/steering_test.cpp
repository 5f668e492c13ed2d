#include "robots/controllers/steering.h"

#include <gtest/gtest.h>

namespace crowd::steering_test {
namespace {

void expectTwist(const Twist& twist, double ahead, double left, double rotation) {
  EXPECT_NEAR(twist.linear.x(), ahead, 1e-12);
  EXPECT_NEAR(twist.linear.y(), left, 1e-12);
  EXPECT_NEAR(twist.rotation, rotation, 1e-12);
}

TEST(Steer, MovesAHolonomicRobotInTheDirection) {
  expectTwist(steer(Drive::HOLONOMIC, PI / 2.0, 0.8), 0.0, 0.8, 0.0);
  expectTwist(steer(Drive::HOLONOMIC, PI, 0.8), -0.8, 0.0, 0.0);
}

TEST(Steer, TurnsADifferentialDriveBeforeItDrives) {
  expectTwist(steer(Drive::DIFFERENTIAL, 0.0, 0.8), 0.8, 0.0, 0.0);
  expectTwist(steer(Drive::DIFFERENTIAL, toRadians(-29.0), 0.8), 0.8 * std::cos(toRadians(29.0)), 0.0,
              -2.0 * toRadians(29.0));
  expectTwist(steer(Drive::DIFFERENTIAL, toRadians(31.0), 0.8), 0.0, 0.0, 2.0 * toRadians(31.0));
  expectTwist(steer(Drive::DIFFERENTIAL, PI, 0.8), 0.0, 0.0, 2.0 * PI);
}

TEST(Steer, KeepsACarMoving) {
  expectTwist(steer(Drive::ACKERMANN, toRadians(60.0), 0.8), 0.4, 0.0, 2.0 * toRadians(60.0));
  expectTwist(steer(Drive::ACKERMANN, PI, 0.8), 0.16, 0.0, 2.0 * PI);
}

}  // namespace
}  // namespace crowd::steering_test
