#include "avoidance/time_gap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/random.h"
#include "common/text/numbers.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::time_gap_test {
namespace {

constexpr double REFERENCE = TimeGap::REFERENCE_SPEED;

std::vector<CandidateMove> limited(const TimeGap& time_gap, const PerceptionsBuilder& scene,
                                   std::vector<CandidateMove> moves) {
  std::vector<MoveBlock> blocks = toBlocks(moves);
  time_gap.cut(scene.perception(), blocks.data(), moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = moveAt(blocks.data(), i);
  return moves;
}

/// The admissible fraction of a move at full speed at an angle to ahead [degrees].
double fractionAt(double degrees, const TimeGap& time_gap, const PerceptionsBuilder& scene) {
  return limited(time_gap, scene, {{unitVector(toRadians(degrees)), 1.0, 1.0}})[0].fraction;
}

/// An agent of radius 0.25 m, and another one of the same radius with a gap in between [m], at a bearing [degrees].
PerceptionsBuilder facing(double gap, double bearing = 0.0) {
  return PerceptionsBuilder().agent(0, {5.0, 0.0}).neighbour(polar(bearing, 0.5 + gap), 0.25);
}

TEST(TimeGap, TakesTheTimeGapToWalkTheGap) {
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(0.5 * REFERENCE)), 0.5, 1e-9);
  EXPECT_NEAR(fractionAt(0.0, {0.5, 1.0, 0.0}, facing(0.25 * REFERENCE)), 0.5, 1e-9);
  EXPECT_NEAR(fractionAt(0.0, {2.0, 1.0, 0.0}, facing(0.5 * REFERENCE)), 0.25, 1e-9);
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(0.134)), 0.1, 1e-9);
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(0.0)), 0.0, 1e-9);
  EXPECT_EQ(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(-0.1)), 0.0);
  EXPECT_EQ(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(1.35)), 1.0);
}

/// The same; the agent walks ahead at 0.5 m/s, the other one at a velocity [m/s].
PerceptionsBuilder following(double gap, const Vector2& velocity) {
  return facing(gap).speed(1.0).velocity({0.5, 0.0}, velocity);
}

TEST(TimeGap, IsThatOfTheGapThatOpens) {
  // f * 1.34 m is the gap of 0.2 m and 0.4 m, less f * 0.5 m.
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.5}, following(0.2, {0.8, 0.0})), 0.6 / (REFERENCE + 0.5), 1e-9);
  // Across, or towards the agent, or more slowly than it may walk at the present gap, no gap opens.
  for (const Vector2& velocity : {Vector2(0.0, 1.0), Vector2(-1.0, 0.0), Vector2(0.1, 0.0)}) {
    EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.5}, following(0.2, velocity)), 0.2 / REFERENCE, 1e-9);
  }
  // The other is at 40 degrees: of a way straight ahead cos(40 degrees) lead towards it.
  const auto aside = facing(0.0, 40.0).speed(1.0).velocity({0.5, 0.0}, polar(40.0, 0.8));
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.5}, aside), 0.4 / (REFERENCE + 0.5 * std::cos(toRadians(40.0))), 1e-9);
}

TEST(TimeGap, DoesNotDependOnTheSpeedOfTheAgent) {
  const auto scene = [](double speed) { return facing(0.2).speed(1.0).velocity({speed, 0.0}, {0.8, 0.0}); };
  for (const double speed : {-1.0, 0.0, 1.0}) {
    EXPECT_EQ(fractionAt(0.0, {1.0, 1.0, 0.5}, scene(speed)), fractionAt(0.0, {1.0, 1.0, 0.5}, scene(0.3)));
  }
}

TEST(TimeGap, OfWhoFollowsAtTheSameSpeedIsAsWithoutAnticipation) {
  for (const double gap : {0.1, 0.3, 0.7}) {
    const auto scene = following(gap, {gap / REFERENCE, 0.0});  // the maximum speed is 1 m/s
    EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 2.0}, scene), fractionAt(0.0, {1.0, 1.0, 0.0}, scene), 1e-9) << gap;
  }
}

TEST(TimeGap, IsForWhoIsAheadOfTheMoveWithinTheBodysWidth) {
  // The other is 1 m away at 25 degrees: 0.42 m aside of straight ahead, less than 0.5 m, more than 0.8 of it.
  const PerceptionsBuilder scene = facing(0.5, 25.0);
  const double cut = 0.5 / REFERENCE;
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.0}, scene), cut, 1e-9);
  EXPECT_EQ(fractionAt(0.0, {1.0, 0.8, 0.0}, scene), 1.0);
  EXPECT_NEAR(fractionAt(25.0, {1.0, 0.8, 0.0}, scene), cut, 1e-9);
  EXPECT_NEAR(fractionAt(50.0, {1.0, 1.0, 0.0}, scene), cut, 1e-9);
  EXPECT_EQ(fractionAt(60.0, {1.0, 1.0, 0.0}, scene), 1.0);   // 35 degrees off: 0.57 m aside
  EXPECT_EQ(fractionAt(205.0, {1.0, 1.0, 0.0}, scene), 1.0);  // behind
}

