#include "geometry/motion_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/error_of.h"
#include "support/perceptions.h"
#include "support/scenes.h"

namespace crowd::motion_limits_test {
namespace {

constexpr double TICK = 0.1;  // [s]

/// Per tick, an agent speeds up or swerves by 0.2 m/s, and slows down by 0.3 m/s.
constexpr MotionLimits LIMITS{2.0, 3.0, INFINITE};

/// Turns by an angle per tick [degrees]; any change of speed up to 10 m/s is possible.
MotionLimits turning(double degrees) { return {100.0, 100.0, toRadians(degrees) / TICK}; }

void expectVector(const Vector2& v, double x, double y) {
  EXPECT_NEAR(v.x(), x, 1e-12);
  EXPECT_NEAR(v.y(), y, 1e-12);
}

TEST(MotionLimits, AreOffByDefault) {
  const MotionLimits unlimited;
  EXPECT_FALSE(unlimited.areOn());
  EXPECT_TRUE(LIMITS.areOn());
  EXPECT_EQ(unlimited.stoppingWay({1.5, 0.0}), Vector2(0.0, 0.0));
  EXPECT_EQ(unlimited.reach(1.5, TICK), 1.5 * TICK);
  EXPECT_EQ(unlimited.braked({1.5, 1.0}, TICK), Vector2(0.0, 0.0));
  EXPECT_EQ(unlimited.reachable({1.5, 0.0}, {-2.0, 1.0}, TICK), Vector2(-2.0, 1.0));
}

TEST(MotionLimits, StoppingWayByHand) {
  expectVector(LIMITS.stoppingWay({1.5, 0.0}), 0.375, 0.0);  // 1.5^2 / 6
  expectVector(LIMITS.stoppingWay({0.0, -3.0}), 0.0, -1.5);
  expectVector(LIMITS.stoppingWay({1.8, 2.4}), 0.9, 1.2);  // 1.5 m at 3 m/s
  EXPECT_EQ(LIMITS.stoppingWay({0.0, 0.0}), Vector2(0.0, 0.0));
  EXPECT_NEAR(LIMITS.reach(1.5, TICK), 0.525, 1e-12);
}

TEST(MotionLimits, BrakesStraightOn) {
  expectVector(LIMITS.braked({1.3, 0.0}, TICK), 1.0, 0.0);
  expectVector(LIMITS.braked({-0.36, 0.48}, TICK), -0.18, 0.24);  // 0.6 -> 0.3 m/s
  EXPECT_EQ(LIMITS.braked({0.2, 0.0}, TICK), Vector2(0.0, 0.0));
  EXPECT_EQ(LIMITS.braked({0.0, 0.0}, TICK), Vector2(0.0, 0.0));
}

TEST(MotionLimits, TheWayOfABrakingAgentIsWithinTheStoppingWay) {
  Vector2 velocity(1.3, 0.0);
  const double bound = LIMITS.stoppingWay(velocity).x();  // 0.2817 m
  double way = 0.0;
  for (int tick = 0; tick < 5; ++tick) {
    velocity = LIMITS.braked(velocity, TICK);
    way += TICK * velocity.x();
    EXPECT_LE(way + LIMITS.stoppingWay(velocity).x(), bound);
  }
  EXPECT_NEAR(way, 0.1 * (1.0 + 0.7 + 0.4 + 0.1), 1e-12);
}

TEST(Reachable, SpeedsUpFromRestInAnyDirection) {
  const Vector2 rest(0.0, 0.0);
  expectVector(LIMITS.reachable(rest, {1.3, 0.0}, TICK), 0.2, 0.0);
  expectVector(LIMITS.reachable(rest, {-1.3, 0.0}, TICK), -0.2, 0.0);
  expectVector(LIMITS.reachable(rest, {0.6, -0.8}, TICK), 0.12, -0.16);
}

TEST(Reachable, SpeedsUpAndBrakesStraightAhead) {
  expectVector(LIMITS.reachable({1.0, 0.0}, {1.3, 0.0}, TICK), 1.2, 0.0);
  expectVector(LIMITS.reachable({1.3, 0.0}, {0.0, 0.0}, TICK), 1.0, 0.0);
  expectVector(LIMITS.reachable({1.3, 0.0}, {-1.3, 0.0}, TICK), 1.0, 0.0);
  expectVector(LIMITS.reachable({0.0, 1.0}, {0.0, 0.0}, TICK), 0.0, 0.7);  // whatever its direction
}

TEST(Reachable, Swerves) {
  expectVector(LIMITS.reachable({1.0, 0.0}, {1.0, 1.0}, TICK), 1.0, 0.2);
  expectVector(LIMITS.reachable({1.0, 0.0}, {1.0, -1.0}, TICK), 1.0, -0.2);
  // A change by 0.6 and 0.8 is 3 and 4 times the possible one: a fifth of it.
  expectVector(LIMITS.reachable({1.0, 0.0}, {1.6, 0.8}, TICK), 1.12, 0.16);
  // A change by -0.9 and 0.8 is, too.
  expectVector(LIMITS.reachable({1.0, 0.0}, {0.1, 0.8}, TICK), 0.82, 0.16);
}

TEST(Reachable, AWantedVelocityInReachIsReturnedExactly) {
  for (const Vector2& wanted : {Vector2(1.13, 0.12), Vector2(0.81, -0.11), Vector2(1.0, 0.0), Vector2(0.71, 0.0)}) {
    EXPECT_EQ(LIMITS.reachable({1.0, 0.0}, wanted, TICK), wanted);
  }
  EXPECT_EQ(LIMITS.reachable({0.2, 0.0}, {0.0, 0.0}, TICK), Vector2(0.0, 0.0));
}

TEST(TurnRate, BoundsTheAngleToTheHeading) {
  const double tangent = std::tan(toRadians(10.0));
  expectVector(turning(10.0).reachable({1.0, 0.0}, {1.0, 1.0}, TICK), 1.0, tangent);
  expectVector(turning(10.0).reachable({1.0, 0.0}, {1.0, -1.0}, TICK), 1.0, -tangent);
  // The line from (1, 0) to (-1, 1), 1 - 2 s and s, leaves the angle where s = tangent (1 - 2 s).
  const double share = tangent / (1.0 + 2.0 * tangent);
  expectVector(turning(10.0).reachable({1.0, 0.0}, {-1.0, 1.0}, TICK), 1.0 - 2.0 * share, share);
  EXPECT_EQ(turning(10.0).reachable({1.0, 0.0}, {1.2, 0.2}, TICK), Vector2(1.2, 0.2));  // 9.5 degrees
}

TEST(TurnRate, AnAgentAtRestStaysUntilItFacesItsWay) {
  const Vector2 rest(0.0, 0.0);
  EXPECT_EQ(turning(10.0).reachable(rest, polar(11.0, 1.0), TICK), rest);
  EXPECT_EQ(turning(10.0).reachable(rest, polar(-90.0, 1.0), TICK), rest);
  EXPECT_EQ(turning(10.0).reachable(rest, {-1.0, 0.0}, TICK), rest);
  EXPECT_EQ(turning(10.0).reachable(rest, polar(-9.0, 1.0), TICK), polar(-9.0, 1.0));
}

TEST(TurnRate, StandsBeforeItTurnsByMoreThanARightAngle) {
  EXPECT_EQ(turning(120.0).reachable({1.0, 0.0}, polar(130.0, 1.0), TICK), Vector2(0.0, 0.0));
  EXPECT_EQ(turning(120.0).reachable({1.0, 0.0}, polar(110.0, 1.0), TICK), polar(110.0, 1.0));
  EXPECT_EQ(turning(180.0).reachable({1.0, 0.0}, {-1.0, 0.0}, TICK), Vector2(-1.0, 0.0));
}

/// The widest angle between the heading and the velocity of an agent that wants to turn back [rad].
double widestAngleOfTurningBack(const MotionLimits& limits) {
  double widest = 0.0;
  for (int i = 1; i <= 2500; ++i) {
    for (const double wanted : {0.5, 1.3, 2.5}) {
      const Vector2 reached = limits.reachable({0.001 * i, 0.0}, wanted * unitVector(PI), TICK);
      widest = std::max(widest, std::abs(bearingOf(reached)));
    }
  }
  return widest;
}

/// Its velocity is on the way to 0, where an angle is easily lost to rounding.
TEST(TurnRate, KeepsTheHeadingOfAnAgentThatTurnsBack) {
  EXPECT_LE(toDegrees(widestAngleOfTurningBack({2.0, 3.0, toRadians(100.0)})), 10.0 + 1e-6);
  EXPECT_LE(toDegrees(widestAngleOfTurningBack(turning(60.0))), 60.0 + 1e-6);
}

TEST(TurnRate, BoundsTheAngleOfAnAgentThatWasPushed) {
  const MotionLimits limits{2.0, 3.0, toRadians(100.0)};
  for (const Vector2& velocity : {Vector2(-0.5, 0.0), Vector2(0.0, -0.5), Vector2(0.1, 0.4)}) {
    for (const Vector2& wanted : {Vector2(1.0, 0.0), Vector2(1.0, 0.3), Vector2(0.0, 1.0), Vector2(-1.0, 0.0)}) {
      const Vector2 reached = limits.reachable(velocity, wanted, TICK);
      EXPECT_LE(toDegrees(std::abs(bearingOf(reached))), 10.0 + 1e-6)
          << "from " << velocity.transpose() << ", wanted " << wanted.transpose();
    }
  }
}

TEST(TurnRate, AnAgentAtRestThatWantsToStayStays) {
  const MotionLimits limits{2.0, 3.0, toRadians(100.0)};
  for (const double degrees : {0.0, 30.0, 120.0, 180.0, -120.0}) {
    const Vector2 wanted = 0.0 * unitVector(toRadians(degrees));  // components of 0 or -0
    EXPECT_EQ(limits.reachable({0.0, 0.0}, wanted, TICK), Vector2(0.0, 0.0)) << degrees;
  }
}

/// By how much a change of velocity exceeds what is possible in a tick: up to 1 if it does not.
double excessOf(const MotionLimits& limits, const Vector2& velocity, const Vector2& after) {
  const Vector2 ahead = velocity.norm() > 0.0 ? Vector2(velocity.normalized()) : Vector2::UnitX();
  const double along = ahead.dot(after - velocity);
  const double most = velocity.norm() > 0.0 && along < 0.0 ? limits.braking : limits.acceleration;
  return std::hypot(along / (most * TICK), cross(ahead, after - velocity) / (limits.acceleration * TICK));
}

/// Expects that a velocity can be had after a tick.
void expectReachable(const MotionLimits& limits, const Vector2& velocity, const Vector2& after) {
  EXPECT_LE(excessOf(limits, velocity, after), 1.0 + 1e-9) << after.transpose();
  if (after.norm() > 1e-12) {
    EXPECT_LE(std::abs(bearingOf(after)), limits.turn_rate * TICK + 1e-9) << after.transpose();
  }
}

/// Random limits; most of them do not bound the turning.
MotionLimits randomLimits(KeyedRandom& random) {
  MotionLimits limits{random.uniform(0.5, 8.0), random.uniform(0.5, 8.0), INFINITE};
  if (random.below(3) == 0) limits.turn_rate = toRadians(random.uniform(10.0, 1500.0));
  return limits;
}

TEST(Reachable, LiesOnTheLineAndWithinTheLimits) {
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const MotionLimits limits = randomLimits(random);
    const Vector2 velocity(random.uniform(0.0, 2.5), 0.0);
    const Vector2 wanted = scenes::randomPoint(random, 2.5);
    const Vector2 reached = limits.reachable(velocity, wanted, TICK);
    expectReachable(limits, velocity, reached);
    if (reached == Vector2::Zero() && limits.turn_rate * TICK > 0.5 * PI) continue;  // it stands before it turns
    const double detour = (reached - velocity).norm() + (wanted - reached).norm();
    EXPECT_NEAR(detour, (wanted - velocity).norm(), 1e-9);
  }
}

TEST(Reachable, IsNearestToTheWantedVelocity) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const MotionLimits limits{random.uniform(0.5, 8.0), random.uniform(0.5, 8.0), INFINITE};
    const Vector2 velocity = scenes::randomPoint(random, 2.0);
    const Vector2 wanted = scenes::randomPoint(random, 2.5);
    const Vector2 reached = limits.reachable(velocity, wanted, TICK);
    if (reached == wanted) continue;
    EXPECT_NEAR(excessOf(limits, velocity, reached), 1.0, 1e-9);
  }
}

