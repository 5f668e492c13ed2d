#include "avoidance/separation_rule.h"
#include "geometry/impact.h"

#include <gtest/gtest.h>

#include "common/random.h"
#include "geometry/impact.h"
#include "learning/actions/goal_relative_actions.h"
#include "scenario/reading/scenario_reader.h"
#include "support/error_of.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/worlds.h"
#include "world/world.h"

namespace crowd::separation_rule_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]

/// The admissible fraction of a move straight ahead at full speed.
double shareAhead(GapSharing sharing, const PerceptionsBuilder& scene) {
  return cut(SeparationRule(sharing, LOOKOUT), scene.perception(), {{Vector2::UnitX(), 1.0, 1.0}})[0].fraction;
}

/// An agent of radius 0.25 m that walks at 0.3 m/s, 0.03 m per tick, and another one ahead, with a gap in between [m].
PerceptionsBuilder facing(double gap, NeighbourKind kind = NeighbourKind::AGENT) {
  return PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({0.5 + gap, 0.0}, 0.25).kind(kind);
}

TEST(SeparationRule, KeepsFreeMoves) {
  EXPECT_EQ(shareAhead(GapSharing::HALF, PerceptionsBuilder().agent(0, {5.0, 0.0})), 1.0);
  EXPECT_EQ(shareAhead(GapSharing::HALF, facing(0.07)), 1.0);  // half of it is more than 0.03
  EXPECT_EQ(shareAhead(GapSharing::NONE, facing(0.001)), 1.0);
  EXPECT_EQ(shareAhead(GapSharing::HALF, PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({-0.5, 0.0}, 0.25)), 1.0);
}

TEST(SeparationRule, AllowsEachAgentHalfOfTheGap) {
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.03)), 0.5, 1e-6);
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.006)), 0.1, 1e-6);
  EXPECT_EQ(shareAhead(GapSharing::HALF, facing(0.0)), 0.0);
}

TEST(SeparationRule, AllowsTheWholeGapToStaticObstaclesAndWalls) {
  EXPECT_NEAR(shareAhead(GapSharing::HALF, facing(0.015, NeighbourKind::OBSTACLE)), 0.5, 1e-6);
  const auto before_wall = PerceptionsBuilder().agent(0, {5.0, 0.0}).wall({0.265, -1.0}, {0.265, 1.0});
  EXPECT_NEAR(shareAhead(GapSharing::HALF, before_wall), 0.5, 1e-6);
}

TEST(SeparationRule, LimitsTheComponentTowardsTheOtherAgent) {
  const auto moves = cut(SeparationRule(GapSharing::HALF, LOOKOUT), facing(0.006).perception(),
                         {{unitVector(toRadians(60.0)), 1.0, 1.0}, {unitVector(toRadians(90.0)), 1.0, 1.0}});
  EXPECT_NEAR(moves[0].fraction, 0.2,
              1e-6);  // 0.015 m of its 0.03 m are towards the other agent, 0.003 m are admissible
  EXPECT_EQ(moves[1].fraction, 1.0);
}

TEST(SeparationRule, MovingSharesDependOnBothVelocities) {
  // Both walked ahead at 0.1 m/s: the line between them moves on by 0.01 m.
  auto following = facing(0.03).velocity({0.1, 0.0}, {0.1, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, following), 0.025 / 0.03, 1e-6);
  EXPECT_NEAR(shareAhead(GapSharing::HALF, following), 0.5, 1e-6);
  auto led = facing(0.03).velocity({-0.1, 0.0}, {-0.1, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, led), 0.005 / 0.03, 1e-6);
  auto meeting = facing(0.03).velocity({0.3, 0.0}, {-0.3, 0.0});
  EXPECT_NEAR(shareAhead(GapSharing::MOVING, meeting), 0.5, 1e-6);
  auto pushed = facing(0.03).velocity({-9.0, 0.0}, {-9.0, 0.0});
  EXPECT_EQ(shareAhead(GapSharing::MOVING, pushed), 0.0);  // staying is always admissible
}

