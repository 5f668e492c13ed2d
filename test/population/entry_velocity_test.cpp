#include "population/entry_velocity.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace crowd::entry_velocity_test {
namespace {

/// A person of 2 m/s at the origin that wants to go along x, and brakes at 4 m/s^2. In ticks of 0.5 s, it stands after
/// 1.5 m; at 1.5, 1 and 0.5 m/s after 1.031, 0.625 and 0.281 m.
const AgentStart PERSON = scenes::agent({0.0, 0.0}, {9.0, 0.0}, 2.0, 0.25);

Vector2 velocityIn(const Scene& scene, const AgentStart& person = PERSON) {
  World world(scenes::halfSeconds(scene));
  world.setMotion({4.0, 4.0, 0.0});
  return entryVelocity(person, world);
}

/// Its speed behind somebody who stands ahead. Both have radii of 0.25 m, and 0.05 m are left.
double speedBehind(double x) { return velocityIn(scenes::scene({scenes::wanderer({x, 0.0})})).x(); }

TEST(EntryVelocity, IsTheGreatestAtWhichItCanStopInTime) {
  EXPECT_EQ(velocityIn(scenes::scene({})), Vector2(2.0, 0.0));
  EXPECT_EQ(speedBehind(2.2), 2.0);
  EXPECT_EQ(speedBehind(2.0), 1.5);
  EXPECT_EQ(speedBehind(1.5), 1.0);
  EXPECT_EQ(speedBehind(1.0), 0.5);
  EXPECT_EQ(speedBehind(0.8), 0.0);
}

TEST(EntryVelocity, IsThatOfOnesThatCanBegin) {
  const Scene free = scenes::scene({});
  AgentStart late = PERSON;
  late.reaction_time = 1.0;
  EXPECT_EQ(velocityIn(free, late), Vector2(0.0, 0.0));
  AgentStart there = PERSON;
  there.goals = {there.position};
  EXPECT_EQ(velocityIn(free, there), Vector2(0.0, 0.0));
  AgentStart hurried = PERSON;
  hurried.hurry = 0.5;
  EXPECT_EQ(velocityIn(free, hurried), Vector2(1.0, 0.0));
  EXPECT_EQ(entryVelocity(PERSON, World(free)), Vector2(0.0, 0.0));  // without motion limits
}

TEST(EntryVelocity, MindsWallsAndWhatIsBehindThem) {
  EXPECT_EQ(velocityIn(scenes::scene({}, {}, {{{5.0, -1.0}, {5.0, 1.0}}})), Vector2(0.0, 0.0));  // hides the goal
  // It sees the goal past the end of the wall, but its body does not pass.
  EXPECT_EQ(velocityIn(scenes::scene({}, {}, {{{1.0, 0.1}, {1.0, 3.0}}})), Vector2(1.0, 0.0));
  EXPECT_EQ(velocityIn(scenes::scene({}, {}, {{{1.0, 0.4}, {1.0, 3.0}}})), Vector2(2.0, 0.0));
}

TEST(EntryVelocity, MindsWhereObstaclesGo) {
  EXPECT_EQ(velocityIn(scenes::scene({}, {scenes::pillar({2.0, 0.0}, 0.5)})), Vector2(1.5, 0.0));
  // From the side, it is on the way after the second that a person of 2 m/s takes to stop.
  EXPECT_EQ(velocityIn(scenes::scene({}, {scenes::moving_obstacle({1.5, -3.0}, {0.0, 3.0}, 0.5)})), Vector2(1.0, 0.0));
  EXPECT_EQ(velocityIn(scenes::scene({}, {scenes::moving_obstacle({1.5, -3.0}, {0.0, 1.0}, 0.5)})), Vector2(2.0, 0.0));
}

TEST(EntryVelocity, MindsWherePeopleGoWhoBrake) {
  // The other one walks towards it at 2 m/s, and stands after 1.5 m, too.
  AgentStart other = scenes::agent({3.0, 0.0}, {-9.0, 0.0}, 2.0, 0.25);
  other.velocity = {-2.0, 0.0};
  EXPECT_EQ(velocityIn(scenes::scene({other})), Vector2(1.0, 0.0)) << "1.5 - 0.625 m are more than 0.55 m";
  other.velocity = {0.0, 2.0};
  EXPECT_EQ(velocityIn(scenes::scene({other})), Vector2(2.0, 0.0));
}

}  // namespace
}  // namespace crowd::entry_velocity_test
