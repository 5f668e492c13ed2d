#include "avoidance/escape_planner.h"

#include <gtest/gtest.h>

#include "avoidance/separation_rule.h"
#include "common/random.h"
#include "scenario/reading/scenario_reader.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/worlds.h"
#include "world/world.h"

namespace crowd::escape_planner_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]

/// The replacements of a move straight ahead and of staying, for an agent of radius 0.25 m that walks at 0.3 m/s.
struct Moves {
  CandidateMove ahead{Vector2::UnitX(), 1.0, 1.0};
  CandidateMove stay{Vector2::UnitX(), 0.0, 0.0};
};

Moves movesIn(const PerceptionsBuilder& scene) {
  const auto moves =
      cut(SeparationRule(GapSharing::MOVING, LOOKOUT), scene.perception(), {Moves().ahead, Moves().stay});
  return {moves[0], moves[1]};
}

PerceptionsBuilder moving_obstacle(const Vector2& position, const Vector2& velocity) {
  return PerceptionsBuilder()
      .agent(0, {5.0, 0.0})
      .neighbour(position, 0.25)
      .kind(NeighbourKind::OBSTACLE)
      .velocity({0, 0}, velocity);
}

TEST(EscapePlanner, KeepsMovesThatNoMovingObstacleCanReach) {
  // At 0.3 and 0.5 m/s the gap shrinks by 1.2 m within the lookout; it is 1.3 m.
  const Moves moves = movesIn(moving_obstacle({1.83, 0.0}, {-0.5, 0.0}));
  EXPECT_EQ(moves.ahead.fraction, 1.0);
  EXPECT_EQ(moves.stay.fraction, 0.0);
}

TEST(EscapePlanner, IgnoresStaticObstacles) {
  const Moves moves = movesIn(moving_obstacle({0.515, 0.0}, {0.0, 0.0}));
  EXPECT_NEAR(moves.ahead.fraction, 0.5, 1e-6);  // 0.015 of the 0.03 of a tick
  EXPECT_EQ(moves.ahead.direction, Vector2::UnitX());
}

TEST(EscapePlanner, LeavesThePathOfAMovingObstacleAtTheLastSafeTick) {
  // The agent is 0.45 m beside the axis of the obstacle's lane; they need 0.52 m. If the agent leaves the lane at once,
  // their least distance is 0.534 m; one tick later it would be 0.506 m.
  const Moves late = movesIn(moving_obstacle({0.36, 0.45}, {-1.0, 0.0}));
  for (const CandidateMove& move : {late.ahead, late.stay}) {
    EXPECT_EQ(move.fraction, 1.0);
    EXPECT_LT(move.direction.y(), -0.3);
  }
  const Moves mirrored = movesIn(moving_obstacle({0.36, -0.45}, {-1.0, 0.0}));
  EXPECT_GT(mirrored.stay.direction.y(), 0.3);
  const Moves early = movesIn(moving_obstacle({0.56, 0.45}, {-1.0, 0.0}));
  EXPECT_EQ(early.stay.fraction, 0.0);
}

TEST(EscapePlanner, DelaysTheContactIfNoPathStaysClear) {
  // In the middle of the lane of a moving obstacle that arrives in 0.5 s; the agent needs 1.73 s to leave the lane. No
  // path stays clear, but walking away from the obstacle stays clear for longer than staying.
  const Moves moves = movesIn(moving_obstacle({1.0, 0.0}, {-1.0, 0.0}));
  EXPECT_LT(moves.ahead.direction.x(), 0.0);
  EXPECT_LT(moves.stay.direction.x(), 0.0);
  EXPECT_EQ(moves.stay.fraction, 1.0);
  EXPECT_NEAR(moves.stay.direction.x(), -1.0, 1e-9);  // 0.69 s; with 22.5 degrees to a side less
}

TEST(EscapePlanner, AllowsForAReversalOfAMovingObstacle) {
  // 0.05 m behind a moving obstacle that leaves: if it reversed, contact would follow after 0.07 s, too soon to leave
  // its lane.
  const Moves moves = movesIn(moving_obstacle({0.55, 0.0}, {0.6, 0.0}));
  EXPECT_LT((moves.ahead.fraction * moves.ahead.direction).x(), 0.0);
}

/// Runs one agent with random actions among moving obstacles and returns the number of ticks that end in an overlap.
int ticksInContact(double lookout, std::uint64_t seed) {
  const std::string text =
      "{name: moving_obstacles, duration: 60, goal_tolerance: 0.1, agents: [{position: [0, 0], goal: [50, 0], speed: "
      "1.3, "
      "radius: "
      "0.25}], obstacles: [{count: 6, position: {ring: {centre: [0, 0], radius: [2, 6]}}, to_and_fro: {box: [[-6, -6], "
      "[6, "
      "6]]}, speed: [0.3, 1.2], radius: [0.2, 0.5]}]}";
  World world(parseScenarios(text, "moving obstacles").scene(seed, 0));
  Perceptions perceptions;
  int ticks = 0;
  for (std::uint64_t tick = 0; tick < 300; ++tick) {
    perceive(world, {6.0, 0}, perceptions);
    const AgentPerception& self = perceptions.agents.front();
    // Keeps the agent near the moving obstacles: out of their range it walks back.
    const bool is_out = self.pose.position.norm() > 3.0;
    const double back = wrapAngle(bearingOf(-self.pose.position) - self.pose.heading);
    KeyedRandom random(seed, KeyedRandom::EXPLORATION, {tick, 0});
    const Perception perception(perceptions, 0);
    CandidateMove move{unitVector(is_out ? back : 2.0 * PI * random.uniform()), 1.0, 1.0};
    if (tick % 10 < 5) move = {Vector2::UnitX(), random.uniform(), 1.0};
    move = cut(SeparationRule(GapSharing::MOVING, lookout), perception, {move})[0];
    world.step({{self.agent, toAction(move)}});
    const Agent& agent = world.agents().front();
    for (const Obstacle& o : world.obstacles()) {
      const double away = (agent.pose.position - o.path.position(world.time())).norm();
      if (away < agent.radius + o.radius - 1e-3) ++ticks;
    }
  }
  return ticks;
}

TEST(EscapePlanner, KeepsASingleAgentFreeOfContacts) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) EXPECT_EQ(ticksInContact(LOOKOUT, seed), 0) << "seed " << seed;
}

TEST(EscapePlanner, TheSameAgentHasContactsWithoutIt) {
  int ticks = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) ticks += ticksInContact(0.0, seed);
  EXPECT_GT(ticks, 100);
}

}  // namespace
}  // namespace crowd::escape_planner_test
