// The step of a world: which actions move which agents, and how.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/worlds.h"
#include "world/world.h"

namespace crowd::world_step_test {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::scene;
using scenes::wanderer;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

TEST(WorldStep, TurnsBeforeMoving) {
  World world(scene({wanderer({1.0, 2.0}, 1.2)}));
  world.step({{0, {PI / 2, 0.5}}});
  const Agent& walker = world.agents()[0];
  expectVector(walker.pose.position, 1.0, 2.06);  // 0.1 s at half of 1.2 m/s, north
  expectVector(walker.velocity, 0.0, 0.6);
  EXPECT_DOUBLE_EQ(walker.pose.heading, PI / 2);
  EXPECT_TRUE(walker.acted);
  EXPECT_EQ(world.tick(), 1U);
  EXPECT_DOUBLE_EQ(world.time(), 0.1);
}

TEST(WorldStep, UsesTheTickDurationOfTheScene) {
  World world(scenes::halfSeconds(scene({wanderer({0.0, 0.0}, 3.0)})));
  for (int i = 0; i < 4; ++i) world.step({ahead(0)});
  expectVector(world.agents()[0].pose.position, 6.0, 0.0);
  EXPECT_EQ(world.time(), 2.0);
}

TEST(WorldStep, RotationsAddUpAndWrapAround) {
  World world(scene({wanderer({0.0, 0.0}, 1.0)}));
  for (int i = 0; i < 3; ++i) world.step({{0, {toRadians(150.0), 0.0}}});
  EXPECT_NEAR(world.agents()[0].pose.heading, toRadians(90.0), 1e-12);
  world.step({{0, {toRadians(120.0), 1.0}}});
  EXPECT_NEAR(world.agents()[0].pose.heading, toRadians(-150.0), 1e-12);
  expectVector(world.agents()[0].pose.position, -0.1 * std::cos(toRadians(30.0)), -0.05);
}

TEST(WorldStep, AcceptsStayingAsAnAction) {
  World world(scene({wanderer({3.0, 4.0})}));
  world.step({{0, {1.0, 0.0}}});
  expectVector(world.agents()[0].pose.position, 3.0, 4.0);
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.heading, 1.0);
  EXPECT_TRUE(world.agents()[0].acted);
}

TEST(WorldStep, AgentsWithoutAnActionStay) {
  World world(scene({wanderer({0.0, 0.0}, 1.0), wanderer({0.0, 5.0}, 1.0)}));
  world.step({ahead(0), ahead(1)});
  world.step({ahead(1)});
  expectVector(world.agents()[0].pose.position, 0.1, 0.0);
  expectVector(world.agents()[0].velocity, 0.0, 0.0);
  EXPECT_FALSE(world.agents()[0].acted);
  expectVector(world.agents()[1].pose.position, 0.2, 5.0);
  expectVector(world.agents()[1].velocity, 1.0, 0.0);
  EXPECT_TRUE(world.agents()[1].acted);
}

TEST(WorldStep, IgnoresASecondActionOfAnAgent) {
  World world(scene({wanderer({0.0, 0.0}, 1.0)}));
  world.step({ahead(0), ahead(0)});
  expectVector(world.agents()[0].pose.position, 0.1, 0.0);
}

TEST(WorldStep, OrderOfActionsDoesNotMatter) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene crowd = scenes::randomScene(seed);
    World world(crowd);
    World shuffled_world(crowd);
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    for (int tick = 0; tick < 30; ++tick) {
      std::vector<AgentAction> actions = scenes::randomActions(world, random);
      world.step(actions);
      for (std::size_t i = actions.size(); i > 1; --i) {
        std::swap(actions[i - 1], actions[random.below(static_cast<std::uint32_t>(i))]);
      }
      shuffled_world.step(actions);
      ASSERT_EQ(stateOf(shuffled_world), stateOf(world)) << "tick " << tick;
    }
  }
}

TEST(WorldStep, IgnoresActionsOfUnknownAndArrivedAgents) {
  World world(scene({agent({0.0, 0.0}, {0.2, 0.0}), wanderer({0.0, 5.0})}));
  world.step({{7, {0.0, 1.0}}, {UINT32_MAX, {0.0, 1.0}}});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  world.step({ahead(0)});
  expectVector(world.agents()[0].pose.position, 0.0, 0.0);
  EXPECT_FALSE(world.agents()[0].acted);
  EXPECT_EQ(world.agents().size(), 2U);
  EXPECT_EQ(world.tick(), 2U);
}

TEST(WorldStep, RefusesInvalidActionsBeforeAnythingMoves) {
  const std::vector<RelativeAction> illegal = {{NOT_A_NUMBER, 1.0}, {INFINITE, 1.0}, {0.0, NOT_A_NUMBER},
                                               {0.0, INFINITE},     {0.0, -0.001},   {0.0, 1.0000001}};
  World world(scene({wanderer({0.0, 0.0}), wanderer({0.0, 5.0})}, {moving_obstacle({9.0, 9.0}, {1.0, 0.0}, 0.5)}));
  world.step({ahead(0)});
  const std::vector<double> before = stateOf(world);
  for (const RelativeAction& action : illegal) {
    SCOPED_TRACE(testing::Message() << action.rotation << ", " << action.speed_fraction);
    EXPECT_THROW(world.step({ahead(0), {1, action}}), InputError);
    EXPECT_EQ(stateOf(world), before);
  }
  world.step({});  // the valid action beside the invalid one is not kept
  EXPECT_FALSE(world.agents()[0].acted);
  world.step({{0, {0.0, 0.0}}, {1, {0.0, 1.0}}});  // both limits of the fraction are valid
  EXPECT_TRUE(world.agents()[0].acted);
  EXPECT_TRUE(world.agents()[1].acted);
  EXPECT_EQ(world.tick(), 3U);
}

TEST(WorldStep, ErrorNamesAgentAndNumbers) {
  World world(scene({wanderer({0.0, 0.0})}));
  const std::string message = errorOf<InputError>([&] { world.step({{0, {0.0, 1.5}}}); });
  EXPECT_TRUE(contains(message, "agent 0")) << message;
  EXPECT_TRUE(contains(message, "1.5")) << message;
}

}  // namespace
}  // namespace crowd::world_step_test
