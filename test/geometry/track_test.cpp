#include "geometry/track.h"

#include <gtest/gtest.h>

#include "geometry/obstacle_path.h"
#include "social_crowd/errors.h"

namespace crowd::track_test {
namespace {

/// 1 m east in 2 s, then 2 m north in 1 s.
Track corner() { return Track({1.0, 3.0, 4.0}, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}}); }

void expectAt(const Track& track, double t, const Vector2& position, const Vector2& velocity) {
  SCOPED_TRACE("t = " + std::to_string(t));
  EXPECT_LT((track.at(t).position - position).norm(), 1e-12);
  EXPECT_LT((track.at(t).velocity - velocity).norm(), 1e-12);
}

TEST(Track, IsStraightBetweenTwoTimes) {
  const Track track = corner();
  expectAt(track, 1.0, {0.0, 0.0}, {0.5, 0.0});
  expectAt(track, 2.0, {0.5, 0.0}, {0.5, 0.0});
  expectAt(track, 3.0, {1.0, 0.0}, {0.0, 2.0});  // the velocity is that of the leg that begins
  expectAt(track, 3.75, {1.0, 1.5}, {0.0, 2.0});
  expectAt(track, 4.0, {1.0, 2.0}, {0.0, 2.0});
  EXPECT_EQ(track.maxSpeed(), 2.0);
  EXPECT_DOUBLE_EQ(track.walked(3.75), 2.5);
}

TEST(Track, PlacesOfItsTimesAreExact) {
  const Track track({0.1, 0.2, 0.30000000000000004}, {{0.1, 0.7}, {1.3, 1.1}, {1e5, 0.3}});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(track.at(track.times()[i]).position, track.places()[i]);
}

TEST(Track, IsPresentFromTheFirstTimeToTheLast) {
  const Track track = corner();
  for (const double t : {1.0, 2.0, 4.0}) EXPECT_TRUE(track.isPresent(t)) << t;
  for (const double t : {0.0, 0.999, 4.001}) EXPECT_FALSE(track.isPresent(t)) << t;
  expectAt(track, 0.0, {0.0, 0.0}, {0.5, 0.0});
  expectAt(track, 9.0, {1.0, 2.0}, {0.0, 2.0});
}

TEST(Track, OfASingleTimeStands) {
  const Track track({2.0}, {{3.0, 4.0}});
  expectAt(track, 2.0, {3.0, 4.0}, {0.0, 0.0});
  EXPECT_TRUE(track.isPresent(2.0));
  EXPECT_FALSE(track.isPresent(2.1));
  EXPECT_EQ(track.maxSpeed(), 0.0);
}

TEST(Track, RequiresAscendingTimesAndAPlaceForEach) {
  EXPECT_THROW(Track({}, {}), InputError);
  EXPECT_THROW(Track({1.0}, {{0.0, 0.0}, {1.0, 0.0}}), InputError);
  EXPECT_THROW(Track({1.0, 1.0}, {{0.0, 0.0}, {1.0, 0.0}}), InputError);
  EXPECT_THROW(Track({1.0, 0.5}, {{0.0, 0.0}, {1.0, 0.0}}), InputError);
}

TEST(Track, ARecordedPathIsThereDuringTheTrackOnly) {
  const ObstaclePath path = ObstaclePath::recorded(std::make_shared<const Track>(corner()));
  EXPECT_EQ(path.kind(), ObstaclePath::Kind::RECORDED);
  EXPECT_TRUE(path.moves());
  EXPECT_FALSE(path.isPresent(0.5));
  EXPECT_TRUE(path.isPresent(1.5));
  EXPECT_EQ(path.speed(), 2.0);
  EXPECT_EQ(path.position(2.0), Vector2(0.5, 0.0));
  EXPECT_TRUE(ObstaclePath::atRest({0.0, 0.0}).isPresent(1e9));
  // After 2 s the rest of it begins.
  const ObstaclePath after = path.after(2.0);
  EXPECT_EQ(after.track()->times(), (std::vector<double>{-1.0, 1.0, 2.0}));
  EXPECT_EQ(after.position(0.0), Vector2(0.5, 0.0));
  EXPECT_FALSE(after.isPresent(2.5));
}

}  // namespace
}  // namespace crowd::track_test
