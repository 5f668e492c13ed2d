#include <gtest/gtest.h>

#include <cmath>

#include "support/error_of.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::goal_relative_actions_test {
namespace {

/// The set with its defaults.
const ActionSet& defaults() {
  static const auto ACTIONS = actionsOf("{type: goal_relative}");
  return *ACTIONS;
}

const ActionSet& smallActionSet() {
  static const auto ACTIONS =
      actionsOf("{type: goal_relative, headings: [0, 30, 180], slow_headings: [0], slow_fraction: 0.5}");
  return *ACTIONS;
}

TEST(GoalRelativeActions, MeasuresHeadingsFromTheBearingOfTheGoal) {
  const ActionSet& goal_relative = smallActionSet();
  const auto scene = PerceptionsBuilder().agent(0, polar(40.0, 5.0));
  ASSERT_EQ(goal_relative.size(), 6U);
  const double expected[] = {40.0, 70.0, 10.0, -140.0, 40.0};
  for (Action action = 0; action < 5; ++action) {
    EXPECT_NEAR(toDegrees(relativeAction(goal_relative, scene.perception(), action).rotation), expected[action], 1e-9);
    EXPECT_EQ(relativeAction(goal_relative, scene.perception(), action).speed_fraction, action == 4 ? 0.5 : 1.0);
  }
}

TEST(GoalRelativeActions, StayingIsTheLastActionAndKeepsTheHeading) {
  const auto scene = PerceptionsBuilder().agent(0, polar(40.0, 5.0));
  EXPECT_EQ(relativeAction(smallActionSet(), scene.perception(), 5).rotation, 0.0);
  EXPECT_EQ(relativeAction(smallActionSet(), scene.perception(), 5).speed_fraction, 0.0);
}

TEST(GoalRelativeActions, KeepsTheHeadingAtTheGoal) {
  const auto scene = PerceptionsBuilder().agent(0, {0.0, 0.0});
  EXPECT_EQ(relativeAction(smallActionSet(), scene.perception(), 0).rotation, 0.0);
}

TEST(GoalRelativeActions, RelativeActionsEqualTheAdmissibleMoves) {
  const ActionSet& goal_relative = defaults();
  const auto scene =
      PerceptionsBuilder().agent(0, polar(25.0, 5.0)).neighbour({0.51, 0.02}, 0.25).wall({-1, 0.26}, {1, 0.26});
  const std::vector<MoveBlock> moves = movesOf(goal_relative, scene.perception());
  bool cut = false;
  for (Action action = 0; action < goal_relative.size(); ++action) {
    const CandidateMove move = moveAt(moves.data(), action);
    const RelativeAction carried_out = goal_relative.relativeAction(scene.perception(), moves.data(), {}, action);
    EXPECT_EQ(carried_out.speed_fraction, move.fraction);
    EXPECT_EQ(carried_out.rotation, bearingOf(move.direction));
    cut = cut || move.fraction < move.wanted;
  }
  EXPECT_TRUE(cut);
}

std::string specOf(const std::string& yaml) { return actionsOf(yaml)->spec(); }

TEST(GoalRelativeActions, AgreesWithItsSpec) {
  const std::string spec =
      "{type: goal_relative, headings: [0, 45], slow_headings: [], slow_fraction: 0.25, stay: false, gap_sharing: "
      "half, "
      "lookout: 1.5}";
  EXPECT_EQ(specOf(spec), spec);
  EXPECT_EQ(specOf("{type: goal_relative}"), defaults().spec());
  const std::string with_time_gap = spec.substr(0, spec.size() - 1) + ", time_gap: 0.9, time_gap_width: 0.8}";
  EXPECT_EQ(specOf(with_time_gap), with_time_gap);
  const std::string with_anticipation = with_time_gap.substr(0, with_time_gap.size() - 1) + ", anticipation_time: 0.5}";
  EXPECT_EQ(specOf(with_anticipation), with_anticipation);
  EXPECT_EQ(specOf(spec.substr(0, spec.size() - 1) + ", time_gap: 0, anticipation_time: 1}"), spec);  // off
  EXPECT_TRUE(contains(errorOf<InputError>([] { specOf("{type: goal_relative, anticipation_time: -1}"); }),
                       "anticipation_time: expected a number of 0 or more"));
  const auto error = [](const std::string& yaml) { return errorOf<InputError>([&] { specOf(yaml); }); };
  EXPECT_TRUE(
      contains(error("{type: goal_relative, headings: [10, 0]}"), "headings[1]: expected a list of rising numbers"));
  EXPECT_TRUE(contains(error("{type: goal_relative, headings: [200]}"), "from 0 to 180, got '200'"));
  EXPECT_TRUE(contains(error("{type: goal_relative, headings: []}"), "headings: expected at least one"));
  EXPECT_TRUE(contains(error("{type: goal_relative, time_gap: -1}"), "time_gap: expected a number of 0 or more"));
  EXPECT_TRUE(
      contains(error("{type: goal_relative, gap_sharing: third}"), "expected none, half or moving, got 'third'"));
}

TEST(GoalRelativeActions, MotionLimitsArePartOfTheSpecIfTheyAreOn) {
  const std::string spec = defaults().spec();
  EXPECT_FALSE(contains(spec, "motion"));
  EXPECT_EQ(actionsOf(spec)->motion(), MotionLimits());
  const std::string start = spec.substr(0, spec.size() - 1) + ", motion: ";
  for (const std::string motion :
       {"{acceleration: 3, braking: 3}", "{acceleration: 2.5, braking: 6, turn_rate: 1.75}"}) {
    EXPECT_EQ(specOf(start + motion + "}"), start + motion + "}");
  }
  EXPECT_EQ(actionsOf(start + "{acceleration: 2.5, braking: 6, turn_rate: 1.75}}")->motion(),
            (MotionLimits{2.5, 6.0, 1.75}));
  EXPECT_EQ(specOf(start + "unlimited}"), spec);
  EXPECT_TRUE(contains(errorOf<InputError>([&] { specOf(start + "{acceleration: 3}}"); }),
                       "action_set.motion: the key 'braking' is missing"));
}

/// The limits in force are those of the perceptions, whatever those of the set.
TEST(GoalRelativeActions, ActionsKeepTheMotionLimitsOfThePerception) {
  const ActionSet& goal_relative = defaults();
  auto scene = PerceptionsBuilder().agent(0, {5.0, 0.0}).speed(1.3);
  EXPECT_EQ(relativeAction(goal_relative, scene.perception(), 0).speed_fraction, 1.0);
  scene.motion({2.0, 3.0, INFINITE});
  EXPECT_NEAR(1.3 * relativeAction(goal_relative, scene.perception(), 0).speed_fraction, 0.2, 1e-12);
  scene.walking({0.65, 0.0});
  EXPECT_NEAR(1.3 * relativeAction(goal_relative, scene.perception(), 0).speed_fraction, 0.85, 1e-12);
  const Action stay = goal_relative.size() - 1;
  EXPECT_NEAR(1.3 * relativeAction(goal_relative, scene.perception(), stay).speed_fraction, 0.35, 1e-12);
}

TEST(GoalRelativeActions, AgentsWithMassSlowDownBesideTheirGoal) {
  // Straight on at 1.5 m/s, the goal is 0.3 m to the left: the circle through it has a radius of 0.15 m, and at 3 m/s^2
  // it can be walked at sqrt(3 * 0.15) m/s. In a tick of 0.1 s an agent brakes by 0.3 m/s.
  const ActionSet& actions = defaults();
  const auto speed_of = [&](const Vector2& goal) {
    const auto scene = PerceptionsBuilder().agent(0, goal).speed(1.5).walking({0.9, 0.0}).motion({3.0, 3.0, INFINITE});
    const Perception seen = scene.perception();
    std::vector<MoveBlock> ahead = toBlocks({CandidateMove{Vector2::UnitX(), 1.0, 1.0}});
    return 1.5 * actions.relativeAction(seen, ahead.data(), {}, 0).speed_fraction;
  };
  EXPECT_NEAR(speed_of({0.0, 0.3}), std::sqrt(3.0 * 0.15), 1e-9);
  EXPECT_NEAR(speed_of({0.3, 0.0}), 1.2, 1e-9);   // straight ahead: it speeds up
  EXPECT_NEAR(speed_of({0.0, 30.0}), 1.2, 1e-9);  // far away
}

}  // namespace
}  // namespace crowd::goal_relative_actions_test
