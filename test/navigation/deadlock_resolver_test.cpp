#include "navigation/deadlock_resolver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "learning/q_table_file.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/evaluation/evaluation.h"
#include "support/robots.h"
#include "support/two_ways.h"
#include "world/world_editor.h"

namespace crowd::deadlock_resolver_test {
namespace {

using two_ways::walker;

/// Agents in a solid world without walls, which walk straight to what they perceive as their goal.
class Crowd {
 public:
  explicit Crowd(const std::vector<AgentStart>& agents, const std::vector<RobotStart>& robots = {})
      : world(robots::with(robots, scenes::halfSeconds(scenes::solid(scenes::scene(agents))))) {}

  /// Lets the agents walk for a tick.
  void step() {
    world.step(straight_walk::actions(world));
    update();
  }
  /// Lets the agents stand still for a tick.
  void stand() {
    world.step({});
    update();
  }
  /// Lets the agents stand for a time [s], and updates the congestion map only.
  void jam(double time) {
    for (const double end = world.time() + time; world.time() < end;) {
      world.step({});
      congestion.update(world, paths());
    }
  }
  void update() {
    for (const Agent& agent : world.agents()) {
      if (agent.isWalking()) world.walkingAgent(agent.id).clearWaypoint();
    }
    congestion.update(world, paths());
    deadlocks.update(world, paths(), congestion);
  }
  bool givesWay(AgentId id) const { return world.agents()[id].has_waypoint; }
  bool doesAnyGiveWay() const {
    const auto& agents = world.agents();
    return std::any_of(agents.begin(), agents.end(), [&](const Agent& agent) { return givesWay(agent.id); });
  }
  /// Walks until an agent gives way, or for a time [s].
  void walkUntilAnyGivesWay(double time) {
    const double end = world.time() + time;
    do {
      step();
    } while (!doesAnyGiveWay() && world.time() < end);
  }

  World world;
  CongestionMap congestion;
  DeadlockResolver deadlocks;

 private:
  std::vector<RemainingPath> paths() const {
    std::vector<RemainingPath> paths(world.agents().size());
    for (const Agent& agent : world.agents()) {
      if (agent.isWalking()) paths[agent.id] = {agent.goal()};
    }
    return paths;
  }
};

/// Two agents of radius 0.2 m that meet head-on at x = 0 after 3.3 s: neither goes round the other one.
std::vector<AgentStart> headOn() { return {walker({-3.5, 0.0}, {9.0, 0.0}), walker({3.5, 0.0}, {-9.0, 0.0})}; }

/// Both walk east. Agent 1 waits right in front of agent 0.
TEST(DeadlockResolver, WhoWaitsGivesWayToOneThatItBlocks) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0}), walker({0.45, 0.0}, {9.0, 0.0})});
  while (crowd.world.time() < DeadlockResolver::STUCK_TIME) {
    EXPECT_FALSE(crowd.givesWay(1)) << crowd.world.time();
    crowd.world.walkingAgent(1).yielding = true;
    crowd.stand();
  }
  crowd.world.walkingAgent(1).yielding = true;
  crowd.stand();
  EXPECT_TRUE(crowd.givesWay(1));
  EXPECT_FALSE(crowd.world.agents()[1].yielding);
  EXPECT_FALSE(crowd.givesWay(0));
  crowd.world.walkingAgent(1).yielding = true;  // TurnTaking lets it wait in each tick
  crowd.stand();
  EXPECT_TRUE(crowd.givesWay(0));  // makes room for agent 1, which walks back
}

/// Agent 1 waits beside agent 0, 0.1 m behind.
TEST(DeadlockResolver, WhoWaitsGivesWayToOneThatItTouches) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0}), walker({-0.1, 0.39}, {9.0, 0.39})});
  while (!crowd.doesAnyGiveWay() && crowd.world.time() < 60.0) {
    crowd.world.walkingAgent(1).yielding = true;
    crowd.stand();
  }
  EXPECT_TRUE(crowd.givesWay(1));
  EXPECT_FALSE(crowd.givesWay(0));
}

TEST(DeadlockResolver, NobodyGivesWayToAnAgentBehindAWall) {
  const std::vector<AgentStart> agents = {walker({0.0, 0.0}, {9.0, 0.0}), walker({0.3, 0.42}, {-9.0, 0.42})};
  Crowd together(agents);
  Crowd apart(agents);
  WorldEditor(apart.world).addWall({{-20.0, 0.21}, {20.0, 0.21}});
  const auto does_any_walk_back = [](const Crowd& crowd) {
    return crowd.deadlocks.walksBack(0) || crowd.deadlocks.walksBack(1);
  };
  bool did_any_walk_back = false;
  while (together.world.time() < 2.0 * (DeadlockResolver::STUCK_TIME + DeadlockResolver::TURN_TIME)) {
    together.stand();
    did_any_walk_back = did_any_walk_back || does_any_walk_back(together);
    apart.stand();
    EXPECT_FALSE(does_any_walk_back(apart)) << apart.world.time();
  }
  EXPECT_TRUE(did_any_walk_back);
}

