#include "social_crowd/learning/goal_fan.h"

#include <gtest/gtest.h>

#include "support/error_of.h"
#include "support/moves.h"
#include "support/perceptions.h"

namespace crowd {
namespace {

GoalFan smallFan() {
  GoalFan::Parameters parameters;
  parameters.headings = {0, 30, 180};
  parameters.slow_headings = {0};
  parameters.slow_share = 0.5;
  return GoalFan(parameters);
}

TEST(GoalFan, MeasuresItsHeadingsFromTheGoalsBearing) {
  const GoalFan fan = smallFan();
  const auto scene = PerceptionsBuilder().agent(0, polar(40.0, 5.0));
  ASSERT_EQ(fan.size(), 6U);
  const double expected[] = {40.0, 70.0, 10.0, -140.0, 40.0};
  for (Action action = 0; action < 5; ++action) {
    EXPECT_NEAR(toDegrees(fan.relativeAction(scene.perception(), action).rotation), expected[action], 1e-9);
    EXPECT_EQ(fan.relativeAction(scene.perception(), action).speed_share, action == 4 ? 0.5 : 1.0);
  }
}

TEST(GoalFan, ToStayComesLastAndKeepsTheHeading) {
  const auto scene = PerceptionsBuilder().agent(0, polar(40.0, 5.0));
  EXPECT_EQ(smallFan().relativeAction(scene.perception(), 5).rotation, 0.0);
  EXPECT_EQ(smallFan().relativeAction(scene.perception(), 5).speed_share, 0.0);
}

TEST(GoalFan, LooksAheadAtTheGoalItself) {
  const auto scene = PerceptionsBuilder().agent(0, {0.0, 0.0});
  EXPECT_EQ(smallFan().relativeAction(scene.perception(), 0).rotation, 0.0);
}

TEST(GoalFan, TellsOfAllMovesWhatItTellsOfEach) {
  const GoalFan fan;
  const auto scene =
      PerceptionsBuilder().agent(0, polar(25.0, 5.0)).body({0.51, 0.02}, 0.25).wall({-1, 0.26}, {1, 0.26});
  const std::vector<MoveBlock> moves = movesOf(fan, scene.perception());
  bool cut = false;
  for (Action action = 0; action < fan.size(); ++action) {
    const RelativeAction alone = fan.relativeAction(scene.perception(), action);
    const CandidateMove move = moveAt(moves.data(), action);
    EXPECT_EQ(alone.speed_share, move.share);
    EXPECT_EQ(alone.rotation, bearingOf(move.direction));
    cut = cut || move.share < move.wanted;
  }
  EXPECT_TRUE(cut);
}

std::string specOf(const std::string& yaml) {
  return makeActionSet(YAML::Load(yaml), {"file.yaml", 0, "action_set"})->spec();
}

TEST(GoalFan, IsWhatItsSpecSays) {
  const std::string spec =
      "{type: goal_fan, headings: [0, 45], slow_headings: [], slow_share: 0.25, stay: false, gap_sharing: half, "
      "lookout: 1.5}";
  EXPECT_EQ(specOf(spec), spec);
  EXPECT_EQ(specOf("{type: goal_fan}"), GoalFan().spec());
  const auto error = [](const std::string& yaml) { return errorOf<InputError>([&] { specOf(yaml); }); };
  EXPECT_TRUE(contains(error("{type: goal_fan, headings: [10, 0]}"), "headings[1]: expected a list of rising numbers"));
  EXPECT_TRUE(contains(error("{type: goal_fan, headings: [200]}"), "from 0 to 180, got '200'"));
  EXPECT_TRUE(contains(error("{type: goal_fan, headings: []}"), "headings: expected at least one"));
  EXPECT_TRUE(contains(error("{type: goal_fan, gap_sharing: third}"), "expected none, half or moving, got 'third'"));
}

}  // namespace
}  // namespace crowd
