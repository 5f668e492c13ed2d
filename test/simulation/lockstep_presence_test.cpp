#include "simulation/lockstep.h"

#include <gtest/gtest.h>

#include "support/answers.h"

namespace crowd::lockstep_presence_test {
namespace {

using answers::agentsOf;
using answers::answersOf;
using answers::EPISODE;
using answers::Ids;
using answers::LEARNER;
using answers::MOVE;
using answers::playTick;

TEST(LockstepPresence, AgentIsAbsentAfterConsecutiveMisses) {
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
  EXPECT_TRUE(lockstep.isComplete());  // agent 1 is not awaited
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.close();
  EXPECT_EQ(lockstep.missedCount(), 4U);  // still counted
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

TEST(LockstepPresence, AnAnswerResetsTheCountOfMisses) {
  Lockstep lockstep(2);
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    lockstep.open(EPISODE, tick, {0});
    EXPECT_FALSE(lockstep.isComplete()) << "tick " << tick;  // awaited: never two consecutive misses
    if (tick % 2 == 0) lockstep.take(answersOf(tick, {0}), LEARNER);
    lockstep.close();
  }
  EXPECT_EQ(lockstep.missedCount(), 5U);
}

TEST(LockstepPresence, AnAnswerEndsTheAbsence) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {1}), LEARNER);
  EXPECT_FALSE(lockstep.isComplete());  // agent 0 is awaited as before
  EXPECT_EQ(agentsOf(lockstep.answers()), Ids{1});
  lockstep.take(answersOf(1, {0}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  lockstep.close();
  lockstep.open(EPISODE, 2, {0, 1});
  lockstep.take(answersOf(2, {0}), LEARNER);
  EXPECT_FALSE(lockstep.isComplete());  // agent 1 is awaited again
}

TEST(LockstepPresence, ALateAnswerEndsTheAbsence) {
  Lockstep lockstep(1);
  playTick(lockstep, 0, {0, 1}, {0});
  lockstep.open(EPISODE, 1, {0, 1});
  lockstep.take(answersOf(1, {0}), LEARNER);
  ASSERT_TRUE(lockstep.isComplete());
  lockstep.take(answersOf(0, {1}), LEARNER);
  EXPECT_EQ(lockstep.droppedCount(), 1U);
  EXPECT_FALSE(lockstep.isComplete());  // its answer to this tick is awaited
  EXPECT_EQ(lockstep.missing(), Ids{1});
  lockstep.take(answersOf(1, {1}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, LateAnswersBetweenTicksPreventAbsence) {
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

TEST(LockstepPresence, IsDesertedWhenAllAgentsAreAbsent) {
  Lockstep lockstep(2);
  playTick(lockstep, 0, {0, 1}, {0, 1});
  playTick(lockstep, 1, {0, 1}, {1});
  playTick(lockstep, 2, {0, 1}, {});
  lockstep.open(EPISODE, 3, {0, 1});
  EXPECT_FALSE(lockstep.isDeserted());  // agent 1 missed only once
  lockstep.close();
  lockstep.open(EPISODE, 4, {0, 1});
  EXPECT_TRUE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
  lockstep.take(answersOf(4, {1}), LEARNER);
  EXPECT_FALSE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepPresence, IsKeptAcrossEpisodes) {
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

TEST(LockstepNewcomers, AreAbsentAfterGivingUp) {
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
  lockstep.take(answersOf(2, {3}), LEARNER);  // a late answer
  lockstep.take(answersOf(2, {0, 1}), LEARNER);
  EXPECT_TRUE(lockstep.isComplete());
  EXPECT_EQ(agentsOf(lockstep.answers()), (Ids{3, 0, 1}));
}

TEST(LockstepNewcomers, GivingUpOnAllAgentsIsDeserted) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0, 1});
  EXPECT_FALSE(lockstep.isDeserted());
  lockstep.giveUpOnNewcomers({0, 1});
  EXPECT_TRUE(lockstep.isDeserted());
  EXPECT_TRUE(lockstep.isComplete());
}

// Sequential scenarios: a tick is opened for one agent after the other.
TEST(LockstepTurns, GivingUpOnNewcomersAppliesToTheirNextTurns) {
  Lockstep lockstep(3);
  lockstep.open(EPISODE, 0, {0});
  lockstep.giveUpOnNewcomers({0, 1, 2});
  EXPECT_TRUE(lockstep.areAbsent({0, 1, 2}));
  lockstep.close();
  lockstep.open(EPISODE, 0, {1});
  EXPECT_FALSE(lockstep.awaitsNewcomer());
  EXPECT_TRUE(lockstep.isComplete());
}

TEST(LockstepTurns, AnAnswerAfterTheTurnEndsTheAbsence) {
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
  EXPECT_FALSE(lockstep.isComplete());  // it is awaited again
}

/// 3 agents enter each tick, and stay for 10 ticks: late answers are still recognised, and absent agents stay absent.
TEST(LockstepPresence, AgentsThatHaveLeftDoNotMatter) {
  Lockstep lockstep(2);
  AgentId entered = 1;  // agent 0 stays and never answers
  std::vector<AgentId> present = {0};
  for (std::uint64_t tick = 0; tick < 3000; ++tick) {
    for (int i = 0; i < 3; ++i) present.push_back(entered++);
    if (present.size() > 31) present.erase(present.begin() + 1, present.begin() + 4);
    lockstep.open(EPISODE, tick, present);
    EXPECT_EQ(lockstep.areAbsent({0}), tick >= 2) << "tick " << tick;
    std::vector<AgentId> answering(present.begin() + 1, present.end());
    EXPECT_TRUE(lockstep.take(answersOf(tick, answering), LEARNER).empty());
    EXPECT_TRUE(lockstep.isComplete() || tick < 2);
    EXPECT_EQ(lockstep.missing(), Ids{0});
    lockstep.close();
    EXPECT_LE(lockstep.knownCount(), 1100U);
    if (tick < 10) continue;
    const auto gone = static_cast<AgentId>(present[1] - 1);
    const std::vector<RefusedAnswer>& refused = lockstep.take(answersOf(tick - 2, {gone}), LEARNER);
    ASSERT_EQ(refused.size(), 1U) << "tick " << tick;
    EXPECT_EQ(refused.front().cause, Refusal::TOO_LATE);
  }
}

}  // namespace
}  // namespace crowd::lockstep_presence_test