/// Agent 1 waits right in front of agent 0, which has the same direction, and walks back towards it.
TEST(DeadlockResolver, WhoBlocksAnAgentBehindItWalksBackTowardsIt) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0}), walker({0.45, 0.0}, {9.0, 0.0})});
  do {
    crowd.world.walkingAgent(1).yielding = true;
    crowd.stand();
  } while (!crowd.deadlocks.walksBack(1) && crowd.world.time() < 60.0);
  ASSERT_TRUE(crowd.deadlocks.walksBack(1));
  EXPECT_LT(crowd.world.agents()[1].perceivedGoal().x(), 0.45 - 0.9);
}

/// Agent 0 waits in the way of agent 1, and walks back farther each time.
TEST(DeadlockResolver, AnAgentWalksBackAgainstTheDirectionOfItsPath) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0}), walker({0.45, 0.0}, {-9.0, 0.0})});
  const auto x = [&] { return crowd.world.agents()[0].pose.position.x(); };
  crowd.update();
  while (x() > -4.0 && crowd.world.time() < 60.0) {
    const double before = x();
    if (crowd.deadlocks.walksBack(0)) {
      crowd.step();
    } else {
      crowd.world.walkingAgent(0).yielding = true;
      crowd.stand();
    }
    EXPECT_LE(x(), before) << crowd.world.time();
  }
  EXPECT_LE(x(), -4.0);
}

TEST(DeadlockResolver, OneOfTwoGivesWay) {
  Crowd crowd(headOn());
  crowd.walkUntilAnyGivesWay(60.0);
  EXPECT_NE(crowd.givesWay(0), crowd.givesWay(1));
  // They have been stuck since 3.5 s at the latest, and did not move by PROGRESS for STUCK_TIME before it.
  EXPECT_GE(crowd.world.time(), 3.3 - DeadlockResolver::PROGRESS + DeadlockResolver::STUCK_TIME);
  EXPECT_LE(crowd.world.time(), 3.5 + DeadlockResolver::STUCK_TIME + DeadlockResolver::TURN_TIME);
}

/// An agent walks against a robot that stands 2 m ahead of it; returns whether it gives way within 10 s.
bool givesWayToRobot(Yields yields) {
  RobotStart robot = robots::robot({0.0, 0.0});
  robot.yields = yields;
  Crowd crowd({walker({-2.0, 0.0}, {9.0, 0.0})}, {robot});
  crowd.walkUntilAnyGivesWay(10.0);
  return crowd.givesWay(0);
}

/// Two agents stand head-on, and three people where the path of one of them leads to, 3 m ahead. With three the axis,
/// which counts like up to two, does not matter.
TEST(DeadlockResolver, WhoEntersACrowdGivesWay) {
  for (const double side : {1.0, -1.0}) {
    std::vector<AgentStart> agents = {walker({-0.21, 0.0}, {9.0, 0.0}), walker({0.21, 0.0}, {-9.0, 0.0})};
    for (const double y : {-1.2, 0.0, 1.2}) agents.push_back(walker({2.8 * side, y}, {2.8 * side, 20.0 + y}));
    Crowd crowd(agents);
    for (int turn = 0; turn < 8; ++turn) {
      while (!crowd.givesWay(0) && !crowd.givesWay(1) && crowd.world.time() < 100.0) crowd.stand();
      EXPECT_EQ(crowd.givesWay(0), side > 0.0) << crowd.world.time();
      EXPECT_EQ(crowd.givesWay(1), side < 0.0) << crowd.world.time();
      while (crowd.doesAnyGiveWay()) crowd.stand();
    }
  }
}

TEST(DeadlockResolver, GivesWayToARobotIfTheCrowdYields) {
  EXPECT_TRUE(givesWayToRobot(Yields::CROWD));
  EXPECT_TRUE(givesWayToRobot(Yields::BOTH));
  EXPECT_FALSE(givesWayToRobot(Yields::ROBOT));
  EXPECT_FALSE(givesWayToRobot(Yields::NOBODY));
}

