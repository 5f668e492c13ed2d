// Decisions in batches: the result of each agent does not depend on the other agents of the batch.

#include "avoidance/perception_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "avoidance/separation_rule.h"
#include "common/random.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::decision_batch_test {
namespace {

constexpr double LOOKOUT = 1.5;  // [s]
constexpr std::array<GapSharing, 3> ALL_SHARINGS = {GapSharing::NONE, GapSharing::HALF, GapSharing::MOVING};

Vector2 anyVector(KeyedRandom& random, double longest) {
  return random.uniform(0.0, longest) * unitVector(random.uniform(-PI, PI));
}

void addBodies(KeyedRandom& random, std::uint32_t count, bool agents_alone, PerceptionsBuilder& scene) {
  const Vector2 own = random.below(5) == 0 ? Vector2(Vector2::Zero()) : anyVector(random, 0.3);
  for (; count > 0; --count) {
    // Some are near enough to limit moves, overlap the agent, or have its position.
    const double farthest = random.below(3) == 0 ? 0.6 : 3.0;
    const Vector2 place = random.below(50) == 0 ? Vector2(Vector2::Zero()) : anyVector(random, farthest);
    scene.neighbour(place, random.uniform(0.05, 0.3));
    scene.velocity(own, random.below(4) == 0 ? Vector2(Vector2::Zero()) : anyVector(random, 0.5));
    if (!agents_alone && random.below(3) == 0) scene.kind(NeighbourKind::OBSTACLE);
  }
}

/// Up to MAX_BATCH agents: alone, with few neighbours, with more than NEIGHBOURS_AT_ONCE, with obstacles, with walls.
PerceptionsBuilder anyGroup(KeyedRandom& random) {
  PerceptionsBuilder group;
  const std::size_t size = 1 + random.below(MAX_BATCH);
  for (AgentId agent = 0; agent < size; ++agent) {
    group.agent(agent, anyVector(random, 6.0));
    const std::uint32_t kind = random.below(8);
    if (kind < 5) addBodies(random, random.below(17), true, group);
    if (kind == 5) addBodies(random, 17 + random.below(20), true, group);
    if (kind == 6) addBodies(random, 1 + random.below(16), false, group);
    if (kind == 7 || random.below(10) == 0) group.wall(anyVector(random, 3.0), anyVector(random, 3.0));
  }
  return group;
}

std::vector<Perception> perceptionsOf(const PerceptionsBuilder& group) {
  std::vector<Perception> seen;
  for (std::size_t i = 0; i < group.all().agents.size(); ++i) seen.push_back(group.perception(i));
  return seen;
}

bool areSame(const std::vector<MoveBlock>& a, const std::vector<MoveBlock>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(MoveBlock)) == 0;
}

/// Action sets whose moves fill less than one block, or more.
std::shared_ptr<const ActionSet> anyActionSet(GapSharing sharing, bool wide) {
  auto actions = actionsOf("{type: goal_relative, gap_sharing: " + GAP_SHARINGS.nameOf(sharing) +
                           (wide ? ", slow_headings: [0, 20, 35, 55, 90, 120, 180]}" : "}"));
  EXPECT_EQ(blocksOf(actions->size()), wide ? 2U : 1U);
  return actions;
}

TEST(DecisionBatch, MovesAndRowsDoNotDependOnTheBatch) {
  for (const GapSharing sharing : ALL_SHARINGS) {
    const auto any = anyActionSet(sharing, sharing == GapSharing::HALF);
    const ActionSet& actions = *any;
    const auto states = statesOf("{type: anticipation}", actions);
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
      const PerceptionsBuilder group = anyGroup(random);
      const std::vector<Perception> seen = perceptionsOf(group);
      const std::size_t blocks = blocksOf(actions.size());
      std::vector<MoveBlock> moves(seen.size() * blocks);
      std::vector<Row> rows(seen.size() * actions.size());
      std::vector<BrakingLimits> limits(seen.size());
      actions.findMoves({seen.data(), seen.size()}, moves.data(), limits.data());
      states->findRows({seen.data(), seen.size()}, moves.data(), rows.data());
      std::vector<MoveBlock> moves_alone(moves.size());
      std::vector<Row> rows_alone(rows.size());
      for (std::size_t k = 0; k < seen.size(); ++k) {
        actions.findMoves({&seen[k], 1}, &moves_alone[k * blocks], &limits[k]);
        states->findRows({&seen[k], 1}, &moves_alone[k * blocks], &rows_alone[k * actions.size()]);
      }
      ASSERT_TRUE(areSame(moves, moves_alone)) << GAP_SHARINGS.nameOf(sharing) << ", seed " << seed;
      ASSERT_EQ(rows, rows_alone) << GAP_SHARINGS.nameOf(sharing) << ", seed " << seed;
    }
  }
}

TEST(DecisionBatch, SeparationLimitsDoNotDependOnTheBatch) {
  const auto actions = actionsOf("{type: goal_relative}");
  const std::vector<MoveBlock> goal_relative =
      movesOf(*actions, PerceptionsBuilder().agent(0, {5.0, 0.0}).perception());
  const std::size_t count = actions->size();
  for (const GapSharing sharing : ALL_SHARINGS) {
    const SeparationRule rule(sharing, LOOKOUT);
    std::size_t cut_short = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
      const PerceptionsBuilder group = anyGroup(random);
      const std::vector<Perception> seen = perceptionsOf(group);
      std::vector<MoveBlock> together(seen.size(), goal_relative[0]);
      std::vector<MoveBlock> alone = together;
      std::vector<BrakingLimits> limits(seen.size());
      rule.cut({seen.data(), seen.size()}, together.data(), count, limits.data());
      for (std::size_t k = 0; k < seen.size(); ++k) {
        rule.cut(seen[k], &alone[k], count, limits[k]);  // neighbour by neighbour, not as a list of near agents
        cut_short += alone[k].fraction[0] < alone[k].wanted[0] ? 1 : 0;
      }
      ASSERT_TRUE(areSame(together, alone)) << GAP_SHARINGS.nameOf(sharing) << ", seed " << seed;
    }
    EXPECT_EQ(cut_short > 200, sharing != GapSharing::NONE) << cut_short;
  }
}

}  // namespace
}  // namespace crowd::decision_batch_test
