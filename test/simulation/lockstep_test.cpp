#include "social_crowd/simulation/lockstep.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/answers.h"

namespace crowd {
namespace {

using answers::agentsOf;
using answers::answersOf;
using answers::EPISODE;
using answers::Ids;
using answers::MOVE;

constexpr LearnerId LEARNER = 0;
constexpr LearnerId OTHER = 1;

/// Causes of the answers that are refused.
std::vector<Refusal> causesOf(const std::vector<RefusedAnswer>& refused) {
  std::vector<Refusal> causes;
  for (const RefusedAnswer& one : refused) causes.push_back(one.cause);
  return causes;
}

/// Opens a tick, takes the answers of some and closes it.
void playTick(Lockstep& lockstep, std::uint64_t tick, const Ids& asked, const Ids& answering) {
  lockstep.open(EPISODE, tick, asked);
  lockstep.take(answersOf(tick, answering), LEARNER);
  lockstep.close();
}

TEST(Lockstep, CompleteOnceEverybodyHasAnswered) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1, 2});
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1, 2}));
  lockstep.take(answersOf(0, {2, 0}), LEARNER);
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.take(answersOf(0, {1}, {-0.25, 0.5}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_TRUE(lockstep.missing().empty());
  lockstep.close();
  ASSERT_EQ(agentsOf(lockstep.answers()), (Ids{2, 0, 1}));
  EXPECT_EQ(lockstep.answers()[0].action.rotation, 0.5);
  EXPECT_EQ(lockstep.answers()[2].action.rotation, -0.25);
  EXPECT_EQ(lockstep.answers()[2].action.speed_fraction, 0.5);
  EXPECT_EQ(lockstep.missedCount(), 0U);
  EXPECT_EQ(lockstep.droppedCount(), 0U);
}

TEST(Lockstep, NobodyAskedIsCompleteAndNotDeserted) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {});
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 0U);
}

TEST(Lockstep, EachTickBeginsWithoutAnswers) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  lockstep.open(EPISODE, 1, {1});
  EXPECT_TRUE(lockstep.answers().empty());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  EXPECT_FALSE(lockstep.isComplete());
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

TEST(LockstepDrops, SecondAnswersAndTheFirstHolds) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  lockstep.take(answersOf(0, {0}), LEARNER);
  lockstep.take(answersOf(0, {0}, {2.0, 0.0}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  ASSERT_EQ(lockstep.answers().size(), 1U);
  EXPECT_EQ(lockstep.answers()[0].action.rotation, 0.5);
  EXPECT_FALSE(lockstep.isComplete());  // the second answer does not stand for agent 1
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepDrops, UnknownAgents) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0});
  lockstep.take(answersOf(1, {1, 7, UINT32_MAX}), LEARNER);  // not asked any more, never asked, never asked
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
  lockstep.take(answersOf(0, {0}, {-100.0, 0.0}), LEARNER);  // the next valid one is as good as ever
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(lockstep.droppedCount(), invalid.size());
}

TEST(LockstepPresence, AbsentAfterSomeMissesInARow) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  for (std::uint64_t tick = 1; tick <= 3; ++tick) {
    lockstep.open(EPISODE, tick, {0, 1});
    lockstep.take(answersOf(tick, {0}), LEARNER);
    EXPECT_FALSE(lockstep.isComplete()) << "tick " << tick;
    lockstep.close();
    EXPECT_EQ(lockstep.missedCount(), tick);
  }
  lockstep.open(EPISODE, 4, {0, 1});
  EXPECT_FALSE(lockstep.isComplete());
  lockstep.take(answersOf(4, {0}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());  // agent 1 is not waited for
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 4U);  // but counted
}

