#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"
#include "world/world_editor.h"

namespace crowd::world_editor_test {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// Requires an InputError with a reason, and an unchanged world.
template <typename Call>
void expectRefused(World& world, const std::string& reason, const Call& call) {
  SCOPED_TRACE(reason);
  const std::vector<double> before = stateOf(world);
  const std::size_t bodies = lookAround(world).neighbours.size();
  const std::string message = errorOf<InputError>(call);
  EXPECT_TRUE(contains(message, reason)) << message;
  EXPECT_EQ(stateOf(world), before);
  EXPECT_EQ(lookAround(world).neighbours.size(), bodies);
}

TEST(WorldEditor, SpawnedAgentIsPerceivedAtOnceAndWalks) {
  World world(scene({wanderer({0.0, 0.0})}, {pillar({0.0, 3.0}, 0.5)}));
  world.step({});
  EXPECT_EQ(WorldEditor(world).spawnAgent(agent({3.0, 0.0}, {3.0, 1.0}, 1.0, 0.4)), 1U);
  EXPECT_EQ(world.activeCount(), 2U);
  EXPECT_TRUE(world.isActive(1));
  const Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.agents.size(), 2U);
  ASSERT_EQ(seen.agents[0].neighbour_count, 2U);
  expectVector(seen.neighbours[0].position, 0.0, 3.0);  // the rim of the obstacle is nearer
  EXPECT_EQ(seen.neighbours[0].kind, NeighbourKind::OBSTACLE);
  expectVector(seen.neighbours[1].position, 3.0, 0.0);
  EXPECT_EQ(seen.neighbours[1].kind, NeighbourKind::AGENT);
  world.step({ahead(1)});
  expectVector(world.agents()[1].pose.position, 3.0, 0.1);
}

TEST(WorldEditor, RefusesToSpawnAgentsOnOccupiedPlaces) {
  World world(scene({wanderer({0.0, 0.0}), agent({5.0, 5.0}, {5.1, 5.0})}, {pillar({0.0, 3.0}, 0.5)},
                    {{{-9.0, -2.0}, {9.0, -2.0}}}));
  world.step({});
  ASSERT_TRUE(world.agents()[1].hasArrived());
  expectRefused(world, "agent 0", [&] { WorldEditor(world).spawnAgent(wanderer({0.49, 0.0})); });
  expectRefused(world, "obstacle 0", [&] { WorldEditor(world).spawnAgent(wanderer({0.0, 2.3})); });
  expectRefused(world, "wall", [&] { WorldEditor(world).spawnAgent(wanderer({3.0, -1.8})); });
  EXPECT_EQ(WorldEditor(world).spawnAgent(wanderer({0.5, 0.0})), 2U);  // beside agent 0
  EXPECT_EQ(WorldEditor(world).spawnAgent(wanderer({5.0, 5.0})), 3U);  // where agent 1 arrived
}

TEST(WorldEditor, RefusesToSpawnInvalidAgents) {
  World world(scene({wanderer({0.0, 0.0})}));
  const auto refuse = [&](const std::string& what, const AgentStart& start) {
    expectRefused(world, what, [&] { WorldEditor(world).spawnAgent(start); });
  };
  refuse("speed", wanderer({3.0, 0.0}, 0.0));
  refuse("speed", wanderer({3.0, 0.0}, -1.0));
  refuse("speed", wanderer({3.0, 0.0}, INFINITE));
  refuse("radius", wanderer({3.0, 0.0}, 1.0, 0.0));
  refuse("radius", wanderer({3.0, 0.0}, 1.0, NOT_A_NUMBER));
  refuse("position", wanderer({NOT_A_NUMBER, 0.0}));
  refuse("position", wanderer({0.0, INFINITE}));
  refuse("goal", agent({3.0, 0.0}, {INFINITE, 0.0}));
  AgentStart dizzy = wanderer({3.0, 0.0});
  dizzy.heading = NOT_A_NUMBER;
  refuse("heading", dizzy);
}

TEST(WorldEditor, RefusesToSpawnAgentsWithoutAGoal) {
  World world(scene({wanderer({0.0, 0.0})}));
  AgentStart aimless = wanderer({3.0, 0.0});
  aimless.goals.clear();
  EXPECT_THROW(WorldEditor(world).spawnAgent(aimless), InputError);
}

