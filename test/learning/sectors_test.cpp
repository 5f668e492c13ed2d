#include "learning/states/sectors.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/sector_cases.h"

namespace crowd::sectors_test {
namespace {

using sector_cases::SectorCase;

constexpr double HAIR = 1e-9;  // [rad]

TEST(EvenSectors, EightSectorsAreCentredOnTheEightRotations) {
  const EvenSectors sectors(8);
  EXPECT_EQ(sectors.count(), 8);
  EXPECT_DOUBLE_EQ(sectors.width(), toRadians(45.0));
  for (const SectorCase& edge : std::vector<SectorCase>{
           {0.0, 0},    {22.4, 0},   {22.6, 1},   {45.0, 1},    {67.4, 1},    {67.6, 2},   {90.0, 2},   {112.4, 2},
           {112.6, 3},  {135.0, 3},  {157.4, 3},  {157.6, 4},   {180.0, 4},   {-180.0, 4}, {-157.6, 4}, {-157.4, 5},
           {-135.0, 5}, {-112.6, 5}, {-112.4, 6}, {-90.0, 6},   {-67.6, 6},   {-67.4, 7},  {-45.0, 7},  {-22.6, 7},
           {-22.4, 0},  {202.4, 4},  {202.6, 5},  {337.4, 7},   {337.6, 0},   {360.0, 0},  {382.4, 0},  {382.6, 1},
           {765.0, 1},  {-360.0, 0}, {-382.6, 7}, {-3600.0, 0}, {-3555.0, 1}, {-3645.0, 7}}) {
    EXPECT_EQ(sectors.indexOf(toRadians(edge.degrees)), edge.sector) << edge.degrees << " degrees";
  }
}

TEST(EvenSectors, ContainTheirRightLimitButNotTheirLeftOne) {
  const EvenSectors sectors(8);
  for (int index = -3; index <= 4; ++index) {  // one turn, as bearings come: -157.5 to 157.5 degrees
    const int sector = index < 0 ? index + 8 : index;
    EXPECT_EQ(sectors.indexOf(sectors.rightLimit(index)), sector);
    EXPECT_EQ(sectors.indexOf(sectors.rightLimit(index + 1) - HAIR), sector);
  }
}

TEST(EvenSectors, ReturnTheirLimits) {
  const EvenSectors sectors(8);
  EXPECT_NEAR(sectors.rightLimit(0), toRadians(-22.5), HAIR);
  EXPECT_NEAR(sectors.rightLimit(1), toRadians(22.5), HAIR);
  EXPECT_NEAR(sectors.rightLimit(7), toRadians(292.5), HAIR);
  EXPECT_NEAR(sectors.rightLimit(-1), toRadians(-67.5), HAIR);
}

TEST(EvenSectors, AcceptAnyNumberOfSectors) {
  EXPECT_EQ(EvenSectors(1).indexOf(PI), 0);
  EXPECT_EQ(EvenSectors(1).indexOf(-3.0), 0);
  EXPECT_EQ(EvenSectors(2).indexOf(toRadians(89.9)), 0);
  EXPECT_EQ(EvenSectors(2).indexOf(toRadians(90.1)), 1);
  EXPECT_EQ(EvenSectors(2).indexOf(toRadians(-90.1)), 1);
  EXPECT_EQ(EvenSectors(2).indexOf(toRadians(-89.9)), 0);
  EXPECT_EQ(EvenSectors(3).indexOf(toRadians(59.9)), 0);
  EXPECT_EQ(EvenSectors(3).indexOf(toRadians(60.1)), 1);
  EXPECT_EQ(EvenSectors(3).indexOf(toRadians(179.9)), 1);
  EXPECT_EQ(EvenSectors(3).indexOf(toRadians(-179.9)), 2);
  EXPECT_EQ(EvenSectors(12).indexOf(toRadians(14.9)), 0);
  EXPECT_EQ(EvenSectors(12).indexOf(toRadians(15.1)), 1);
  EXPECT_EQ(EvenSectors(12).indexOf(toRadians(-15.1)), 11);
}

TEST(EvenSectors, NumberSectorsOverSeveralTurns) {
  const EvenSectors sectors(8);
  EXPECT_EQ(sectors.unwrappedIndexOf(toRadians(-22.6)), -1);
  EXPECT_EQ(sectors.unwrappedIndexOf(toRadians(-360.0)), -8);
  EXPECT_EQ(sectors.unwrappedIndexOf(toRadians(382.6)), 9);
  EXPECT_EQ(sectors.wrap(0), 0);
  EXPECT_EQ(sectors.wrap(7), 7);
  EXPECT_EQ(sectors.wrap(8), 0);
  EXPECT_EQ(sectors.wrap(17), 1);
  EXPECT_EQ(sectors.wrap(-1), 7);
  EXPECT_EQ(sectors.wrap(-8), 0);
  EXPECT_EQ(sectors.wrap(-17), 7);
}

/// Sectors like those of figure 3.6 of the thesis, narrower in front: 15, 45, 90 and 180 degrees to either side.
MirroredSectors thesisSectors() { return MirroredSectors({15.0, 45.0, 90.0, 180.0}); }

TEST(MirroredSectors, AreFinerInFront) {
  const MirroredSectors sectors = thesisSectors();
  EXPECT_EQ(sectors.count(), 8);
  for (const SectorCase& edge : sector_cases::UNEVEN) {
    EXPECT_EQ(sectors.indexOf(toRadians(edge.degrees)), edge.sector) << edge.degrees << " degrees";
  }
}

TEST(MirroredSectors, AssignLimitsToTheRearSectorAndStraightAheadToTheLeft) {
  const MirroredSectors sectors = thesisSectors();
  EXPECT_EQ(sectors.indexOf(0.0), 0);
  EXPECT_EQ(sectors.indexOf(-0.0), 0);
  EXPECT_EQ(sectors.indexOf(toRadians(15.0)), 1);
  EXPECT_EQ(sectors.indexOf(toRadians(45.0)), 2);
  EXPECT_EQ(sectors.indexOf(toRadians(90.0)), 3);
  EXPECT_EQ(sectors.indexOf(PI), 3);
  EXPECT_EQ(sectors.indexOf(toRadians(-15.0)), 5);
  EXPECT_EQ(sectors.indexOf(toRadians(-45.0)), 6);
  EXPECT_EQ(sectors.indexOf(toRadians(-90.0)), 7);
}

TEST(MirroredSectors, ReturnTheirLimits) {
  const MirroredSectors sectors = thesisSectors();
  const std::array<double, 8> right = {0.0, 15.0, 45.0, 90.0, -15.0, -45.0, -90.0, -180.0};
  const std::array<double, 8> left = {15.0, 45.0, 90.0, 180.0, 0.0, -15.0, -45.0, -90.0};
  for (int sector = 0; sector < 8; ++sector) {
    EXPECT_NEAR(sectors.rightLimit(sector), toRadians(right.at(sector)), HAIR) << sector;
    EXPECT_NEAR(sectors.leftLimit(sector), toRadians(left.at(sector)), HAIR) << sector;
  }
}

TEST(MirroredSectors, CanBeOnlyLeftAndRight) {
  const MirroredSectors sectors({180.0});
  EXPECT_EQ(sectors.count(), 2);
  EXPECT_EQ(sectors.indexOf(3.0), 0);
  EXPECT_EQ(sectors.indexOf(PI), 0);
  EXPECT_EQ(sectors.indexOf(-3.0), 1);
}

}  // namespace
}  // namespace crowd::sectors_test
