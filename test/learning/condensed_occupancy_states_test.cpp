#include <gtest/gtest.h>

#include "learning/states/sector_states.h"
#include "support/error_of.h"
#include "support/parts.h"
#include "support/perceptions.h"
#include "support/rows.h"

namespace crowd::condensed_occupancy_states_test {
namespace {

using Classes = std::vector<int>;

Row rowOf(const StateSet& states, const PerceptionsBuilder& scene) { return rowsOf(states, scene.perception()).at(0); }

const SectorStates& states() {
  static const auto STATES = statesOf("{type: condensed_occupancy}");
  return dynamic_cast<const SectorStates&>(*STATES);
}

Row rowOf(const PerceptionsBuilder& scene) { return rowOf(states(), scene); }

/// An agent with a goal at a distance of 5 m and a bearing [degrees].
PerceptionsBuilder goalAt(double degrees) { return PerceptionsBuilder().agent(0, polar(degrees, 5.0)); }

/// A body of radius 0.1 m with its rim at a distance [m], at a bearing [degrees]. At 0.3 m and beyond it spans up to
/// asin(0.1 / 0.4) = 14.5 degrees to either side, less than half a sector's width.
PerceptionsBuilder& addNeighbour(double degrees, double rim, PerceptionsBuilder& scene) {
  return scene.neighbour(polar(degrees, rim + 0.1), 0.1);
}

/// The row of a state of set 2: a body in each sector that has a class.
Row rowOf(int goal_sector, const Classes& classes) {
  PerceptionsBuilder scene = goalAt(45.0 * goal_sector);
  for (std::size_t sector = 0; sector < classes.size(); ++sector) {
    if (classes[sector] == 0) continue;
    addNeighbour(45.0 * static_cast<double>(sector), classes[sector] == 1 ? 0.4 : 0.8, scene);
  }
  return rowOf(scene);
}

TEST(CondensedOccupancyStates, Has4097Rows) {
  EXPECT_EQ(states().rowCount(), 4097U);  // 8 * 2 * 2^8 + 1
  EXPECT_EQ(states().terminal(), 4096U);
  EXPECT_EQ(states().rowsPerPerception(), 1U);
}

TEST(CondensedOccupancyStates, EncodesTheSectorOfTheGoal) {
  for (int sector = 0; sector < 8; ++sector) EXPECT_EQ(rowOf(goalAt(45.0 * sector)), 512U * sector);
}

TEST(CondensedOccupancyStates, EncodesOccupiedSectors) {
  const Row digits[] = {128, 64, 32, 16, 8, 4, 2, 1};
  for (int sector = 0; sector < 8; ++sector) {
    PerceptionsBuilder scene = goalAt(0.0);
    EXPECT_EQ(rowOf(addNeighbour(45.0 * sector, 0.6, scene)), digits[sector]);
  }
  PerceptionsBuilder across_a_limit = goalAt(90.0);  // at 0.7 m and 22.5 degrees it lies in both sectors
  EXPECT_EQ(rowOf(addNeighbour(22.5, 0.6, across_a_limit)), 2U * 512U + 128U + 64U);
  PerceptionsBuilder two = goalAt(-45.0);
  addNeighbour(180.0, 0.9, two);
  EXPECT_EQ(rowOf(addNeighbour(-45.0, 0.6, two)), 7U * 512U + 8U + 1U);
  PerceptionsBuilder beyond = goalAt(0.0);
  EXPECT_EQ(rowOf(addNeighbour(0.0, 1.01, beyond)), 0U);
  EXPECT_EQ(rowOf(goalAt(0.0).wall({0.8, -0.1}, {0.8, 0.1})), 128U);  // to 7.1 degrees on both sides
}

TEST(CondensedOccupancyStates, EncodesWhetherAnySectorIsNear) {
  PerceptionsBuilder near = goalAt(0.0);
  EXPECT_EQ(rowOf(addNeighbour(180.0, 0.4, near)), 256U + 8U);
  // The state does not contain which of them is near.
  for (const double near_one : {0.0, 90.0}) {
    PerceptionsBuilder scene = goalAt(45.0);
    addNeighbour(near_one, 0.4, scene);
    EXPECT_EQ(rowOf(addNeighbour(90.0 - near_one, 0.9, scene)), 512U + 256U + 128U + 32U);
  }
  PerceptionsBuilder both = goalAt(45.0);
  addNeighbour(0.0, 0.4, both);
  EXPECT_EQ(rowOf(addNeighbour(90.0, 0.3, both)), 512U + 256U + 128U + 32U);
}

TEST(CondensedOccupancyStates, IsAFunctionOfStateSetTwo) {
  EXPECT_EQ(rowOf(0, {}), 0U);
  EXPECT_EQ(rowOf(3, {0, 0, 0, 2, 1, 1, 2, 0}), 3U * 512U + 256U + 16U + 8U + 4U + 2U);  // figure 3.9
  EXPECT_EQ(rowOf(3, {0, 0, 0, 2, 2, 2, 2, 0}), 3U * 512U + 16U + 8U + 4U + 2U);
  EXPECT_EQ(rowOf(7, {1, 1, 1, 1, 1, 1, 1, 1}), 4095U);
}

TEST(CondensedOccupancyStates, ReturnsDistanceClassesForRewards) {
  EXPECT_EQ(states().distanceClasses(0), Classes{});
  EXPECT_EQ(states().distanceClasses(states().terminal()), Classes{});
  EXPECT_EQ(states().distanceClasses(rowOf(5, {2, 0, 2})), (Classes{2, 2}));
  EXPECT_EQ(states().distanceClasses(rowOf(5, {2, 0, 1})), (Classes{1, 2, 2}));
  EXPECT_EQ(states().distanceClasses(4095), (Classes{1, 2, 2, 2, 2, 2, 2, 2, 2}));
  // The goal part is 0.
  const auto reward = rewardOf("{goal: distance_gained, obstacle_cost: 10}", states());
  const PerceptionsBuilder alone = goalAt(0.0);
  const Perception seen = alone.perception();
  EXPECT_DOUBLE_EQ((*reward)(seen.self, seen, rowOf(5, {2, 0, 1})), -10.2);  // 10 and twice 10 / 10^2
  EXPECT_EQ((*reward)(seen.self, seen, rowOf(5, {})), 0.0);
}

TEST(CondensedOccupancyStates, MirrorsGoalAndSectors) {
  EXPECT_EQ(states().mirrored(states().terminal()), states().terminal());
  EXPECT_EQ(states().mirrored(0), 0U);
  EXPECT_EQ(states().mirrored(rowOf(1, {2, 2, 0, 0, 2, 0, 0, 0})), rowOf(7, {2, 0, 0, 0, 2, 0, 0, 2}));
  EXPECT_EQ(states().mirrored(rowOf(4, {0, 0, 1, 2, 0, 0, 0, 0})), rowOf(4, {0, 0, 0, 0, 0, 2, 1, 0}));
  for (Row row = 0; row < states().rowCount(); ++row) ASSERT_EQ(states().mirrored(states().mirrored(row)), row);
}

TEST(CondensedOccupancyStates, ReturnsOccupiedSectorsForPictures) {
  EXPECT_TRUE(states().occupiedSectors(goalAt(0.0).perception()).empty());
  PerceptionsBuilder scene = goalAt(0.0);
  addNeighbour(0.0, 0.6, scene);
  addNeighbour(90.0, 0.3, scene);
  const auto occupied = states().occupiedSectors(scene.perception());
  ASSERT_EQ(occupied.size(), 2U);
  EXPECT_NEAR(occupied[0].from, toRadians(-22.5), 1e-9);
  EXPECT_NEAR(occupied[0].to, toRadians(22.5), 1e-9);
  EXPECT_EQ(occupied[0].distance_class, 2);
  EXPECT_NEAR(occupied[1].from, toRadians(67.5), 1e-9);
  EXPECT_EQ(occupied[1].distance_class, 1);
}

TEST(CondensedOccupancyStates, ReadBackTheirSpec) {
  EXPECT_EQ(statesOf("{type: condensed_occupancy}")->spec(),
            "{type: condensed_occupancy, sectors: 8, collision_radius: 0.5, vision_radius: 1}");
  const auto four = statesOf("{type: condensed_occupancy, sectors: 4, collision_radius: 0.25, vision_radius: 3}");
  EXPECT_EQ(four->spec(), "{type: condensed_occupancy, sectors: 4, collision_radius: 0.25, vision_radius: 3}");
  EXPECT_EQ(four->rowCount(), 129U);  // 4 * 2 * 2^4 + 1
  EXPECT_EQ(dynamic_cast<const SectorPicture&>(*four).distanceLimits(), (std::vector<double>{0.25, 3.0}));
  EXPECT_EQ(four->visionRadius(), 3.0);
  // Goal behind, a body at the right whose rim is 2.9 m away: 2 * 32 + 1.
  EXPECT_EQ(rowOf(*four, PerceptionsBuilder().agent(0, {-1.0, 0.0}).neighbour({0.0, -3.0}, 0.1)), 65U);
  const std::string message = errorOf<InputError>([] { statesOf("{type: condensed_occupancy, sectors: 13}"); });
  EXPECT_TRUE(contains(message, "state_set.sectors: expected")) << message;
  EXPECT_TRUE(contains(errorOf<InputError>([] { statesOf("{type: condensed_occupancy, vision_radius: 0.5}"); }),
                       "state_set.vision_radius: expected a radius of vision above the collision radius"));
}

}  // namespace
}  // namespace crowd::condensed_occupancy_states_test
