#include "simulation/lockstep.h"

#include <gtest/gtest.h>

#include "support/answers.h"

namespace crowd::lockstep_test {
namespace {

using answers::agentsOf;
using answers::answersOf;
using answers::EPISODE;
using answers::Ids;
using answers::LEARNER;
using answers::playTick;

TEST(Lockstep, IsCompleteWhenAllAgentsHaveAnswered) {
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

TEST(Lockstep, IsCompleteAndNotDesertedWithoutAgents) {
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

TEST(LockstepCounts, ResetSetsThemToZero) {
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

}  // namespace
}  // namespace crowd::lockstep_test