TEST(WorldEditor, RemovedAgentIsNotPerceived) {
  World world(scene({wanderer({0.0, 0.0}), wanderer({2.0, 0.0}), agent({9.0, 9.0}, {9.1, 9.0})}));
  world.step({});
  WorldEditor(world).removeAgent(0);
  EXPECT_EQ(world.activeCount(), 1U);
  EXPECT_FALSE(world.isActive(0));
  EXPECT_EQ(world.agents()[0].status, AgentStatus::REMOVED);
  const Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.agents.size(), 2U);  // agent 2 has just arrived
  EXPECT_EQ(seen.agents[0].agent, 1U);
  EXPECT_EQ(seen.agents[0].neighbour_count, 0U);
  world.step({ahead(0), ahead(1)});
  expectVector(world.agents()[0].pose.position, 0.0, 0.0);
  expectRefused(world, "0", [&] { WorldEditor(world).removeAgent(0); });  // removed already
  expectRefused(world, "2", [&] { WorldEditor(world).removeAgent(2); });  // arrived
  expectRefused(world, "3", [&] { WorldEditor(world).removeAgent(3); });  // unknown
}

TEST(WorldEditor, NewGoalReplacesAllGoals) {
  AgentStart start = agent({0.0, 0.0}, {5.0, 0.0}, 1.0);
  start.goals.emplace_back(0.0, 5.0);
  World world(scenes::halfSeconds(scene({start, agent({9.0, 9.0}, {9.1, 9.0})})));
  WorldEditor(world).setGoal(0, {1.0, 0.0});
  expectVector(world.agents()[0].goal(), 1.0, 0.0);
  for (int i = 0; i < 2; ++i) world.step({ahead(0)});
  EXPECT_TRUE(world.agents()[0].hasArrived());
}

TEST(WorldEditor, NewGoalAfterTheFirstArrivalReplacesTheRest) {
  AgentStart start = agent({0.0, 0.0}, {0.5, 0.0}, 1.0);
  start.goals.emplace_back(8.0, 0.0);
  World world(scenes::halfSeconds(scene({start})));
  world.step({ahead(0)});
  WorldEditor(world).setGoal(0, {1.5, 0.0});
  world.step({ahead(0)});
  EXPECT_TRUE(world.isActive(0));
  world.step({ahead(0)});
  EXPECT_TRUE(world.agents()[0].hasArrived());
}

TEST(WorldEditor, RefusesInvalidGoals) {
  World world(scene({agent({0.0, 0.0}, {5.0, 0.0}), agent({9.0, 9.0}, {9.1, 9.0})}));
  world.step({});
  expectRefused(world, "goal", [&] { WorldEditor(world).setGoal(0, {NOT_A_NUMBER, 0.0}); });
  expectRefused(world, "goal", [&] { WorldEditor(world).setGoal(0, {0.0, -INFINITE}); });
  expectRefused(world, "1", [&] { WorldEditor(world).setGoal(1, {0.0, 0.0}); });  // arrived
  expectRefused(world, "2", [&] { WorldEditor(world).setGoal(2, {0.0, 0.0}); });  // unknown
}

TEST(WorldEditor, SpawnedObstacleBeginsItsPathAtThePresentTime) {
  World world(scenes::halfSeconds(scene({wanderer({0.0, 0.0})}, {}, {{{0.0, -4.0}, {8.0, -4.0}}})));
  for (int i = 0; i < 3; ++i) world.step({});
  EXPECT_EQ(WorldEditor(world).spawnObstacle({4.0, -4.0}, {0.0, 1.0}, 0.5), 0U);   // obstacles may overlap walls
  EXPECT_EQ(WorldEditor(world).spawnObstacle({4.0, -4.0}, {0.0, 0.0}, 0.25), 1U);  // and each other
  const Perceptions now = lookAround(world);
  ASSERT_EQ(now.neighbours.size(), 2U);
  expectVector(now.neighbours[0].position, 4.0, -4.0);
  expectVector(now.neighbours[0].velocity, 0.0, 1.0);
  expectVector(now.neighbours[1].velocity, 0.0, 0.0);
  EXPECT_FALSE(world.obstacles()[1].path.moves());
  world.step({});
  const Perceptions later = lookAround(world);
  expectVector(later.neighbours[0].position, 4.0, -3.5);
  expectVector(later.neighbours[1].position, 4.0, -4.0);
}

