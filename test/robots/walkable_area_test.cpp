#include "robots/metrics/walkable_area.h"

#include <gtest/gtest.h>

#include "robots/robot_monitor.h"
#include "support/robots.h"

namespace crowd::robots::walkable_area_test {
namespace {

const Eigen::AlignedBox2d USED(Vector2(-3.0, -1.0), Vector2(3.0, 1.0));  // 12 m^2

/// The walls of a rectangle about the origin.
std::vector<Segment> rectangle(double half_width, double half_height) {
  const Vector2 a(half_width, half_height);
  const Vector2 b(-half_width, half_height);
  return {{a, b}, {b, -a}, {-a, -b}, {-b, a}};
}

double areaOf(const Scene& scene, const Vector2& place, const std::vector<Segment>& gates = {}) {
  const World world(scene);
  ObservedScene observed;
  observed.observe(world);
  return WalkableArea(observed, gates, place).size(USED);
}

TEST(WalkableArea, InTheOpenIsTheRectangleThatIsUsed) { EXPECT_EQ(areaOf(scene({}), {0.0, 0.0}), 12.0); }

TEST(WalkableArea, OfARoomIsThatBetweenItsWalls) {
  // 10 m x 6 m, without 0.1 m at each wall: 9.8 x 5.8 = 56.84 m^2. The points are 0.1 m apart: an error of up to half
  // of that along the boundary of 31.2 m, and of the disc below, 6.9 m.
  EXPECT_NEAR(areaOf(scene({}, {}, rectangle(5.0, 3.0)), {0.0, 0.0}), 9.8 * 5.8, 1.6);
  // A pillar of 1 m takes the disc of 1.1 m away.
  const Scene with_pillar = scene({}, {scenes::pillar({2.0, 0.0}, 1.0)}, rectangle(5.0, 3.0));
  EXPECT_NEAR(areaOf(with_pillar, {0.0, 0.0}), 9.8 * 5.8 - PI * 1.1 * 1.1, 2.0);
}

TEST(WalkableArea, IsOnOneSideOfAWallUnlessItIsAGate) {
  std::vector<Segment> walls = rectangle(5.0, 3.0);
  const Segment across{{1.0, -3.0}, {1.0, 3.0}};
  walls.push_back(across);
  EXPECT_NEAR(areaOf(scene({}, {}, walls), {0.0, 0.0}), 5.8 * 5.8, 1.2);
  EXPECT_NEAR(areaOf(scene({}, {}, walls), {3.0, 0.0}), 3.8 * 5.8, 1.0);
  EXPECT_NEAR(areaOf(scene({}, {}, walls), {3.0, 0.0}, {across}), 9.8 * 5.8, 1.6);
}

TEST(WalkableArea, ThatIsNotEnclosedIsInTheRectangle) {
  // Two walls along y = +-0.5 that end at x = +-20: of the rectangle, 6 m x 0.8 m are between them.
  const Scene corridor = scene({}, {}, {{{-20.0, 0.5}, {20.0, 0.5}}, {{-20.0, -0.5}, {20.0, -0.5}}});
  // The floor beside the walls is connected with it, round their ends: 2 x 6 x (0.5 - 0.1) more.
  EXPECT_NEAR(areaOf(corridor, {0.0, 0.0}), 6.0 * 0.8 + 2.0 * 6.0 * 0.4, 1.5);
}

TEST(WalkableArea, ALongDiagonalWallHasNoHoles) {
  std::vector<Segment> walls = rectangle(5.0, 5.0);
  walls.push_back({{-5.0, -5.0}, {5.0, 5.0}});
  EXPECT_LT(areaOf(scene({}, {}, walls), {2.0, -2.0}), 50.0);
}

TEST(PeopleDensity, IsTheMeanNumberOfPeoplePerSquareMetre) {
  // Three people who stand in the room of 9.8 m x 5.8 m; the robot stands, too.
  Scene made = with({robotTo({4.0, 0.0}, {-4.0, 0.0})},
                    scene({wanderer({0.0, 2.0}), wanderer({1.0, 2.0}), wanderer({2.0, 2.0})}, {}, rectangle(5.0, 3.0)));
  World world(made);
  RobotMonitor monitor(made, world);
  for (int tick = 0; tick < 4; ++tick) {
    world.step({});
    monitor.observe(world);
  }
  EXPECT_NEAR(monitor.results().at(0).people_density, 3.0 / (9.8 * 5.8), 0.002);
}

}  // namespace
}  // namespace crowd::robots::walkable_area_test