/// Agent 0 moves to and fro by 0.6 m in front of one that is held, and thus makes progress again and again.
TEST(DeadlockResolver, WhoPacesForLongGivesWay) {
  Crowd crowd({walker({0.5, 0.5}, {9.0, 0.5}), walker({1.5, 0.5}, {-9.0, 0.5})});
  crowd.world.walkingAgent(1).setHeld(Hold::ROUTE, true);
  bool is_near = false;
  while (!crowd.givesWay(0) && crowd.world.time() < 60.0) {
    is_near = !is_near;
    WorldEditor(crowd.world).teleport(0, {{is_near ? 1.0 : 0.4, 0.5}, 0.0});
    crowd.stand();
  }
  EXPECT_GE(crowd.world.time(), DeadlockResolver::PACING_TIME);
  EXPECT_LE(crowd.world.time(), DeadlockResolver::PACING_TIME + DeadlockResolver::TURN_TIME + 1.0);
}

/// It is behind the place of the meeting then.
TEST(DeadlockResolver, AnAgentWalksBackForAWhile) {
  Crowd crowd(headOn());
  crowd.walkUntilAnyGivesWay(60.0);
  const AgentId back = crowd.givesWay(0) ? 0 : 1;
  const double start = crowd.world.time();
  while (crowd.givesWay(back) && crowd.world.time() < start + 60.0) crowd.step();
  EXPECT_NEAR(crowd.world.time() - start, DeadlockResolver::RETREAT_TIME, 0.5 + 1e-9);
  EXPECT_GT(std::abs(crowd.world.agents()[back].pose.position.x()), 1.0);
}

/// Two agents face each other in one square of the congestion map, and the one that walks west has another one behind
/// it in the next square, at x [m]. They stand for `jam_time` [s] before those that can walk do. In n ticks of 0.5 s in
/// which agents stand, their share of the maximum speed falls to 0.8^n: below 0.1 in 5.5 s, when the front one gives
/// way; 1 s after the one behind has reached it, its share is 0.64. After a jam two ticks at full speed raise it to
/// 0.36.
void expectThatTheOneBehindGivesWay(double x, double jam_time, bool gives_way) {
  Crowd crowd({walker({1.04, 0.5}, {9.0, 0.5}), walker({1.45, 0.5}, {-9.0, 0.5}), walker({x, 0.5}, {-9.0, 0.5})});
  crowd.jam(jam_time);
  while (!crowd.givesWay(1) && crowd.world.time() < 60.0) crowd.step();
  ASSERT_TRUE(crowd.givesWay(1));
  crowd.step();
  EXPECT_EQ(crowd.givesWay(2), gives_way);
}
TEST(DeadlockResolver, InAJamAgentsBehindGiveWayToo) { expectThatTheOneBehindGivesWay(2.95, 12.0, true); }
TEST(DeadlockResolver, AgentsBehindThatGotOnUntilNowStay) { expectThatTheOneBehindGivesWay(6.35, 0.0, false); }

/// Two agents face each other between two rows of twelve people who pass them, 1 m apart, within 12 s. Together with
/// them agents in either direction get on.
TEST(DeadlockResolver, WhoIsStuckInACrowdThatGoesOnStays) {
  std::vector<AgentStart> agents = {walker({0.5, 0.75}, {9.0, 0.75}), walker({1.0, 0.75}, {-9.0, 0.75})};
  for (int i = 0; i < 12; ++i) {
    agents.push_back(walker({1.0 - i, 1.35}, {30.0, 1.35}));
    agents.push_back(walker({0.5 + i, 0.15}, {-30.0, 0.15}));
  }
  Crowd crowd(agents);
  while (crowd.world.time() < 9.0) {
    crowd.step();
    EXPECT_FALSE(crowd.doesAnyGiveWay()) << crowd.world.time();
  }
  crowd.walkUntilAnyGivesWay(20.0);
  EXPECT_NE(crowd.givesWay(0), crowd.givesWay(1));
}

/// Agents of the same direction that touch each other, as in front of a door: the one nearer to its goal goes first.
TEST(DeadlockResolver, InAnArchTheAgentFartherFromItsGoalGivesWay) {
  Crowd crowd({walker({-0.9, 0.0}, {9.0, 0.0}), walker({-1.3, 0.0}, {9.0, 0.0})});
  while (!crowd.doesAnyGiveWay() && crowd.world.time() < 60.0) crowd.stand();
  EXPECT_FALSE(crowd.givesWay(0));
  EXPECT_TRUE(crowd.givesWay(1));
}