TEST(Reachable, SoAreAllVelocitiesBetweenItAndBraking) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const MotionLimits limits = randomLimits(random);
    const Vector2 velocity(random.uniform(0.0, 2.5), 0.0);
    const Vector2 reached = limits.reachable(velocity, scenes::randomPoint(random, 2.5), TICK);
    const Vector2 braked = limits.braked(velocity, TICK);
    for (int i = 0; i <= 20; ++i) expectReachable(limits, velocity, braked + 0.05 * i * (reached - braked));
  }
}

TEST(MotionLimits, WidestPermitsWhatEitherPermits) {
  const MotionLimits widest = crowd::widest({2.0, 3.0, 1.0}, {1.0, 6.0, 0.5});
  EXPECT_EQ(widest, (MotionLimits{2.0, 6.0, 1.0}));
  EXPECT_EQ(crowd::widest(LIMITS, LIMITS), LIMITS);
  EXPECT_EQ(crowd::widest(LIMITS, MotionLimits()), MotionLimits());
}

MotionLimits read(const std::string& yaml) { return readMotionLimits(YAML::Load(yaml), {"file.yaml", 0, "motion"}); }

std::string errorOfReading(const std::string& yaml) {
  return errorOf<InputError>([&] { read(yaml); });
}

TEST(ReadMotionLimits, ReadsAMapOrAWord) {
  EXPECT_EQ(read("{acceleration: 2, braking: 3}"), LIMITS);
  EXPECT_EQ(read("unlimited"), MotionLimits());
  const MotionLimits turning = read("{acceleration: 1.5, braking: 6, turn_rate: 1.75}");
  EXPECT_EQ(turning.acceleration, 1.5);
  EXPECT_EQ(turning.braking, 6.0);
  EXPECT_EQ(turning.turn_rate, 1.75);
}

