#include "navigation/right_of_way.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/floors.h"
#include "support/seeds.h"
#include "support/two_ways.h"
#include "world/world_editor.h"

namespace crowd::right_of_way_test {
namespace {

using two_ways::RADIUS;
using two_ways::walker;
using two_ways::walksEast;

/// Agents at a door in a wall along the y axis, around the origin, in a room of 10 m by 8 m.
class Door {
 public:
  Door(std::vector<AgentStart> agents, double width, const FloorPlan& floor)
      : passages(std::make_shared<Passages>(floor, RADIUS, RightOfWay::maxWidth(RADIUS))),
        world(two_ways::worldOf(std::move(agents))),
        right_of_way(passages, RADIUS) {
    EXPECT_EQ(passages->size(), 1U);
    EXPECT_NEAR((*passages)[0].width, width, 2.0 * Passages::SPACING);
    update();
  }
  explicit Door(std::vector<AgentStart> agents, double width = 0.9)
      : Door(std::move(agents), width, floors::roomWithDoor(width)) {}

  void update() { two_ways::apply(right_of_way, world); }
  void step() {
    world.step(straight_walk::actions(world));
    update();
  }
  /// Lets time pass while no agent moves.
  void stand() {
    world.step({});
    update();
  }

  const Agent& agent(AgentId id) const { return world.agents()[id]; }
  /// Whether an agent is neither held nor sent away from its path.
  bool mayWalk(AgentId id) const {
    const bool is_on_path = agent(id).perceivedGoal() == Vector2::Zero() || !agent(id).has_waypoint;
    return !agent(id).yielding && is_on_path;
  }
  bool isInside(const Agent& agent) const { return passages->at(agent.pose.position) != Passages::NONE; }

