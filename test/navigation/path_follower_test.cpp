#include "navigation/path_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/floors.h"

namespace crowd::path_follower_test {
namespace {

using State = PathFollower::State;

constexpr double CLEARANCE = 0.3;
const Vector2 START(-3.0, 0.0);
const Vector2 GOAL(3.0, 0.0);

double remainingLength(const PathFollower& follower, const Vector2& position) {
  return floors::lengthOf(position, {{follower.corners().begin(), follower.corners().end()}, 0.0});
}

/// A room with a door from y = 2 to y = 3.2, between START and GOAL.
class PathFollowerTest : public testing::Test {
 protected:
  FloorPlan floor_ = floors::roomWithDoor(1.2, 2.6);
  NavigationMesh mesh_{floor_, CLEARANCE};
  NavigationMesh::Query query_{mesh_};
};

TEST_F(PathFollowerTest, LeadsToTheDoorAndThenToTheGoal) {
  PathFollower follower(GOAL);
  EXPECT_EQ(follower.corners().size(), 0U);
  const Vector2 next = follower.next(START, query_);
  EXPECT_EQ(follower.state(), State::ON_THE_WAY);
  EXPECT_NEAR(next.x(), 0.0, 0.6);
  EXPECT_NEAR(next.y(), 2.3, 0.2);
  EXPECT_GT(follower.corners().size(), 1U);
  EXPECT_NEAR(remainingLength(follower, START), query_.findPath(START, GOAL)->length, 1e-9);

  Vector2 position = START;
  double walked = 0.0;
  double nearest = 1.0;
  for (int tick = 0; tick < 200 && (position - GOAL).norm() > 0.05; ++tick) {
    const Vector2 way = follower.next(position, query_) - position;
    const Vector2 step = way * std::min(1.0, 0.1 / way.norm());
    nearest = std::min(nearest, floors::clearanceAlong(floor_, position, position + step));
    position += step;
    walked += step.norm();
  }
  EXPECT_LE((position - GOAL).norm(), 0.05);
  EXPECT_NEAR(walked, query_.findPath(START, GOAL)->length, 0.1);
  EXPECT_GE(nearest, CLEARANCE - 0.1);  // corners are reached at 0.1 m
  EXPECT_EQ(follower.next(GOAL, query_), GOAL);
}

TEST_F(PathFollowerTest, APersonThatWasPushedAwayGetsANewWay) {
  PathFollower follower(GOAL);
  Vector2 position(1.0, 2.0);  // behind the door
  EXPECT_EQ(follower.next(position, query_), GOAL);
  position = START;
  const Vector2 next = follower.next(position, query_);
  EXPECT_NE(next, GOAL);
  EXPECT_TRUE(query_.isStraight(position, next));
  EXPECT_NEAR(remainingLength(follower, position), query_.findPath(position, GOAL)->length, 1e-9);
}

/// A room with doors from y = 2 to 3.2 and from y = -3.2 to -2, and a wall between them, with a gap, in the left half.
FloorPlan roomWithTwoDoors() {
  FloorPlan floor = floors::room({-5.0, -4.0}, {5.0, 4.0});
  for (const Vector2& ys : {Vector2(-4.0, -3.2), Vector2(-2.0, 2.0), Vector2(3.2, 4.0)}) {
    floor.walls.push_back({{0.0, ys.x()}, {0.0, ys.y()}});
  }
  floor.walls.push_back({{-5.0, -1.0}, {-0.8, -1.0}});
  return floor;
}

TEST_F(PathFollowerTest, APersonThatWasPushedAsideReturnsToItsWay) {
  const NavigationMesh mesh(roomWithTwoDoors(), CLEARANCE);
  NavigationMesh::Query query(mesh);
  PathFollower follower(GOAL);
  const Vector2 door = follower.next(Vector2(-3.0, 0.5), query);
  EXPECT_GT(door.y(), 1.0);
  const Vector2 pushed(-1.2, -1.4);  // the wall hides the door; the way back is 1.1 times as long as the straight line
  EXPECT_FALSE(query.isStraight(pushed, door));
  EXPECT_GT(follower.next(pushed, query).y(), -1.4);
  const Span<Vector2> corners = follower.corners();
  EXPECT_EQ(std::count(corners.begin(), corners.end(), door), 1);
  EXPECT_EQ(corners[corners.size() - 1], GOAL);
}

TEST_F(PathFollowerTest, APersonThatWasPushedThroughAGapTakesTheShorterWay) {
  const NavigationMesh mesh(roomWithTwoDoors(), CLEARANCE);
  NavigationMesh::Query query(mesh);
  PathFollower follower(GOAL);
  EXPECT_GT(follower.next(Vector2(-3.0, 0.5), query).y(), 1.0);
  const Vector2 pushed(-4.5, -1.6);  // behind the wall
  EXPECT_LT(follower.next(pushed, query).y(), -1.0);
  EXPECT_NEAR(remainingLength(follower, pushed), query.findPath(pushed, GOAL)->length, 1e-9);
}

/// Between two walls 0.5 m apart there is no mesh, and the door is out of sight.
TEST_F(PathFollowerTest, InAPocketTheWayIsKept) {
  FloorPlan floor = floor_;
  for (const double x : {-3.25, -2.75}) floor.walls.push_back({{x, -3.9}, {x, -1.5}});
  const NavigationMesh mesh(floor, CLEARANCE);
  NavigationMesh::Query query(mesh);
  PathFollower follower(GOAL);
  const Vector2 door = follower.next(START, query);
  EXPECT_EQ(follower.state(), State::ON_THE_WAY);
  EXPECT_EQ(follower.next({-3.0, -3.0}, query), door);
  EXPECT_EQ(follower.state(), State::IN_POCKET);
  follower.next({-3.0, -1.0}, query);
  EXPECT_EQ(follower.state(), State::ON_THE_WAY);
}

TEST_F(PathFollowerTest, OnTheStraightLineToACornerTheWayIsKept) {
  PathFollower follower(GOAL);
  const Vector2 corner = follower.next(START, query_);
  for (const double share : {0.1, 0.3, 0.5}) {
    EXPECT_EQ(follower.next(START + share * (corner - START), query_), corner) << share;
  }
}

TEST_F(PathFollowerTest, AGoalOutOfReachIsReportedAndTriedAgain) {
  PathFollower follower({100.0, 0.0});
  EXPECT_EQ(follower.next(START, query_), START);
  EXPECT_EQ(follower.state(), State::UNREACHABLE);
  EXPECT_EQ(follower.corners().size(), 0U);

  const NavigationMesh closed(floors::roomWithDoor(0.0), CLEARANCE);
  NavigationMesh::Query closed_query(closed);
  PathFollower other(GOAL);
  EXPECT_EQ(other.next(START, closed_query), START);
  EXPECT_EQ(other.state(), State::UNREACHABLE);
  other.replan();
  EXPECT_EQ(other.state(), State::ON_THE_WAY);
  EXPECT_NE(other.next(START, query_), START);
  EXPECT_EQ(other.state(), State::ON_THE_WAY);

  // Without a word about the change, the way is found after a while.
  PathFollower waiting(GOAL);
  EXPECT_EQ(waiting.next(START, closed_query), START);
  int ticks = 0;
  while (ticks < 100 && waiting.next(START, query_) == START) ++ticks;
  EXPECT_GT(ticks, 0);
  EXPECT_LT(ticks, 100);
}

TEST_F(PathFollowerTest, TheSamePositionsGiveTheSamePoints) {
  PathFollower first(GOAL);
  PathFollower second(GOAL);
  NavigationMesh::Query other_query(mesh_);
  Vector2 position = START;
  for (int tick = 0; tick < 40; ++tick) {
    const Vector2 next = first.next(position, query_);
    ASSERT_EQ(second.next(position, other_query), next) << tick;
    position += 0.1 * (next - position).normalized();
  }
}

}  // namespace
}  // namespace crowd::path_follower_test
