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

/// Opens a tick, takes the answers of some and closes it.
void playTick(Lockstep& lockstep, std::uint64_t tick, const Ids& asked, const Ids& answering) {
  lockstep.open(EPISODE, tick, asked);
  lockstep.take(answersOf(tick, answering));
  lockstep.close();
}

TEST(Lockstep, CompleteOnceEverybodyHasAnswered) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1, 2});
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1, 2}));
  lockstep.take(answersOf(0, {2, 0}));
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.take(answersOf(0, {1}, {-0.25, 0.5}));
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_TRUE(lockstep.missing().empty());
  lockstep.close();
  ASSERT_EQ(agentsOf(lockstep.answers()), (Ids{2, 0, 1}));
  EXPECT_EQ(lockstep.answers()[0].action.rotation, 0.5);
  EXPECT_EQ(lockstep.answers()[2].action.rotation, -0.25);
  EXPECT_EQ(lockstep.answers()[2].action.speed_share, 0.5);
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
  lockstep.take(answersOf(3, {0}));
  lockstep.take(answersOf(5, {0}));
  lockstep.take(answersOf(4, {0, 1}, MOVE, EPISODE - 1));
  EXPECT_EQ(lockstep.droppedCount(), 4U);
  EXPECT_EQ(lockstep.missing(), (Ids{0, 1}));
  EXPECT_TRUE(lockstep.answers().empty());
}

TEST(LockstepDrops, AnswersWhileNoTickIsOpen) {
  Lockstep lockstep(3);
  lockstep.take(answersOf(0, {0}));
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.take(answersOf(0, {1}));
  EXPECT_EQ(lockstep.droppedCount(), 2U);
  EXPECT_EQ(agentsOf(lockstep.answers()), Ids{0});
}

TEST(LockstepDrops, SecondAnswersAndTheFirstHolds) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  lockstep.take(answersOf(0, {0}));
  lockstep.take(answersOf(0, {0}, {2.0, 0.0}));
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  ASSERT_EQ(lockstep.answers().size(), 1U);
  EXPECT_EQ(lockstep.answers()[0].action.rotation, 0.5);
  EXPECT_FALSE(lockstep.isComplete());  // the second answer does not stand for agent 1
  lockstep.take(answersOf(0, {1, 1}));
  EXPECT_EQ(lockstep.droppedCount(), 2U);
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepDrops, UnknownAgents) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0});
  lockstep.take(answersOf(1, {1, 7, UINT32_MAX}));  // not asked any more, never asked, never asked
  EXPECT_EQ(lockstep.droppedCount(), 3U);
  EXPECT_FALSE(lockstep.isComplete());
  EXPECT_TRUE(lockstep.answers().empty());
}

TEST(LockstepDrops, UnsoundAnswers) {
  constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const std::vector<RelativeAction> unsound = {{NOT_A_NUMBER, 1.0}, {-INFINITE, 1.0}, {0.0, NOT_A_NUMBER},
                                               {0.0, INFINITE},     {0.0, -0.01},     {0.0, 1.01}};
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0});
  for (const RelativeAction& action : unsound) lockstep.take(answersOf(0, {0}, action));
  EXPECT_EQ(lockstep.droppedCount(), unsound.size());
  EXPECT_EQ(lockstep.missing(), Ids{0});
  lockstep.take(answersOf(0, {0}, {-100.0, 0.0}));  // the next sound one is as good as ever
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(lockstep.droppedCount(), unsound.size());
}

TEST(LockstepPresence, AbsentAfterSomeMissesInARow) {
  Lockstep lockstep(3);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  for (std::uint64_t tick = 1; tick <= 3; ++tick) {
    lockstep.open(EPISODE, tick, {0, 1});
    lockstep.take(answersOf(tick, {0}));
    EXPECT_FALSE(lockstep.isComplete()) << "tick " << tick;
    lockstep.close();
    EXPECT_EQ(lockstep.missedCount(), tick);
  }
  lockstep.open(EPISODE, 4, {0, 1});
  EXPECT_FALSE(lockstep.isComplete());
  lockstep.take(answersOf(4, {0}));
  EXPECT_TRUE(lockstep.isComplete());  // agent 1 is not waited for
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 4U);  // but counted
}