  std::shared_ptr<const Passages> passages;
  World world;  // without contacts: only the right of way holds agents up
  RightOfWay right_of_way;
};

AgentStart east(double x, double y) { return walker({x, y}, {4.5, 0.0}); }
AgentStart west(double x, double y) { return walker({x, y}, {-4.5, 0.0}); }

TEST(RightOfWay, TheNearestAgentGoesFirst) {
  Door door({east(-1.3, 0.0), east(-1.0, 0.3)}, 0.5);
  EXPECT_FALSE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
  while (!door.isInside(door.agent(1))) door.step();
  EXPECT_TRUE(door.mayWalk(0));
}

/// 1.2 m is 2.26 times the width of an agent with its margin, 0.53 m: 3 agents within 3 / 2.26 * 0.52 m = 0.69 m.
TEST(RightOfWay, AgentsOfOneDirectionGoInProportionToTheWidth) {
  Door door({east(-0.9, 0.4), east(-0.9, -0.4), east(-1.2, 0.0), east(-1.3, 0.5)}, 1.2);
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
  EXPECT_TRUE(door.mayWalk(2));
  EXPECT_FALSE(door.mayWalk(3));
  Door narrow({east(-0.9, 0.0), east(-1.2, 0.3), east(-1.6, 0.0)}, 0.5);
  EXPECT_TRUE(narrow.mayWalk(0));
  EXPECT_FALSE(narrow.mayWalk(1));
  EXPECT_FALSE(narrow.mayWalk(2));
}

/// Two bodies of 0.4 m fit into 1.2 m.
TEST(RightOfWay, WithOncomingTrafficAsManyGoAtATimeAsFitSideBySide) {
  Door door({east(-0.9, 0.4), east(-0.9, -0.4), east(-1.2, 0.0), west(1.5, 1.5)}, 1.2);
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
  EXPECT_FALSE(door.mayWalk(2));
}

TEST(RightOfWay, AgentsFarFromThePassageDoNotClaimIt) {
  Door door({east(-1.0, 0.0), west(RightOfWay::LOOKAHEAD + 0.9, 0.0)});
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
}

TEST(RightOfWay, TheOtherDirectionWaitsAndClearsTheLane) {
  Door door({east(-1.0, 0.0), west(1.5, 0.0), west(1.5, 1.5)});
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_FALSE(door.mayWalk(1));
  EXPECT_FALSE(door.mayWalk(2));
  // The agent in front of the door is sent aside: another one passes between it and the middle of the lane.
  EXPECT_FALSE(door.agent(1).yielding);
  EXPECT_GE(std::abs(door.agent(1).perceivedGoal().y()), 2.0 * RADIUS);
  EXPECT_TRUE(door.agent(2).yielding);
}

TEST(RightOfWay, AnAgentThatLeavesGivesItToTheNext) {
  Door door({east(-1.0, 0.0), west(1.5, 0.0), east(-1.0, 0.4)});
  EXPECT_FALSE(door.mayWalk(1));
  WorldEditor(door.world).removeAgent(0);
  WorldEditor(door.world).removeAgent(2);
  door.update();
  EXPECT_TRUE(door.mayWalk(1));
}

/// A corridor of 1.6 m, in which agents can pass each other, with a door: none can wait beside the others.
FloorPlan corridorWithDoor(double width) {
  FloorPlan floor = floors::room({-8.0, -0.8}, {8.0, 0.8});
  floor.walls.push_back({{0.0, -0.8}, {0.0, -0.5 * width}});
  floor.walls.push_back({{0.0, 0.5 * width}, {0.0, 0.8}});
  return floor;
}

TEST(RightOfWay, ThereIsNoneWithoutRoomToWait) {
  const std::vector<AgentStart> agents = {walker({-1.0, 0.0}, {7.0, 0.0}), walker({1.2, 0.0}, {-7.0, 0.0})};
  Door door(agents, 0.8, corridorWithDoor(0.8));
  EXPECT_TRUE(door.mayWalk(0));
  EXPECT_TRUE(door.mayWalk(1));
  Door with_room(agents, 0.8);
  EXPECT_TRUE(with_room.mayWalk(0));
  EXPECT_FALSE(with_room.mayWalk(1));
}

/// Two agents side by side would be wedged in a door of 0.8 m, but not in one of 1.1 m.
TEST(RightOfWay, AgentsEnterNarrowDoorsWithoutRoomToWaitOneBehindTheOther) {
  const std::vector<AgentStart> agents = {walker({-0.75, 0.2}, {7.0, 0.0}), walker({-0.7, -0.25}, {7.0, 0.0}),
                                          walker({0.75, 0.0}, {-7.0, 0.0})};
  const auto formFiles = [](Door& door) {
    DeadlockResolver deadlocks;
    const std::vector<RemainingPath> paths = two_ways::findPaths(door.world);
    deadlocks.update(door.world, paths);
    door.right_of_way.update(door.world, paths);
    door.right_of_way.formSingleFiles(door.world, deadlocks);
  };
  Door door(agents, 0.8, corridorWithDoor(0.8));
  formFiles(door);
  EXPECT_TRUE(door.agent(0).yielding);  // farther away than agent 1
  EXPECT_FALSE(door.agent(1).yielding);
  EXPECT_FALSE(door.agent(2).yielding);  // walks in the other direction
  WorldEditor(door.world).removeAgent(1);
  formFiles(door);
  EXPECT_FALSE(door.agent(0).yielding);
  Door occupied({walker({-0.7, 0.1}, {7.0, 0.0}), walker({0.0, 0.0}, {-7.0, 0.0})}, 0.8, corridorWithDoor(0.8));
  formFiles(occupied);
  EXPECT_TRUE(occupied.agent(0).yielding);
  EXPECT_FALSE(occupied.agent(1).yielding);  // inside
  Door wider(agents, 1.1, corridorWithDoor(1.1));
  formFiles(wider);
  EXPECT_FALSE(wider.agent(0).yielding);
}

/// Without progress for 4 s all agents are released for 3 s (docs/way_finding.md).
TEST(RightOfWay, AllAreReleasedAfterAStall) {
  Door door({east(-1.0, 0.0), west(1.5, 0.0)});
  std::string released;
  for (int tick = 0; tick < 28; ++tick) {
    released += door.mayWalk(1) ? 'r' : 'w';
    EXPECT_TRUE(door.mayWalk(0));
    door.stand();
  }
  EXPECT_EQ(released, "wwwwwwwwrrrrrrwwwwwwwwrrrrrr");
}

/// At 0.1 m/s it takes more than 10 s to the other side.
TEST(RightOfWay, NoneIsReleasedWhileAnAgentWalksSlowly) {
  Door door({walker({-1.0, 0.0}, {4.5, 0.0}, 0.1), west(1.5, 1.5)});
  while (door.world.time() < 10.0) {
    ASSERT_FALSE(door.mayWalk(1)) << door.world.time();
    door.step();
  }
  EXPECT_GT(door.agent(0).pose.position.x(), -0.1);
}

/// Walks until all have arrived, at most for this time [s]. @return how many agents of one direction entered one after
/// the other, in their order
std::vector<std::size_t> countBatches(Door& door, double time) {
  std::vector<std::size_t> batches;
  std::vector<bool> entered(door.world.agents().size(), false);
  bool direction = false;
  while (door.world.activeCount() > 0 && door.world.time() < time) {
    door.step();
    const Agent* first_inside = nullptr;
    for (const Agent& agent : door.world.agents()) {
      if (!agent.isWalking() || !door.isInside(agent)) continue;
      if (first_inside == nullptr) first_inside = &agent;
      EXPECT_EQ(walksEast(agent), walksEast(*first_inside)) << "both directions inside at " << door.world.time();
      if (entered[agent.id]) continue;
      entered[agent.id] = true;
      if (batches.empty() || walksEast(agent) != direction) batches.push_back(0);
      direction = walksEast(agent);
      ++batches.back();
    }
  }
  EXPECT_EQ(door.world.activeCount(), 0U) << "of " << door.world.agents().size() << " have not arrived";
  return batches;
}

/// Speeds are low, so that no agent steps over the passage.
AgentStart slow(AgentStart start) {
  start.max_speed = 0.6;
  return start;
}

/// Places in rows across the x axis, the first row 1.2 m from the door.
Vector2 inRows(int number, int in_a_row) {
  const int row = number / in_a_row;
  return {1.2 + 0.6 * row, 0.6 * (number % in_a_row) - 0.3 * (in_a_row - 1)};
}

TEST(RightOfWay, DirectionsTakeTurnsAfterABatch) {
  std::vector<AgentStart> agents;
  agents.reserve(24);
  for (int i = 0; i < 12; ++i) {
    const Vector2 place = inRows(i, 4);
    agents.push_back(slow(east(-place.x(), place.y())));
    agents.push_back(slow(west(place.x(), place.y())));
  }
  Door door(agents);
  EXPECT_EQ(countBatches(door, 300.0), (std::vector<std::size_t>{8, 8, 4, 4}));
}

TEST(RightOfWay, OneDirectionAloneHasNoBatches) {
  std::vector<AgentStart> agents;
  agents.reserve(20);
  for (int i = 0; i < 20; ++i) agents.push_back(slow(west(inRows(i, 5).x(), inRows(i, 5).y())));
  Door door(agents);
  EXPECT_EQ(countBatches(door, 300.0), (std::vector<std::size_t>{20}));
}

/// Crowds of any size in front of a door: one direction at a time is inside, and all agents arrive.
TEST(RightOfWay, OneDirectionAtATimeForAnyCrowd) {
  forSeeds(15, KeyedRandom::PLACEMENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    const double width = random.uniform(0.6, 1.1);
    std::vector<AgentStart> agents(2 + random.below(25));
    for (AgentStart& start : agents) {
      const double x = random.uniform(1.0, 4.5);
      const double y = random.uniform(-3.5, 3.5);
      start = slow(random.below(2) == 0 ? east(-x, y) : west(x, y));
    }
    Door door(agents, width);
    countBatches(door, 400.0);
  });
}

}  // namespace
}  // namespace crowd::right_of_way_test
