#include "robots/controllers/reactive_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/robots.h"

namespace crowd::reactive_rule_test {
namespace {

constexpr float NOTHING = std::numeric_limits<float>::infinity();

/// A disc of 0.3 m, 1 m/s and 0.5 m/s^2 with one ray per degree from -180 degrees on.
RobotStart robotWithScan() {
  RobotStart robot = robots::robot({0.0, 0.0});
  robot.limits.max_acceleration = 0.5;
  robot.scan.rays = 360;
  return robot;
}

/// Nothing in range.
std::vector<float> openScan() { return std::vector<float>(360, NOTHING); }

std::size_t rayAt(int degrees) { return static_cast<std::size_t>(degrees + 180); }

TEST(ReactiveRule, DrivesToTheGoalInTheOpen) {
  const Twist ahead = reactiveCommand(robotWithScan(), {5.0, 0.0}, openScan());
  EXPECT_EQ(ahead.linear, Vector2(1.0, 0.0));
  EXPECT_EQ(ahead.rotation, 0.0);
  const Twist aside = reactiveCommand(robotWithScan(), {0.0, 5.0}, openScan());
  EXPECT_EQ(aside.linear.x(), 0.0);  // it turns first
  EXPECT_NEAR(aside.rotation, PI, 1e-12);
  EXPECT_NEAR(reactiveCommand(robotWithScan(), {0.4, 0.0}, openScan()).linear.x(), 0.4, 1e-12);
}

TEST(ReactiveRule, StopsWithinTheFreeLength) {
  // A wall at 0.6 m all round: with the margin of 0.1 m, 0.2 m are free in every direction. sqrt(2 * 0.5 * 0.2) m/s.
  const Twist slow = reactiveCommand(robotWithScan(), {5.0, 0.0}, std::vector<float>(360, 0.6F));
  EXPECT_NEAR(slow.linear.x(), std::sqrt(0.2), 1e-6);
  EXPECT_EQ(slow.rotation, 0.0);
  // With a post ahead alone, it turns: beyond asin(0.4 / 0.6) = 41.8 degrees, at 45, nothing is in the way.
  std::vector<float> ranges = openScan();
  ranges[rayAt(0)] = 0.6F;
  const Twist turning = reactiveCommand(robotWithScan(), {5.0, 0.0}, ranges);
  EXPECT_NEAR(std::abs(turning.rotation), 2.0 * toRadians(45.0), 1e-9);
  EXPECT_EQ(turning.linear.x(), 0.0);
}

TEST(ReactiveRule, PassesBesideSomebody) {
  // Somebody of 0.25 m stands 1 m ahead: rays within 14 degrees meet him.
  std::vector<float> ranges = openScan();
  for (int degrees = -14; degrees <= 14; ++degrees) {
    const double bearing = toRadians(degrees);
    ranges[rayAt(degrees)] = static_cast<float>(std::cos(bearing) - std::sqrt(0.0625 - std::pow(std::sin(bearing), 2)));
  }
  const Twist twist = reactiveCommand(robotWithScan(), {5.0, 0.0}, ranges);
  // The disc of 0.4 m passes beside the point at 14 degrees and 0.97 m if it turns by 24 degrees beyond it, and beside
  // the nearer ones at 41 degrees from the axis at most.
  EXPECT_GT(std::abs(twist.rotation), 2.0 * toRadians(30.0));
  EXPECT_LT(std::abs(twist.rotation), 2.0 * toRadians(50.0));
}

TEST(ReactiveRule, UnderstandsInvalidRanges) {
  std::vector<float> ranges = openScan();
  ranges[rayAt(0)] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(reactiveCommand(robotWithScan(), {5.0, 0.0}, ranges).linear.x(), 1.0);
  for (float& range : ranges) range = -NOTHING;  // below the least range everywhere
  EXPECT_EQ(reactiveCommand(robotWithScan(), {5.0, 0.0}, ranges).linear.norm(), 0.0);
}

TEST(ReactiveRule, AHolonomicRobotDrivesSideways) {
  RobotStart robot = robotWithScan();
  robot.drive = Drive::HOLONOMIC;
  const Twist twist = reactiveCommand(robot, {0.0, 5.0}, openScan());
  EXPECT_NEAR(twist.linear.y(), 1.0, 1e-12);
  EXPECT_EQ(twist.rotation, 0.0);
}

}  // namespace
}  // namespace crowd::reactive_rule_test
