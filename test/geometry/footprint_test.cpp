#include "geometry/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::footprint_test {
namespace {

Footprint polygon(std::vector<Vector2> corners) { return {0.0, std::move(corners)}; }

const std::vector<Vector2> SQUARE = {{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}};
/// A square of 2 m without its upper right quarter.
const std::vector<Vector2> L_SHAPE = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}, {-1.0, 1.0}};

TEST(Footprint, DistanceToPoints) {
  const Footprint square = polygon(SQUARE);
  EXPECT_NEAR(distance(square, Pose(), Vector2(1.0, 0.0)), 0.5, 1e-15);
  EXPECT_NEAR(distance(square, Pose(), Vector2(1.0, 1.0)), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(distance(square, Pose(), Vector2(0.2, 0.0)), -0.3, 1e-15);
  // Turned by 45 degrees, a corner points along x.
  EXPECT_NEAR(distance(square, {{3.0, 0.0}, PI / 4.0}, Vector2(4.0, 0.0)), 1.0 - std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(distance(Footprint{0.3, {}}, {{1.0, 0.0}, 2.0}, Vector2(1.0, 1.0)), 0.7, 1e-15);
}

TEST(Footprint, MayBeConcave) {
  const Footprint shape = polygon(L_SHAPE);
  EXPECT_NEAR(distance(shape, Pose(), Vector2(0.3, 0.4)), 0.3, 1e-15);  // in the notch
  EXPECT_NEAR(distance(shape, Pose(), Vector2(-0.2, 0.5)), -0.2, 1e-15);
  EXPECT_EQ(problemOf(L_SHAPE), "");
  EXPECT_NEAR(shape.reach(), std::sqrt(2.0), 1e-15);
}

TEST(Footprint, DistanceToSegments) {
  const Footprint square = polygon(SQUARE);
  EXPECT_NEAR(distance(square, Pose(), Segment{{0.8, -3.0}, {0.8, 3.0}}), 0.3, 1e-15);
  EXPECT_NEAR(distance(square, Pose(), Segment{{0.9, 0.8}, {3.0, 4.0}}), 0.5, 1e-15);  // 0.4 and 0.3 from a corner
  EXPECT_EQ(distance(square, Pose(), Segment{{-3.0, 0.0}, {3.0, 0.1}}), 0.0);
  EXPECT_EQ(distance(square, Pose(), Segment{{-0.1, 0.0}, {0.1, 0.1}}), 0.0);  // within
  EXPECT_NEAR(distance(Footprint{0.3, {}}, Pose(), Segment{{0.2, -1.0}, {0.2, 1.0}}), -0.1, 1e-15);
}

TEST(Footprint, DistanceBetweenFootprints) {
  const Footprint square = polygon(SQUARE);
  const Footprint disc{0.3, {}};
  EXPECT_NEAR(distance(square, Pose(), square, {{1.4, 0.2}, 0.0}), 0.4, 1e-15);
  EXPECT_NEAR(distance(square, Pose(), square, {{2.0, 0.0}, PI / 4.0}), 1.5 - std::sqrt(0.5), 1e-15);
  EXPECT_LE(distance(square, Pose(), square, {{0.9, 0.0}, 0.0}), 0.0);
  EXPECT_LE(distance(polygon({{0.1, 0.1}, {-0.1, 0.1}, {0.0, -0.1}}), Pose(), square, Pose()), 0.0);  // within
  EXPECT_LE(distance(square, Pose(), polygon({{0.1, 0.1}, {-0.1, 0.1}, {0.0, -0.1}}), Pose()), 0.0);
  EXPECT_NEAR(distance(disc, {{2.0, 0.0}, 0.0}, square, Pose()), 1.2, 1e-15);
  EXPECT_NEAR(distance(square, Pose(), disc, {{2.0, 0.0}, 0.0}), 1.2, 1e-15);
  EXPECT_NEAR(distance(disc, Pose(), disc, {{2.0, 0.0}, 0.0}), 1.4, 1e-15);
}

TEST(Footprint, RefusesPolygonsThatAreNone) {
  EXPECT_EQ(problemOf({{0.0, 0.0}, {1.0, 0.0}}), "expected at least 3 corners, got 2");
  EXPECT_EQ(problemOf({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}),
            "expected a polygon that does not cross itself, but edges 0-1 and 2-3 cross");
  EXPECT_EQ(problemOf({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}), "corner 1 and the next are the same");
  EXPECT_EQ(problemOf({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}),
            "expected a polygon with an area, got corners on one line");
  EXPECT_EQ(problemOf(SQUARE), "");
}

}  // namespace
}  // namespace crowd::footprint_test
