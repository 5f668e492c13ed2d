#include "geometry/obstacle_path.h"

#include <gtest/gtest.h>

#include "common/random.h"
#include "social_crowd/errors.h"

namespace crowd::obstacle_path_test {
namespace {

void expectAt(const ObstaclePath& path, double t, const Vector2& position, const Vector2& velocity) {
  SCOPED_TRACE("t = " + std::to_string(t));
  EXPECT_NEAR(path.position(t).x(), position.x(), 1e-12);
  EXPECT_NEAR(path.position(t).y(), position.y(), 1e-12);
  EXPECT_NEAR(path.velocity(t).x(), velocity.x(), 1e-12);
  EXPECT_NEAR(path.velocity(t).y(), velocity.y(), 1e-12);
}

TEST(ObstaclePath, AtRestStays) {
  const ObstaclePath path = ObstaclePath::atRest({1.0, 2.0});
  EXPECT_FALSE(path.moves());
  expectAt(path, 0.0, {1.0, 2.0}, {0.0, 0.0});
  expectAt(path, 1e6, {1.0, 2.0}, {0.0, 0.0});
}

TEST(ObstaclePath, StraightContinuesWithoutEnd) {
  const ObstaclePath path = ObstaclePath::straight({0.0, -5.0}, {0.25, 0.5});
  EXPECT_TRUE(path.moves());
  expectAt(path, 0.0, {0.0, -5.0}, {0.25, 0.5});
  expectAt(path, 8.0, {2.0, -1.0}, {0.25, 0.5});
}

TEST(ObstaclePath, StraightWithoutVelocityIsAtRest) {
  EXPECT_EQ(ObstaclePath::straight({1.0, 2.0}, {0.0, 0.0}).kind(), ObstaclePath::Kind::AT_REST);
}

TEST(ObstaclePath, ToAndFroTurnsAtTheEnds) {
  // 4 m at 0.5 m/s: 8 s there, 8 s back.
  const ObstaclePath path = ObstaclePath::toAndFro({{0.0, -1.0}, {0.0, 3.0}}, 0.5);
  expectAt(path, 0.0, {0.0, -1.0}, {0.0, 0.5});
  expectAt(path, 2.0, {0.0, 0.0}, {0.0, 0.5});
  expectAt(path, 8.0, {0.0, 3.0}, {0.0, -0.5});
  expectAt(path, 12.0, {0.0, 1.0}, {0.0, -0.5});
  expectAt(path, 16.0, {0.0, -1.0}, {0.0, 0.5});
  expectAt(path, 18.0, {0.0, 0.0}, {0.0, 0.5});
}

TEST(ObstaclePath, ToAndFroReturnsThroughAllItsPoints) {
  // Legs of 3 m and 4 m at 1 m/s: 7 s there, 7 s back.
  const ObstaclePath path = ObstaclePath::toAndFro({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, 1.0);
  expectAt(path, 3.0, {3.0, 0.0}, {0.0, 1.0});
  expectAt(path, 5.0, {3.0, 2.0}, {0.0, 1.0});
  expectAt(path, 9.0, {3.0, 2.0}, {0.0, -1.0});
  expectAt(path, 12.0, {2.0, 0.0}, {-1.0, 0.0});
  expectAt(path, 15.0, {1.0, 0.0}, {1.0, 0.0});
}

TEST(ObstaclePath, LoopReturnsFromTheLastPointToTheFirst) {
  // A triangle of 3, 4 and 5 m at 2 m/s: a round takes 6 s.
  const ObstaclePath path = ObstaclePath::loop({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, 2.0);
  expectAt(path, 1.0, {2.0, 0.0}, {2.0, 0.0});
  expectAt(path, 2.5, {3.0, 2.0}, {0.0, 2.0});
  expectAt(path, 4.75, {1.5, 2.0}, {-1.2, -1.6});  // half of the 5 m
  expectAt(path, 7.0, {2.0, 0.0}, {2.0, 0.0});
}

TEST(ObstaclePath, SkipsRepeatedPoints) {
  const ObstaclePath path = ObstaclePath::loop({{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}}, 1.0);
  expectAt(path, 0.5, {0.5, 0.0}, {1.0, 0.0});
  expectAt(path, 1.5, {0.5, 0.0}, {-1.0, 0.0});
}

/// Compares a path with the one after a time that begins there.
void expectGoesOn(const ObstaclePath& path, double begin) {
  SCOPED_TRACE("begin = " + std::to_string(begin));
  const ObstaclePath after = path.after(begin);
  EXPECT_EQ(after.points().front(), path.position(begin));
  for (double t = 0.3; t < 20.0; t += 0.7) expectAt(after, t, path.position(begin + t), path.velocity(begin + t));
}

TEST(ObstaclePath, GoesOnAfterATimeAsBefore) {
  expectGoesOn(ObstaclePath::atRest({1.0, 2.0}), 3.0);
  expectGoesOn(ObstaclePath::straight({0.0, -5.0}, {0.25, 0.5}), 3.0);
  // Rounds of 12 m and 14 m; the first begin is at a point, the second between two points, the last in another round.
  const std::vector<Vector2> points{{0.0, 0.0}, {3.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}};
  for (const double begin : {3.0, 5.5, 8.0, 11.5, 47.25}) {
    expectGoesOn(ObstaclePath::loop(points, 1.0), begin);
    expectGoesOn(ObstaclePath::toAndFro(points, 1.0), begin);
  }
}

TEST(ObstaclePath, PathAfterATimeHasThePointsThatComeNextFirst) {
  const ObstaclePath path = ObstaclePath::toAndFro({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, 1.0);
  EXPECT_EQ(path.after(5.0).points(), (std::vector<Vector2>{{3, 2}, {3, 4}, {3, 0}, {0, 0}, {3, 0}}));
  EXPECT_EQ(path.after(3.0).points(), (std::vector<Vector2>{{3, 0}, {3, 4}, {3, 0}, {0, 0}}));
}

TEST(ObstaclePath, PathAfterATimeHasNoLegOfRoundingErrors) {
  const ObstaclePath path = ObstaclePath::toAndFro({{0.0, 0.0}, {2.1, 0.0}}, 0.3);
  for (const double begin : {21.0, 35.0, 49.0}) {
    const double left = 2.1 - path.position(begin).x();
    ASSERT_TRUE(left > 0.0 && left < 1e-12) << left;  // otherwise this tests nothing
    const std::vector<Vector2> points = path.after(begin).points();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points.front(), path.position(begin));
    EXPECT_EQ(points.back(), Vector2(0.0, 0.0));
  }
  // At the end of the last leg, too: the first point comes next.
  const ObstaclePath round = ObstaclePath::loop({{2.1, 0.0}, {0.0, 0.0}}, 0.3);
  EXPECT_EQ(round.after(14.0 - 1e-12).points().size(), 2U);
}

TEST(ObstaclePath, RequiresTwoDifferentPointsAndASpeed) {
  EXPECT_THROW(ObstaclePath::toAndFro({}, 1.0), InputError);
  EXPECT_THROW(ObstaclePath::toAndFro({{1.0, 1.0}}, 1.0), InputError);
  EXPECT_THROW(ObstaclePath::loop({{1.0, 1.0}, {1.0, 1.0}}, 1.0), InputError);
  EXPECT_THROW(ObstaclePath::loop({{0.0, 0.0}, {1.0, 1.0}}, 0.0), InputError);
}

TEST(ObstaclePath, MovesWithItsVelocityAndAtMostAtItsSpeed) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<Vector2> points;
    const std::uint32_t count = 1 + random.below(5);
    for (std::uint32_t i = 0; i < count; ++i) {
      const double x = random.uniform(-5.0, 5.0);
      points.emplace_back(x, random.uniform(-5.0, 5.0));
    }
    points.emplace_back(7.0, 7.0);
    const double speed = random.uniform(0.1, 2.0);
    const ObstaclePath path = seed % 2 == 0 ? ObstaclePath::loop(points, speed) : ObstaclePath::toAndFro(points, speed);
    int turns = 0;
    for (int tick = 0; tick < 1000; ++tick) {
      const double t = 0.1 * tick;
      const Vector2 step = path.position(t + 0.1) - path.position(t);
      EXPECT_LE(step.norm(), 0.1 * speed + 1e-9);
      EXPECT_NEAR(path.velocity(t).norm(), speed, 1e-9);
      turns += (step - 0.1 * path.velocity(t)).norm() > 1e-9 ? 1 : 0;
    }
    EXPECT_LT(turns, 200);  // straight but for the corners
  }
}

}  // namespace
}  // namespace crowd::obstacle_path_test
