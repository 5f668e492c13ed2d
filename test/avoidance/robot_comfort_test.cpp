// The distance that people keep from robots.

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/separation_rule.h"
#include "avoidance/time_to_collision.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd::robot_comfort_test {
namespace {

/// An agent of 0.25 m and a robot of 0.3 m that stands at a place, in the agent's frame.
PerceptionsBuilder seen(const Vector2& robot, double comfort, const Vector2& wanted = Vector2::Zero()) {
  PerceptionsBuilder scene;
  scene.agent(0, {9.0, 0.0}).speed(1.0);
  return scene.neighbour(robot, 0.3).robot(comfort, wanted);
}

/// The time to collision with static bodies at a velocity [s].
double timeOf(const PerceptionsBuilder& scene, const Vector2& velocity) {
  CandidateVelocities candidates;
  candidates.count = 1;
  candidates.xs.fill(static_cast<float>(velocity.x()));
  candidates.ys.fill(static_cast<float>(velocity.y()));
  candidates.clear();
  accumulateTimeToCollision(scene.perception(), {1.0, 0.0}, 0.0, candidates);
  return candidates.any_static ? 1.0 / static_cast<double>(candidates.static_bodies[0]) : NEVER;
}

const Vector2 AHEAD(1.0, 0.0);
const Vector2 BESIDE(2.0, 0.7);  // it passes this robot at 0.15 m

TEST(RobotComfort, PeoplePassARobotAtThisDistance) {
  EXPECT_GT(timeOf(seen(BESIDE, 0.0), AHEAD), 1e8);
  EXPECT_GT(timeOf(seen(BESIDE, 0.14), AHEAD), 1e8);
  // The sum of the radii is 0.85 m.
  EXPECT_NEAR(timeOf(seen(BESIDE, 0.3), AHEAD), 2.0 - std::sqrt(0.85 * 0.85 - 0.7 * 0.7), 1e-5);
  EXPECT_NEAR(timeOf(seen({2.0, 0.0}, 0.3), AHEAD), 2.0 - 0.85, 1e-5);
}

TEST(RobotComfort, OnlyWhereThereIsRoomBehindThem) {
  // The wall behind is 0.1 m away, of which they use 0.08 m; 0.63 m are not touched, 0.64 m with 0.1125 m are.
  const Vector2 aside(2.0, 0.635);
  EXPECT_GT(timeOf(seen(aside, 0.3).wall({-0.35, -2.0}, {-0.35, 2.0}), AHEAD), 1e8);
  EXPECT_LT(timeOf(seen(aside, 0.3).wall({-0.3625, -2.0}, {-0.3625, 2.0}), AHEAD), 2.0);
  // A wall at their side does not count; one on the far side of a robot beside them does.
  EXPECT_LT(timeOf(seen(aside, 0.3).wall({-2.0, -0.3}, {2.0, -0.3}), AHEAD), 2.0);
  EXPECT_GT(timeOf(seen({0.1, 0.635}, 0.3).wall({-2.0, -0.3}, {2.0, -0.3}), AHEAD), 1e8);
  // So does an obstacle, but not a person, who can step back.
  const auto time_before = [&](NeighbourKind kind) {
    PerceptionsBuilder scene;
    scene.agent(0, {9.0, 0.0}).speed(1.0).neighbour({-0.6, 0.0}, 0.25).kind(kind);
    return timeOf(scene.neighbour(aside, 0.3).robot(0.3), AHEAD);
  };
  EXPECT_LT(time_before(NeighbourKind::AGENT), 2.0);
  EXPECT_GT(time_before(NeighbourKind::OBSTACLE), 1e8);
}

/// The admissible part of a move of an agent of 1 m/s that faces a robot at this gap, at an angle [degrees].
double admissible(double gap, double angle, double comfort, const MotionLimits& motion = {}) {
  PerceptionsBuilder scene = seen({0.55 + gap, 0.0}, comfort);
  scene.motion(motion);
  const auto moves = cut(SeparationRule(GapSharing::HALF, 0.0), scene.perception(), {{polar(angle, 1.0), 1.0, 1.0}});
  return moves[0].fraction;
}

TEST(RobotComfort, MovesSlowDownWithinIt) {
  // A tick at full speed leads 0.1 m ahead.
  EXPECT_NEAR(admissible(0.45, 0.0, 0.3), 1.0, 1e-9);
  EXPECT_NEAR(admissible(0.35, 0.0, 0.3), 0.5 + 0.3, 1e-9);  // 0.05 m, and 0.3 m/s
  EXPECT_NEAR(admissible(0.3, 0.0, 0.3), 0.3, 1e-9);
  EXPECT_NEAR(admissible(0.24, 0.0, 0.3), 0.15, 1e-9);  // half of the way to 0.6 of it, 0.18 m
  EXPECT_NEAR(admissible(0.185, 0.0, 0.3), 0.0125, 1e-9);
  EXPECT_EQ(admissible(0.17, 0.0, 0.3), 0.0);
  EXPECT_EQ(admissible(0.17, 90.0, 0.3), 1.0);  // round it, and away
  EXPECT_EQ(admissible(0.17, 180.0, 0.3), 1.0);
  EXPECT_NEAR(admissible(0.3, 60.0, 0.3), 0.6, 1e-9);
  EXPECT_NEAR(admissible(0.05, 0.0, 0.0), 0.5, 1e-7);  // the separation rule alone
}

TEST(RobotComfort, AgentsWithMassBrakeInTime) {
  MotionLimits motion;
  motion.acceleration = 3.0;
  motion.braking = 2.0;
  // 0.05 m are left until the comfort: 0.1 v + v^2 / 4 = 0.05 gives 0.290 m/s, besides 0.3 m/s.
  EXPECT_NEAR(admissible(0.35, 0.0, 0.3, motion), std::sqrt(0.04 + 0.2) - 0.2 + 0.3, 1e-9);
}

TEST(RobotComfort, ARobotThatWaitsIsExpectedToGoOn) {
  // It is 2 m away, and will come at 0.3 m/s.
  EXPECT_NEAR(timeOf(seen({2.0, 0.0}, 0.3, {-0.3, 0.0}), {0.0, 0.0}), (2.0 - 0.85) / 0.3, 1e-5);
  EXPECT_GT(timeOf(seen({2.0, 0.0}, 0.0, {-0.3, 0.0}), {0.0, 0.0}), 1e8);
  // Within its comfort they do not stay in its way, and may walk away from it.
  EXPECT_LT(timeOf(seen({0.7, 0.0}, 0.3, {-0.3, 0.0}), {0.0, 0.0}), 1e-5);
  EXPECT_GT(timeOf(seen({0.7, 0.0}, 0.3, {-0.3, 0.0}), {-1.0, 0.0}), 1e8);
}

}  // namespace
}  // namespace crowd::robot_comfort_test
