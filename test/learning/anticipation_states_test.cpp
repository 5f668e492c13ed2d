#include "learning/states/anticipation_states.h"

#include <gtest/gtest.h>

#include "avoidance/time_to_collision.h"
#include "learning/actions/goal_relative_actions.h"
#include "learning/actions/kings_moves.h"
#include "support/error_of.h"
#include "support/moves.h"
#include "support/perceptions.h"
#include "support/rows.h"

namespace crowd::anticipation_states_test {
namespace {

constexpr double ROUNDING = 1e-5;  // tolerance of times in single precision
const CandidateMove ANY_MOVE;

const AnticipationStates& states() {
  static const AnticipationStates STATES({}, GoalRelativeActions().size());
  return STATES;
}

/// Returns the features of a move.
struct Features {
  double reciprocal_time = NEVER;
  double constant_velocity_time = NEVER;
  double static_time = NEVER;
  double fraction = 1.0;
  double turn_cosine = 1.0;
  double oncoming = 0.0;
};

MoveFeatures describeAll(const PerceptionsBuilder& scene, const CandidateMove& move) {
  const double min_fraction = AnticipationStates::Parameters().admissible_fractions.front();
  return featuresAlone(scene.perception(), toBlocks({move})[0], 1, {CandidateSpeeds::WANTED, min_fraction});
}

Features describe(const PerceptionsBuilder& scene, const CandidateMove& move) {
  const MoveFeatures all = describeAll(scene, move);
  return {all.reciprocal_times[0], all.constant_velocity_times[0],
          all.static_times[0],     all.admissible_fractions[0],
          all.turn_cosines[0],     all.oncoming};
}

/// Returns the features of full speed ahead, 0.3 m/s.
Features ahead(const PerceptionsBuilder& scene) { return describe(scene, {Vector2::UnitX(), 1.0, 1.0}); }

Row rowOf(const Features& move_features) {
  MoveFeatures lanes = describeAll(PerceptionsBuilder().agent(0, {1.0, 0.0}), ANY_MOVE);
  lanes.reciprocal_times[0] = static_cast<float>(move_features.reciprocal_time);
  lanes.constant_velocity_times[0] = static_cast<float>(move_features.constant_velocity_time);
  lanes.static_times[0] = static_cast<float>(move_features.static_time);
  lanes.admissible_fractions[0] = static_cast<float>(move_features.fraction);
  lanes.turn_cosines[0] = static_cast<float>(move_features.turn_cosine);
  lanes.oncoming = static_cast<float>(move_features.oncoming);
  Row row = 0;
  states().findRows(lanes, 1, &row);
  return row;
}

std::vector<Row> rowsOf(const AnticipationStates& states, const ActionSet& actions, const PerceptionsBuilder& scene) {
  const Perception seen = scene.perception();
  return rowsOf(states, seen, movesOf(actions, seen));
}

TEST(AnticipationStates, FreeMovesHaveNoTimesToCollision) {
  const auto move_features = ahead(PerceptionsBuilder().agent(0, {9.0, 0.0}));
  EXPECT_GE(move_features.reciprocal_time, NEVER);
  EXPECT_GE(move_features.constant_velocity_time, NEVER);
  EXPECT_GE(move_features.static_time, NEVER);
  EXPECT_EQ(move_features.fraction, 1.0);
  EXPECT_EQ(move_features.turn_cosine, 1.0);
}

TEST(AnticipationStates, AgentsHaveConstantVelocityAndReciprocalTimes) {
  // Gap 1.2 m; the other comes at 0.1 m/s, the agent moved sideways at 0.1 m/s: the relative speed is 0.4 m/s head on,
  // and the reciprocal one 0.7 m/s, slightly sideways.
  const auto scene =
      PerceptionsBuilder().agent(0, {9.0, 0.0}).neighbour({1.7, 0.0}, 0.25).velocity({0.0, 0.1}, {-0.1, 0.0});
  const auto move_features = ahead(scene);
  EXPECT_NEAR(move_features.constant_velocity_time, 3.0, ROUNDING);
  EXPECT_NEAR(move_features.reciprocal_time, timeToCollision(Vector2(1.7, 0.0), {0.7, -0.1}, 0.5), ROUNDING);
  EXPECT_GE(move_features.static_time, NEVER);
  EXPECT_NEAR(move_features.turn_cosine, 1.0, ROUNDING);
}

TEST(AnticipationStates, StaticObstaclesAndWallsHaveStaticTimes) {
  auto scene = PerceptionsBuilder().agent(0, {9.0, 0.0}).neighbour({2.0, 0.0}, 0.25).kind(NeighbourKind::OBSTACLE);
  EXPECT_NEAR(ahead(scene).static_time, 5.0, ROUNDING);
  EXPECT_GE(ahead(scene).constant_velocity_time, NEVER);
  scene.wall({0.85, -1.0}, {0.85, 1.0});
  EXPECT_NEAR(ahead(scene).static_time, 2.0, ROUNDING);
}

TEST(AnticipationStates, BlockedMovesHaveTheTimesOfStaying) {
  // Gap 1.2 m; the other comes at 0.1 m/s: 12 s if the agent stays. The wall is never touched.
  const auto scene = PerceptionsBuilder()
                         .agent(0, {9.0, 0.0})
                         .neighbour({1.7, 0.0}, 0.25)
                         .velocity({0.0, 0.0}, {-0.1, 0.0})
                         .wall({0.85, -1.0}, {0.85, 1.0});
  const auto blocked = describe(scene, {Vector2::UnitX(), 1.0, 0.04});
  EXPECT_NEAR(blocked.constant_velocity_time, 12.0, ROUNDING);
  EXPECT_NEAR(blocked.reciprocal_time, 12.0, ROUNDING);
  EXPECT_GE(blocked.static_time, NEVER);
  EXPECT_NEAR(blocked.fraction, 0.04, ROUNDING);
  const auto cut = describe(scene, {Vector2::UnitX(), 1.0, 0.06});
  EXPECT_NEAR(cut.constant_velocity_time, 3.0, ROUNDING);
  EXPECT_NEAR(cut.reciprocal_time, 1.2 / 0.7, ROUNDING);
  EXPECT_NEAR(cut.static_time, 2.0, ROUNDING);
}

TEST(AnticipationStates, IgnoresObstaclesBehindTheGoal) {
  const auto scene =
      PerceptionsBuilder().agent(0, {1.0, 0.0}).neighbour({2.0, 0.0}, 0.25).kind(NeighbourKind::OBSTACLE);
  EXPECT_GE(ahead(scene).static_time, NEVER);
}

TEST(AnticipationStates, EachRowIsOneCombinationOfClasses) {
  std::vector<bool> taken(states().rowCount(), false);
  const std::vector<double> late = {0.1, 0.5, 1.2, 1.7, 2.5, 3.5, 5, NEVER};
  const std::vector<double> constant_velocity = {0.1, 1, 3, NEVER};
  const std::vector<double> fixed = {0.1, 0.7, 1, 2, 4, NEVER};
  for (const double r : late) {
    for (const double s : constant_velocity) {
      for (const double f : fixed) {
        for (const double fraction : {0.0, 0.1, 0.6, 1.0}) {
          for (const double turn : {0.0, 10.0, 30.0, 90.0}) {
            for (const double oncoming : {0.0, 1.5}) {
              const Row row = rowOf({r, s, f, fraction, std::cos(toRadians(turn)), oncoming});
              ASSERT_LT(row, states().rowCount());
              EXPECT_FALSE(taken[row]) << row;
              taken[row] = true;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(std::count(taken.begin(), taken.end(), true), 6144);
  EXPECT_EQ(states().rowCount(), 6144U);
  EXPECT_EQ(rowOf({NEVER, NEVER, NEVER, 1.0, 1.0, 1.5}), rowOf(Features()) + 1);  // the approach is the last digit
}

TEST(AnticipationStates, FindsARowForEachMove) {
  const auto scene =
      PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({1.0, 0.0}, 0.25).velocity({0.3, 0}, {-0.3, 0});
  const std::vector<Row> rows = rowsOf(states(), GoalRelativeActions(), scene);
  ASSERT_EQ(rows.size(), GoalRelativeActions().size());
  const double approach = 2.0;  // 0.3 m/s against 0.3 m/s
  auto move_features = ahead(scene);
  move_features.oncoming = approach;
  EXPECT_EQ(rows[0], rowOf(move_features));
  EXPECT_NE(rows[0], rows[13]);  // backwards
}

TEST(AnticipationStates, AcceptsAnyActionSet) {
  for (const int count : {2, 4, 24, 25, 60}) {
    const KingsMoves kings(count);
    const AnticipationStates states({}, kings.size());
    const auto scene = PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({-1.0, 0.0}, 0.25);
    const std::vector<Row> rows = rowsOf(states, kings, scene);
    ASSERT_EQ(rows.size(), kings.size());
    EXPECT_EQ(rows[0], rowOf(Features()));
    // Behind the agent, another one stands at a gap of 0.5 m: contact after 1.7 s, or half of that.
    const Action back = kings.size() / 2;
    if (count % 2 == 0) {
      EXPECT_EQ(rows[back], rowOf({0.5 / 0.6, 0.5 / 0.3, NEVER, 1.0, 1.0, 0.0})) << count;
    }
  }
}

TEST(AnticipationStates, AgreesWithItsSpec) {
  const std::string spec =
      "{type: anticipation, vision_radius: 5, wall_distance: 0.8, max_neighbours: 9, reciprocal_times: [1, 2], "
      "constant_velocity_times: [], static_times: [3], admissible_fractions: [0.5], turns: [10], oncoming: [], "
      "personal_space: 0.2, candidate_speeds: admissible}";
  const auto made = makeStateSet(YAML::Load(spec), {"file.yaml", 0, "state_set"}, GoalRelativeActions());
  EXPECT_EQ(made->spec(), spec);
  EXPECT_EQ(made->rowCount(), 24U);  // 3 * 2 * 2 * 2
  EXPECT_EQ(made->maxNeighbours(), 9U);
  const auto error = errorOf<InputError>([] {
    makeStateSet(YAML::Load("{type: anticipation, turns: [190]}"), {"file.yaml", 0, "state_set"},
                 GoalRelativeActions());
  });
  EXPECT_TRUE(contains(error, "turns[0]: expected a list of rising numbers from 0 to 180, got '190'"));
}

}  // namespace
}  // namespace crowd::anticipation_states_test
