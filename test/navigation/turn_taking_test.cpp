#include "navigation/turn_taking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/floors.h"
#include "support/seeds.h"
#include "support/two_ways.h"
#include "world/world_editor.h"

namespace crowd::turn_taking_test {
namespace {

using two_ways::RADIUS;
using two_ways::walker;
using two_ways::walksEast;

/// Agents at a door of 0.9 m in a wall along the y axis, around the origin, in a room of 10 m by 8 m.
class Door {
 public:
  explicit Door(std::vector<AgentStart> agents, double width = 0.9)
      : Door(std::move(agents), floors::roomWithDoor(width)) {}
  Door(std::vector<AgentStart> agents, const FloorPlan& floor)
      : world(two_ways::worldOf(std::move(agents))),
        turns(std::make_shared<FloorRuler>(floor, WayClaims::wideClearance(RADIUS))) {
    update();
  }

  void update() { two_ways::apply(turns, world); }
  void step() {
    world.step(straight_walk::actions(world));
    update();
  }
  const Agent& agent(AgentId id) const { return world.agents()[id]; }
  /// Whether an agent is neither held nor sent away from its path.
  bool mayWalk(AgentId id) const {
    const bool is_on_path = agent(id).perceivedGoal() == Vector2::Zero() || !agent(id).has_waypoint;
    return !agent(id).yielding && is_on_path;
  }

