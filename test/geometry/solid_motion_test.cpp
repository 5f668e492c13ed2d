#include "geometry/solid_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::solid_motion_test {
namespace {

using Disc = SolidMotion::Disc;
using Outcome = SolidMotion::Outcome;

constexpr double RADIUS = 0.25;  // [m]

Disc walker(const Vector2& position, const Vector2& way) { return {position, way, RADIUS, true}; }
Disc stander(const Vector2& position) { return {position, Vector2::Zero(), RADIUS, true}; }
Disc obstacle(const Vector2& position, const Vector2& way, double radius) { return {position, way, radius, false}; }

std::vector<Outcome> move(const std::vector<Disc>& discs, const std::vector<Segment>& walls = {}) {
  SolidMotion motion;
  return motion.move(discs, WallIndex(walls));
}

void expectAt(const Outcome& outcome, double x, double y) {
  EXPECT_NEAR(outcome.position.x(), x, 1e-12);
  EXPECT_NEAR(outcome.position.y(), y, 1e-12);
}

/// The end of its motion, whether it touched anything, and whether it was blocked.
void expectOutcome(const Outcome& outcome, double x, double y, bool touched, bool diverted) {
  expectAt(outcome, x, y);
  EXPECT_EQ(outcome.touched, touched);
  EXPECT_EQ(outcome.diverted, diverted);
}

TEST(SolidMotion, FreeBodiesMoveAsWanted) {
  const auto outcomes = move({walker({0.0, 0.0}, {0.3, 0.4}), walker({0.0, 3.0}, {0.0, -0.1})});
  expectOutcome(outcomes[0], 0.3, 0.4, false, false);
  expectOutcome(outcomes[1], 0.0, 2.9, false, false);
  EXPECT_TRUE(move({}).empty());
}

TEST(SolidMotion, BothAgentsStopInAHeadOnContact) {
  // 0.5 m of gap, closing by 1 + 0.6 m a tick: after 0.3125 of the tick.
  const auto outcomes = move({walker({0.0, 0.0}, {1.0, 0.0}), walker({1.0, 0.0}, {-0.6, 0.0})});
  expectOutcome(outcomes[0], 0.3125, 0.0, true, true);
  expectOutcome(outcomes[1], 0.8125, 0.0, true, true);
}

TEST(SolidMotion, AStandingAgentIsTouchedAndStays) {
  const auto outcomes = move({stander({1.0, 0.3}), walker({0.0, 0.0}, {1.0, 0.0})});
  expectOutcome(outcomes[0], 1.0, 0.3, true, false);
  expectOutcome(outcomes[1], 0.6, 0.0, true,
                true);  // 0.4 m and 0.3 m from the other's centre: the radii's sum is 0.5 m
}

TEST(SolidMotion, AnAgentTouchedFromBehindContinues) {
  // 0.5 m of gap, closing by 0.8 m a tick: after 0.625 of the tick.
  const auto outcomes = move({walker({0.0, 0.0}, {1.0, 0.0}), walker({1.0, 0.0}, {0.2, 0.0})});
  expectOutcome(outcomes[0], 0.625, 0.0, true, true);
  expectOutcome(outcomes[1], 1.2, 0.0, true, false);
}

TEST(SolidMotion, WallsStopAgents) {
  const std::vector<Segment> walls = {{{1.0, -5.0}, {1.0, 5.0}}};
  expectOutcome(move({walker({0.0, 0.0}, {2.0, 1.0})}, walls)[0], 0.75, 0.375, true, true);
  expectOutcome(move({walker({0.0, 0.0}, {0.75, 1.0})}, walls)[0], 0.75, 1.0, false, false);  // just up to it
  expectOutcome(move({walker({0.75, 0.0}, {0.0, 3.0})}, walls)[0], 0.75, 3.0, false, false);  // along it
  expectOutcome(move({walker({0.75, 0.0}, {0.1, 3.0})}, walls)[0], 0.75, 0.0, true, true);
  expectOutcome(move({walker({0.75, 0.0}, {-1.0, 3.0})}, walls)[0], -0.25, 3.0, false, false);
}

TEST(SolidMotion, FastBodiesDoNotPassThroughWallsOrEachOther) {
  expectAt(move({walker({0.0, 0.0}, {100.0, 0.0})}, {{{50.0, -1.0}, {50.0, 1.0}}})[0], 49.75, 0.0);
  const auto outcomes = move({walker({0.0, 0.0}, {100.0, 0.0}), walker({50.5, 0.0}, {-100.0, 0.0})});
  expectAt(outcomes[0], 25.0, 0.0);
  expectAt(outcomes[1], 25.5, 0.0);
}

TEST(SolidMotion, AnAgentCanTouchAnotherThatStoppedEarlierInTheTick) {
  // The middle agent stops at the standing one after 0.25 of the tick; the fast agent reaches it there after 0.5.
  const auto outcomes = move({walker({-1.25, 0.0}, {2.0, 0.0}), walker({0.0, 0.0}, {1.0, 0.0}), stander({0.75, 0.0})});
  expectOutcome(outcomes[0], -0.25, 0.0, true, true);
  expectOutcome(outcomes[1], 0.25, 0.0, true, true);
  expectOutcome(outcomes[2], 0.75, 0.0, true, false);
}

TEST(SolidMotion, AnAgentContinuesIfTheOtherStopsBeforeTheContact) {
  // Without the wall, the first agent would touch the second.
  const std::vector<Segment> walls = {{{1.0, -0.2}, {1.0, 0.2}}};
  const auto outcomes = move({walker({0.0, 0.0}, {2.0, 0.0}), walker({1.5, 2.0}, {0.0, -4.0})}, walls);
  expectOutcome(outcomes[0], 0.75, 0.0, true, true);
  expectOutcome(outcomes[1], 1.5, -2.0, false, false);
}

TEST(SolidMotion, FourAgentsStopAtASimultaneousContact) {
  // Neighbours are sqrt(2) * (1 - t) apart: they touch when each agent is 0.5 / sqrt(2) m from the middle.
  const double left = 0.5 / std::sqrt(2.0);
  const auto outcomes = move({walker({1.0, 0.0}, {-1.0, 0.0}), walker({0.0, 1.0}, {0.0, -1.0}),
                              walker({-1.0, 0.0}, {1.0, 0.0}), walker({0.0, -1.0}, {0.0, 1.0})});
  expectOutcome(outcomes[0], left, 0.0, true, true);
  expectOutcome(outcomes[1], 0.0, left, true, true);
  expectOutcome(outcomes[2], -left, 0.0, true, true);
  expectOutcome(outcomes[3], 0.0, -left, true, true);
}

TEST(SolidMotion, TouchingAgentsInLineStopTogether) {
  const auto outcomes =
      move({walker({0.0, 0.0}, {1.0, 0.0}), walker({0.5, 0.0}, {1.0, 0.0}), walker({1.0, 0.0}, {1.0, 0.0})},
           {{{1.75, -1.0}, {1.75, 1.0}}});
  expectOutcome(outcomes[0], 0.5, 0.0, true, true);
  expectOutcome(outcomes[1], 1.0, 0.0, true, true);
  expectOutcome(outcomes[2], 1.5, 0.0, true, true);
}

TEST(SolidMotion, ParallelMotionIsNoContact) {
  const auto outcomes = move({walker({0.0, 0.0}, {1.0, 0.0}), walker({0.0, 0.5}, {1.0, 0.0}), stander({0.5, -0.5})});
  expectOutcome(outcomes[0], 1.0, 0.0, false, false);
  expectOutcome(outcomes[1], 1.0, 0.5, false, false);
  expectOutcome(outcomes[2], 0.5, -0.5, false, false);
}

TEST(SolidMotion, OverlappingBodiesMayOnlySeparate) {
  expectOutcome(move({walker({0.0, 0.0}, {1.0, 0.0}), stander({0.3, 0.0})})[0], 0.0, 0.0, true, true);
  expectOutcome(move({walker({0.0, 0.0}, {-1.0, 0.0}), stander({0.3, 0.0})})[0], -1.0, 0.0, false, false);
}

TEST(SolidObstacle, StopsAnAgentThatWalksIntoIt) {
  const auto outcomes = move({walker({0.0, 0.0}, {2.0, 0.0}), obstacle({2.0, 0.0}, {0.0, 0.0}, 0.75)});
  expectOutcome(outcomes[0], 1.0, 0.0, true, true);
  expectOutcome(outcomes[1], 2.0, 0.0, false, false);
}

TEST(SolidObstacle, StopsAnAgentThatCatchesUpWithIt) {
  const auto outcomes = move({walker({0.0, 0.0}, {1.0, 0.0}), obstacle({1.0, 0.0}, {0.2, 0.0}, 0.25)});
  expectOutcome(outcomes[0], 0.625, 0.0, true, true);
  expectOutcome(outcomes[1], 1.2, 0.0, false, false);
}

TEST(SolidObstacle, PushesAnAgentThatItRunsInto) {
  // 0.75 m of gap at 1 m a tick: it pushes for the last quarter.
  const auto outcomes = move({stander({0.5, 0.0}), obstacle({-1.0, 0.0}, {1.0, 0.0}, 0.5)});
  expectOutcome(outcomes[0], 0.75, 0.0, true, true);
  expectOutcome(outcomes[1], 0.0, 0.0, false, false);
  // An agent that walks towards it is pushed back: contact after half of the tick.
  expectOutcome(move({walker({0.5, 0.0}, {-0.5, 0.0}), obstacle({-1.0, 0.0}, {1.0, 0.0}, 0.5)})[0], 0.75, 0.0, true,
                true);
}

TEST(SolidObstacle, PushesAwayFromItsCentre) {
  // They touch along (0.8, 0.6); the velocity (1, 0) has the component 0.8 in this direction.
  const auto outcomes = move({stander({0.8, 0.6}), obstacle({0.0, 0.0}, {1.0, 0.0}, 0.75)});
  expectOutcome(outcomes[0], 0.8 + 0.64, 0.6 + 0.48, true, true);
}

TEST(SolidObstacle, PassesOverAnAgentPushedAgainstAWall) {
  // It touches the agent after 0.25 of the tick, pushes it to the wall until 0.5, and then passes over it.
  const std::vector<Segment> walls = {{{0.5, -1.0}, {0.5, 1.0}}};
  const auto outcomes = move({stander({0.0, 0.0}), obstacle({-1.0, 0.0}, {1.0, 0.0}, 0.5)}, walls);
  expectOutcome(outcomes[0], 0.25, 0.0, true, true);
  expectOutcome(outcomes[1], 0.0, 0.0, false, false);
  // The agent may then leave the obstacle, but not move deeper into it.
  const Disc parked = obstacle({0.1, 0.0}, {0.0, 0.0}, 0.5);
  expectAt(move({walker({0.25, 0.0}, {0.0, 1.0}), parked}, walls)[0], 0.25, 1.0);
  expectAt(move({walker({0.25, 0.0}, {-0.1, 0.0}), parked}, walls)[0], 0.25, 0.0);
}

TEST(SolidObstacle, PassesOverAnAgentPushedAgainstAnotherAgent) {
  const auto outcomes = move({stander({0.0, 0.0}), stander({0.75, 0.0}), obstacle({-1.0, 0.0}, {1.0, 0.0}, 0.5)});
  expectOutcome(outcomes[0], 0.25, 0.0, true, true);
  expectOutcome(outcomes[1], 0.75, 0.0, true, false);
}

TEST(SolidObstacle, AnAgentBetweenTwoObstaclesStays) {
  const auto outcomes =
      move({stander({0.0, 0.0}), obstacle({-1.0, 0.0}, {1.0, 0.0}, 0.5), obstacle({1.0, 0.0}, {-1.0, 0.0}, 0.5)});
  expectOutcome(outcomes[0], 0.0, 0.0, true, true);
}

TEST(SolidObstacle, PushesAnAgentThatStoppedEarlierInTheTick) {
  // It walks 0.25 m up to the stander, stops at 0.25 of the tick, and is pushed sideways from 0.5 on.
  const auto outcomes =
      move({walker({0.0, 0.0}, {1.0, 0.0}), stander({0.75, 0.0}), obstacle({0.25, -2.0}, {0.0, 3.0}, 0.25)});
  expectOutcome(outcomes[0], 0.25, 1.5, true, true);
  expectOutcome(outcomes[1], 0.75, 0.0, true, false);  // the obstacle passes without contact
}

}  // namespace
}  // namespace crowd::solid_motion_test
