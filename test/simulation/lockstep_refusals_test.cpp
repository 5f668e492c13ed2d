#include "simulation/lockstep.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/answers.h"

namespace crowd::lockstep_refusals_test {
namespace {

using answers::agentsOf;
using answers::answersOf;
using answers::EPISODE;
using answers::Ids;
using answers::LEARNER;
using answers::MOVE;
using answers::playTick;

constexpr LearnerId OTHER = 1;

/// Causes of the answers that are refused.
std::vector<Refusal> causesOf(const std::vector<RefusedAnswer>& refused) {
  std::vector<Refusal> causes;
  for (const RefusedAnswer& one : refused) causes.push_back(one.cause);
  return causes;
}

TEST(LockstepDrops, AnswersToAnotherTickOrEpisode) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 4, {0, 1});
  lockstep.take(answersOf(3, {0}), LEARNER);
  lockstep.take(answersOf(5, {0}), LEARNER);
  lockstep.take(answersOf(4, {0, 1}, MOVE, EPISODE - 1), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 4U);
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1}));
  EXPECT_TRUE(lockstep.answers().empty());
}

TEST(LockstepDrops, AnswersWhileNoTickIsOpen) {
  Lockstep lockstep(3);
  lockstep.take(answersOf(0, {0}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 2U);
  EXPECT_EQ(agentsOf(lockstep.answers()), Ids{0});
}

TEST(LockstepDrops, SecondAnswersAndKeepsTheFirst) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  lockstep.take(answersOf(0, {0}), LEARNER);
  lockstep.take(answersOf(0, {0}, {2.0, 0.0}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  ASSERT_EQ(lockstep.answers().size(), 1U);
  EXPECT_EQ(lockstep.answers()[0].action.rotation, 0.5);
  EXPECT_FALSE(lockstep.isComplete());  // the second answer does not count for agent 1
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepDrops, UnknownAgents) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0});
  lockstep.take(answersOf(1, {1, 7, UINT32_MAX}), LEARNER);  // not asked in this tick, never asked, never asked
  EXPECT_EQ(lockstep.droppedCount(), 3U);
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_TRUE(lockstep.answers().empty());
}

TEST(LockstepDrops, InvalidAnswers) {
  constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const std::vector<RelativeAction> invalid = {{NOT_A_NUMBER, 1.0}, {-INFINITE, 1.0}, {0.0, NOT_A_NUMBER},
                                               {0.0, INFINITE},     {0.0, -0.01},     {0.0, 1.01}};
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0});
  for (const RelativeAction& action : invalid) lockstep.take(answersOf(0, {0}, action), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), invalid.size());
  EXPECT_EQ(lockstep.missing(), Ids{0});
  lockstep.take(answersOf(0, {0}, {-100.0, 0.0}), LEARNER);  // a later valid answer is accepted
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(lockstep.droppedCount(), invalid.size());
}

// Repeated answers: perceptions may be sent again to a learner that has answered, and its answer be sent again as well.
TEST(LockstepRepetitions, AreIgnoredDuringAndAfterTheTick) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_TRUE(lockstep.take(answersOf(0, {0, 0}), LEARNER).empty());
  EXPECT_TRUE(lockstep.take(answersOf(0, {0}), LEARNER).empty());
  lockstep.close();
  EXPECT_TRUE(lockstep.take(answersOf(0, {0}), LEARNER).empty());
  lockstep.open(EPISODE, 1, {0, 1});
  EXPECT_TRUE(lockstep.take(answersOf(0, {0}), LEARNER).empty());
  EXPECT_EQ(lockstep.droppedCount(), 0U);
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1}));
}

TEST(LockstepRepetitions, AnswersToAnAbandonedTickAreIgnored) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 4, {0, 1});
  lockstep.open(EPISODE + 1, 0, {0, 1});  // after a reset
  EXPECT_TRUE(lockstep.take(answersOf(4, {0, 1}), LEARNER).empty());
  EXPECT_EQ(lockstep.droppedCount(), 0U);
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1}));
}

TEST(LockstepRefusals, NameTheCause) {
  constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
  Lockstep lockstep(3);
  playTick(lockstep, 3, {0, 1}, {1});
  lockstep.open(EPISODE, 4, {0});
  const auto causes = [&](std::uint64_t tick, AgentId agent, const RelativeAction& action, std::uint64_t episode) {
    return causesOf(lockstep.take(answersOf(tick, {agent}, action, episode), LEARNER));
  };
  using Causes = std::vector<Refusal>;
  EXPECT_EQ(causes(4, 7, MOVE, EPISODE), Causes{Refusal::NOT_ASKED});  // never
  EXPECT_EQ(causes(4, 1, MOVE, EPISODE), Causes{Refusal::NOT_ASKED});  // in this tick
  EXPECT_EQ(causes(4, 0, {NOT_A_NUMBER, 1.0}, EPISODE), Causes{Refusal::BAD_ROTATION});
  EXPECT_EQ(causes(4, 0, {0.0, 2.0}, EPISODE), Causes{Refusal::BAD_SPEED});
  EXPECT_EQ(causes(4, 0, {0.0, NOT_A_NUMBER}, EPISODE), Causes{Refusal::BAD_SPEED});
  EXPECT_EQ(causes(3, 0, MOVE, EPISODE), Causes{Refusal::TOO_LATE});
  EXPECT_EQ(causes(9, 0, MOVE, EPISODE - 1), Causes{Refusal::TOO_LATE});
  EXPECT_EQ(causes(5, 0, MOVE, EPISODE), Causes{Refusal::TOO_EARLY});
  EXPECT_EQ(causes(0, 0, MOVE, EPISODE + 1), Causes{Refusal::TOO_EARLY});
  EXPECT_EQ(causes(4, 0, MOVE, EPISODE), Causes{});
  EXPECT_EQ(causes(4, 0, {0.0, 0.0}, EPISODE), Causes{Refusal::SECOND_ANSWER});
  EXPECT_EQ(lockstep.droppedCount(), 10U);
}

TEST(LockstepRefusals, NameBothLearnersOfAnAgent) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_TRUE(lockstep.take(answersOf(0, {0}), LEARNER).empty());
  const std::vector<RefusedAnswer> refused = lockstep.take(answersOf(0, {0, 1}), OTHER);  // with the same action
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].cause, Refusal::OTHER_LEARNER);
  EXPECT_EQ(refused[0].answer.agent, 0U);
  EXPECT_EQ(refused[0].learner, OTHER);
  EXPECT_EQ(refused[0].other, LEARNER);
}

TEST(LockstepRefusals, NameBothLearnersIfTheOtherAnswersLater) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0}, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(0, {0}), OTHER)), std::vector<Refusal>{Refusal::OTHER_LEARNER});
  playTick(lockstep, 1, {0}, {0});
  lockstep.open(EPISODE, 2, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(0, {0}), OTHER)), std::vector<Refusal>{Refusal::OTHER_LEARNER});
}

TEST(LockstepRefusals, AllowALearnerToReplaceAStoppedOne) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0}, {0});
  playTick(lockstep, 1, {0}, {});
  lockstep.open(EPISODE, 2, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(1, {0}), OTHER)), std::vector<Refusal>{Refusal::TOO_LATE});
  EXPECT_TRUE(lockstep.take(answersOf(2, {0}), OTHER).empty());
  EXPECT_TRUE(lockstep.isComplete());
}

}  // namespace
}  // namespace crowd::lockstep_refusals_test
