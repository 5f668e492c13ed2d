#include "avoidance/braking_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/separation_rule.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd::braking_rule_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]

/// Speeds up by up to 0.2 m/s in a tick, slows down by up to 0.3 m/s.
constexpr MotionLimits LIMITS{2.0, 3.0, INFINITE};

/// An agent of radius 0.25 m and of up to 1.2 m/s that walks ahead at a speed. At 0.6 m/s, the way of a tick and the
/// one until it stands afterwards are 0.06 m each.
PerceptionsBuilder walker(double speed) {
  return PerceptionsBuilder().motion(LIMITS).agent(0, {9.0, 0.0}).speed(1.2).walking({speed, 0.0});
}

/// The same with a wall ahead. @param gap between both [m]
PerceptionsBuilder beforeWall(double gap, double speed) {
  return walker(speed).wall({0.25 + gap, -1.0}, {0.25 + gap, 1.0});
}

/// The same with a body of radius 0.25 m ahead, of this speed towards the agent. @param gap between both [m]
PerceptionsBuilder facing(double gap, double speed, double other_speed = 0.0,
                          NeighbourKind kind = NeighbourKind::AGENT) {
  return walker(speed).neighbour({0.5 + gap, 0.0}, 0.25).kind(kind).velocity({speed, 0.0}, Vector2(-other_speed, 0.0));
}

PerceptionsBuilder beforeObstacle(double gap, double speed) { return facing(gap, speed, 0.0, NeighbourKind::OBSTACLE); }

/// The admissible fraction of a move at full speed.
double share(const PerceptionsBuilder& scene, GapSharing sharing = GapSharing::HALF,
             const Vector2& direction = Vector2::UnitX()) {
  return cut(SeparationRule(sharing, LOOKOUT), scene.perception(), {{direction, 1.0, 1.0}})[0].fraction;
}

/// The velocity of an action, agent frame [m/s].
Vector2 velocityOf(const RelativeAction& action, double max_speed) {
  return action.speed_fraction * max_speed * unitVector(action.rotation);
}

/// The velocity after a tick towards a wanted one at full speed, agent frame [m/s].
Vector2 towards(const PerceptionsBuilder& scene, const Vector2& direction = Vector2::UnitX(),
                GapSharing sharing = GapSharing::HALF) {
  const Perception seen = scene.perception();
  const BrakingLimits limits = limitsOf(seen, sharing);
  const RelativeAction action = BrakingRule(seen, limits).actionTowards({direction, 1.0, 1.0});
  return velocityOf(action, seen.self.max_speed);
}

void expectVector(const Vector2& v, double x, double y) {
  EXPECT_NEAR(v.x(), x, 1e-6);
  EXPECT_NEAR(v.y(), y, 1e-6);
}

TEST(BrakingRule, CutsToTheSpeedFromWhichItStopsBeforeTheGapEnds) {
  for (const double speed : {0.0, 0.3, 0.6}) {
    EXPECT_NEAR(share(beforeWall(0.12, speed)), 0.5, 1e-6) << speed;  // 0.6 m/s
    EXPECT_NEAR(share(beforeObstacle(0.12, speed)), 0.5, 1e-6) << speed;
  }
  EXPECT_NEAR(share(beforeWall(0.045, 0.3)), 0.25, 1e-6);  // 0.3 m/s: 0.03 m and 0.015 m
  EXPECT_EQ(share(beforeWall(0.361, 0.0)), 1.0);           // 1.2 m/s: 0.12 m and 0.24 m
  EXPECT_NEAR(share(beforeWall(0.36, 0.0)), 1.0, 1e-6);
  EXPECT_EQ(share(beforeWall(0.0, 0.0)), 0.0);
}

