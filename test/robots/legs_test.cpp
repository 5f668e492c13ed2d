#include "robots/legs.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/scenes.h"

namespace crowd::legs_test {
namespace {

TEST(Legs, StandBesideEachOther) {
  std::vector<ScanTarget> legs;
  addLegs({{1.0, 2.0}, 0.0}, 0.0, 0.3, 5, legs);
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_TRUE(legs[0].centre.isApprox(Vector2(1.0, 2.1)));
  EXPECT_TRUE(legs[1].centre.isApprox(Vector2(1.0, 1.9)));
  EXPECT_EQ(legs[0].radius, 0.06);
  EXPECT_EQ(legs[1].body, 5U);
}

TEST(Legs, SwingAgainstEachOther) {
  std::vector<ScanTarget> legs;
  addLegs({{0.0, 0.0}, PI / 2.0}, 1.3 / 4.0, 0.3, 0, legs);
  EXPECT_TRUE(legs[0].centre.isApprox(Vector2(-0.1, 0.15)));
  EXPECT_TRUE(legs[1].centre.isApprox(Vector2(0.1, -0.15)));
}

TEST(Legs, StayWithinTheBody) {
  for (double radius = 0.02; radius < 0.5; radius += 0.02) {
    for (double walked = 0.0; walked < 1.3; walked += 0.05) {
      SCOPED_TRACE(radius);
      std::vector<ScanTarget> legs;
      addLegs({{0.0, 0.0}, 1.0}, walked, radius, 0, legs);
      for (const ScanTarget& leg : legs) EXPECT_LE(leg.centre.norm() + leg.radius, radius + 1e-12);
    }
  }
}

TEST(Gait, AddsUpWhatAgentsWalk) {
  World world(
      scenes::halfSeconds(scenes::scene({scenes::wanderer({0.0, 0.0}, 1.0), scenes::wanderer({0.0, 5.0}, 1.0)})));
  Gait gait;
  for (int i = 0; i < 3; ++i) {
    world.step({{0, {0.0, 1.0}}});
    gait.observe(world);
  }
  EXPECT_DOUBLE_EQ(gait.walked(0), 1.5);
  EXPECT_EQ(gait.walked(1), 0.0);
  EXPECT_EQ(gait.walked(9), 0.0);
}

}  // namespace
}  // namespace crowd::legs_test
