#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "avoidance/time_to_collision.h"
#include "common/random.h"
#include "support/error_of.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"
#include "support/rows.h"

namespace crowd::anticipation_states_test {
namespace {

constexpr double ROUNDING = 1e-5;                                        // tolerance of times in single precision
const CollisionPrediction PREDICTION = {CandidateSpeeds::WANTED, 0.05};  // of the defaults

const ActionSet& goalRelative() {
  static const auto ACTIONS = actionsOf("{type: goal_relative}");
  return *ACTIONS;
}

const StateSet& states() {
  static const auto STATES = statesOf("{type: anticipation}", goalRelative());
  return *STATES;
}

/// The features of a move.
struct Features {
  double reciprocal_time = NEVER;
  double constant_velocity_time = NEVER;
  double static_time = NEVER;
  double fraction = 1.0;
  double turn_cosine = 1.0;
  double oncoming = 0.0;
};

Features featuresOf(const MoveFeatures& all, std::size_t move) {
  return {all.reciprocal_times[move], all.constant_velocity_times[move],
          all.static_times[move],     all.admissible_fractions[move],
          all.turn_cosines[move],     all.oncoming};
}

Features describe(const PerceptionsBuilder& scene, const CandidateMove& move) {
  return featuresOf(featuresAlone(scene.perception(), toBlocks({move})[0], 1, PREDICTION), 0);
}

/// Returns the features of full speed ahead, 0.3 m/s.
Features ahead(const PerceptionsBuilder& scene) { return describe(scene, {Vector2::UnitX(), 1.0, 1.0}); }

/// The row with the default limits: each digit is the number of limits that a quantity reaches.
Row rowOf(const Features& move_features) {
  Row row = 0;
  const auto append = [&](double value, const std::vector<double>& limits) {
    const auto reached = [&](double limit) { return static_cast<float>(value) >= static_cast<float>(limit); };
    row = row * static_cast<Row>(limits.size() + 1);
    row += static_cast<Row>(std::count_if(limits.begin(), limits.end(), reached));
  };
  append(move_features.reciprocal_time, {0.5, 1, 1.5, 2, 3, 4, 6});
  append(move_features.constant_velocity_time, {1, 2, 4});
  append(move_features.static_time, {0.5, 1, 2, 3, 4.5});
  append(move_features.fraction, {0.05, 0.5, 0.95});
  append(-move_features.turn_cosine,
         {-std::cos(toRadians(4.0)), -std::cos(toRadians(15.0)), -std::cos(toRadians(45.0))});
  append(move_features.oncoming, {1.2});
  return row;
}

std::vector<Row> rowsOf(const StateSet& states, const ActionSet& actions, const PerceptionsBuilder& scene) {
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

/// Agents, obstacles and a wall, near and far, of any velocity.
PerceptionsBuilder randomScene(std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  const auto vector = [&](double longest) {
    const double length = random.uniform(0.0, longest);
    return polar(random.uniform(-180.0, 180.0), length);
  };
  PerceptionsBuilder scene = PerceptionsBuilder().agent(0, vector(6.0)).speed(random.uniform(0.3, 1.3));
  const Vector2 own = vector(1.3);
  for (std::uint32_t count = random.below(4); count > 0; --count) {
    scene.neighbour(vector(4.0), 0.2).velocity(own, vector(1.3));
    if (random.below(3) == 0) scene.kind(NeighbourKind::OBSTACLE);
  }
  if (random.below(3) == 0) {
    const Vector2 from = vector(2.0);
    scene.wall(from, from + vector(2.0));
  }
  return scene;
}

TEST(AnticipationStates, EachRowIsOneCombinationOfClasses) {
  const std::array<Row, 6> classes = {2, 4, 4, 6, 4, 8};  // of each quantity, the last one first
  std::array<std::set<Row>, 6> found;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const PerceptionsBuilder scene = randomScene(seed);
    const Perception seen = scene.perception();
    const std::vector<MoveBlock> moves = movesOf(goalRelative(), seen);
    const MoveFeatures features = featuresAlone(seen, moves[0], goalRelative().size(), PREDICTION);
    const std::vector<Row> rows = rowsOf(states(), seen, moves);
    for (std::size_t move = 0; move < rows.size(); ++move) {
      ASSERT_EQ(rows[move], rowOf(featuresOf(features, move))) << "seed " << seed << ", move " << move;
      Row rest = rows[move];
      for (std::size_t i = 0; i < classes.size(); rest /= classes.at(i++)) found.at(i).insert(rest % classes.at(i));
      ASSERT_EQ(rest, 0U);
    }
  }
  for (std::size_t i = 0; i < classes.size(); ++i) EXPECT_EQ(found.at(i).size(), classes.at(i));
  EXPECT_EQ(states().rowCount(), 6144U);  // 8 * 4 * 6 * 4 * 4 * 2
}

TEST(AnticipationStates, FindsARowForEachMove) {
  const auto scene =
      PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({1.0, 0.0}, 0.25).velocity({0.3, 0}, {-0.3, 0});
  const std::vector<Row> rows = rowsOf(states(), goalRelative(), scene);
  ASSERT_EQ(rows.size(), goalRelative().size());
  const double approach = 2.0;  // 0.3 m/s against 0.3 m/s
  auto move_features = ahead(scene);
  move_features.oncoming = approach;
  EXPECT_EQ(rows[0], rowOf(move_features));
  EXPECT_NE(rows[0], rows[13]);  // backwards
}

TEST(AnticipationStates, AcceptsAnyActionSet) {
  for (const int count : {2, 4, 24, 25, 60}) {
    const auto kings = actionsOf("{type: kings_moves, rotations: " + std::to_string(count) + "}");
    const auto states = statesOf("{type: anticipation}", *kings);
    const auto scene = PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour({-1.0, 0.0}, 0.25);
    const std::vector<Row> rows = rowsOf(*states, *kings, scene);
    ASSERT_EQ(rows.size(), kings->size());
    EXPECT_EQ(rows[0], rowOf(Features()));
    // Behind the agent, another one stands at a gap of 0.5 m: contact after 1.7 s, or half of that.
    const Action back = kings->size() / 2;
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
  const auto made = statesOf(spec);
  EXPECT_EQ(made->spec(), spec);
  EXPECT_EQ(made->rowCount(), 24U);  // 3 * 2 * 2 * 2
  EXPECT_EQ(made->maxNeighbours(), 9U);
  const auto error = errorOf<InputError>([] { statesOf("{type: anticipation, turns: [190]}"); });
  EXPECT_TRUE(contains(error, "turns[0]: expected a list of rising numbers from 0 to 180, got '190'"));
}

}  // namespace
}  // namespace crowd::anticipation_states_test
