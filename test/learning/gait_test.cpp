#include "learning/actions/gait.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "common/text/numbers.h"
#include "geometry/geometry.h"
#include "support/error_of.h"
#include "support/learners.h"
#include "support/moves.h"
#include "support/parts.h"
#include "support/perceptions.h"

namespace crowd::gait_test {
namespace {

constexpr double TICK = 0.1;            // [s]
constexpr double LARGEST_EXTENT = 1.7;  // of an agent

KeyedRandom agentOf(std::uint64_t number) { return {0, KeyedRandom::GAIT, {3, number}}; }

TEST(Gait, StaysWithinItsMaxima) {
  const Gait gait{5.0, 15.0, 0.08};
  double most_turn = 0.0;
  double least_pace = 1.0;
  for (std::uint64_t agent = 0; agent < 200; ++agent) {
    for (int tick = 0; tick < 600; ++tick) {
      const GaitDeviation deviation = gait.at(agentOf(agent), tick * TICK);
      most_turn = std::max(most_turn, std::abs(deviation.turn));
      least_pace = std::min(least_pace, deviation.pace);
      ASSERT_LE(deviation.pace, 1.0);
    }
  }
  EXPECT_LE(toDegrees(most_turn), LARGEST_EXTENT * 20.0);
  EXPECT_GE(toDegrees(most_turn), 20.0);  // some agents deviate by more than the usual maximum
  EXPECT_GE(least_pace, 1.0 - LARGEST_EXTENT * 0.08);
  EXPECT_LE(least_pace, 1.0 - 0.08);
}

TEST(Gait, ChangesSmoothly) {
  // A cubic step from -1 to 1 within 0.8 s rises by at most 2 * 1.5 / 8 in a tick.
  const Gait gait{4.0, 0.0, 0.0};
  const double most = LARGEST_EXTENT * 4.0 * 2.0 * 1.5 * TICK / 0.8;
  for (std::uint64_t agent = 0; agent < 50; ++agent) {
    for (int tick = 0; tick < 300; ++tick) {
      const double turn = gait.at(agentOf(agent), (tick + 1) * TICK).turn - gait.at(agentOf(agent), tick * TICK).turn;
      ASSERT_LE(toDegrees(std::abs(turn)), most) << "agent " << agent << ", tick " << tick;
    }
  }
}

TEST(Gait, FavoursNoSide) {
  const Gait gait{5.0, 15.0, 0.0};
  double sum = 0.0;
  for (std::uint64_t agent = 0; agent < 1000; ++agent) {
    for (int tick = 0; tick < 400; tick += 40) sum += toDegrees(gait.at(agentOf(agent), tick * TICK).turn);
  }
  // Uniform values have a variance of 1/3: about 9 degrees, so that the mean of 10,000 is within 0.1 about once.
  EXPECT_NEAR(sum / 10000.0, 0.0, 0.5);
}

TEST(Gait, DiffersBetweenAgentsAndIsRepeated) {
  const Gait gait{5.0, 15.0, 0.08};
  EXPECT_EQ(gait.at(agentOf(1), 7.3).turn, gait.at(agentOf(1), 7.3).turn);
  EXPECT_NE(gait.at(agentOf(1), 7.3).turn, gait.at(agentOf(2), 7.3).turn);
  EXPECT_FALSE(Gait().isOn());
  EXPECT_EQ(Gait().at(agentOf(1), 7.3).turn, 0.0);
  EXPECT_EQ(Gait().at(agentOf(1), 7.3).pace, 1.0);
}

std::string textOf(const std::string& yaml) { return toText(readGait(YAML::Load(yaml), {"file.yaml", 0, "gait"})); }

TEST(Gait, IsRead) {
  EXPECT_EQ(textOf("{sway: 5, wander: 15, pace: 0.08}"), "{sway: 5, wander: 15, pace: 0.08}");
  EXPECT_EQ(textOf("{wander: 15}"), "{sway: 0, wander: 15, pace: 0}");
  EXPECT_EQ(textOf("{shift: 0.2}"), "{sway: 0, wander: 0, pace: 0, shift: 0.2}");
  EXPECT_TRUE(contains(errorOf<InputError>([] { textOf("{shift: 11}"); }), "gait.shift"));
  EXPECT_TRUE(contains(errorOf<InputError>([] { textOf("{sway: -1}"); }), "gait.sway"));
  EXPECT_TRUE(contains(errorOf<InputError>([] { textOf("{pace: 2}"); }), "gait.pace"));
  EXPECT_TRUE(contains(errorOf<InputError>([] { textOf("{sigh: 1}"); }), "sigh"));
}

std::shared_ptr<const ActionSet> walkingAsPeopleDo() {
  return actionsOf("{type: goal_relative, gait: {sway: 5, wander: 15, pace: 0.08}}");
}

TEST(Gait, ActsOnAgentsWithMotionLimitsOnly) {
  const auto with = walkingAsPeopleDo();
  const auto scene = PerceptionsBuilder().agent(0, {5.0, 0.0});
  EXPECT_EQ(relativeAction(*with, scene.perception(), 0).rotation, 0.0);
  EXPECT_EQ(relativeAction(*with, scene.perception(), 0).speed_fraction, 1.0);
}

/// The action straight ahead of an agent of radius 0.25 m that walks at full speed.
RelativeAction ahead(AgentId agent, bool beside_wall) {
  auto scene =
      PerceptionsBuilder().agent(agent, {5.0, 0.0}).speed(1.3).walking({1.3, 0.0}).motion({3.0, 3.0, INFINITE});
  if (beside_wall) scene.wall({-5.0, 0.251}, {5.0, 0.251}).wall({-5.0, -0.251}, {5.0, -0.251});
  return relativeAction(*walkingAsPeopleDo(), scene.perception(), 0);
}

TEST(Gait, IsNotThatOfAgentsWhoLearn) {
  const auto scene =
      PerceptionsBuilder().agent(0, {5.0, 0.0}).speed(1.3).walking({1.3, 0.0}).motion({3.0, 3.0, INFINITE});
  const auto actions = walkingAsPeopleDo();
  const Perception seen = scene.perception();
  const RelativeAction learning = relativeAction(*actions->whileLearning(), seen, 0);
  EXPECT_EQ(learning.rotation, 0.0);
  EXPECT_EQ(learning.speed_fraction, 1.0);
  EXPECT_NE(relativeAction(*actions, seen, 0).rotation, 0.0);
}

/// The answer to an agent that walks straight to its goal, by a table without values.
double rotationOf(Learner& learner) {
  const auto scene = PerceptionsBuilder(0, 7).agent(0, {5.0, 0.0}).walking({0.3, 0.0}).motion({3.0, 3.0, INFINITE});
  return learners::decide(learner, scene).agents.at(0).action.rotation;
}

TEST(Gait, BeginsAndEndsWithTheModeOfTheLearner) {
  Learner learner(
      parseModel("{state_set: {type: anticipation}, action_set: {type: goal_relative, motion: {acceleration: 3, "
                 "braking: 3}, gait: {sway: 45, wander: 45}}, reward: {type: progress}}"),
      learners::options(Mode::TRAINING));
  EXPECT_EQ(rotationOf(learner), 0.0);
  learner.setMode(Mode::DEMO);
  EXPECT_NE(rotationOf(learner), 0.0);
  learner.setMode(Mode::TRAINING);
  EXPECT_EQ(rotationOf(learner), 0.0);
}

TEST(Gait, ShiftsAtItsRateInAllDirections) {
  constexpr std::uint32_t MOVES = 4;
  Gait gait;
  EXPECT_FALSE(gait.shiftAt(agentOf(1), MOVES, 0, TICK).has_value());
  gait.shift = 0.5;
  std::array<int, MOVES> shifts{};
  for (std::uint64_t agent = 0; agent < 200; ++agent) {
    for (std::uint64_t tick = 0; tick < 1000; ++tick) {
      const auto shift = gait.shiftAt(agentOf(agent), MOVES, tick, TICK);
      ASSERT_EQ(shift, gait.shiftAt(agentOf(agent), MOVES, tick, TICK));
      if (shift) ++shifts.at(*shift);
    }
  }
  // Of 200,000 ticks one in 20 has a shift: 2,500 of each move, with a standard deviation below 50.
  for (const int count : shifts) EXPECT_NEAR(count, 2500, 250);
}

/// Number of ticks, of 1000, in which an agent at rest does not answer as the chosen move says.
int shiftsOf(double shift, bool is_blocked) {
  const auto actions = actionsOf("{type: goal_relative, gait: {shift: " + toText(shift) + "}}");
  int shifts = 0;
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    auto scene = PerceptionsBuilder(0, tick).agent(0, {5.0, 0.0}).speed(1.3).motion({3.0, 3.0, INFINITE});
    if (is_blocked) scene.wall({0.251, -5.0}, {0.251, 5.0});
    const RelativeAction action = relativeAction(*actions, scene.perception(), 0);
    if (action.rotation != 0.0) ++shifts;
  }
  return shifts;
}

TEST(Gait, OnlyAgentsThatStandShift) {
  EXPECT_EQ(shiftsOf(0.0, true), 0);
  EXPECT_EQ(shiftsOf(10.0, false), 0);
  EXPECT_GT(shiftsOf(10.0, true), 500);  // in each tick; moves that are blocked, or to stay, turn nobody
}

TEST(Gait, DeviatesOnlyWhereThereIsSpace) {
  for (AgentId agent = 0; agent < 50; ++agent) {
    EXPECT_NE(ahead(agent, false).rotation, 0.0) << agent;
    EXPECT_EQ(ahead(agent, true).rotation, 0.0) << agent;
    EXPECT_EQ(ahead(agent, true).speed_fraction, 1.0) << agent;
  }
}

}  // namespace
}  // namespace crowd::gait_test
