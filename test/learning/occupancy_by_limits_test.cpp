// State set 2 and its condensed form with sectors by limits, those of state set 1 (figure 3.6).

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "learning/states/occupancy_states.h"
#include "support/error_of.h"
#include "support/parts.h"
#include "support/perceptions.h"
#include "support/rows.h"
#include "support/sector_cases.h"

namespace crowd::occupancy_by_limits_test {
namespace {

using Classes = std::vector<int>;

/// 15, 45, 90 and 180 degrees: sectors 0 to 3 on the left, 4 to 7 on the right, each from front to back.
OccupancyStates::Parameters thesisSectors() {
  OccupancyStates::Parameters parameters;
  parameters.obstacle_sectors = {15, 45, 90, 180};
  return parameters;
}

PerceptionsBuilder agentAlone() { return PerceptionsBuilder().agent(0, {5.0, 0.0}); }

Classes classesOf(const PerceptionsBuilder& scene) {
  const OccupancyStates states(thesisSectors());
  return states.distanceClasses(states.rowOf(scene.perception()));
}

Classes classesOfNeighbour(double degrees, double distance, double radius) {
  return classesOf(agentAlone().neighbour(polar(degrees, distance), radius));
}

std::string errorIn(const std::string& yaml) {
  return errorOf<InputError>([&] { statesOf(yaml); });
}

TEST(OccupancyByLimits, HasTheSectorsOfSetOne) {
  const OccupancyStates states(thesisSectors());
  const auto set_one = statesOf("{type: nearest_obstacle}");
  for (const sector_cases::SectorCase& edge : sector_cases::UNEVEN) {
    // 0.7 m away and so small that it cuts no limiting vector.
    const PerceptionsBuilder scene = agentAlone().neighbour(polar(edge.degrees, 0.7), 1e-4);
    const Classes classes = states.distanceClasses(states.rowOf(scene.perception()));
    if (edge.degrees == 0.0) continue;  // exactly on a limit
    ASSERT_EQ(classes.size(), 8U);
    for (int sector = 0; sector < 8; ++sector) {
      EXPECT_EQ(classes[static_cast<std::size_t>(sector)], sector == edge.sector ? 2 : 0) << edge.degrees << " degrees";
    }
    const auto row = static_cast<int>(rowsOf(*set_one, scene.perception()).at(0));
    EXPECT_EQ(row, 7 + edge.sector * 2 + 2) << edge.degrees << " degrees";  // (3.3) with the goal ahead
  }
}

TEST(OccupancyByLimits, IntersectsTheLimitsOfBothSides) {
  // The rim is 0.4 away. The limit ahead is cut from 0.4 on; those at 15 degrees pass 0.7 sin 15 = 0.181 from the
  // centre and are cut from 0.7 cos 15 - sqrt(0.3^2 - 0.181^2) = 0.437 on; those at 45 degrees pass 0.495 from it.
  EXPECT_EQ(classesOfNeighbour(0.0, 0.7, 0.3), (Classes{1, 1, 0, 0, 1, 1, 0, 0}));
  // At 30 degrees the limits at 15 and 45 pass 0.7 sin 15 = 0.181 from the centre.
  EXPECT_EQ(classesOfNeighbour(30.0, 0.7, 0.1), (Classes{0, 2, 0, 0, 0, 0, 0, 0}));
  // At 20 degrees that at 15 passes 0.7 sin 5 = 0.061, and is cut from 0.697 - sqrt(0.01 - 0.0037) = 0.618 on.
  EXPECT_EQ(classesOfNeighbour(20.0, 0.7, 0.1), (Classes{2, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(-20.0, 0.7, 0.1), (Classes{0, 0, 0, 0, 2, 2, 0, 0}));
  // The same behind: the limit at 90 degrees passes 0.4 sin 10 = 0.069, and is cut from 0.394 - 0.072 = 0.322 on.
  EXPECT_EQ(classesOfNeighbour(80.0, 0.4, 0.1), (Classes{0, 0, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(-120.0, 0.7, 0.1), (Classes{0, 0, 0, 0, 0, 0, 0, 2}));
  // Exactly behind it cuts the limit at 180 degrees, between the last sectors of both sides.
  EXPECT_EQ(classesOfNeighbour(180.0, 0.7, 0.1), (Classes{0, 0, 0, 2, 0, 0, 0, 2}));
  EXPECT_EQ(classesOfNeighbour(0.0, 0.1, 0.3), (Classes{1, 1, 1, 1, 1, 1, 1, 1}));  // around the agent
}

TEST(OccupancyByLimits, WallsCutTheLimitsOfBothSides) {
  // Across the way at 0.3: the limits are cut at 0.3, 0.3 / cos 15 = 0.311 and 0.3 / cos 45 = 0.424.
  EXPECT_EQ(classesOf(agentAlone().wall({0.3, -3.0}, {0.3, 3.0})), (Classes{1, 1, 1, 0, 1, 1, 1, 0}));
  // At 0.45: 0.466 and 0.636.
  EXPECT_EQ(classesOf(agentAlone().wall({0.45, -3.0}, {0.45, 3.0})), (Classes{1, 1, 2, 0, 1, 1, 2, 0}));
  EXPECT_EQ(classesOf(agentAlone().wall({-0.6, -0.1}, {-0.6, 0.1})), (Classes{0, 0, 0, 2, 0, 0, 0, 2}));
}

TEST(OccupancyByLimits, CostsWhatItsSectorsCost) {
  const OccupancyStates states(thesisSectors());
  const auto reward = rewardOf("{goal: distance_gained, obstacle_cost: 10}", states);
  // A disc of radius 0.3 whose centre is 0.7 m ahead: class 1 in four sectors.
  const PerceptionsBuilder scene = agentAlone().neighbour({0.7, 0.0}, 0.3);
  const Perception seen = scene.perception();
  EXPECT_DOUBLE_EQ((*reward)(seen.self, seen, states.rowOf(seen)), -40.0);
}

TEST(OccupancyByLimits, NumbersOfGoalAndObstacleSectorsMayDiffer) {
  const auto states = statesOf("{type: occupancy, sectors: 6, obstacle_sectors: [30, 180]}");
  EXPECT_EQ(states->rowCount(), 487U);  // 6 * 3^4 + 1
  const auto& six = dynamic_cast<const OccupancyStates&>(*states);
  EXPECT_EQ(six.rowOf({5, {0, 2, 0, 1}}), 424U);  // 5 * 81 + 2 * 9 + 1
  EXPECT_EQ(six.mirrored(424U), 92U);             // goal sector 1; classes 0, 1, 0, 2
  EXPECT_EQ(six.distanceClasses(424U), (Classes{0, 2, 0, 1}));
  EXPECT_EQ(six.distanceClasses(486U), Classes{});
  // Goal at -60 degrees, sector 5; a body on the left at 100 degrees, rim 0.6; one on the right, rim 0.3.
  const PerceptionsBuilder scene = PerceptionsBuilder()
                                       .agent(0, polar(-60.0, 5.0))
                                       .neighbour(polar(100.0, 0.7), 0.1)
                                       .neighbour(polar(-100.0, 0.4), 0.1);
  EXPECT_EQ(rowsOf(*states, scene.perception()).at(0), 424U);
  const auto condensed = statesOf("{type: condensed_occupancy, sectors: 6, obstacle_sectors: [30, 180]}");
  EXPECT_EQ(condensed->rowCount(), 193U);                               // 6 * 2 * 2^4 + 1
  EXPECT_EQ(rowsOf(*condensed, scene.perception()).at(0), 181U);        // 5 * 32 + 16 + 4 + 1
  EXPECT_EQ(condensed->mirrored(5U * 32U + 16U + 4U), 32U + 16U + 1U);  // goal sector 1, sector 3
  for (Row row = 0; row < states->rowCount(); ++row) ASSERT_EQ(states->mirrored(states->mirrored(row)), row);
}

TEST(OccupancyByLimits, ReturnsOccupiedSectorsForPictures) {
  for (const char* const type : {"occupancy", "condensed_occupancy"}) {
    const auto states = statesOf(std::string("{type: ") + type + ", obstacle_sectors: [15, 45, 90, 180]}");
    const PerceptionsBuilder scene = agentAlone().neighbour(polar(30.0, 0.7), 0.1).neighbour(polar(-120.0, 0.4), 0.1);
    const auto occupied = dynamic_cast<const SectorPicture&>(*states).occupiedSectors(scene.perception());
    ASSERT_EQ(occupied.size(), 2U);
    EXPECT_NEAR(occupied[0].from, toRadians(15.0), 1e-9);
    EXPECT_NEAR(occupied[0].to, toRadians(45.0), 1e-9);
    EXPECT_EQ(occupied[0].distance_class, 2);
    EXPECT_NEAR(occupied[1].from, toRadians(-180.0), 1e-9);
    EXPECT_NEAR(occupied[1].to, toRadians(-90.0), 1e-9);
    EXPECT_EQ(occupied[1].distance_class, 1);
  }
}

TEST(OccupancyByLimits, ExplainsItsRows) {
  const RowMeaning meaning = OccupancyStates(thesisSectors()).meaning();
  ASSERT_EQ(meaning.quantities.size(), 9U);
  EXPECT_EQ(meaning.quantities[0].classes.size(), 8U);
  EXPECT_EQ(meaning.quantities[1].name, "body left 0-15°");
  EXPECT_EQ(meaning.quantities[8].name, "body right 90-180°");
  const auto condensed = statesOf("{type: condensed_occupancy, obstacle_sectors: [15, 45, 90, 180]}");
  EXPECT_EQ(dynamic_cast<const ExplainedRows&>(*condensed).meaning().quantities[4].name, "body left 45-90°");
}

TEST(OccupancyByLimits, ReadsBackItsSpec) {
  for (const char* const type : {"occupancy", "condensed_occupancy"}) {
    const std::string spec = std::string("{type: ") + type +
                             ", sectors: 5, obstacle_sectors: [22.5, 180], collision_radius: 0.25, vision_radius: 3}";
    EXPECT_EQ(statesOf(spec)->spec(), spec);
  }
}

TEST(OccupancyByLimits, RefusesOtherLimits) {
  const std::string expected = "expected a list of rising limits [degrees], the last one 180";
  for (const char* const wrong : {"15", "[]", "{}", "[15, 45]", "[180, 15]", "[90, 90, 180]", "[15, 180, 270]"}) {
    for (const char* const type : {"occupancy", "condensed_occupancy", "nearest_obstacle"}) {
      const std::string message = errorIn(std::string("{type: ") + type + ", obstacle_sectors: " + wrong + "}");
      EXPECT_TRUE(contains(message, "state_set.obstacle_sectors")) << message;
      EXPECT_TRUE(contains(message, expected)) << message;
    }
  }
  const std::string seven = errorIn("{type: occupancy, obstacle_sectors: [10, 20, 30, 40, 50, 60, 180]}");
  EXPECT_TRUE(contains(seven, "state_set.obstacle_sectors: expected at most 6 limits")) << seven;
  EXPECT_TRUE(contains(errorIn("{type: occupancy, obstacle_sectors: [-15, 180]}"), "expected")) << "negative";
}

}  // namespace
}  // namespace crowd::occupancy_by_limits_test
