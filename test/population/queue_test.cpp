#include "population/queue.h"

#include <gtest/gtest.h>

#include "support/straight_walk.h"
#include "world/world_editor.h"

namespace crowd::queue_test {
namespace {

/// Head at the origin, places at x = 0, 1, 2 ...; agents stay at the goals they have until the queue sends them.
QueueDescription line(const Range& service = {2.0, 2.0}) {
  QueueDescription queue;
  queue.spacing = 1.0;
  queue.service = service;
  return queue;
}

/// Agents of 1 m/s and ticks of 0.5 s that do not leave at their goals.
World worldOf(const std::vector<Vector2>& places, std::vector<Segment> walls = {}) {
  Scene scene;
  scene.tick_duration = 0.5;
  scene.goal_tolerance = 0.1;
  scene.walls = std::move(walls);
  for (const Vector2& place : places) {
    AgentStart start;
    start.position = place;
    start.goals = {place};
    start.max_speed = 1.0;
    start.radius = 0.2;
    start.leaves = false;
    scene.agents.push_back(start);
  }
  return World(scene);
}

KeyedRandom random() { return {1, KeyedRandom::POPULATION, {}}; }

void step(World& world) { world.step(straight_walk::actions(world)); }

TEST(Queue, TheNearestStandsInLineFirst) {
  World world = worldOf({{9.0, 0.0}, {0.5, 0.5}, {0.0, 0.5}});
  const QueueDescription description = line();
  Queue queue(description, random());
  for (const AgentId agent : {0U, 1U, 2U}) queue.join(agent);
  EXPECT_TRUE(queue.update(world).empty());
  // Agent 2 is 0.5 m from the head; then agent 1 is 0.707 m from place 1, and agent 0 is 7 m from place 2.
  EXPECT_EQ(queue.line(), (std::vector<AgentId>{2, 1}));
  EXPECT_EQ(world.agents()[2].goal(), Vector2(0.0, 0.0));
  EXPECT_EQ(world.agents()[1].goal(), Vector2(1.0, 0.0));
  EXPECT_EQ(world.agents()[0].goal(), Vector2(2.0, 0.0));
}

/// Agent 0 is at the head after one tick, and is served for 2 s from then on, until t = 2.5 s. Agent 1 stands 1 m
/// behind: it moves up in 2 ticks, until t = 3.5 s, and is served until t = 5.5 s.
TEST(Queue, ServesOneAfterTheOther) {
  World world = worldOf({{0.0, 0.5}, {1.0, 0.0}});
  const QueueDescription description = line();
  Queue queue(description, random());
  queue.join(0);
  queue.join(1);
  std::vector<std::pair<double, AgentId>> served;
  while (world.time() < 10.0) {
    for (const AgentId agent : queue.update(world)) served.emplace_back(world.time(), agent);
    if (world.time() == 2.5) {
      EXPECT_EQ(world.agents()[1].goal(), Vector2(0.0, 0.0));
    }
    step(world);
  }
  EXPECT_EQ(served, (std::vector<std::pair<double, AgentId>>{{2.5, 0}, {5.5, 1}}));
  EXPECT_TRUE(queue.line().empty());
}

TEST(Queue, TheLineMovesUpWhenAnAgentLeavesIt) {
  World world = worldOf({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}});
  const QueueDescription description = line({100.0, 100.0});
  Queue queue(description, random());
  for (const AgentId agent : {0U, 1U, 2U}) queue.join(agent);
  queue.update(world);
  EXPECT_EQ(queue.end(), Vector2(3.0, 0.0));
  queue.leave(1);
  queue.update(world);
  EXPECT_EQ(queue.line(), (std::vector<AgentId>{0, 2}));
  EXPECT_EQ(world.agents()[2].goal(), Vector2(1.0, 0.0));
  EXPECT_EQ(queue.end(), Vector2(2.0, 0.0));
}

TEST(Queue, TheNextIsServedWhenTheFirstLeaves) {
  World world = worldOf({{0.0, 0.0}, {1.0, 0.0}});
  const QueueDescription description = line({4.0, 4.0});
  Queue queue(description, random());
  queue.join(0);
  queue.join(1);
  double served_at = 0.0;
  while (served_at == 0.0 && world.time() < 20.0) {
    if (world.time() == 3.0) queue.leave(0);
    for (const AgentId agent : queue.update(world)) {
      EXPECT_EQ(agent, 1U);
      served_at = world.time();
    }
    step(world);
  }
  EXPECT_EQ(served_at, 8.0);  // at the head at 4 s
}

/// A wall at x = 2.2: places 0 and 1 are in front of it, place 2 is too near to it.
TEST(Queue, WallsEndTheLine) {
  World world = worldOf({{0.0, 0.0}, {1.0, 0.0}, {1.5, 0.5}}, {{{2.2, -3.0}, {2.2, 3.0}}});
  const QueueDescription description = line({100.0, 100.0});
  Queue queue(description, random());
  for (const AgentId agent : {0U, 1U, 2U}) queue.join(agent);
  queue.update(world);
  EXPECT_EQ(queue.line(), (std::vector<AgentId>{0, 1}));
  EXPECT_EQ(world.agents()[2].goal(), Vector2(1.0, 0.0));
  EXPECT_TRUE(queue.stands(2, world));  // 0.7 m from the last place, where others may wait, too
  WorldEditor(world).removeWall(0);
  queue.update(world);
  EXPECT_EQ(queue.line(), (std::vector<AgentId>{0, 1, 2}));
}

TEST(Queue, ServiceTimesAreInTheirRange) {
  World world = worldOf({{0.0, 0.0}});
  const QueueDescription description = line({1.0, 3.0});
  Queue queue(description, random());
  double sum = 0.0;
  constexpr int COUNT = 200;
  for (int i = 0; i < COUNT; ++i) {
    step(world);
    queue.join(0);
    queue.update(world);
    const double begin = world.time();
    while (!queue.line().empty()) {
      step(world);
      queue.update(world);
    }
    const double duration = world.time() - begin;
    EXPECT_GE(duration, 1.0);
    EXPECT_LE(duration, 3.0);
    sum += duration;
  }
  EXPECT_NEAR(sum / COUNT, 2.25, 0.15);  // 2 s, and 0.25 s until the end of the tick
}

}  // namespace
}  // namespace crowd::queue_test
