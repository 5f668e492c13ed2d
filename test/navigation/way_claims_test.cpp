#include "navigation/way_claims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/floors.h"
#include "support/two_ways.h"

namespace crowd::way_claims_test {
namespace {

using two_ways::RADIUS;
using two_ways::walker;

constexpr double PRECISION = WayClaims::STEP + 2.0 * FloorRuler::SPACING;  // of lengths along a way [m]

/// Claims of agents at a door in a wall along the y axis.
struct Door {
  Door(std::vector<AgentStart> agents, const FloorPlan& floor)
      : world(two_ways::worldOf(std::move(agents))), ruler(floor, WayClaims::wideClearance(RADIUS)) {
    claims.update(world, two_ways::findPaths(world), ruler);
  }
  explicit Door(std::vector<AgentStart> agents, double width = 0.9)
      : Door(std::move(agents), floors::roomWithDoor(width)) {}

  World world;
  FloorRuler ruler;
  WayClaims claims;
};

/// A door of 0.9 m in a line is 0.5 m wide for the centre of a body of 0.2 m: less than the 1.8 m that two need. The
/// floor across the way is so narrow where the ends of the wall are less than 0.2 m from the line across: up to 0.2 m
/// from the door.
TEST(WayClaims, ADoorIsNarrow) {
  Door door({walker({-2.0, 0.0}, {4.5, 0.0})});
  ASSERT_EQ(door.claims.claimants().size(), 1U);
  const Claimant& claimant = door.claims.claimants().front();
  EXPECT_EQ(claimant.agent, 0U);
  EXPECT_NEAR(claimant.distance, 1.8, PRECISION);
  EXPECT_NEAR(claimant.length, 0.4, 2.0 * PRECISION);
  EXPECT_FALSE(claimant.isInside());
  EXPECT_NEAR((claimant.heading - Vector2::UnitX()).norm(), 0.0, 1e-9);
  double last = -WayClaims::STEP;
  for (const Claim& claim : door.claims.of(claimant)) {
    EXPECT_NEAR(claim.ahead, last + WayClaims::STEP, 1e-9);
    EXPECT_NEAR((claim.place - Vector2(claim.ahead - 2.0, 0.0)).norm(), 0.0, 1e-9);
    if (claim.is_narrow) EXPECT_NEAR(claim.width.total(), 0.5, 2.0 * PRECISION);
    EXPECT_EQ(claim.passage, claim.ahead < claimant.distance ? 0U : 1U);
    last = claim.ahead;
  }
  EXPECT_NEAR(last, WayClaims::LOOKAHEAD, PRECISION);
}

TEST(WayClaims, AWideDoorIsNot) {
  EXPECT_TRUE(Door({walker({-2.0, 0.0}, {4.5, 0.0})}, 2.6).claims.claimants().empty());
}

/// For the centre of a body of 0.2 m both are 1.6 m wide. Two bodies need 1.8 m in a door, and 1.0 m in a corridor.
TEST(WayClaims, ADoorIsNarrowWhereACorridorOfItsWidthIsNot) {
  EXPECT_EQ(Door({walker({-2.0, 0.0}, {4.5, 0.0})}, 2.0).claims.claimants().size(), 1U);
  const FloorPlan corridor = floors::room({-8.0, -1.0}, {8.0, 1.0});
  EXPECT_TRUE(Door({walker({-7.0, 0.0}, {7.5, 0.0})}, corridor).claims.claimants().empty());
}

TEST(WayClaims, ADoorFarAwayIsNotClaimed) {
  EXPECT_TRUE(Door({walker({-WayClaims::LOOKAHEAD - 0.6, 0.0}, {4.5, 0.0})}).claims.claimants().empty());
}

TEST(WayClaims, AnAgentInTheDoorIsInside) {
  Door door({walker({-0.05, 0.0}, {4.5, 0.0})});
  ASSERT_EQ(door.claims.claimants().size(), 1U);
  EXPECT_TRUE(door.claims.claimants().front().isInside());
  EXPECT_EQ(door.claims.of(door.claims.claimants().front())[0].passage, 0U);
}

/// A corridor of 1 m and 16 m, in which bodies of 0.2 m cannot pass each other: the way through it is claimed to its
/// end.
TEST(WayClaims, ANarrowCorridorIsClaimedToItsEnd) {
  Door door({walker({-7.0, 0.0}, {7.5, 0.0})}, floors::room({-8.0, -0.5}, {8.0, 0.5}));
  ASSERT_EQ(door.claims.claimants().size(), 1U);
  const Span<Claim> claims = door.claims.of(door.claims.claimants().front());
  EXPECT_NEAR(claims[claims.size() - 1].place.x(), 7.5, PRECISION);
  EXPECT_TRUE(std::all_of(claims.begin(), claims.end(), [](const Claim& claim) { return claim.is_narrow; }));
}

TEST(WayClaims, FindsClaimsNearAPlace) {
  Door door({walker({-2.0, 0.0}, {4.5, 0.0}), walker({2.0, 3.0}, {-4.5, 0.0})});
  ASSERT_EQ(door.claims.claimants().size(), 1U);  // the other way to the door is 3.6 m long
  std::size_t count = 0;
  door.claims.visitNear({0.0, 0.0}, 0.25, [&](const NearClaim& claim) {
    EXPECT_EQ(claim.claimant, 0U);
    EXPECT_LE(claim.place.norm(), 0.25);
    ++count;
  });
  EXPECT_EQ(count, 3U);  // at -0.2, 0 and 0.2 m
  door.claims.visitNear({0.0, 2.0}, 1.0, [&](const NearClaim& claim) { ADD_FAILURE() << claim.place.transpose(); });
}

}  // namespace
}  // namespace crowd::way_claims_test
