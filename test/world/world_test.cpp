#include "social_crowd/world/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "social_crowd/common/errors.h"
#include "support/error_of.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd {
namespace {

using scenes::agent;
using scenes::moving_obstacle;
using scenes::pillar;
using scenes::scene;
using scenes::wanderer;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();
TEST(WorldStep, TurnsFirstThenWalks) {
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

TEST(WorldStep, LastsAsLongAsTheSceneSays) {
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

TEST(WorldStep, StayingIsAnAction) {
  World world(scene({wanderer({3.0, 4.0})}));
  world.step({{0, {1.0, 0.0}}});
  expectVector(world.agents()[0].pose.position, 3.0, 4.0);
  EXPECT_DOUBLE_EQ(world.agents()[0].pose.heading, 1.0);
  EXPECT_TRUE(world.agents()[0].acted);
}

TEST(WorldStep, NobodyMovesWithoutAnAction) {
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

TEST(WorldStep, SecondActionOfATickDoesNotMoveAnAgentAgain) {
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

TEST(WorldStep, IllegalActionsThrowAndNothingHasMoved) {
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
  world.step({});  // what stood beside the illegal ones is forgotten
  EXPECT_FALSE(world.agents()[0].acted);
  world.step({{0, {0.0, 0.0}}, {1, {0.0, 1.0}}});  // both limits of the share are legal
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

TEST(WorldArrival, WithinTheTolerance) {
  Scene line = scenes::halfSeconds(scene({agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}));
  line.goal_tolerance = 0.5;
  World world(line);
  EXPECT_EQ(world.activeCount(), 1U);
  for (int i = 0; i < 2; ++i) world.step({ahead(0)});
  EXPECT_TRUE(world.isActive(0));  // at x = 1
  world.step({ahead(0)});          // at x = 1.5, 0.5 m from the goal
  EXPECT_TRUE(world.agents()[0].hasArrived());
  EXPECT_EQ(world.agents()[0].arrival_tick, 3U);
  EXPECT_EQ(world.activeCount(), 0U);
  EXPECT_FALSE(world.isActive(0));
}

TEST(WorldArrival, JustOutsideTheToleranceIsNotThere) {
  Scene line = scenes::halfSeconds(scene({agent({0.0, 0.0}, {2.0, 0.0}, 1.0)}));
  line.goal_tolerance = std::nextafter(0.5, 0.0);
  World world(line);
  for (int i = 0; i < 3; ++i) world.step({ahead(0)});
  EXPECT_TRUE(world.isActive(0));
}

TEST(WorldArrival, WhoBeginsAtItsGoalArrivesAtTheEndOfTheFirstTick) {
  World world(scene({agent({0.0, 0.0}, {0.1, 0.0}), wanderer({9.0, 9.0})}));
  EXPECT_TRUE(world.isActive(0));
  world.step({});
  EXPECT_EQ(world.agents()[0].arrival_tick, 1U);
}

TEST(WorldArrival, SeveralGoalsAreReachedInTheirOrder) {
  AgentStart rounder = agent({0.0, 0.0}, {2.0, 0.0}, 1.0);
  rounder.goals = {{2.0, 0.0}, {1.0, 0.0}, {3.0, 0.0}};
  World world(scenes::halfSeconds(scene({rounder})));
  const Agent& walker = world.agents()[0];
  for (int i = 0; i < 3; ++i) world.step({ahead(0)});
  expectVector(walker.goal(), 2.0, 0.0);  // it has passed (1, 0), but that is not its turn yet
  world.step({ahead(0)});
  expectVector(walker.goal(), 1.0, 0.0);
  world.step({{0, {PI, 1.0}}});
  expectVector(walker.goal(), 1.0, 0.0);
  world.step({ahead(0)});
  expectVector(walker.goal(), 3.0, 0.0);
  for (int i = 0; i < 3; ++i) world.step({{0, {i == 0 ? PI : 0.0, 1.0}}});
  EXPECT_TRUE(world.isActive(0));
  world.step({ahead(0)});
  EXPECT_TRUE(walker.hasArrived());
  EXPECT_EQ(walker.arrival_tick, 10U);
}

TEST(WorldArrival, ArrivedAgentsAreNeitherPerceivedNorTouched) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({-1.5, 0.0}, 1.0)})));
  for (int i = 0; i < 2; ++i) world.step({ahead(0), ahead(1)});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  const Perceptions after = lookAround(world);
  ASSERT_EQ(after.agents.size(), 2U);
  EXPECT_EQ(after.agents[1].neighbour_count, 0U);
  for (int i = 0; i < 4; ++i) {
    world.step({ahead(1)});  // through (1, 0), where the other one stopped
    EXPECT_FALSE(world.agents()[0].in_contact);
    EXPECT_FALSE(world.agents()[1].touched);
  }
  expectVector(world.agents()[1].pose.position, 1.5, 0.0);
}

TEST(WorldArrival, IsPerceivedExactlyOnce) {
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {1.0, 0.0}, 1.0), wanderer({0.0, 5.0})})));
  int arrivals = 0;
  for (int tick = 0; tick < 5; ++tick) {
    for (const AgentPerception& seen : lookAround(world).agents) {
      if (seen.agent != 0) continue;
      EXPECT_LE(world.tick(), 2U);
      EXPECT_EQ(seen.arrived, world.tick() == 2U);
      arrivals += seen.arrived ? 1 : 0;
    }
    world.step({ahead(0)});
  }
  EXPECT_EQ(arrivals, 1);
}