TEST(ReadMotionLimits, RefusesOthers) {
  EXPECT_EQ(errorOfReading("{acceleration: 2}"), "file.yaml: line 1: motion: the key 'braking' is missing");
  EXPECT_EQ(errorOfReading("{braking: 2, turn_rate: 1.75}"),
            "file.yaml: line 1: motion: the key 'acceleration' is missing");
  const auto says = [](const std::string& yaml, const std::string& part) {
    EXPECT_TRUE(contains(errorOfReading(yaml), part)) << yaml << ": " << errorOfReading(yaml);
  };
  says("{acceleration: 2, braking: -3}", "motion.braking: expected a number above 0, got '-3'");
  says("{acceleration: 0, braking: 3}", "motion.acceleration: expected a number above 0, got '0'");
  says("{acceleration: 2, braking: .inf}", "motion.braking: expected");
  says("{acceleration: 2, braking: 2e6}", "motion.braking: expected at most 1e+06 m/s^2, got '2e6'");
  says("{acceleration: 2, braking: 3, turn_rate: -1}", "motion.turn_rate: expected a number above 0, got '-1'");
  says("{acceleration: 2, braking: 3, turning: 90}", "motion: unknown key 'turning'");
  says("endless", "motion: expected a map with acceleration and braking, or unlimited, got 'endless'");
  says("3", "motion: expected a map with acceleration and braking, or unlimited, got '3'");
  says("[2, 3]", "motion: expected");
}

TEST(MotionLimitsText, IsReadBack) {
  EXPECT_EQ(toText(MotionLimits()), "unlimited");
  EXPECT_EQ(toText(LIMITS), "{acceleration: 2, braking: 3}");
  EXPECT_EQ(toText(MotionLimits{2.0, 3.0, 1.75}), "{acceleration: 2, braking: 3, turn_rate: 1.75}");
  EXPECT_EQ(read(toText(MotionLimits())), MotionLimits());
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const MotionLimits limits = randomLimits(random);
    EXPECT_EQ(read(toText(limits)), limits) << "seed " << seed << ": " << toText(limits);
  }
}

}  // namespace
}  // namespace crowd::motion_limits_test