TEST(LockstepPresence, NamesAgentsOnceWhenTheyBecomeAbsent) {
  Lockstep lockstep(2);
  const auto agents_absent_after = [&](std::uint64_t tick, const Ids& answering) {
    lockstep.open(EPISODE, tick, {0, 1, 2});
    lockstep.take(answersOf(tick, answering), LEARNER);
    return lockstep.close();
  };
  EXPECT_EQ(agents_absent_after(0, {0}), Ids{});
  EXPECT_EQ(agents_absent_after(1, {0, 2}), Ids{1});
  EXPECT_EQ(agents_absent_after(2, {0}), Ids{});
  EXPECT_EQ(agents_absent_after(3, {0}), Ids{2});
  lockstep.open(EPISODE, 4, {0, 5});
  EXPECT_EQ(lockstep.giveUpOnNewcomers({0, 5, 6}), (Ids{5, 6}));
  EXPECT_EQ(lockstep.giveUpOnNewcomers({0, 5, 6}), Ids{});
}

TEST(LockstepPresence, AnAnswerInBetweenStartsTheCountAnew) {
  Lockstep lockstep(2);
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    lockstep.open(EPISODE, tick, {0});
    EXPECT_FALSE(lockstep.isComplete()) << "tick " << tick;  // waited for: never two misses in a row
    if (tick % 2 == 0) lockstep.take(answersOf(tick, {0}), LEARNER);
    lockstep.close();
  }
  EXPECT_EQ(lockstep.missedCount(), 5U);
}

TEST(LockstepPresence, AbsentOneComesBackWithAnAnswer) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {1}), LEARNER);
  EXPECT_FALSE(lockstep.isComplete());  // agent 0 is waited for as before
  EXPECT_EQ(agentsOf(lockstep.answers()), Ids{1});
  lockstep.take(answersOf(1, {0}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  lockstep.close();
  lockstep.open(EPISODE, 2, {0, 1});
  lockstep.take(answersOf(2, {0}), LEARNER);
  EXPECT_FALSE(lockstep.isComplete());  // agent 1 is waited for again
}

TEST(LockstepPresence, LateAnswerShowsPresence) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {0}), LEARNER);
  ASSERT_TRUE(lockstep.isComplete());
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_FALSE(lockstep.isComplete());  // it is there: wait for its answer to this tick
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.take(answersOf(1, {1}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, LateAnswersBetweenTicksShowPresenceToo) {
  Lockstep lockstep(2);
  playTick(lockstep, 0, {0}, {0});
  for (std::uint64_t tick = 1; tick < 6; ++tick) {
    playTick(lockstep, tick, {0}, {});
    lockstep.take(answersOf(tick, {0}), LEARNER);
  }
  lockstep.open(EPISODE, 6, {0});
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_EQ(lockstep.missedCount(), 5U);
  EXPECT_EQ(lockstep.droppedCount(), 5U);
}

TEST(LockstepPresence, DesertedWhenEverybodyIsAbsent) {
  Lockstep lockstep(2);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  playTick(lockstep, 1, {0, 1}, {1});
  playTick(lockstep, 2, {0, 1}, {});
  lockstep.open(EPISODE, 3, {0, 1});
  EXPECT_FALSE(lockstep.isDeserted());  // agent 1 missed once only
  lockstep.close();
  lockstep.open(EPISODE, 4, {0, 1});
  EXPECT_TRUE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
  lockstep.take(answersOf(4, {1}), LEARNER);
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, IsKeptFromEpisodeToEpisode) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE + 1, 0, {0, 1});
  lockstep.take(answersOf(0, {0}, {0.0, 0.0}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);  // an answer to the old episode
  lockstep.take(answersOf(0, {0}, MOVE, EPISODE + 1), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());  // agent 1 is still absent
}

TEST(LockstepNewcomers, AreAwaitedUntilTheirFirstAnswer) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_TRUE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(0, {0}), LEARNER);
  EXPECT_TRUE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  lockstep.close();
  lockstep.open(EPISODE, 1, {0, 1});
  EXPECT_FALSE(lockstep.awaitsNewcomer());  // both are known now
  lockstep.close();
  lockstep.open(EPISODE, 2, {0, 1, 2});
  EXPECT_TRUE(lockstep.awaitsNewcomer());
}