TEST(BrakingRule, HalfOfTheGapToAnAgentAtRest) {
  EXPECT_NEAR(share(facing(0.24, 0.0)), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.09, 0.0)), 0.25, 1e-6);
  EXPECT_NEAR(share(facing(0.5775, 0.0)), 0.875, 1e-6);  // 1.05 m/s: 0.105 m and 0.18375 m
  EXPECT_EQ(share(facing(0.0, 0.0)), 0.0);
  EXPECT_EQ(share(facing(0.001, 0.0), GapSharing::NONE), 1.0);
}

TEST(BrakingRule, SharesTheGapBetweenTheStoppingRegions) {
  // It stops after 0.06 m; 0.12 m are left, half of them are its own.
  EXPECT_NEAR(share(facing(0.18, 0.6)), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.24, 0.6, 0.6)), 0.5, 1e-6);
  // The other walks away and stops after 0.06 m: that is no gap yet.
  EXPECT_NEAR(share(facing(0.24, 0.0, -0.6)), 0.5, 1e-6);
}

TEST(BrakingRule, MovingSharesFollowTheLine) {
  // Both walk ahead at 0.6 m/s: the gap is 0.12 m between the own stop and the other; half of it, and 0.06 m more.
  // The way left is 0.06 + 0.06 + 0.06 m: v T + v^2 / 6 = 0.18.
  const double speed = -0.3 + std::sqrt(0.09 + 6.0 * 0.18);
  EXPECT_NEAR(share(facing(0.18, 0.6, -0.6), GapSharing::MOVING), speed / 1.2, 1e-6);
  EXPECT_NEAR(share(facing(0.18, 0.6, -0.6), GapSharing::HALF), 0.5, 1e-6);
  EXPECT_NEAR(share(facing(0.24, 0.6, 0.6), GapSharing::MOVING), 0.5, 1e-6);  // the mean velocity is 0
}

TEST(BrakingRule, LimitsTheComponentTowardsTheWall) {
  const Vector2 aside = unitVector(toRadians(60.0));
  EXPECT_NEAR(share(beforeWall(0.06, 0.0), GapSharing::HALF, aside), 0.5, 1e-6);  // half of 0.12 m
  EXPECT_EQ(share(beforeWall(0.0, 0.0), GapSharing::HALF, Vector2::UnitY()), 1.0);
  EXPECT_EQ(share(beforeWall(0.0, 0.0), GapSharing::HALF, -Vector2::UnitX()), 1.0);
}

TEST(BrakingRule, ActionsKeepTheLimits) {
  expectVector(towards(walker(0.0)), 0.2, 0.0);
  expectVector(towards(walker(0.6)), 0.8, 0.0);
  expectVector(towards(walker(1.1)), 1.2, 0.0);
  expectVector(towards(walker(0.6), -Vector2::UnitX()), 0.3, 0.0);
  expectVector(towards(walker(0.6), -Vector2::UnitX(), GapSharing::NONE), 0.3, 0.0);
  expectVector(towards(walker(0.3), -Vector2::UnitX()), 0.0, 0.0);
}

TEST(BrakingRule, TakesTheFallbackIfThePreferredMoveIsNotFree) {
  const CandidateMove ahead{Vector2::UnitX(), 1.0, 1.0};
  const CandidateMove left{Vector2::UnitY(), 1.0, 1.0};
  const auto velocity = [&](const PerceptionsBuilder& scene, const CandidateMove& preferred,
                            const CandidateMove& fallback) {
    const Perception seen = scene.perception();
    const BrakingLimits limits = limitsOf(seen, GapSharing::HALF);
    return velocityOf(BrakingRule(seen, limits).actionTowards(preferred, fallback), 1.2);
  };
  expectVector(velocity(walker(0.0), ahead, left), 0.2, 0.0);
  expectVector(velocity(beforeWall(0.0, 0.0), ahead, left), 0.0, 0.2);
  expectVector(velocity(beforeWall(0.0, 0.0), left, ahead), 0.0, 0.2);
}

