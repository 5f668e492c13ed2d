#include "population/route_follower.h"

#include <gtest/gtest.h>

#include <array>

namespace crowd::route_follower_test {
namespace {

using Kind = WaypointDescription::Kind;

KeyedRandom randomOf(std::uint64_t seed) { return {seed, KeyedRandom::POPULATION, {}}; }

WaypointDescription place(double x, const Range& wait = {}) {
  WaypointDescription waypoint;
  waypoint.place.first = {x, 0.0};
  waypoint.wait = wait;
  return waypoint;
}

RouteDescription routeOf(std::vector<WaypointDescription> waypoints, bool repeat = false) {
  RouteDescription route;
  route.waypoints = std::move(waypoints);
  route.repeat = repeat;
  return route;
}

double xOf(const RouteFollower& follower) { return follower.waypoint().place.first.x(); }

TEST(RouteFollower, VisitsTheWaypointsInTheirOrder) {
  const RouteDescription route = routeOf({place(1.0), place(2.0)});
  RouteFollower follower(route, randomOf(1));
  EXPECT_EQ(xOf(follower), 1.0);
  EXPECT_EQ(follower.passed(), 0U);
  EXPECT_TRUE(follower.advance());
  EXPECT_EQ(xOf(follower), 2.0);
  EXPECT_EQ(follower.passed(), 1U);
  EXPECT_FALSE(follower.advance());
  EXPECT_EQ(follower.passed(), 2U);
}

TEST(RouteFollower, BeginsAgain) {
  const RouteDescription route = routeOf({place(1.0), place(2.0)}, true);
  RouteFollower follower(route, randomOf(1));
  for (int i = 0; i < 7; ++i) ASSERT_TRUE(follower.advance());
  EXPECT_EQ(xOf(follower), 2.0);
  EXPECT_EQ(follower.passed(), 7U);
  EXPECT_TRUE(follower.repeats());
}

TEST(RouteFollower, WaitsAsLongAsTheWaypointSays) {
  const RouteDescription route = routeOf({place(1.0, {5.0, 5.0}), place(2.0)});
  RouteFollower follower(route, randomOf(1));
  EXPECT_FALSE(follower.isWaiting());
  EXPECT_FALSE(follower.hasWaited(100.0));
  follower.beginWait(10.0);
  EXPECT_TRUE(follower.isWaiting());
  EXPECT_FALSE(follower.hasWaited(14.9));
  EXPECT_TRUE(follower.hasWaited(15.0));
  follower.advance();
  EXPECT_FALSE(follower.isWaiting());
  follower.beginWait(20.0);
  EXPECT_TRUE(follower.hasWaited(20.0));
}

TEST(RouteFollower, DrawsWaitsFromTheirRange) {
  const RouteDescription route = routeOf({place(1.0, {5.0, 20.0})}, true);
  RouteFollower follower(route, randomOf(3));
  int short_waits = 0;
  for (int i = 0; i < 300; ++i) {
    follower.beginWait(0.0);
    EXPECT_FALSE(follower.hasWaited(4.9));
    EXPECT_TRUE(follower.hasWaited(20.0));
    short_waits += follower.hasWaited(12.5) ? 1 : 0;
    follower.advance();
  }
  EXPECT_NEAR(short_waits, 150, 40);
}

TEST(RouteFollower, DrawsAnAlternativeEachTime) {
  WaypointDescription either;
  either.kind = Kind::ONE_OF;
  either.alternatives = {place(1.0), place(2.0), place(3.0)};
  const RouteDescription route = routeOf({either}, true);
  RouteFollower follower(route, randomOf(5));
  RouteFollower same(route, randomOf(5));
  std::array<int, 4> visits{};
  for (int i = 0; i < 600; ++i) {
    ++visits.at(static_cast<std::size_t>(xOf(follower)));
    EXPECT_EQ(xOf(follower), xOf(same));
    follower.advance();
    same.advance();
  }
  for (std::size_t i = 1; i <= 3; ++i) EXPECT_NEAR(visits.at(i), 200, 50);
}

TEST(RouteFollower, EachLegHasItsRandomNumbers) {
  const RouteDescription route = routeOf({place(1.0)}, true);
  RouteFollower follower(route, randomOf(5));
  const std::uint64_t first = follower.random().next();
  EXPECT_EQ(follower.random().next(), first);
  follower.advance();
  EXPECT_NE(follower.random().next(), first);
}

}  // namespace
}  // namespace crowd::route_follower_test