TEST(TimeGap, IsKeptToTheNearestOfThoseAhead) {
  auto scene = facing(1.0).neighbour({0.5 + 0.134, 0.0}, 0.25);
  EXPECT_NEAR(fractionAt(0.0, {1.0, 1.0, 0.0}, scene), 0.1, 1e-9);
}

TEST(TimeGap, IsNotForObstaclesAndWalls) {
  EXPECT_EQ(fractionAt(0.0, {1.0, 1.0, 0.0}, facing(0.1).kind(NeighbourKind::OBSTACLE)), 1.0);
  EXPECT_EQ(fractionAt(0.0, {1.0, 1.0, 0.0}, PerceptionsBuilder().agent(0, {5.0, 0.0}).wall({0.3, -1}, {0.3, 1})), 1.0);
}

TEST(TimeGap, LeavesSlowerMovesAsTheyAre) {
  const auto moves = limited({1.0, 1.0, 0.0}, facing(0.5 * REFERENCE), {{Vector2::UnitX(), 0.4, 0.4}});
  EXPECT_EQ(moves[0].fraction, 0.4);
  EXPECT_EQ(moves[0].wanted, 0.4);
}

TEST(TimeGap, IsOffAtZero) {
  EXPECT_FALSE(TimeGap(0.0, 1.0, 0.0).isOn());
  EXPECT_EQ(fractionAt(0.0, {0.0, 1.0, 0.0}, facing(0.0)), 1.0);
}

PerceptionsBuilder randomScene(std::uint64_t seed) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {1});
  const auto place = [&] { return polar(360.0 * random.uniform(), 0.4 + 2.6 * random.uniform()); };
  PerceptionsBuilder scene;
  scene.agent(0, place());
  const std::uint32_t count = random.below(20);
  for (std::uint32_t i = 0; i < count; ++i) {
    scene.neighbour(place(), 0.1 + 0.15 * random.uniform());
    scene.kind(random.uniform() < 0.2 ? NeighbourKind::OBSTACLE : NeighbourKind::AGENT);
  }
  return scene;
}

std::shared_ptr<const ActionSet> actionSet(double time_gap) {
  return actionsOf("{type: goal_relative, time_gap: " + toText(time_gap) + "}");
}

TEST(TimeGap, NeverMakesAMoveFasterAndALongerOneNever) {
  std::size_t slower = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const PerceptionsBuilder scene = randomScene(seed);
    const auto free = movesOf(*actionSet(0.0), scene.perception());
    const auto shorter = movesOf(*actionSet(0.7), scene.perception());
    const auto longer = movesOf(*actionSet(1.4), scene.perception());
    for (std::size_t i = 0; i < actionSet(0.0)->size(); ++i) {
      const CandidateMove move = moveAt(free.data(), i);
      EXPECT_LE(moveAt(shorter.data(), i).fraction, move.fraction) << "seed " << seed << ", move " << i;
      EXPECT_LE(moveAt(longer.data(), i).fraction, moveAt(shorter.data(), i).fraction) << "seed " << seed;
      EXPECT_GE(moveAt(longer.data(), i).fraction, 0.0) << "seed " << seed;
      EXPECT_EQ(moveAt(longer.data(), i).direction, move.direction) << "seed " << seed;
      slower += moveAt(longer.data(), i).fraction < move.fraction ? 1 : 0;
    }
  }
  EXPECT_GT(slower, 1000U);  // of 3600
}

TEST(TimeGap, IsThatOfTheMomentWhileLearning) {
  const auto actions = actionsOf("{type: goal_relative, time_gap: 1, anticipation_time: 1}");
  const PerceptionsBuilder scene = following(0.2, {0.7, 0.0});
  EXPECT_NEAR(moveAt(movesOf(*actions, scene.perception()).data(), 0).fraction, 0.9 / (REFERENCE + 1.0), 1e-9);
  EXPECT_NEAR(moveAt(movesOf(*actions->whileLearning(), scene.perception()).data(), 0).fraction, 0.2 / REFERENCE, 1e-9);
}

TEST(TimeGap, DoesNotHoldUpWhoEscapesFromAMovingObstacle) {
  // Another agent is ahead; a moving obstacle comes from behind at 1 m/s and would touch in 0.5 s.
  const auto fraction = [](double time_gap, bool chased) {
    auto scene = facing(0.2);
    if (chased) scene.neighbour({-1.0, 0.0}, 0.25).kind(NeighbourKind::OBSTACLE).velocity({0.0, 0.0}, {1.0, 0.0});
    return moveAt(movesOf(*actionSet(time_gap), scene.perception()).data(), 0).fraction;
  };
  EXPECT_LT(fraction(1.0, false), fraction(0.0, false));
  EXPECT_EQ(fraction(1.0, true), fraction(0.0, true));
}

}  // namespace
}  // namespace crowd::time_gap_test