TEST(WorldEditor, RefusesInvalidObstacles) {
  World world(scene({wanderer({0.0, 0.0})}));
  const Vector2 rest(0.0, 0.0);
  expectRefused(world, "agent 0", [&] { WorldEditor(world).spawnObstacle({0.7, 0.0}, rest, 0.5); });
  expectRefused(world, "radius", [&] { WorldEditor(world).spawnObstacle({3.0, 0.0}, rest, 0.0); });
  expectRefused(world, "radius", [&] { WorldEditor(world).spawnObstacle({3.0, 0.0}, rest, INFINITE); });
  expectRefused(world, "position", [&] { WorldEditor(world).spawnObstacle({3.0, NOT_A_NUMBER}, rest, 0.5); });
  expectRefused(world, "velocity", [&] { WorldEditor(world).spawnObstacle({3.0, 0.0}, {INFINITE, 0.0}, 0.5); });
}

TEST(WorldEditor, MovedObstacleKeepsNumberAndVelocity) {
  World world(scenes::halfSeconds(
      scene({wanderer({0.0, 0.0})}, {moving_obstacle({4.0, 0.0}, {0.0, 1.0}, 0.25), pillar({2.0, 0.0}, 0.5)})));
  world.step({});
  WorldEditor(world).moveObstacle(0, {1.0, 3.0});
  ASSERT_EQ(world.obstacles().size(), 2U);
  expectVector(world.obstacles()[0].path.position(world.time()), 1.0, 3.0);
  expectVector(world.obstacles()[1].path.position(world.time()), 2.0, 0.0);
  world.step({});  // half a second later
  expectVector(world.obstacles()[0].path.position(world.time()), 1.0, 3.5);
  EXPECT_EQ(world.obstacles()[0].radius, 0.25);
  WorldEditor(world).moveObstacle(1, {0.0, -2.0});
  EXPECT_FALSE(world.obstacles()[1].path.moves());
  expectRefused(world, "obstacle 2", [&] { WorldEditor(world).moveObstacle(2, {3.0, 3.0}); });
  expectRefused(world, "agent 0", [&] { WorldEditor(world).moveObstacle(1, {0.3, 0.0}); });
  expectRefused(world, "position", [&] { WorldEditor(world).moveObstacle(1, {NOT_A_NUMBER, 0.0}); });
}

TEST(WorldEditor, RemovingAnObstacleRenumbersTheFollowingOnes) {
  World world(scene({wanderer({0.0, 0.0})}, {pillar({2.0, 0.0}, 0.5), moving_obstacle({4.0, 0.0}, {0.0, 1.0}, 0.25)}));
  WorldEditor(world).removeObstacle(0);
  ASSERT_EQ(world.obstacles().size(), 1U);
  const Perceptions seen = lookAround(world);
  ASSERT_EQ(seen.neighbours.size(), 1U);
  expectVector(seen.neighbours[0].position, 4.0, 0.0);
  expectVector(seen.neighbours[0].velocity, 0.0, 1.0);
  EXPECT_EQ(seen.neighbours[0].radius, 0.25);
  expectRefused(world, "obstacle 1", [&] { WorldEditor(world).removeObstacle(1); });
}

TEST(WorldEditor, EveryNewGoalHasANewNumber) {
  AgentStart start = agent({0.0, 0.0}, {0.5, 0.0}, 1.0);
  start.goals.emplace_back(8.0, 0.0);
  World world(scenes::halfSeconds(scene({start, wanderer({0.0, 3.0})})));
  const auto numbers = [&] {
    const Perceptions seen = lookAround(world);
    return std::vector<std::uint32_t>{seen.agents[0].goal_number, seen.agents[1].goal_number};
  };
  EXPECT_EQ(numbers(), (std::vector<std::uint32_t>{0, 0}));
  world.step({ahead(0)});  // reaches the first
  EXPECT_EQ(numbers(), (std::vector<std::uint32_t>{1, 0}));
  world.step({});
  EXPECT_EQ(numbers(), (std::vector<std::uint32_t>{1, 0}));
  WorldEditor(world).setGoal(0, {9.0, 0.0});
  WorldEditor(world).setGoal(1, scenes::FAR_AWAY);  // the same position is a new goal, too
  EXPECT_EQ(numbers(), (std::vector<std::uint32_t>{2, 1}));
}

}  // namespace
}  // namespace crowd::world_editor_test