TEST(LockstepPresence, AnAnswerInBetweenStartsTheCountAnew) {
  Lockstep lockstep(2);
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    lockstep.open(EPISODE, tick, {0});
    EXPECT_FALSE(lockstep.isComplete()) << "tick " << tick;  // waited for: never two misses in a row
    if (tick % 2 == 0) lockstep.take(answersOf(tick, {0}));
    lockstep.close();
  }
  EXPECT_EQ(lockstep.missedCount(), 5U);
}

TEST(LockstepPresence, AbsentOneComesBackWithAnAnswer) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {1}));
  EXPECT_FALSE(lockstep.isComplete());  // agent 0 is waited for as before
  EXPECT_EQ(agentsOf(lockstep.answers()), Ids{1});
  lockstep.take(answersOf(1, {0}));
  EXPECT_TRUE(lockstep.isComplete());
  lockstep.close();
  lockstep.open(EPISODE, 2, {0, 1});
  lockstep.take(answersOf(2, {0}));
  EXPECT_FALSE(lockstep.isComplete());  // agent 1 is waited for again
}

TEST(LockstepPresence, LateAnswerShowsPresence) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {0}));
  ASSERT_TRUE(lockstep.isComplete());
  lockstep.take(answersOf(0, {1}));
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_FALSE(lockstep.isComplete());  // it is there: wait for its answer to this tick
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.take(answersOf(1, {1}));
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, LateAnswersBetweenTicksShowPresenceToo) {
  Lockstep lockstep(2);
  playTick(lockstep, 0, {0}, {0});
  for (std::uint64_t tick = 1; tick < 6; ++tick) {
    playTick(lockstep, tick, {0}, {});
    lockstep.take(answersOf(tick, {0}));
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
  lockstep.take(answersOf(4, {1}));
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, IsKeptFromEpisodeToEpisode) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE + 1, 0, {0, 1});
  lockstep.take(answersOf(0, {0}));
  EXPECT_EQ(lockstep.droppedCount(), 1U);  // an answer to the old episode
  lockstep.take(answersOf(0, {0}, MOVE, EPISODE + 1));
  EXPECT_TRUE(lockstep.isComplete());  // agent 1 is still absent
}

TEST(LockstepNewcomers, AreAwaitedUntilTheirFirstAnswer) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_TRUE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(0, {0}));
  EXPECT_TRUE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(0, {1}));
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
  lockstep.take(answersOf(1, {0}));
  lockstep.giveUpOnNewcomers({0, 1, 2, 3});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  EXPECT_FALSE(lockstep.isComplete());  // agent 1 is known and awaited
  lockstep.take(answersOf(1, {1}));
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(lockstep.missing(), (Ids{2, 3}));
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 2U);
  lockstep.open(EPISODE, 2, {0, 1, 2, 3});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  lockstep.take(answersOf(2, {3}));  // it comes after all
  lockstep.take(answersOf(2, {0, 1}));
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
  playTick(lockstep, 0, {0, 1}, {0, 0});
  EXPECT_EQ(lockstep.missedCount(), 1U);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  lockstep.resetCounts();
  EXPECT_EQ(lockstep.missedCount(), 0U);
  EXPECT_EQ(lockstep.droppedCount(), 0U);
  playTick(lockstep, 1, {0, 1}, {1, 1, 1});
  EXPECT_EQ(lockstep.missedCount(), 1U);
  EXPECT_EQ(lockstep.droppedCount(), 2U);
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
  lockstep.take(answersOf(0, {0}));  // too late for its turn
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_FALSE(lockstep.areAbsent({0}));
  EXPECT_FALSE(lockstep.areAbsent({0, 1}));
  lockstep.close();
  lockstep.open(EPISODE, 1, {0});
  EXPECT_FALSE(lockstep.isComplete());  // it is waited for again
}

}  // namespace
}  // namespace crowd