TEST(WorldArrival, ContactsAtTheEndOfThatVeryTickCount) {
  // Agent 0 arrives at (0.5, 0), 0.4 m from agent 1: they overlap by 0.1 m.
  World world(scenes::halfSeconds(scene({agent({0.0, 0.0}, {0.5, 0.0}, 1.0), wanderer({0.9, 0.0})})));
  world.step({ahead(0)});
  ASSERT_TRUE(world.agents()[0].hasArrived());
  EXPECT_TRUE(world.agents()[0].touched);
  EXPECT_TRUE(world.agents()[1].touched);
  world.step({});
  EXPECT_FALSE(world.agents()[1].in_contact);
  EXPECT_TRUE(world.agents()[1].touched);  // once touched, always touched
}

/// Whether the first agent of a scene is in contact after a tick without moves.
bool isInContact(const Scene& scene) {
  World world(scene);
  EXPECT_FALSE(world.agents()[0].in_contact);  // ticks count, not the start
  world.step({});
  EXPECT_EQ(world.agents()[0].touched, world.agents()[0].in_contact);
  return world.agents()[0].in_contact;
}

TEST(WorldContact, BeginsBeyondOneMillimetre) {
  const auto beside = [](double gap) -> Vector2 { return Vector2(3.0, 4.0) + (0.5 + gap) * unitVector(2.0); };
  const AgentStart standing = wanderer({3.0, 4.0});
  EXPECT_FALSE(isInContact(scene({standing, wanderer(beside(0.001))})));
  EXPECT_FALSE(isInContact(scene({standing, wanderer(beside(-0.00099))})));
  EXPECT_TRUE(isInContact(scene({standing, wanderer(beside(-0.00101))})));
  EXPECT_FALSE(isInContact(scene({standing}, {pillar(beside(-0.00099), 0.25)})));
  EXPECT_TRUE(isInContact(scene({standing}, {pillar(beside(-0.00101), 0.25)})));
}

TEST(WorldContact, WallsCountLikeBodies) {
  const auto wall = [](double x) { return std::vector<Segment>{{{x, -1.0}, {x, 1.0}}}; };
  EXPECT_FALSE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(0.24901))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(0.24899))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {}, wall(-0.1))));
  EXPECT_TRUE(isInContact(scene({wanderer({0.1, 1.2})}, {}, wall(0.0))));   // 0.22 m from the wall's end
  EXPECT_FALSE(isInContact(scene({wanderer({0.2, 1.2})}, {}, wall(0.0))));  // 0.28 m
}

TEST(WorldContact, LargeObstacleReachesFar) {
  EXPECT_TRUE(isInContact(scene({wanderer({0.0, 0.0})}, {pillar({20.2, 0.0}, 20.0)})));
  EXPECT_FALSE(isInContact(scene({wanderer({0.0, 0.0})}, {pillar({20.3, 0.0}, 20.0)})));
}

TEST(WorldContact, MovingObstacleRunsIntoAnAgentAndOn) {
  // Centres are 1 - 0.1 k m apart after tick k, radii sum up to 0.5 m: contact from tick 6 to 14.
  World world(scene({wanderer({1.0, 0.0}, 1.0, 0.2)}, {moving_obstacle({0.0, 0.0}, {1.0, 0.0}, 0.3)}));
  for (int tick = 1; tick <= 20; ++tick) {
    world.step({});
    EXPECT_EQ(world.agents()[0].in_contact, tick >= 6 && tick <= 14) << "tick " << tick;
    EXPECT_EQ(world.agents()[0].touched, tick >= 6) << "tick " << tick;
  }
}

/// Whether an agent overlaps anything by more than a millimetre, by looking at everything.
bool overlapsSomething(const World& world, const Agent& agent) {
  const Vector2& at = agent.pose.position;
  const auto overlaps = [&](const Vector2& centre, double radius) {
    return agent.radius + radius - std::hypot(centre.x() - at.x(), centre.y() - at.y()) > 0.001;
  };
  bool contact = false;
  for (const Agent& other : world.agents()) {
    const bool on_the_floor = other.isWalking() || other.arrival_tick == world.tick();
    contact = contact || (on_the_floor && other.id != agent.id && overlaps(other.pose.position, other.radius));
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    contact = contact || overlaps(obstacle.path.position(world.time()), obstacle.radius);
  }
  for (const Segment& wall : world.walls()) contact = contact || overlaps(nearestPoint(wall, at), 0.0);
  return contact;
}

TEST(WorldContact, AgreesWithLookingAtEverything) {
  std::size_t contacts = 0;
  std::size_t arrivals = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world(scenes::randomScene(seed, 60));
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {});
    std::vector<bool> touched(world.agents().size(), false);
    for (int tick = 0; tick < 40; ++tick) {
      world.step(scenes::randomActions(world, random));
      for (const Agent& agent : world.agents()) {
        const bool arrives = agent.hasArrived() && agent.arrival_tick == world.tick();
        const bool contact = (agent.isWalking() || arrives) && overlapsSomething(world, agent);
        touched[agent.id] = touched[agent.id] || contact;
        ASSERT_EQ(agent.in_contact, contact) << "tick " << world.tick() << ", agent " << agent.id;
        ASSERT_EQ(agent.touched, touched[agent.id]) << "tick " << world.tick() << ", agent " << agent.id;
        contacts += contact ? 1 : 0;
        arrivals += arrives ? 1 : 0;
      }
    }
  }
  EXPECT_GT(contacts, 1000U);
  EXPECT_GT(arrivals, 5U);
}

}  // namespace
}  // namespace crowd