/// A crowded box with walls, static obstacles, and agents of various radii and speeds.
Scene denseScene(std::uint64_t seed) {
  const std::string text =
      "{name: dense, duration: 60, goal_tolerance: 0.1, agents: [{count: 40, position: {box: [[-3, -3], [3, 3]]}, "
      "goal: {box: [[-3, -3], [3, 3]]}, speed: [0.5, 2.5], radius: [0.1, 0.35]}], obstacles: [{count: 6, position: "
      "{box: [[-3, -3], [3, 3]]}, radius: [0.1, 0.5]}], walls: [[[-3.4, -3.4], [3.4, -3.4]], [[3.4, -3.4], [3.4, "
      "3.4]], [[3.4, 3.4], [-3.4, 3.4]], [[-3.4, 3.4], [-3.4, -3.4]], [[-1, 0], [1, 0.3]]]}";
  return parseScenarios(text, "dense").scene(seed, 0);
}

/// The deepest overlap of any agent with anything [m]; negative: the narrowest gap.
double deepestOverlap(const World& world) {
  double deepest = -1.0;
  for (const Agent& a : world.agents()) {
    if (!a.isWalking()) continue;
    for (const Agent& b : world.agents()) {
      if (b.id == a.id || !b.isWalking()) continue;
      deepest = std::max(deepest, a.radius + b.radius - (a.pose.position - b.pose.position).norm());
    }
    for (const Obstacle& o : world.obstacles()) {
      deepest = std::max(deepest, a.radius + o.radius - (a.pose.position - o.path.position(0.0)).norm());
    }
    for (const Segment& wall : world.walls().list())
      deepest = std::max(deepest, a.radius - distanceTo(wall, a.pose.position));
  }
  return deepest;
}

/// Runs a dense crowd with random actions and returns the deepest overlap of all ticks [m].
double worstOfRandomWalk(GapSharing sharing, std::uint64_t seed) {
  GoalRelativeActions::Parameters parameters;
  parameters.gap_sharing = sharing;
  const GoalRelativeActions goal_relative(parameters);
  World world(denseScene(seed));
  Perceptions perceptions;
  double worst = -1.0;
  for (std::uint64_t tick = 0; tick < 200; ++tick) {
    perceive(world, {6.0, 0}, perceptions);
    std::vector<AgentAction> actions;
    for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
      const AgentId agent = perceptions.agents[i].agent;
      if (perceptions.agents[i].arrived) continue;
      KeyedRandom random(seed, KeyedRandom::EXPLORATION, {tick, agent});
      // Mostly straight to the goal, where the crowd is dense; some answers are left out.
      const bool ahead = random.uniform() < 0.5;
      if (random.uniform() < 0.05) continue;
      const Action action = ahead ? 0 : random.below(goal_relative.size());
      actions.push_back({agent, relativeAction(goal_relative, {perceptions, i}, action)});
    }
    world.step(actions);
    worst = std::max(worst, deepestOverlap(world));
  }
  return worst;
}

TEST(SeparationRule, PreventsAllContactsInADenseCrowd) {
  for (const GapSharing sharing : {GapSharing::HALF, GapSharing::MOVING}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      EXPECT_LE(worstOfRandomWalk(sharing, seed), TOUCH_TOLERANCE) << GAP_SHARINGS.nameOf(sharing) << ", seed " << seed;
    }
  }
}

TEST(SeparationRule, TheSameCrowdHasContactsWithoutIt) { EXPECT_GT(worstOfRandomWalk(GapSharing::NONE, 1), 0.05); }

TEST(GapSharing, HasNames) {
  for (const char* name : {"none", "half", "moving"}) EXPECT_EQ(GAP_SHARINGS.nameOf(GAP_SHARINGS.parse(name)), name);
  EXPECT_TRUE(contains(errorOf<InputError>([] { GAP_SHARINGS.parse("third"); }), "none, half or moving, got 'third'"));
}

}  // namespace
}  // namespace crowd::separation_rule_test
