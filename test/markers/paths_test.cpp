#include <gtest/gtest.h>

#include "ros/markers/marker_paths.h"

namespace crowd::paths_test {
namespace {

/// A walk of one metre a second along x, seen each second for 10 s, of which 4 s are shown.
WalkedPaths walkOf10() {
  WalkedPaths paths(0.05, 1000);
  for (int second = 0; second <= 10; ++second) {
    paths.setTimes(second, 4.0);
    paths.add(0, Vector2(second, 0.0));
  }
  return paths;
}

TEST(PathTime, IsShorterForManyWalkers) {
  EXPECT_DOUBLE_EQ(pathTimeFor(0), 600.0);
  EXPECT_DOUBLE_EQ(pathTimeFor(6), 100.0);
  EXPECT_DOUBLE_EQ(pathTimeFor(50), 12.0);
  EXPECT_DOUBLE_EQ(pathTimeFor(1000), 2.5);
}

TEST(WalkedPaths, FadeWithAge) {
  const WalkedPaths paths = walkOf10();
  EXPECT_DOUBLE_EQ(paths.strengthAt(10.0), 1.0);
  EXPECT_DOUBLE_EQ(paths.strengthAt(9.0), 0.75);
  EXPECT_DOUBLE_EQ(paths.strengthAt(6.0), 0.0);
  EXPECT_DOUBLE_EQ(paths.strengthAt(1.0), 0.0);
}

TEST(WalkedPaths, SettlingRemovesOldPoints) {
  WalkedPaths paths = walkOf10();
  EXPECT_EQ(paths.paths().at(0).points.size(), 11U);
  paths.settle();
  ASSERT_EQ(paths.paths().at(0).points.size(), 4U);  // those of the seconds 7 to 10
  EXPECT_EQ(paths.paths().at(0).points.front().position.x(), 7.0);
  EXPECT_EQ(paths.paths().at(0).settled, 4U);
}

TEST(WalkedPaths, OneWhoStandsKeepsOnePoint) {
  WalkedPaths paths = walkOf10();
  for (int second = 11; second <= 30; ++second) {
    paths.setTimes(second, 4.0);
    paths.add(0, Vector2(10.0, 0.0));
  }
  paths.settle();
  ASSERT_EQ(paths.paths().at(0).points.size(), 1U);
  EXPECT_EQ(paths.paths().at(0).points.front().position.x(), 10.0);
}

TEST(WalkedPaths, AreDrawnAgainWhenTheyHaveFaded) {
  WalkedPaths paths = walkOf10();
  paths.settle();
  EXPECT_FALSE(paths.isUnsettled());
  paths.setTimes(10.3, 4.0);
  EXPECT_FALSE(paths.isUnsettled());
  paths.setTimes(10.4, 4.0);  // a tenth of the time for which they are shown
  EXPECT_TRUE(paths.isUnsettled());
}

TEST(WalkedPaths, RemovedPointsDoNotCount) {
  WalkedPaths paths(0.05, 10);  // thinned if there were more than 10 points
  for (int second = 0; second <= 100; ++second) {
    paths.setTimes(second, 4.0);
    paths.add(0, Vector2(second, 0.0));
    paths.settle();
  }
  const auto& points = paths.paths().at(0).points;
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[1].position.x() - points[0].position.x(), 1.0);
}

/// Every second one comes and walks for 3 s. The first one stands all the time.
TEST(WalkedPaths, ThoseWhoHaveLeftAreForgottenWhenTheyHaveFaded) {
  WalkedPaths paths(0.05, 1000);
  for (std::uint32_t second = 1; second <= 100; ++second) {
    paths.setTimes(second, 4.0);
    paths.add(0, Vector2::Zero());
    for (std::uint32_t walker = second < 3 ? 1 : second - 2; walker <= second; ++walker) {
      paths.add(walker, Vector2(second, walker));
    }
    paths.settle();
    ASSERT_LE(paths.paths().size(), 7U);
    ASSERT_EQ(paths.paths().count(0), 1U);
    if (second > 5) ASSERT_EQ(paths.paths().count(second - 5), 1U);  // it left 3 s ago
  }
  EXPECT_EQ(paths.paths().count(94), 0U);
}

}  // namespace
}  // namespace crowd::paths_test
