#include "learning/states/occupancy_states.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/perceptions.h"
#include "support/rows.h"
#include "support/sector_cases.h"

namespace crowd::occupancy_states_test {
namespace {

using Classes = std::vector<int>;
using Situation = OccupancyStates::Situation;
using sector_cases::SectorCase;

const Classes NOTHING = {0, 0, 0, 0, 0, 0, 0, 0};
const Classes ALL_NEAR = {1, 1, 1, 1, 1, 1, 1, 1};

/// An agent whose goal lies 5 m straight ahead.
PerceptionsBuilder agentAlone() { return PerceptionsBuilder().agent(0, {5.0, 0.0}); }

/// Decodes the distance class of each of the 8 sectors from the row.
Classes classesOf(const PerceptionsBuilder& scene) {
  const OccupancyStates states;
  return states.distanceClasses(states.rowOf(states.describe(scene.perception())));
}

Classes classesOfNeighbour(const Vector2& position, double radius) {
  return classesOf(agentAlone().neighbour(position, radius));
}

/// The same for a wall; the result must not depend on the order of its ends.
Classes classesOfWall(const Vector2& from, const Vector2& to) {
  Classes classes = classesOf(agentAlone().wall(from, to));
  EXPECT_EQ(classesOf(agentAlone().wall(to, from)), classes);
  return classes;
}

TEST(OccupancyStates, HasEightGoalSectors) {
  const OccupancyStates states;
  for (const SectorCase& edge : sector_cases::EVEN) {
    const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(edge.degrees, 2.0));
    EXPECT_EQ(states.describe(scene.perception()).goal_sector, edge.sector) << edge.degrees << " degrees";
  }
}

TEST(OccupancyStates, BodyOccupiesTheSectorOfItsCentre) {
  // Half the angle it spans is asin(0.1 / 0.7) = 8.2 degrees; its rim is 0.6 away.
  EXPECT_EQ(classesOfNeighbour(polar(0.0, 0.7), 0.1), (Classes{2, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(45.0, 0.7), 0.1), (Classes{0, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(90.0, 0.7), 0.1), (Classes{0, 0, 2, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(135.0, 0.7), 0.1), (Classes{0, 0, 0, 2, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(180.0, 0.7), 0.1), (Classes{0, 0, 0, 0, 2, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(-135.0, 0.7), 0.1), (Classes{0, 0, 0, 0, 0, 2, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(-90.0, 0.7), 0.1), (Classes{0, 0, 0, 0, 0, 0, 2, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(-45.0, 0.7), 0.1), (Classes{0, 0, 0, 0, 0, 0, 0, 2}));
}

// Limiting vectors lie at 22.5, 67.5, ... degrees; sin 22.5 = 0.3827, cos 22.5 = 0.9239.

TEST(OccupancyStates, BodyThatCutsALimitOccupiesBothAdjacentSectors) {
  // At 20 degrees the limit at 22.5 passes 0.7 sin 2.5 = 0.031 from the centre, at 14 degrees 0.7 sin 8.5 = 0.103. The
  // rim is 0.6 away, so the vector of length 0.5 does not reach it.
  EXPECT_EQ(classesOfNeighbour(polar(20.0, 0.7), 0.1), (Classes{2, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(14.0, 0.7), 0.1), (Classes{2, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(-20.0, 0.7), 0.1), (Classes{2, 0, 0, 0, 0, 0, 0, 2}));
  EXPECT_EQ(classesOfNeighbour(polar(110.0, 0.7), 0.1), (Classes{0, 0, 2, 2, 0, 0, 0, 0}));
}

TEST(OccupancyStates, EachLimitHasItsOwnClass) {
  // The rim is 0.4 away: class 1 where the centre is. The limits beside it pass 0.7 * 0.3827 = 0.268 from the centre
  // and are cut from 0.7 * 0.9239 - sqrt(0.3^2 - 0.268^2) = 0.512 on: beyond the vector of length 0.5, so class 2.
  EXPECT_EQ(classesOfNeighbour(polar(0.0, 0.7), 0.3), (Classes{1, 2, 0, 0, 0, 0, 0, 2}));
  EXPECT_EQ(classesOfNeighbour(polar(-90.0, 0.7), 0.3), (Classes{0, 0, 0, 0, 0, 2, 1, 2}));
  // At 0.65: 0.249; 0.601 - sqrt(0.09 - 0.062) = 0.433, class 1.
  EXPECT_EQ(classesOfNeighbour(polar(0.0, 0.65), 0.3), (Classes{1, 1, 0, 0, 0, 0, 0, 1}));
}

TEST(OccupancyStates, LimitingVectorsEndAtTheRadiusOfVision) {
  // The rim is 0.9 away. The limits pass 1.5 * 0.3827 = 0.574 from the centre, but are cut from 1.386 - sqrt(0.36 -
  // 0.33) = 1.21 on only.
  EXPECT_EQ(classesOfNeighbour(polar(0.0, 1.5), 0.6), (Classes{2, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(OccupancyStates, LargeBodyCutsMoreLimits) {
  // The limits at 67.5 degrees pass cos 22.5 = 0.924 from the centre, where they are sin 22.5 = 0.383 long. Those at
  // 112.5 degrees begin 1 m from the centre and lead away from it.
  EXPECT_EQ(classesOfNeighbour(polar(0.0, 1.0), 0.99), (Classes{1, 1, 1, 0, 0, 0, 1, 1}));
}

TEST(OccupancyStates, SectorsContinueBehindTheAgent) {
  EXPECT_EQ(classesOfNeighbour(polar(180.0, 0.7), 0.3), (Classes{0, 0, 0, 2, 1, 2, 0, 0}));
  // The limit at 157.5 degrees passes 0.7 sin 7.5 = 0.091 from the centre, and is cut from 0.694 - sqrt(0.044 - 0.008)
  // = 0.505 on; that at 202.5 degrees passes 0.7 sin 37.5 = 0.426 from it. The rim is 0.49 away.
  EXPECT_EQ(classesOfNeighbour(polar(165.0, 0.7), 0.21), (Classes{0, 0, 0, 2, 1, 0, 0, 0}));
  EXPECT_EQ(classesOfNeighbour(polar(-165.0, 0.7), 0.21), (Classes{0, 0, 0, 0, 1, 2, 0, 0}));
}

TEST(OccupancyStates, BodyAroundTheAgentOccupiesAllSectors) {
  EXPECT_EQ(classesOfNeighbour({0.1, 0.0}, 0.3), ALL_NEAR);
  EXPECT_EQ(classesOfNeighbour({0.0, 0.0}, 0.3), ALL_NEAR);
  EXPECT_EQ(classesOfNeighbour({0.0, -0.25}, 0.26), ALL_NEAR);
  EXPECT_EQ(classesOfNeighbour({0.0, 2.0}, 3.0), ALL_NEAR);
}

TEST(OccupancyStates, LimitsBelongToTheNearerClass) {
  // 0.75 - 0.25 = 0.5 and 1.25 - 0.25 = 1, both exactly; asin(0.25 / 0.75) = 19.5 degrees stay within the sector.
  EXPECT_EQ(classesOfNeighbour({0.75, 0.0}, 0.25)[0], 1);
  EXPECT_EQ(classesOfNeighbour({std::nextafter(0.75, 1.0), 0.0}, 0.25)[0], 2);
  EXPECT_EQ(classesOfNeighbour({1.25, 0.0}, 0.25)[0], 2);
  EXPECT_EQ(classesOfNeighbour({std::nextafter(1.25, 2.0), 0.0}, 0.25), NOTHING);
  EXPECT_EQ(classesOfNeighbour({3.0, 0.0}, 0.25), NOTHING);
}

TEST(OccupancyStates, NearerOfTwoBodiesDeterminesTheClass) {
  const Vector2 near = polar(5.0, 0.4);  // rim 0.3
  const Vector2 far = polar(-5.0, 0.9);  // rim 0.8
  const Classes expected = {1, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(classesOf(agentAlone().neighbour(near, 0.1).neighbour(far, 0.1)), expected);
  EXPECT_EQ(classesOf(agentAlone().neighbour(far, 0.1).neighbour(near, 0.1)), expected);
}

TEST(OccupancyStates, NearBodyDoesNotChangeOtherSectors) {
  // The far one (90 degrees, rim 0.7, asin(0.3 / 1) = 17.5 degrees) shares no sector with the near one.
  EXPECT_EQ(classesOf(agentAlone().neighbour(polar(0.0, 0.4), 0.1).neighbour(polar(90.0, 1.0), 0.3)),
            (Classes{1, 0, 2, 0, 0, 0, 0, 0}));
  // Two far ones and a wall behind; the bodies share the sector ahead.
  EXPECT_EQ(classesOf(agentAlone()
                          .neighbour(polar(20.0, 0.7), 0.1)
                          .neighbour(polar(-20.0, 0.7), 0.1)
                          .wall({-0.4, -0.1}, {-0.4, 0.1})),
            (Classes{2, 2, 0, 0, 1, 0, 0, 2}));
}

TEST(OccupancyStates, LongWallHasDifferentClassesInDifferentSectors) {
  // A wall across the way at 0.5: in the neighbours its nearest part lies at 22.5 degrees, 0.5 / cos(22.5) = 0.541
  // away; beyond them at 67.5 degrees, 0.5 / cos(67.5) = 1.307.
  EXPECT_EQ(classesOfWall({0.5, -3.0}, {0.5, 3.0}), (Classes{1, 2, 0, 0, 0, 0, 0, 2}));
  // At 0.3: 0.325 and 0.784; the wall's ends are at 84.3 degrees, within the sector from 67.5 to 112.5.
  EXPECT_EQ(classesOfWall({0.3, -3.0}, {0.3, 3.0}), (Classes{1, 1, 2, 0, 0, 0, 2, 1}));
  // At 0.95: 0.95 / cos(22.5) = 1.028.
  EXPECT_EQ(classesOfWall({0.95, -3.0}, {0.95, 3.0}), (Classes{2, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfWall({1.1, -3.0}, {1.1, 3.0}), NOTHING);
}

TEST(OccupancyStates, WallBehindTheAgentContinuesAcross180Degrees) {
  EXPECT_EQ(classesOfWall({-0.5, -3.0}, {-0.5, 3.0}), (Classes{0, 0, 0, 2, 1, 2, 0, 0}));
}

TEST(OccupancyStates, WallOccupiesSectorsUpToItsEnd) {
  // To the left at 0.4, from far behind to x = 0.1: that end is at atan(0.4 / 0.1) = 76 degrees, in sector 2. Sector 3
  // begins at 112.5 degrees: 0.4 / sin(112.5) = 0.433. Sector 4 at 157.5 degrees: 0.4 / sin(157.5) = 1.045.
  EXPECT_EQ(classesOfWall({-3.0, 0.4}, {0.1, 0.4}), (Classes{0, 0, 1, 1, 0, 0, 0, 0}));
  // On to x = 0.2: that end is at 63.4 degrees, in sector 1, sqrt(0.2^2 + 0.4^2) = 0.447 away.
  EXPECT_EQ(classesOfWall({-3.0, 0.4}, {0.2, 0.4}), (Classes{0, 1, 1, 1, 0, 0, 0, 0}));
  // Only to x = -0.6: the end is at 146.3 degrees, 0.721 away.
  EXPECT_EQ(classesOfWall({-3.0, 0.4}, {-0.6, 0.4}), (Classes{0, 0, 0, 2, 0, 0, 0, 0}));
}

TEST(OccupancyStates, RadialWallOccupiesOneSector) {
  EXPECT_EQ(classesOfWall({0.6, 0.0}, {3.0, 0.0}), (Classes{2, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfWall(polar(-120.0, 0.3), polar(-120.0, 3.0)), (Classes{0, 0, 0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(classesOfWall({-0.6, 0.0}, {-3.0, 0.0}), (Classes{0, 0, 0, 0, 2, 0, 0, 0}));
}

TEST(OccupancyStates, WallThroughTheAgentOccupiesAllSectors) {
  EXPECT_EQ(classesOfWall({-1.0, 0.0}, {1.0, 0.0}), ALL_NEAR);
  EXPECT_EQ(classesOfWall({-1.0, -2.0}, {2.0, 4.0}), ALL_NEAR);
  EXPECT_EQ(classesOfWall({0.0, 0.0}, {1.0, 0.0}), ALL_NEAR);  // ends in the agent's centre
}

TEST(OccupancyStates, CloseWallOccupiesHalfOfTheCircle) {
  // At 0.001 to the left its ends are at 0.06 and 179.94 degrees.
  EXPECT_EQ(classesOfWall({-1.0, 0.001}, {1.0, 0.001}), (Classes{1, 1, 1, 1, 1, 0, 0, 0}));
}

TEST(OccupancyStates, WallOfLengthZeroIsAPoint) {
  EXPECT_EQ(classesOfWall(polar(50.0, 0.6), polar(50.0, 0.6)), (Classes{0, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(classesOfWall({0.0, 0.0}, {0.0, 0.0}), ALL_NEAR);
}

TEST(OccupancyStates, NumbersRowsAsTheThesisDoes) {
  const OccupancyStates states;
  EXPECT_EQ(states.rowCount(), 52489U);
  EXPECT_EQ(states.terminal(), 52488U);  // 3^8 * 8 = 6561 * 8
  EXPECT_EQ(states.rowOf({0, {}}), 0U);
  EXPECT_EQ(states.rowOf({0, {0, 0, 0, 0, 0, 0, 0, 1}}), 1U);      // the last sector counts 3^0
  EXPECT_EQ(states.rowOf({0, {2}}), 4374U);                        // the first 3^7 = 2187, twice
  EXPECT_EQ(states.rowOf({3, {2}}), 24057U);                       // 3 * 6561 + 4374
  EXPECT_EQ(states.rowOf({1, {0, 1, 0, 0, 2, 0, 0, 0}}), 7344U);   // 6561 + 3^6 + 2 * 3^3 = 6561 + 729 + 54
  EXPECT_EQ(states.rowOf({7, {2, 2, 2, 2, 2, 2, 2, 2}}), 52487U);  // 7 * 6561 + 6560
}

TEST(OccupancyStates, MapsSituationsToRowsOneToOneAndEachCanBePerceived) {
  const OccupancyStates states;
  std::vector<int> found(states.rowCount(), 0);
  for (int goal = 0; goal < 8; ++goal) {
    for (int code = 0; code < 6561; ++code) {
      PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(45.0 * goal, 5.0));
      Classes classes(8);
      int rest = code;
      for (std::size_t sector = 0; sector < 8; ++sector, rest /= 3) {
        classes[sector] = rest % 3;
        const double rim = classes[sector] == 1 ? 0.3 : 0.8;
        if (classes[sector] > 0) scene.neighbour(polar(45.0 * static_cast<double>(sector), rim + 0.01), 0.01);
      }
      const Row row = rowsOf(states, scene.perception()).at(0);
      ASSERT_LT(row, states.terminal());
      ASSERT_EQ(states.distanceClasses(row), classes) << "row " << row;
      ++found[row];
    }
  }
  for (Row row = 0; row < states.terminal(); ++row) ASSERT_EQ(found[row], 1) << "row " << row;
  EXPECT_EQ(states.distanceClasses(states.terminal()), Classes{});
}

TEST(OccupancyStates, ReturnsOccupiedSectorsForPictures) {
  const OccupancyStates states;
  EXPECT_TRUE(states.occupiedSectors(agentAlone().perception()).empty());
  const PerceptionsBuilder scene = agentAlone().neighbour(polar(0.0, 0.7), 0.1).neighbour(polar(90.0, 0.4), 0.1);
  const auto occupied = states.occupiedSectors(scene.perception());
  ASSERT_EQ(occupied.size(), 2U);
  EXPECT_NEAR(occupied[0].from, toRadians(-22.5), 1e-9);
  EXPECT_NEAR(occupied[0].to, toRadians(22.5), 1e-9);
  EXPECT_EQ(occupied[0].distance_class, 2);
  EXPECT_NEAR(occupied[1].from, toRadians(67.5), 1e-9);
  EXPECT_NEAR(occupied[1].to, toRadians(112.5), 1e-9);
  EXPECT_EQ(occupied[1].distance_class, 1);
}

TEST(OccupancyStates, UsesItsParameters) {
  OccupancyStates::Parameters parameters;
  parameters.sectors = 4;
  parameters.distances = {0.25, 3.0};
  const OccupancyStates states(parameters);
  EXPECT_EQ(states.terminal(), 324U);                // 3^4 * 4
  EXPECT_EQ(states.rowOf({2, {1, 0, 0, 2}}), 191U);  // 2 * 81 + 27 + 2
  EXPECT_EQ(states.distanceClasses(191U), (Classes{1, 0, 0, 2}));
  EXPECT_EQ(states.distanceLimits(), (std::vector<double>{0.25, 3.0}));
  EXPECT_EQ(states.rowsPerPerception(), 1U);
  EXPECT_EQ(states.spec(), "{type: occupancy, sectors: 4, collision_radius: 0.25, vision_radius: 3}");
  // At the right, rim 2.9; goal behind.
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {-1.0, 0.0}).neighbour({0.0, -3.0}, 0.1);
  EXPECT_EQ(states.rowOf(states.describe(scene.perception())), 164U);  // 2 * 81 + 2
}

}  // namespace
}  // namespace crowd::occupancy_states_test
