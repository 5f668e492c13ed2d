// The distance that people keep from robots.

#include <gtest/gtest.h>

#include <cmath>

#include "avoidance/time_to_collision.h"
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
  // So does a person, and another robot does not.
  PerceptionsBuilder person = seen(aside, 0.3);
  EXPECT_GT(timeOf(person.neighbour({-0.6, 0.0}, 0.25), AHEAD), 1e8);
  EXPECT_LT(timeOf(person.robot(0.0), AHEAD), 2.0);
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
