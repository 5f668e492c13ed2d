#include "scenario/writing/scene_document.h"

#include <gtest/gtest.h>

#include <string>

#include "common/random.h"
#include "scenario/reading/scenario_reader.h"
#include "support/scenes.h"

namespace crowd::scene_document_test {
namespace {

constexpr double EPSILON = 1e-12;

/// The scene that a reader of the document gets.
Scene readBack(const Scene& scene) { return parseScenarios(toDocument(scene, "."), "scene.yaml").scene(99, 0); }

void expectNear(const Vector2& got, const Vector2& expected) { EXPECT_LT((got - expected).norm(), EPSILON); }

void expectSame(const Scene& got, const Scene& expected) {
  EXPECT_EQ(got.name, expected.name);
  EXPECT_EQ(got.tick_duration, expected.tick_duration);
  EXPECT_EQ(got.max_ticks, expected.max_ticks);
  EXPECT_EQ(got.goal_tolerance, expected.goal_tolerance);
  EXPECT_EQ(got.contact, expected.contact);
  EXPECT_EQ(got.order, expected.order);
  EXPECT_EQ(got.motion, expected.motion);
  EXPECT_EQ(got.arrived, expected.arrived);
  EXPECT_EQ(got.collision_radius, expected.collision_radius);
  ASSERT_EQ(got.agents.size(), expected.agents.size());
  for (std::size_t i = 0; i < got.agents.size(); ++i) {
    const AgentStart& agent = got.agents[i];
    const AgentStart& original = expected.agents[i];
    expectNear(agent.position, original.position);
    EXPECT_NEAR(wrapAngle(agent.heading - original.heading), 0.0, EPSILON);
    ASSERT_EQ(agent.goals.size(), original.goals.size());
    for (std::size_t goal = 0; goal < agent.goals.size(); ++goal) expectNear(agent.goals[goal], original.goals[goal]);
    EXPECT_EQ(agent.max_speed, original.max_speed);
    EXPECT_EQ(agent.radius, original.radius);
  }
  ASSERT_EQ(got.obstacles.size(), expected.obstacles.size());
  for (std::size_t i = 0; i < got.obstacles.size(); ++i) {
    EXPECT_EQ(got.obstacles[i].path.kind(), expected.obstacles[i].path.kind());
    EXPECT_EQ(got.obstacles[i].radius, expected.obstacles[i].radius);
    for (const double time : {0.0, 3.7, 50.1}) {
      EXPECT_LT((got.obstacles[i].path.position(time) - expected.obstacles[i].path.position(time)).norm(), 1e-9);
    }
  }
  ASSERT_EQ(got.walls.size(), expected.walls.size());
  for (std::size_t i = 0; i < got.walls.size(); ++i) {
    expectNear(got.walls[i].from, expected.walls[i].from);
    expectNear(got.walls[i].to, expected.walls[i].to);
  }
}

TEST(SceneDocument, WritesASmallScene) {
  Scene scene = scenes::scene({{{1.0, -2.0}, PI / 2, {{1.0, 2.0}, {0.5, 2.0}}, 1.5, 0.25}},
                              {scenes::pillar({0.0, 3.0}, 0.5), scenes::moving_obstacle({4.0, 0.0}, {-0.5, 0.0}, 0.25)},
                              {{{0.0, 5.0}, {1.0, 5.0}}});
  scene.name = "Anna's";
  EXPECT_EQ(toDocument(scene, "."),
            "---\n"
            "name: 'Anna''s'\n"
            "tick: 0.1\n"
            "duration: 100\n"
            "goal_tolerance: 0.25\n"
            "agents:\n"
            "  - {position: [1, -2], goals: [[1, 2], [0.5, 2]], speed: 1.5, radius: 0.25, heading: 90}\n"
            "obstacles:\n"
            "  - {position: [0, 3], radius: 0.5}\n"
            "  - {position: [4, 0], radius: 0.25, velocity: [-0.5, 0]}\n"
            "walls:\n"
            "  - [[0, 5], [1, 5]]\n");
  expectSame(readBack(scene), scene);
}

TEST(SceneDocument, ReadsBackPathsOfObstacles) {
  Scene scene = scenes::scene({scenes::agent({0.0, 0.0}, {0.0, 9.0})});
  scene.obstacles.push_back({ObstaclePath::toAndFro({{3.0, 0.0}, {3.0, 4.0}, {6.0, 4.0}}, 0.7), 0.3});
  scene.obstacles.push_back({ObstaclePath::loop({{-3.0, 0.0}, {-3.0, 4.0}, {-6.0, 4.0}}, 0.2), 0.4});
  expectSame(readBack(scene), scene);
}

TEST(SceneDocument, ReadsBackTheContactModel) {
  Scene scene = scenes::scene({scenes::agent({0.0, 0.0}, {0.0, 9.0})});
  scene.contact = Contact::SOLID;
  expectSame(readBack(scene), scene);
}

TEST(SceneDocument, ReadsBackOrderAndCollisionRadius) {
  Scene scene = scenes::scene({scenes::agent({0.0, 0.0}, {0.0, 9.0})});
  scene.order = Order::SEQUENTIAL;
  scene.collision_radius = 0.35;
  expectSame(readBack(scene), scene);
}

TEST(SceneDocument, ReadsBackWhetherAgentsStay) {
  Scene scene = scenes::scene({scenes::agent({0.0, 0.0}, {0.0, 9.0})});
  EXPECT_EQ(toDocument(scene, ".").find("arrived"), std::string::npos);
  scene.arrived = Arrived::STAY;
  EXPECT_NE(toDocument(scene, ".").find("\narrived: stay\n"), std::string::npos);
  expectSame(readBack(scene), scene);
  EXPECT_TRUE(readBack(scene).agents[0].stays);
}

TEST(SceneDocument, ReadsBackMotionLimits) {
  Scene scene = scenes::scene({scenes::agent({0.0, 0.0}, {0.0, 9.0})});
  for (const MotionLimits& motion : {MotionLimits{2.0, 3.0, INFINITE}, MotionLimits{2.0, 3.0, 1.75}, MotionLimits()}) {
    scene.motion = motion;
    expectSame(readBack(scene), scene);
  }
}

TEST(SceneDocument, ReadsBackDrawnScenes) {
  const ScenarioList drawn = parseScenarios(
      "name: drawn\n"
      "units: thesis\n"
      "duration: 777\n"
      "goal_tolerance: 0.3\n"
      "agents:\n"
      "  - {count: 4, position: {box: [[-4, -4], [4, 4]]}, goal: {opposite: [0, 0]}, speed: [0.02, 0.04],\n"
      "     radius: [0.2, 0.3], heading: [-180, 180]}\n"
      "obstacles:\n"
      "  - {count: 2, position: {box: [[-4, -4], [4, 4]]}, radius: [0.3, 0.5]}\n"
      "  - {position: {box: [[-4, -4], [4, 4]]}, radius: 0.3, to_and_fro: {box: [[-4, -4], [4, 4]]}, speed: 0.01}\n",
      "drawn.yaml");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = drawn.scene(seed, seed);
    expectSame(readBack(scene), scene);
  }
}

/// Routes, sources and the like are written as they are in the file.
TEST(SceneDocument, Populations) {
  const std::string keys = R"(duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0.5, 0.5], route: 'anna''s', reaction_time: 12.5, speed: 1, hurry: 1.25, radius: 0.25, heading: 90}
routes:
  'anna''s': {repeat: true, waypoints: [{place: {box: [[0, 0], [4, 2]]}, wait: [5, 20]}, {place: [1, 2], wait: 0}, {place: [2, 2], wait: 3, face: -37.5}]}
  'out': {waypoints: [{one_of: [{queue: 'till'}, {place: {ring: {centre: [1, 2], radius: [0, 3]}}, wait: 1, face: [3, 0.5]}]}, {sink: 'exit'}]}
  'flight': {waypoints: [{sink: nearest}]}
sources:
  - {area: {box: [[0, 0], [1, 2]]}, rate: 0.5, interval: regular, from: 3, until: 60, count: 100, goals: [[9, 9]], speed: [1, 1.5], radius: 0.2}
  - {area: [7, 7], times: [1, 2.5], route: 'out', speed: 1, hurry: [1, 1.5], radius: 0.2}
  - {area: [7, 7], rate: 1, from: 0, goal: {opposite: [0, 0]}, speed: 1, radius: 0.2}
sinks:
  'exit': {area: {box: [[10, 0], [11, 2]]}}
queues:
  'till': {head: [3, 2], direction: 37, spacing: 0.5, service: [5, 20], face: {robot: 'rob'}}
gates:
  'door': {wall: [[2, 0], [3, 0]], open: true}
  'bar': {wall: [[5, 0], [6, 0]], open: [[10, 20], [40, 60]]}
attractions:
  'window': {area: {box: [[5, 5], [7, 6]]}, radius: 4, share: 0.25, wait: [5, 20], face: 90}
  'stall': {area: [8, 5], radius: 4, share: 1, wait: 3}
alarms:
  - {time: 30, area: all, sink: nearest, speed_factor: 1.5, reaction_time: [0, 20]}
  - {time: 40, area: {ring: {centre: [1, 2], radius: [0, 3]}}, sink: 'exit', speed_factor: 1, keep_sources: true}
  - {time: 50.5, area: all, speed_factor: 0.5}
)";
  const std::string robots = "robots: [{name: rob, position: [20, 20], radius: 0.3, max_speed: 1}]\n";
  const Scene scene = parseScenarios("name: n\n" + robots + keys, "s.yaml").scene(1, 0);
  const std::string text = toDocument(scene, ".");
  EXPECT_EQ(toDocument(readBack(scene), "."), text);
  const std::string sections = keys.substr(keys.find("routes:"));
  EXPECT_EQ(text.substr(text.find("routes:")), sections);
  EXPECT_NE(text.find("route: 'anna''s', reaction_time: 12.5, speed: 1"), std::string::npos) << text;
}

}  // namespace
}  // namespace crowd::scene_document_test
