#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/random.h"
#include "support/overlaps.h"
#include "world/world.h"

/// Builders of scenes for tests.
namespace crowd::scenes {

constexpr double SPEED = 1.3;            // [m/s]
constexpr double RADIUS = 0.25;          // [m]
constexpr double GOAL_TOLERANCE = 0.25;  // [m]
constexpr std::uint64_t MAX_TICKS = 1000;

/// A goal that no test reaches [m].
inline const Vector2 FAR_AWAY(1000.0, 0.0);

/// An agent that faces its goal.
inline AgentStart agent(const Vector2& position, const Vector2& goal, double max_speed = SPEED,
                        double radius = RADIUS) {
  return {position, bearingOf(goal - position), {goal}, max_speed, radius};
}

/// An agent that faces along x and never arrives.
inline AgentStart wanderer(const Vector2& position, double max_speed = SPEED, double radius = RADIUS) {
  return {position, 0.0, {FAR_AWAY}, max_speed, radius};
}

inline Scene scene(std::vector<AgentStart> agents, std::vector<Obstacle> obstacles = {},
                   std::vector<Segment> walls = {}) {
  Scene scene;
  scene.name = "scene";
  scene.max_ticks = MAX_TICKS;
  scene.goal_tolerance = GOAL_TOLERANCE;
  scene.agents = std::move(agents);
  scene.obstacles = std::move(obstacles);
  scene.walls = std::move(walls);
  return scene;
}

/// The same scene with a tick duration that is exact in binary: 0.5 s, so that an agent of
/// 1 m/s walks 0.5 m per tick.
inline Scene halfSeconds(Scene scene) {
  scene.tick_duration = 0.5;
  return scene;
}

/// The same scene as a solid world: bodies stop at contacts.
inline Scene solid(Scene scene) {
  scene.contact = Contact::SOLID;
  return scene;
}

inline Obstacle pillar(const Vector2& position, double radius) { return {ObstaclePath::atRest(position), radius}; }

inline Obstacle moving_obstacle(const Vector2& start, const Vector2& velocity, double radius) {
  return {ObstaclePath::straight(start, velocity), radius};
}

inline Vector2 randomPoint(KeyedRandom& random, double half_width) {
  const double x = random.uniform(-half_width, half_width);
  return {x, random.uniform(-half_width, half_width)};
}

/// A square with agents that walk through each other, static and moving obstacles, and walls.
inline Scene randomScene(std::uint64_t seed, std::uint32_t max_agents = 30, double half_width = 6.0) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  Scene made = scene({});
  made.agents.resize(2 + random.below(max_agents - 1));
  for (AgentStart& start : made.agents) {
    start.position = randomPoint(random, half_width);
    start.heading = random.uniform(-PI, PI);
    for (std::uint32_t goals = 1 + random.below(2); goals > 0; --goals) {
      start.goals.emplace_back(start.position + randomPoint(random, 3.0));
    }
    start.max_speed = random.uniform(0.5, 2.0);
    start.radius = random.uniform(0.15, 0.4);
  }
  for (std::uint32_t i = random.below(6); i > 0; --i) {
    const Vector2 start = randomPoint(random, half_width);
    made.obstacles.push_back(pillar(start, random.uniform(0.2, 0.8)));
  }
  for (std::uint32_t i = random.below(4); i > 0; --i) {
    const Vector2 start = randomPoint(random, half_width);
    const Vector2 velocity = randomPoint(random, 1.0);
    made.obstacles.push_back(moving_obstacle(start, velocity, random.uniform(0.2, 0.8)));
  }
  for (std::uint32_t i = random.below(4); i > 0; --i) {
    const Vector2 from = randomPoint(random, half_width);
    made.walls.push_back({from, randomPoint(random, half_width)});
  }
  return made;
}

/// A random scene with enough agents for several threads.
inline Scene randomCrowd(std::uint64_t seed) {
  Scene made = randomScene(seed, 500, 20.0);
  while (made.agents.size() <= 2 * ThreadPool::FEW_SHORT_ITEMS) {
    made.agents.push_back(made.agents[made.agents.size() / 2]);
  }
  return made;
}

/// A dense crowd in a solid world in which no bodies overlap at the start: agents with speeds up to `max_speed` [m/s],
/// static obstacles, a number of moving obstacles, and walls.
inline Scene solidCrowd(std::uint64_t seed, std::size_t agents, double max_speed, std::size_t moving_obstacles = 0) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {1});
  const double half_width = 0.5 * std::sqrt(static_cast<double>(agents)) + 1.0;
  Scene made = solid(scene({}));
  for (int i = 0; i < 3; ++i) {
    const Vector2 from = randomPoint(random, half_width);
    made.walls.push_back({from, randomPoint(random, half_width)});
    made.obstacles.push_back(pillar(randomPoint(random, half_width), random.uniform(0.2, 0.6)));
  }
  for (std::size_t i = 0; i < moving_obstacles; ++i) {
    const Vector2 start = randomPoint(random, half_width);
    made.obstacles.push_back(moving_obstacle(start, randomPoint(random, 1.5), random.uniform(0.2, 0.6)));
  }
  while (made.agents.size() < agents) {
    made.agents.push_back(
        wanderer(randomPoint(random, half_width), random.uniform(0.5, max_speed), random.uniform(0.15, 0.35)));
    if (hasOverlap(made)) made.agents.pop_back();
  }
  return made;
}

/// Random actions of about nine tenths of the agents.
inline std::vector<AgentAction> randomActions(const World& world, KeyedRandom& random) {
  std::vector<AgentAction> actions;
  for (const Agent& agent : world.agents()) {
    const double rotation = random.uniform(-PI, PI);
    const double share = random.uniform();
    if (random.below(10) > 0) actions.push_back({agent.id, {rotation, share}});
  }
  return actions;
}

/// The same, but every other agent walks straight to its goal.
inline std::vector<AgentAction> purposefulActions(const World& world, KeyedRandom& random) {
  std::vector<AgentAction> actions = randomActions(world, random);
  for (AgentAction& given : actions) {
    const Agent& agent = world.agents()[given.agent];
    const double bearing = bearingOf(agent.goal() - agent.pose.position);
    if (agent.id % 2 == 0) given.action = {wrapAngle(bearing - agent.pose.heading), 1.0};
  }
  return actions;
}

}  // namespace crowd::scenes