TEST(BrakingRule, StayingBrakesAndKeepsTheHeading) {
  const auto stay = [](const PerceptionsBuilder& scene) {
    const Perception seen = scene.perception();
    const BrakingLimits limits = limitsOf(seen, GapSharing::HALF);
    return BrakingRule(seen, limits).actionTowards({Vector2::UnitY(), 0.0, 0.0});
  };
  expectVector(velocityOf(stay(walker(0.6)), 1.2), 0.3, 0.0);
  EXPECT_EQ(stay(walker(0.6)).rotation, 0.0);
  EXPECT_EQ(stay(walker(0.2)).speed_fraction, 0.0);
  EXPECT_EQ(stay(walker(0.2)).rotation, 0.0);
}

TEST(BrakingRule, BrakesAsHardAsItCanWhereOnlyTheStoppingWayIsLeft) {
  // The stopping way is 0.24 m at 1.2 m/s, 0.375 m at 1.5 m/s.
  expectVector(towards(beforeWall(0.24, 1.2)), 0.9, 0.0);
  expectVector(towards(beforeWall(0.375, 1.5).speed(1.5)), 1.2, 0.0);
  expectVector(towards(beforeObstacle(0.24, 1.2)), 0.9, 0.0);
  expectVector(towards(facing(0.24, 1.2)), 0.9, 0.0);
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    expectVector(towards(facing(0.48, 1.2, 1.2), Vector2::UnitX(), sharing), 0.9, 0.0);
    expectVector(towards(facing(0.24 + 0.06, 1.2, 0.6), Vector2::UnitX(), sharing), 0.9, 0.0);
  }
  EXPECT_EQ(towards(beforeWall(0.015, 0.3)), Vector2(0.0, 0.0));
}

TEST(BrakingRule, ActionsGoOnAsFarAsTheGapAllows) {
  // 0.36 m at 1.2 m/s; 0.3234 m at three quarters of the way from the braked speed, 0.9 m/s, to that.
  expectVector(towards(beforeWall(0.3601, 1.2)), 1.2, 0.0);
  expectVector(towards(beforeWall(0.3599, 1.2)), 1.125, 0.0);
  expectVector(towards(beforeWall(0.3235, 1.2)), 1.125, 0.0);  // 0.1125 m and 0.2109 m
  expectVector(towards(beforeWall(0.3233, 1.2)), 1.05, 0.0);
  expectVector(towards(beforeWall(0.25, 1.2)), 0.9, 0.0);  // 0.2559 m at 0.975 m/s
}

/// A fast agent that somebody was placed in front of, so that it cannot stop in time.
TEST(BrakingRule, StopsFasterThanItCanBeforeSomebodyWhoAppears) {
  expectVector(towards(facing(0.1, 1.2)), 0.5, 0.0);       // half of the gap in a tick
  expectVector(towards(facing(0.1, 1.2, 1.2)), 0.5, 0.0);  // so does the other
  expectVector(towards(beforeWall(0.05, 1.2)), 0.5, 0.0);  // the whole gap
  expectVector(towards(beforeObstacle(0.05, 1.2)), 0.5, 0.0);
  EXPECT_LT(towards(facing(0.0, 1.2)).x(), 1e-6);
  EXPECT_NEAR(share(facing(0.1, 1.2)), 0.5 / 1.2, 1e-6);
}

TEST(BrakingRule, StopsInTimeAfterItsMaximumSpeedFell) {
  // It still walks at 1.2 m/s, but may only walk at 0.3: 0.03 m in the tick. 0.05 m are beyond its reach, 0.01 m not.
  const auto speed_before = [](double gap) { return towards(beforeWall(gap, 1.2).speed(0.3)).norm(); };
  EXPECT_NEAR(speed_before(0.05), 0.3, 1e-9);
  EXPECT_LE(speed_before(0.01), 0.1);
}

}  // namespace
}  // namespace crowd::braking_rule_test
