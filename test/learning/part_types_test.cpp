// Properties of all registered state sets, action sets and rewards. A new type is tested without a change here.

#include "learning/part_types.h"

#include <gtest/gtest.h>

#include <set>

#include "learning/model.h"
#include "learning/states/obstacle_classes.h"
#include "learning/states/row_meaning.h"
#include "support/error_of.h"
#include "support/learners.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/rows.h"

namespace crowd::part_types_test {
namespace {

std::string typed(const std::string& name) { return "{type: " + name + "}"; }

template <typename Types>
void expectDistinctNames(const Types& types) {
  std::set<std::string> names;
  for (const auto& type : types) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name;
    EXPECT_FALSE(std::string(type.summary).empty()) << type.name;
  }
}

TEST(PartTypes, HaveNamesAndSummaries) {
  expectDistinctNames(stateSetTypes());
  expectDistinctNames(actionSetTypes());
  expectDistinctNames(rewardTypes());
}

TEST(PartTypes, ErrorsListTheNames) {
  const std::vector<ActionSetType> one = {{"first", "", nullptr}};
  EXPECT_EQ(namesOf(one), "first");
  const std::vector<ActionSetType> three = {{"first", "", nullptr}, {"second", "", nullptr}, {"third", "", nullptr}};
  EXPECT_EQ(namesOf(three), "first, second or third");
  EXPECT_TRUE(contains(errorOf<InputError>([] { actionsOf("{type: fourth}"); }),
                       "expected " + namesOf(actionSetTypes()) + ", got 'fourth'"));
}

TEST(PartTypes, StateAndActionSetsHaveDefaultsAndReadBackTheirSpecs) {
  for (const ActionSetType& action_type : actionSetTypes()) {
    const auto actions = actionsOf(typed(action_type.name));
    EXPECT_EQ(actionsOf(actions->spec())->spec(), actions->spec());
    for (const StateSetType& state_type : stateSetTypes()) {
      const auto states = statesOf(typed(state_type.name), *actions);
      EXPECT_EQ(statesOf(states->spec(), *actions)->spec(), states->spec());
    }
  }
}

TEST(PartTypes, MirroringTwiceGivesTheOriginal) {
  for (const ActionSetType& action_type : actionSetTypes()) {
    const auto actions = actionsOf(typed(action_type.name));
    for (Action action = 0; action < actions->size(); ++action) {
      ASSERT_LT(actions->mirrored(action), actions->size()) << action_type.name;
      ASSERT_EQ(actions->mirrored(actions->mirrored(action)), action) << action_type.name;
    }
    for (const StateSetType& state_type : stateSetTypes()) {
      const auto states = statesOf(typed(state_type.name), *actions);
      for (Row row = 0; row < states->rowCount(); ++row) {
        ASSERT_LT(states->mirrored(row), states->rowCount()) << state_type.name;
        ASSERT_EQ(states->mirrored(states->mirrored(row)), row) << state_type.name;
      }
    }
  }
}

TEST(PartTypes, RowsOfAnyPerceptionAreInTheTable) {
  constexpr AgentId AGENTS = 20;
  for (const ActionSetType& action_type : actionSetTypes()) {
    const auto actions = actionsOf(typed(action_type.name));
    for (const StateSetType& state_type : stateSetTypes()) {
      const auto states = statesOf(typed(state_type.name), *actions);
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const PerceptionsBuilder tick = learners::randomTick(seed, 0, 0, AGENTS);
        for (AgentId agent = 0; agent < AGENTS; ++agent) {
          const Perception seen = tick.perception(agent);
          for (const Row row : rowsOf(*states, seen, movesOf(*actions, seen))) {
            ASSERT_LT(row, states->rowCount()) << state_type.name << ", seed " << seed;
          }
        }
      }
    }
  }
}

TEST(PartTypes, PicturesShowDistanceLimitsWithinTheVision) {
  const auto actions = actionsOf(typed("kings_moves"));
  for (const StateSetType& type : stateSetTypes()) {
    const auto states = statesOf(typed(type.name), *actions);
    const auto* const picture = dynamic_cast<const SectorPicture*>(states.get());
    if (picture == nullptr) continue;
    ASSERT_FALSE(picture->distanceLimits().empty()) << type.name;
    EXPECT_EQ(picture->distanceLimits().back(), states->visionRadius()) << type.name;
  }
}

TEST(PartTypes, DescriptionsHaveAllRows) {
  const auto actions = actionsOf(typed("kings_moves"));
  for (const StateSetType& type : stateSetTypes()) {
    const auto states = statesOf(typed(type.name), *actions);
    const auto* const explained = dynamic_cast<const ExplainedRows*>(states.get());
    if (explained == nullptr) continue;
    const RowMeaning meaning = explained->meaning();
    std::size_t rows = 1;
    for (const RowQuantity& quantity : meaning.quantities) rows *= quantity.classes.size();
    if (!meaning.rows.empty()) rows = meaning.rows.size();
    EXPECT_EQ(rows + (meaning.has_terminal ? 1 : 0), states->rowCount()) << type.name;
  }
}

TEST(PartTypes, ThesisRewardRequiresDistanceClasses) {
  const std::string message = errorOf<InputError>([] {
    parseModel(
        "{state_set: {type: anticipation}, action_set: {type: goal_relative}, "
        "reward: {goal: cosine_cubed, obstacle_cost: 80}}");
  });
  EXPECT_TRUE(contains(message, "do not encode distance classes")) << message;
}

}  // namespace
}  // namespace crowd::part_types_test
