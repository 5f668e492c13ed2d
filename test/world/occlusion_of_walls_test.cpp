// The visible parts of walls.

#include <gtest/gtest.h>

#include <vector>

#include "support/hidden_bodies.h"
#include "world/occlusion.h"

namespace crowd::occlusion_of_walls_test {
namespace {

using sceneries::BIG;
using sceneries::expectWalls;
using sceneries::look;
using sceneries::neighbour;
using sceneries::Scenery;

TEST(OcclusionOfWalls, BodyCutsTheWallBehindIt) {
  const Segment wall{{4.0, -6.0}, {4.0, 6.0}};
  expectWalls(look({{BIG}, {wall}}), {{{4.0, -6.0}, {4.0, -3.0}}, {{4.0, 3.0}, {4.0, 6.0}}});
  expectWalls(look({{BIG}, {{wall.to, wall.from}}}), {{{4.0, -3.0}, {4.0, -6.0}}, {{4.0, 6.0}, {4.0, 3.0}}});
  expectWalls(look({{BIG}, {{{4.0, -2.9}, {4.0, 2.9}}}}), {});
  expectWalls(look({{BIG}, {{{0.5, -6.0}, {0.5, 6.0}}}}), {{{0.5, -6.0}, {0.5, 6.0}}});  // it is in front
}

TEST(OcclusionOfWalls, BodyBehindTheAgentCutsTheWallBehindIt) {
  const Scenery seen = look({{neighbour({-2.0, 0.0}, 1.2)}, {{{-4.0, -6.0}, {-4.0, 6.0}}}});
  expectWalls(seen, {{{-4.0, 3.0}, {-4.0, 6.0}}, {{-4.0, -6.0}, {-4.0, -3.0}}});
}

TEST(OcclusionOfWalls, WallCutsTheWallBehindIt) {
  const Segment front{{2.0, 0.0}, {2.0, 1.0}};
  const Segment back{{4.0, -2.0}, {4.0, 1.0}};
  expectWalls(look({{}, {front, back}}), {front, {{4.0, -2.0}, {4.0, 0.0}}});
}

TEST(OcclusionOfWalls, CrossingWallsCutEachOther) {
  // They cross at (3, 0). The slanting wall is in front on the right, the other one on the left.
  const Segment slanting{{2.0, -2.0}, {4.0, 2.0}};
  const Segment across{{3.0, -3.0}, {3.0, 3.0}};
  expectWalls(look({{}, {slanting, across}}), {{{2.0, -2.0}, {3.0, 0.0}}, {{3.0, 0.0}, {3.0, 3.0}}});
}

TEST(OcclusionOfWalls, WallsOfACornerStayWhole) {
  const std::vector<Segment> corner = {{{2.0, -1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {-1.0, 1.0}}};
  expectWalls(look({{}, corner}), corner);
}

TEST(OcclusionOfWalls, EqualWallsAreBothVisible) {
  const std::vector<Segment> twice = {{{2.0, -1.0}, {2.0, 1.0}}, {{2.0, 1.0}, {2.0, -1.0}}};
  expectWalls(look({{}, twice}), twice);
}

TEST(OcclusionOfWalls, OmitsPartsBeyondTheRadiusOfVision) {
  // A disc hides a part of the wall beside the agent. The part behind it is more than 1.2 m away.
  const Segment wall{{0.0, 1.0}, {8.0, 1.0}};
  const Neighbour hiding = neighbour({0.6, 0.7}, 0.28);
  const Scenery seen = look({{hiding}, {wall}});
  ASSERT_EQ(seen.walls.size(), 2U);
  EXPECT_LT(distanceTo(seen.walls[1], Vector2::Zero()), distanceTo(seen.walls[0], Vector2::Zero()));
  expectWalls(look({{hiding}, {wall}}, 1.2), {seen.walls[1]});
}

}  // namespace
}  // namespace crowd::occlusion_of_walls_test
