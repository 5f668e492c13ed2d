#include "avoidance/separation_rule.h"

#include <gtest/gtest.h>

#include "support/error_of.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd::separation_rule_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]

/// The admissible fraction of a move straight ahead at full speed.
double shareAhead(GapSharing sharing, const PerceptionsBuilder& scene) {
  return cut(SeparationRule(sharing, LOOKOUT), scene.perception(), {{Vector2::UnitX(), 1.0, 1.0}})[0].fraction;
}

/// An agent of radius 0.25 m that walks at 0.3 m/s, 0.03 m per tick, and another one ahead, with a gap in between [m].
PerceptionsBuilder facing(double gap, NeighbourKind kind = NeighbourKind::AGENT) {
  return PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({0.5 + gap, 0.0}, 0.25).kind(kind);
}

TEST(SeparationRule, KeepsFreeMoves) {
  EXPECT_EQ(shareAhead(GapSharing::HALF, PerceptionsBuilder().agent(0, {5.0, 0.0})), 1.0);
  EXPECT_EQ(shareAhead(GapSharing::HALF, facing(0.07)), 1.0);  // half of it is more than 0.03
  EXPECT_EQ(shareAhead(GapSharing::NONE, facing(0.001)), 1.0);
  EXPECT_EQ(shareAhead(GapSharing::HALF, PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({-0.5, 0.0}, 0.25)), 1.0);
}

TEST(SeparationRule, AllowsEachAgentHalfOfTheGap) {
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.03)), 0.5, 1e-6);
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.006)), 0.1, 1e-6);
  EXPECT_EQ(shareAhead(GapSharing::HALF, facing(0.0)), 0.0);
}

TEST(SeparationRule, AllowsTheWholeGapToStaticObstaclesAndWalls) {
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.015, NeighbourKind::OBSTACLE)), 0.5, 1e-6);
  const auto before_wall = PerceptionsBuilder().agent(0, {5.0, 0.0}).wall({0.265, -1.0}, {0.265, 1.0});
  EXPECT_NEAR(shareAhead(GapSharing::HALF, before_wall), 0.5, 1e-6);
}

TEST(SeparationRule, ConsidersAllNeighboursOfACrowd) {
  // Thirty bodies behind the agent, which limit nothing, are nearer than the one ahead.
  auto crowd = PerceptionsBuilder().agent(0, {5.0, 0.0});
  for (int i = 0; i < 30; ++i) crowd.neighbour(polar(120.0 + 4.0 * i, 0.3), 0.05);
  EXPECT_NEAR(shareAhead(GapSharing::HALF, crowd.neighbour({0.53, 0.0}, 0.25)), 0.5, 1e-6);
}

TEST(SeparationRule, LimitsTheComponentTowardsTheOtherAgent) {
  const auto moves = cut(SeparationRule(GapSharing::HALF, LOOKOUT), facing(0.006).perception(),
                         {{unitVector(toRadians(60.0)), 1.0, 1.0}, {unitVector(toRadians(90.0)), 1.0, 1.0}});
  EXPECT_NEAR(moves[0].fraction, 0.2,
              1e-6);  // 0.015 m of its 0.03 m are towards the other agent, 0.003 m are admissible
  EXPECT_EQ(moves[1].fraction, 1.0);
}

TEST(SeparationRule, MovingSharesDependOnBothVelocities) {
  // Both walked ahead at 0.1 m/s: the line between them moves on by 0.01 m.
  auto following = facing(0.03).velocity({0.1, 0.0}, {0.1, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, following), 0.025 / 0.03, 1e-6);
  EXPECT_NEAR(shareAhead(GapSharing::HALF, following), 0.5, 1e-6);
  auto led = facing(0.03).velocity({-0.1, 0.0}, {-0.1, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, led), 0.005 / 0.03, 1e-6);
  auto meeting = facing(0.03).velocity({0.3, 0.0}, {-0.3, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, meeting), 0.5, 1e-6);
  auto pushed = facing(0.03).velocity({-9.0, 0.0}, {-9.0, 0.0});
  EXPECT_EQ(shareAhead(GapSharing::MOVING, pushed), 0.0);  // staying is always admissible
}

TEST(GapSharing, HasNames) {
  for (const char* name : {"none", "half", "moving"}) EXPECT_EQ(GAP_SHARINGS.nameOf(GAP_SHARINGS.parse(name)), name);
  EXPECT_TRUE(contains(errorOf<InputError>([] { GAP_SHARINGS.parse("third"); }), "none, half or moving, got 'third'"));
}

}  // namespace
}  // namespace crowd::separation_rule_test
