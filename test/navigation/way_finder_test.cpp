#include "navigation/way_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/floors.h"
#include "support/seeds.h"
#include "support/two_ways.h"
#include "world/world_editor.h"

namespace crowd::way_finder_test {
namespace {

using two_ways::RADIUS;
using two_ways::walker;

/// A world in which way-finding leads the agents from the start.
class Led {
 public:
  explicit Led(const Scene& scene) : world(scene) { ways.update(world); }
  Led(std::vector<AgentStart> agents, std::vector<Segment> walls)
      : Led(scenes::solid(scenes::scene(std::move(agents), {}, std::move(walls)))) {}

  const Agent& agent(AgentId id = 0) const { return world.agents()[id]; }
  /// Walks straight to the perceived goals for this time [s].
  void walk(double time) {
    const double end = world.time() + time;
    while (world.time() < end && world.activeCount() > 0) {
      world.step(straight_walk::actions(world));
      ways.update(world);
    }
  }

  World world;
  WayFinder ways;
};

/// A corridor along the x axis from -10 m to 10 m.
std::vector<Segment> corridor(double width) { return floors::room({-10.0, -0.5 * width}, {10.0, 0.5 * width}).walls; }

TEST(WayFinder, LeadsRoundAWallWithoutTouchingIt) {
  // 4 m away behind a wall that ends at y = 3.
  Led led({walker({-2.0, 0.0}, {2.0, 0.0})}, {{{0.0, -9.0}, {0.0, 3.0}}});
  EXPECT_TRUE(led.agent().has_waypoint);
  EXPECT_GT(led.agent().waypoint.y(), 3.0);
  led.walk(30.0);
  EXPECT_TRUE(led.agent().hasArrived());
  EXPECT_EQ(led.agent().blocked_moves, 0U);
  // The way past (0, 3) at 0.2 m to 0.3 m is between 7.21 m and 8.0 m long.
  EXPECT_GT(led.world.time(), 2.0 * std::hypot(2.0, 3.0) - scenes::GOAL_TOLERANCE);
  EXPECT_LT(led.world.time(), 8.0);
}

TEST(WayFinder, DoesNothingWithoutWalls) {
  Led led({walker({-2.0, 0.0}, {2.0, 0.0})}, {});
  EXPECT_FALSE(led.agent().has_waypoint);
  const std::size_t wall = WorldEditor(led.world).addWall({{0.0, -9.0}, {0.0, 3.0}});
  led.ways.update(led.world);
  EXPECT_TRUE(led.agent().has_waypoint);
  WorldEditor(led.world).removeWall(wall);
  led.ways.update(led.world);
  EXPECT_FALSE(led.agent().has_waypoint);
}

/// Bodies of 0.4 m on both lanes pass each other.
TEST(WayFinder, KeepsRightInACorridor) {
  Led led({walker({-8.0, 0.0}, {9.0, 0.0}), walker({8.0, 0.0}, {-9.0, 0.0})}, corridor(2.0));
  EXPECT_LT(led.agent(0).perceivedGoal().y(), -RADIUS);  // east: the right side is in the south
  EXPECT_GT(led.agent(1).perceivedGoal().y(), RADIUS);
  led.walk(7.0);  // they have 1 m left before they meet
  EXPECT_LT(led.agent(0).pose.position.y(), -RADIUS);
  EXPECT_GT(led.agent(1).pose.position.y(), RADIUS);
  led.walk(30.0);
  EXPECT_EQ(led.world.activeCount(), 0U);
  EXPECT_FALSE(led.agent(0).touched);
}

TEST(WayFinder, WalksStraightOnWideFloor) {
  Led led({walker({-8.0, 0.0}, {9.0, 0.0})}, corridor(9.0));
  EXPECT_EQ(led.agent().perceivedGoal(), Vector2(9.0, 0.0));
  led.walk(5.0);
  EXPECT_EQ(led.agent().perceivedGoal(), Vector2(9.0, 0.0));
}

/// Two corridors that meet at a right angle; their inner corner is at (0, 0).
std::vector<Segment> rightAngle(double width) {
  return {{{-20.0, 0.0}, {0.0, 0.0}},       {{0.0, 0.0}, {0.0, 20.0}},       {{-20.0, -width}, {width, -width}},
          {{width, -width}, {width, 20.0}}, {{-20.0, 0.0}, {-20.0, -width}}, {{0.0, 20.0}, {width, 20.0}}};
}

/// Agents that stand still, as if others were in their way.
void stand(Led& led, double time) {
  for (const double end = led.world.time() + time; led.world.time() < end;) {
    led.world.step({});
    led.ways.update(led.world);
  }
}

/// An agent 4 m in front of a corner at which another one stands.
Led slowedDown(double width, double time) {
  Led led({walker({-4.0, -0.5}, {0.5, 18.0}), walker({-0.2, -0.5}, {0.5, 18.0})}, rightAngle(width));
  stand(led, time);
  return led;
}

TEST(WayFinder, ACrowdUsesTheWidthOfACorner) {
  EXPECT_LT(slowedDown(12.0, 0.2).agent().perceivedGoal().norm(), 0.6);
  const Vector2 outside = slowedDown(12.0, 20.0).agent().perceivedGoal();
  EXPECT_GT(outside.norm(), 1.0);
  EXPECT_GT(outside.x(), 0.5);
  EXPECT_LT(outside.y(), -0.5);
  EXPECT_LT(slowedDown(1.0, 20.0).agent().perceivedGoal().norm(), 0.8);  // there is no room
}

TEST(WayFinder, AnAgentBesideTheCornerWalksOnToItsGoal) {
  Led led = slowedDown(12.0, 20.0);
  led.walk(40.0);
  EXPECT_TRUE(led.agent().hasArrived());
}

/// A wall with two doors, at y = 0 and y = 4. One agent stands in the nearer one.
TEST(WayFinder, LeadsRoundACrowd) {
  std::vector<Segment> walls = floors::room({-8.0, -8.0}, {8.0, 8.0}).walls;
  walls.push_back({{0.0, -8.0}, {0.0, -1.0}});
  walls.push_back({{0.0, 1.0}, {0.0, 3.0}});
  walls.push_back({{0.0, 5.0}, {0.0, 8.0}});
  Led led({walker({-5.0, 0.0}, {7.0, 0.0}), walker({-0.2, 0.0}, {7.0, 0.0})}, walls);
  stand(led, 2.0);
  EXPECT_EQ(led.agent(0).perceivedGoal(), Vector2(7.0, 0.0));
  stand(led, 20.0);
  EXPECT_GT(led.agent(0).perceivedGoal().y(), 3.0);
  EXPECT_EQ(led.agent(1).perceivedGoal(), Vector2(7.0, 0.0));  // no agent is ahead of it
}

TEST(WayFinder, ANewGoalHasANewWay) {
  Led led({walker({-8.0, 0.0}, {9.0, 0.0})}, corridor(2.0));
  led.walk(5.0);
  EXPECT_GT(led.agent().perceivedGoal().x(), led.agent().pose.position.x());
  WorldEditor(led.world).setGoal(0, {-9.0, 0.0});
  led.ways.update(led.world);
  EXPECT_LT(led.agent().perceivedGoal().x(), led.agent().pose.position.x());
  EXPECT_GT(led.agent().perceivedGoal().y(), RADIUS);  // west: the right side is in the north
  led.walk(30.0);
  EXPECT_LT(led.agent().pose.position.x(), -8.7);
}

/// Its way keeps 0.1 m from walls. The room beside its way has a door of 0.58 m, which is too narrow for that.
TEST(WayFinder, AnAgentFindsOutOfARoomWithANarrowerDoorThanItsWay) {
  std::vector<Segment> walls = floors::room({-1.0, -3.0}, {1.0, 0.0}).walls;
  walls.erase(walls.begin() + 2);  // the upper one
  walls.push_back({{-6.0, 0.0}, {-0.29, 0.0}});
  walls.push_back({{0.29, 0.0}, {6.0, 0.0}});
  Led led({walker({-5.0, 2.0}, {5.0, 2.0})}, walls);
  led.walk(1.0);
  WorldEditor(led.world).teleport(0, {{0.7, -2.6}, 0.0});
  led.walk(30.0);
  EXPECT_TRUE(led.agent().hasArrived());
}

TEST(WayFinder, KnowsWhichGoalsAreOutOfReach) {
  std::vector<Segment> walls = floors::room({0.0, 0.0}, {3.0, 3.0}).walls;
  walls.push_back({{5.0, 0.0}, {5.0, 3.0}});
  Led led({walker({-2.0, 1.0}, {1.5, 1.5}), walker({-2.0, 2.0}, {6.0, 1.5})}, walls);
  EXPECT_TRUE(led.ways.isOutOfReach(0));
  EXPECT_FALSE(led.ways.isOutOfReach(1));
  EXPECT_FALSE(led.ways.isOutOfReach(7));
  led.walk(20.0);
  EXPECT_EQ(led.agent(0).pose.position, Vector2(-2.0, 1.0));
  EXPECT_TRUE(led.agent(1).hasArrived());
}

TEST(WayFinder, ReleasedAgentsPerceiveTheirGoals) {
  Led led({walker({-2.0, 0.0}, {2.0, 0.0}), walker({-1.0, 0.0}, {2.0, 0.0})}, {{{0.0, -9.0}, {0.0, 3.0}}});
  led.world.walkingAgent(1).yielding = true;
  led.ways.giveUp(led.world);
  for (AgentId id = 0; id < 2; ++id) {
    EXPECT_EQ(led.agent(id).perceivedGoal(), Vector2(2.0, 0.0));
    EXPECT_FALSE(led.agent(id).yielding);
  }
}

/// Moves everything in a scene.
Scene shifted(Scene scene, const Vector2& by) {
  for (AgentStart& agent : scene.agents) {
    agent.position += by;
    for (Vector2& goal : agent.goals) goal += by;
  }
  for (Segment& wall : scene.walls) wall = {wall.from + by, wall.to + by};
  return scene;
}

/// 80 km away. The shift is a multiple of all lengths that the floor is divided into, and exact in binary.
TEST(WayFinder, ALayoutFarFromTheOriginHasTheSameWays) {
  const Vector2 shift(65536.0, -49152.0);
  const Scene scene = scenes::solid(scenes::scene({walker({-4.0, 0.0}, {4.0, 0.0}), walker({4.0, 1.0}, {-4.0, -1.0})},
                                                  {}, floors::roomWithDoor(1.0, 2.0).walls));
  Led near(scene);
  Led far(shifted(scene, shift));
  for (int tick = 0; tick < 50; ++tick) {
    for (AgentId id = 0; id < 2; ++id) {
      ASSERT_LT((far.agent(id).perceivedGoal() - shift - near.agent(id).perceivedGoal()).norm(), 1e-3) << tick;
    }
    near.walk(0.1);
    far.walk(0.1);
  }
}

TEST(WayFinder, RefusesAFloorThatIsTooLarge) {
  World world(scenes::scene({walker({-2.0, 0.0}, {2.0, 0.0})}, {}, {{{3e7, 0.0}, {3e7, 1.0}}}));
  WayFinder ways;
  EXPECT_NE(errorOf<InputError>([&] { ways.update(world); }).find("too large"), std::string::npos);
}

/// On random floors, an agent alone that is not out of reach arrives, without a touch of a wall or an obstacle.
TEST(WayFinder, AnAgentAloneArrivesOnRandomFloors) {
  int arrived = 0;
  int out_of_reach = 0;
  forSeeds(150, KeyedRandom::CONTENT, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const FloorPlan floor = floors::random(random);
    const auto place = [&] {
      const double x = random.uniform(0.3, 5.7);
      return Vector2(x, random.uniform(0.3, 4.7));
    };
    const Vector2 from = place();
    const Vector2 to = place();
    if (floors::clearanceAt(floor, from) < 0.3 || floors::clearanceAt(floor, to) < 0.3) return;
    Scene scene = scenes::solid(scenes::scene({walker(from, to)}, {}, floor.walls));
    for (const FloorPlan::Disc& disc : floor.obstacles)
      scene.obstacles.push_back(scenes::pillar(disc.centre, disc.radius));
    Led led(scene);
    const bool has_no_way = led.ways.isOutOfReach(0);
    led.walk(60.0);
    EXPECT_EQ(led.agent().hasArrived(), !has_no_way) << from.transpose() << " to " << to.transpose();
    EXPECT_EQ(led.agent().blocked_moves, 0U) << from.transpose() << " to " << to.transpose();
    ++(has_no_way ? out_of_reach : arrived);
  });
  EXPECT_GT(arrived, 8);
  EXPECT_GT(out_of_reach, 0);
}

}  // namespace
}  // namespace crowd::way_finder_test
