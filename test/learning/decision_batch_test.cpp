// Decisions in batches: the result of each agent does not depend on the other agents of the batch.

#include "social_crowd/avoidance/decision_context.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "social_crowd/avoidance/separation_rule.h"
#include "social_crowd/common/random.h"
#include "social_crowd/learning/actions/goal_relative_actions.h"
#include "social_crowd/learning/states/anticipation_states.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd {
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

/// Deciding agents with their buffers.
struct Choosing {
  std::vector<MoveBlock> moves;
  std::vector<Row> rows;
  std::vector<DecisionContext> contexts;

  Choosing(const PerceptionsBuilder& group, std::size_t actions)
      : moves(group.all().agents.size() * blocksOf(actions)), rows(group.all().agents.size() * actions) {
    for (std::size_t i = 0; i < group.all().agents.size(); ++i) {
      contexts.push_back({group.perception(i), &moves[i * blocksOf(actions)], &rows[i * actions]});
    }
  }
  DecisionBatch all() const { return {contexts.data(), contexts.size()}; }
};

bool areSame(const std::vector<MoveBlock>& a, const std::vector<MoveBlock>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(MoveBlock)) == 0;
}

/// Action sets whose moves fill less than one block, or more.
GoalRelativeActions anyActionSet(GapSharing sharing, bool wide) {
  GoalRelativeActions::Parameters parameters;
  parameters.gap_sharing = sharing;
  if (wide) parameters.slow_headings = {0, 20, 35, 55, 90, 120, 180};
  GoalRelativeActions goal_relative(parameters);
  EXPECT_EQ(blocksOf(goal_relative.size()), wide ? 2U : 1U);
  return goal_relative;
}

TEST(DecisionBatch, FindTheSameMovesAndRowsTogetherAsAlone) {
  for (const GapSharing sharing : ALL_SHARINGS) {
    const GoalRelativeActions actions = anyActionSet(sharing, sharing == GapSharing::HALF);
    const AnticipationStates states(AnticipationStates::Parameters(), actions.size());
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
      const PerceptionsBuilder group = anyGroup(random);
      const Choosing together(group, actions.size());
      actions.findMovesOfAll(together.all());
      states.findRowsOfAll(together.all());
      const Choosing alone(group, actions.size());
      for (const DecisionContext& context : alone.contexts) {
        actions.findMoves(context);
        states.findRows(context);
      }
      ASSERT_TRUE(areSame(together.moves, alone.moves)) << toText(sharing) << ", seed " << seed;
      ASSERT_EQ(together.rows, alone.rows) << toText(sharing) << ", seed " << seed;
    }
  }
}

TEST(DecisionBatch, AreCutShortTogetherByEveryLimitThatOneAloneMeets) {
  const std::vector<MoveBlock> goal_relative =
      movesOf(GoalRelativeActions(), PerceptionsBuilder().agent(0, {5.0, 0.0}).perception());
  const std::size_t count = GoalRelativeActions().size();
  for (const GapSharing sharing : ALL_SHARINGS) {
    const SeparationRule rule(sharing, LOOKOUT);
    std::size_t cut_short = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
      KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
      const PerceptionsBuilder group = anyGroup(random);
      const Choosing together(group, count);
      const Choosing alone(group, count);
      for (const Choosing* choosing : {&together, &alone}) {
        for (const DecisionContext& context : choosing->contexts) *context.moves = goal_relative[0];
      }
      rule.cut(together.all(), count);
      for (const DecisionContext& context : alone.contexts) {
        rule.cut(context.seen, context.moves, count);  // neighbour by neighbour, not as a list of near agents
        cut_short += context.moves->fraction[0] < context.moves->wanted[0] ? 1 : 0;
      }
      ASSERT_TRUE(areSame(together.moves, alone.moves)) << toText(sharing) << ", seed " << seed;
    }
    EXPECT_EQ(cut_short > 200, sharing != GapSharing::NONE) << cut_short;
  }
}

}  // namespace
}  // namespace crowd