/// Side by side: agent 1 is 0.3 m behind the line beside agent 0, but has the shorter way, 8.25 m instead of 9.5 m.
TEST(DeadlockResolver, InAnArchAgentsSideBySideGiveWayToo) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 3.0}), walker({-0.25, -0.3125}, {8.0, -0.3125})});
  while (!crowd.doesAnyGiveWay() && crowd.world.time() < 60.0) crowd.stand();
  EXPECT_TRUE(crowd.givesWay(0));  // and agent 1, which it walks towards, makes room
}

/// Two agents face each other and cannot move. The one that gives way first cannot walk back, so it has priority then.
TEST(DeadlockResolver, AnAgentThatCannotWalkBackHasPriority) {
  Crowd crowd({walker({-0.25, 0.0}, {9.0, 0.0}), walker({0.25, 0.0}, {-9.0, 0.0})});
  while (!crowd.doesAnyGiveWay() && crowd.world.time() < 60.0) crowd.stand();
  const AgentId first = crowd.givesWay(0) ? 0 : 1;
  while (crowd.givesWay(first) && crowd.world.time() < 60.0) crowd.stand();
  EXPECT_TRUE(crowd.givesWay(1 - first));
  EXPECT_FALSE(crowd.givesWay(first));
}

/// The way is (1, 0), and the wall runs from the lower left to the upper right in front of the agent; without the part
/// towards the wall, (1, -1) / sqrt(2), it is (1, 1) / 2.
TEST(DeadlockResolver, AnAgentThatIsStuckAloneSlidesAlongTheWall) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0})});
  const double across = 0.2 * std::sqrt(0.5);
  const Vector2 touch(across, -across);
  WorldEditor(crowd.world).addWall({touch - Vector2(0.3, 0.3), touch + Vector2(0.1, 0.1)});
  const Agent& agent = crowd.world.agents()[0];
  while (!agent.has_waypoint && crowd.world.time() < 60.0) crowd.stand();
  EXPECT_GE(crowd.world.time(), DeadlockResolver::STUCK_TIME);
  ASSERT_TRUE(agent.has_waypoint);
  EXPECT_NEAR(((agent.waypoint - agent.pose.position).normalized() - Vector2(1.0, 1.0).normalized()).norm(), 0.0, 1e-9);
}

/// Between a wall on its right and an agent on its left, which has a longer way and so gives way.
TEST(DeadlockResolver, AnAgentThatIsWedgedSlidesAlongWallAndAgent) {
  Crowd crowd({walker({0.0, 0.0}, {9.6, 2.8}), walker({0.0, 0.4}, {19.2, 6.0})});
  WorldEditor(crowd.world).addWall({{-0.3, -0.2}, {0.3, -0.2}});
  const Agent& agent = crowd.world.agents()[0];
  while (!agent.has_waypoint && crowd.world.time() < 60.0) crowd.stand();
  ASSERT_TRUE(agent.has_waypoint);
  EXPECT_NEAR(((agent.waypoint - agent.pose.position).normalized() - Vector2::UnitX()).norm(), 0.0, 1e-9);
}

/// Agent 0 came from the south and is on its way to the east. Nobody can move.
TEST(DeadlockResolver, AnAgentThatWalkedRoundACornerWalksBackAgainstItsPath) {
  std::vector<AgentStart> agents = {walker({-0.25, -2.5}, {-0.25, 0.0}), walker({0.25, 0.0}, {-9.0, 0.0})};
  agents[0].goals.emplace_back(9.0, 0.0);
  Crowd crowd(agents);
  const auto& walked = crowd.world.agents();
  while (walked[0].goal().x() < 9.0 && crowd.world.time() < 60.0) {
    std::vector<AgentAction> actions = straight_walk::actions(crowd.world);
    actions.erase(std::remove_if(actions.begin(), actions.end(), [](const auto& action) { return action.agent != 0; }),
                  actions.end());
    crowd.world.step(actions);
    crowd.update();
  }
  std::vector<Vector2> attempts;  // directions
  for (bool before = false; attempts.size() < 3 && crowd.world.time() < 300.0; before = crowd.givesWay(0)) {
    crowd.stand();
    if (!crowd.givesWay(0) || before) continue;
    attempts.push_back((walked[0].waypoint - walked[0].pose.position).normalized());
  }
  ASSERT_EQ(attempts.size(), 3U);
  for (const Vector2& attempt : attempts) EXPECT_GT(attempt.dot(Vector2(-1.0, 0.0)), 0.99);
}