  World world;  // without contacts: only turns hold agents up
  TurnTaking turns;
};

AgentStart east(double x, double y) { return walker({x, y}, {4.5, 0.0}); }
AgentStart west(double x, double y) { return walker({x, y}, {-4.5, 0.0}); }

TEST(TurnTaking, OneDirectionGoesFirst) {
  Door door({east(-1.0, 0.0), west(1.0, 0.0)});
  EXPECT_TRUE(door.mayWalk(0));  // both have come into sight at the same time: the lower id
  EXPECT_FALSE(door.mayWalk(1));
  WorldEditor(door.world).removeAgent(0);
  while (door.world.time() < TurnTaking::DECISION_TIME) door.step();
  EXPECT_TRUE(door.mayWalk(1));
}

TEST(TurnTaking, WhoHasWaitedLongerGoesFirst) {
  // Agent 0 is 3.8 m from the door, where it is out of sight; agent 1 is not. After 2.5 s both are near.
  Door door({east(-3.8, 0.0), walker({1.5, 0.0}, {-4.5, 0.0}, 0.1)});
  while (door.world.time() < 2.5) door.step();
  EXPECT_FALSE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
}

/// All come into sight at the same time. Agents 0 and 1 are 2.4 m from each other: neither is near the other one.
TEST(TurnTaking, WhoLeavesACrowdGoesFirst) {
  Door crowd_in_the_east({east(-1.2, 0.0), west(1.2, 0.0), west(1.9, 0.5), west(1.9, -0.5)});
  EXPECT_FALSE(crowd_in_the_east.mayWalk(0));
  EXPECT_TRUE(crowd_in_the_east.mayWalk(1));
  Door crowd_in_the_west({west(1.2, 0.0), east(-1.2, 0.0), east(-1.9, 0.5), east(-1.9, -0.5)});
  EXPECT_FALSE(crowd_in_the_west.mayWalk(0));
  EXPECT_TRUE(crowd_in_the_west.mayWalk(1));
}

TEST(TurnTaking, AgentsPassEachOtherInAWideDoor) {
  Door door({east(-1.0, 0.0), west(1.0, 0.0)}, 2.6);
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
}

/// Two agents of opposite directions, 0.5 m apart, in a corridor of 1 m or in two corridors with a thin wall between
/// them.
bool doesAnyWait(const std::vector<Segment>& walls) {
  FloorPlan floor;
  floor.walls = walls;
  World world = two_ways::worldOf({walker({-2.0, 0.25}, {4.0, 0.25}), walker({2.0, 0.75}, {-4.0, 0.75})}, walls);
  TurnTaking turns(std::make_shared<FloorRuler>(floor, WayClaims::wideClearance(RADIUS)));
  turns.update(world, std::vector<RemainingPath>{{{4.0, 0.25}}, {{-4.0, 0.75}}});
  const auto waits = [](const Agent& agent) { return agent.yielding || agent.has_waypoint; };
  return std::any_of(world.agents().begin(), world.agents().end(), waits);
}

TEST(TurnTaking, AgentsBehindAThinWallDoNotCount) {
  EXPECT_TRUE(doesAnyWait(floors::room({-8.0, 0.0}, {8.0, 1.0}).walls));
  std::vector<Segment> walls = floors::room({-8.0, -0.5}, {8.0, 1.5}).walls;
  walls.push_back({{-8.0, 0.5}, {8.0, 0.5}});
  EXPECT_FALSE(doesAnyWait(walls));
}

TEST(TurnTaking, AgentsWaitAtADistance) {
  Door door({east(-1.0, 0.0), west(TurnTaking::WAITING_DISTANCE + 0.6, 0.0)});
  EXPECT_TRUE(door.mayWalk(1));  // it walks up to the place where it waits
  while (door.mayWalk(1) && door.world.time() < 3.0) door.step();
  EXPECT_NEAR(door.agent(1).pose.position.x(), TurnTaking::WAITING_DISTANCE + 0.2, 0.5);
}

/// The agent in the door has just passed its middle; the other one stands in its way.
TEST(TurnTaking, WhoWaitsStepsAsideForThoseWhoComeOut) {
  Door door({east(0.05, 0.0), west(1.5, 0.05), west(1.2, 0.9)});
  EXPECT_FALSE(door.agent(1).yielding);
  EXPECT_TRUE(door.agent(1).has_waypoint);
  const Vector2 aside = door.agent(1).perceivedGoal() - door.agent(1).pose.position;
  EXPECT_NEAR(aside.x(), 0.0, 1e-9);
  EXPECT_GT(aside.y(), 0.5);            // to the side on which it is
  EXPECT_TRUE(door.agent(2).yielding);  // no agent walks towards it
}

TEST(TurnTaking, AgentsBehindOthersKeepAGap) {
  // Agent 1 is behind agent 0, 0.1 m apart; agent 2 is beside it; agent 3 is 0.5 m behind agent 1.
  Door door({east(-1.0, 0.0), east(-1.5, 0.0), east(-1.0, 0.6), east(-2.4, 0.0)});
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_FALSE(door.mayWalk(1));
  EXPECT_TRUE(door.mayWalk(2));
  EXPECT_TRUE(door.mayWalk(3));
}

TEST(TurnTaking, TheDirectionInsideGoesOnForAWhile) {
  // Agent 1 is inside, agent 0 follows it; agent 2 has waited as long as agent 0 has been on its way.
  Door door({east(-1.0, 0.0), east(-0.05, 0.0), west(1.2, 1.2)});
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
  EXPECT_FALSE(door.mayWalk(2));
}

/// In a corridor of 1 m: the agent that came first goes on, the other one stops.
TEST(TurnTaking, OneOfTwoWhoMeetInsideStops) {
  Door door({walker({-2.0, 0.0}, {7.0, 0.0}), walker({2.0, 0.0}, {-7.0, 0.0})}, floors::room({-8.0, -0.5}, {8.0, 0.5}));
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.agent(1).yielding);
}

/// Speeds are low, so that no agent steps over the door.
AgentStart slow(AgentStart start) {
  start.max_speed = 0.6;
  return start;
}

/// A crowd of any size, without bodies: agents in front of the door wait for one that comes out, and all arrive.
TEST(TurnTaking, AnyCrowdPassesADoor) {
  int waiting = 0;
  forSeeds(60, KeyedRandom::PLACEMENT, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const double width = random.uniform(0.6, 1.1);
    std::vector<AgentStart> agents(2 + random.below(25));
    for (AgentStart& start : agents) {
      const double x = random.uniform(1.0, 4.5);
      const double y = random.uniform(-0.2, 0.2) * x;
      start = slow(random.below(2) == 0 ? east(-x, y) : west(x, y));
    }
    Door door(agents, width);
    while (door.world.activeCount() > 0 && door.world.time() < 400.0) {
      door.step();
      for (const Agent& inside : door.world.agents()) {
        if (!inside.isWalking() || inside.pose.position.norm() > 0.1) continue;
        for (const Agent& other : door.world.agents()) {
          const Vector2& place = other.pose.position;
          const bool is_in_front = std::abs(place.x()) > std::max(0.5, 2.5 * std::abs(place.y())) && place.norm() < 1.5;
          if (!other.isWalking() || !is_in_front || other.perceivedGoal() == other.goal()) continue;
          if (walksEast(other) == walksEast(inside)) continue;
          EXPECT_FALSE(door.mayWalk(other.id)) << other.id << " at " << door.world.time();
          ++waiting;
        }
      }
    }
    EXPECT_EQ(door.world.activeCount(), 0U) << "of " << door.world.agents().size() << " have not arrived";
  });
  EXPECT_GT(waiting, 5);
}

}  // namespace
}  // namespace crowd::turn_taking_test