TEST(LockstepNewcomers, AreAbsentOnceGivenUp) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  lockstep.open(EPISODE, 1, {0, 1, 2, 3});
  lockstep.take(answersOf(1, {0}), LEARNER);
  lockstep.giveUpOnNewcomers({0, 1, 2, 3});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  EXPECT_FALSE(lockstep.isComplete());  // agent 1 is known and awaited
  lockstep.take(answersOf(1, {1}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(lockstep.missing(), (Ids{2, 3}));
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 2U);
  lockstep.open(EPISODE, 2, {0, 1, 2, 3});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(2, {3}), LEARNER);  // it comes after all
  lockstep.take(answersOf(2, {0, 1}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(agentsOf(lockstep.answers()), (Ids{3, 0, 1}));
}

TEST(LockstepNewcomers, GivingUpOnAllOfThemLeavesADesert) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_FALSE(lockstep.isDeserted());
  lockstep.giveUpOnNewcomers({0, 1});
  EXPECT_TRUE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepCounts, BeginAnewOnReset) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0, 7});
  EXPECT_EQ(lockstep.missedCount(), 1U);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  lockstep.resetCounts();
  EXPECT_EQ(lockstep.missedCount(), 0U);
  EXPECT_EQ(lockstep.droppedCount(), 0U);
  playTick(lockstep, 1, {0, 1}, {1, 7, 8});
  EXPECT_EQ(lockstep.missedCount(), 1U);
  EXPECT_EQ(lockstep.droppedCount(), 2U);
}

// Repeated answers: perceptions may be sent again to a learner that has answered, and its answer be sent again as well.

TEST(LockstepRepetitions, AreIgnoredWhileTheTickIsOpenAndAfterIt) {
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
  lockstep.open(EPISODE + 1, 0, {0, 1});  // a reset came between
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

TEST(LockstepRefusals, NameBothLearnersAlsoWhenTheOtherAnswersLater) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0}, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(0, {0}), OTHER)), std::vector<Refusal>{Refusal::OTHER_LEARNER});
  playTick(lockstep, 1, {0}, {0});
  lockstep.open(EPISODE, 2, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(0, {0}), OTHER)), std::vector<Refusal>{Refusal::OTHER_LEARNER});
}

TEST(LockstepRefusals, ALearnerMayTakeOverFromOneThatHasStopped) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0}, {0});
  playTick(lockstep, 1, {0}, {});
  lockstep.open(EPISODE, 2, {0});
  EXPECT_EQ(causesOf(lockstep.take(answersOf(1, {0}), OTHER)), std::vector<Refusal>{Refusal::TOO_LATE});
  EXPECT_TRUE(lockstep.take(answersOf(2, {0}), OTHER).empty());
  EXPECT_TRUE(lockstep.isComplete());
}

// Sequential scenarios: a tick is opened for one agent after the other.

TEST(LockstepTurns, GivingUpOnNewcomersCountsForTheirTurnsToCome) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0});
  lockstep.giveUpOnNewcomers({0, 1, 2});
  EXPECT_TRUE(lockstep.areAbsent({0, 1, 2}));
  lockstep.close();
  lockstep.open(EPISODE, 0, {1});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepTurns, AnAnswerAfterTheTurnShowsThatALearnerIsThere) {
  Lockstep lockstep(1);
  lockstep.open(EPISODE, 0, {0});
  lockstep.close();
  EXPECT_TRUE(lockstep.areAbsent({0}));
  lockstep.open(EPISODE, 0, {1});
  lockstep.take(answersOf(0, {0}), LEARNER);  // too late for its turn
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_FALSE(lockstep.areAbsent({0}));
  EXPECT_FALSE(lockstep.areAbsent({0, 1}));
  lockstep.close();
  lockstep.open(EPISODE, 1, {0});
  EXPECT_FALSE(lockstep.isComplete());  // it is waited for again
}

}  // namespace
}  // namespace crowd