/// A wall behind agent 0 runs from its upper left to its lower right and touches it. Its way back is (-1, 0); without
/// the part towards the wall, (-1, -1) / sqrt(2), it is (-1, 1) / 2.
TEST(DeadlockResolver, AnAgentSlidesAlongAWallThatItTouches) {
  Crowd crowd({walker({-0.25, 0.0}, {9.0, 0.0}), walker({0.25, 0.0}, {-9.0, 0.0})});
  const double across = 0.2 * std::sqrt(0.5);
  const Vector2 touch(-0.25 - across, -across);
  WorldEditor(crowd.world).addWall({touch + Vector2(-0.3, 0.3), touch + Vector2(0.1, -0.1)});
  while (!crowd.givesWay(0) && crowd.world.time() < 60.0) crowd.stand();
  ASSERT_TRUE(crowd.givesWay(0));
  const Vector2 back = crowd.world.agents()[0].waypoint - crowd.world.agents()[0].pose.position;
  EXPECT_NEAR((back.normalized() - Vector2(-1.0, 1.0).normalized()).norm(), 0.0, 1e-9);
}

TEST(DeadlockResolver, AgentsThatWaitDoNotGiveWay) {
  Crowd held(headOn());
  Crowd yielding(headOn());
  for (AgentId id = 0; id < 2; ++id) {
    WorldEditor(held.world).teleport(id, {{id == 0 ? -0.25 : 0.25, 0.0}, 0.0});
    WorldEditor(yielding.world).teleport(id, {{id == 0 ? -0.25 : 0.25, 0.0}, 0.0});
    held.world.walkingAgent(id).setHeld(Hold::ROUTE, true);
    yielding.world.walkingAgent(id).yielding = true;
  }
  held.walkUntilAnyGivesWay(40.0);
  yielding.walkUntilAnyGivesWay(40.0);
  EXPECT_FALSE(held.doesAnyGiveWay());
  EXPECT_FALSE(yielding.doesAnyGiveWay());
}

TEST(DeadlockResolver, AnAgentBehindOneThatWaitsStays) {
  Crowd crowd({walker({0.0, 0.0}, {9.0, 0.0}), walker({-2.0, 0.0}, {9.0, 0.0})});
  crowd.world.walkingAgent(0).setHeld(Hold::ROUTE, true);
  crowd.walkUntilAnyGivesWay(40.0);
  EXPECT_FALSE(crowd.doesAnyGiveWay());
}

TEST(DeadlockResolver, AgentsThatPassEachOtherDoNotGiveWay) {
  Crowd crowd({walker({-3.0, 0.25}, {9.0, 0.25}), walker({3.0, -0.25}, {-9.0, -0.25})});
  crowd.walkUntilAnyGivesWay(12.0);
  EXPECT_FALSE(crowd.doesAnyGiveWay());
}

/// A corridor of 1.6 m with a narrow part of 0.7 m from x = -2 to x = 2. Two bodies of 0.5 m do not pass each other
/// there.
TEST(DeadlockResolver, BothArriveThroughACorridorInWhichTheyCannotPassEachOther) {
  const ScenarioList scenarios = parseScenarios(
      "name: corridor\nduration: 200\ngoal_tolerance: 0.3\ncontact: solid\n"
      "walls: [[[-12, -0.8], [-2, -0.8]], [[-2, -0.8], [-2, -0.35]], [[-2, -0.35], [2, -0.35]],\n"
      "        [[2, -0.35], [2, -0.8]], [[2, -0.8], [12, -0.8]], [[12, -0.8], [12, 0.8]], [[12, 0.8], [2, 0.8]],\n"
      "        [[2, 0.8], [2, 0.35]], [[2, 0.35], [-2, 0.35]], [[-2, 0.35], [-2, 0.8]], [[-2, 0.8], [-12, 0.8]],\n"
      "        [[-12, 0.8], [-12, -0.8]]]\n"
      "agents: [{position: [-6, 0], goal: [10, 0], speed: 1, radius: 0.25},\n"
      "         {position: [6, 0], goal: [-10, 0], speed: 1, radius: 0.25}]\n",
      "s.yaml");
  EpisodeResult result;
  evaluate(loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt"), scenarios, EvaluationPlan(),
           [&](EvaluatedEpisode& walked) {
             result = walked.result;
             return true;
           });
  EXPECT_EQ(result.arrivedCount(), 2U);
  for (const AgentResult& agent : result.agents) EXPECT_FALSE(agent.touched);
  // Without a meeting a way of 16 m takes 16 s; one agent gave way, which costs STUCK_TIME at least.
  EXPECT_GT(result.ticks, static_cast<std::uint64_t>(10.0 * (16.0 + DeadlockResolver::STUCK_TIME)));
}

}  // namespace
}  // namespace crowd::deadlock_resolver_test
