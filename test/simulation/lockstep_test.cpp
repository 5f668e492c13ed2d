#include "social_crowd/simulation/lockstep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "support/scenes.h"

namespace crowd {
namespace {

using Ids = std::vector<AgentId>;

constexpr std::uint64_t EPISODE = 5;
constexpr RelativeAction MOVE{0.5, 1.0};

RelativeActions answersOf(std::uint64_t tick, const Ids& agents, const RelativeAction& action = MOVE,
                          std::uint64_t episode = EPISODE) {
  RelativeActions answers;
  answers.episode = episode;
  answers.tick = tick;
  for (const AgentId agent : agents) answers.agents.push_back({agent, action});
  return answers;
}

Ids agentsOf(const std::vector<AgentAction>& answers) {
  Ids agents;
  for (const AgentAction& answer : answers) agents.push_back(answer.agent);
  return agents;
}

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
  lockstep.giveUpOnNewcomers();
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
  lockstep.giveUpOnNewcomers();
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

/// Plays at random and keeps the books by hand: what an agent did since it was last heard of.
class RandomPlay {
 public:
  explicit RandomPlay(std::uint64_t seed)
      : random_(seed, KeyedRandom::EXPLORATION, {}),
        patience_(1 + static_cast<int>(random_.below(4))),
        lockstep_(patience_) {}

  void playTick() {
    if (random_.below(10) == 0) ++episode_;
    ++tick_;
    askSomebody();
    check();
    for (std::uint32_t i = random_.below(15); i > 0; --i) {
      if (random_.below(12) == 0) {
        giveUp();
      } else {
        answer(tick_ - (random_.below(5) == 0 ? 1 : 0), true);
      }
      check();
    }
    lockstep_.close();
    for (const AgentId id : asked_) {
      if (answered(id)) continue;
      ++missed_;
      ++misses_[id];
    }
    EXPECT_EQ(lockstep_.missedCount(), missed_);
    if (random_.below(3) == 0) answer(tick_, false);
  }

 private:
  void askSomebody() {
    asked_.clear();
    for (AgentId id = 0; id < 6; ++id) {
      if (random_.below(4) > 0) asked_.push_back(id);
    }
    answered_.clear();
    counted_answers_ = 0;
    lockstep_.open(episode_, tick_, asked_);
  }

  void answer(std::uint64_t tick, bool open) {
    const AgentId id = random_.below(8);
    const bool sound = random_.below(6) > 0;
    lockstep_.take(answersOf(tick, {id}, {0.0, sound ? 1.0 : 2.0}, episode_));
    ++given_;
    if (!isAsked(id) || !sound) return;
    heard_[id] = true;
    misses_[id] = 0;
    given_up_[id] = false;
    if (open && tick == tick_ && !answered(id)) answered_.push_back(id);
  }

  void giveUp() {
    lockstep_.giveUpOnNewcomers();
    for (const AgentId id : asked_) {
      if (!heard_[id]) given_up_[id] = true;
    }
  }

  bool isAsked(AgentId id) const { return std::count(asked_.begin(), asked_.end(), id) > 0; }
  bool answered(AgentId id) const { return std::count(answered_.begin(), answered_.end(), id) > 0; }
  bool isPresent(AgentId id) { return !given_up_[id] && misses_[id] < patience_; }

  void check() {
    Ids missing;
    bool somebody_present = false;
    bool awaited = false;
    bool newcomer = false;
    for (const AgentId id : asked_) {
      somebody_present = somebody_present || isPresent(id);
      if (answered(id)) continue;
      missing.push_back(id);
      awaited = awaited || isPresent(id);
      newcomer = newcomer || (isPresent(id) && !heard_[id]);
    }
    EXPECT_EQ(agentsOf(lockstep_.answers()), answered_);
    EXPECT_EQ(lockstep_.missing(), missing);
    EXPECT_EQ(lockstep_.isComplete(), !awaited);
    EXPECT_EQ(lockstep_.isDeserted(), !asked_.empty() && !somebody_present);
    EXPECT_EQ(lockstep_.awaitsNewcomer(), newcomer);
    taken_ += answered_.size() - counted_answers_;  // since the last check
    counted_answers_ = answered_.size();
    EXPECT_EQ(lockstep_.droppedCount() + taken_, given_);  // each answer is taken or dropped
  }

  KeyedRandom random_;
  int patience_;
  Lockstep lockstep_;
  std::uint64_t episode_ = 0;
  std::uint64_t tick_ = 0;
  Ids asked_;
  Ids answered_;
  std::map<AgentId, bool> heard_;
  std::map<AgentId, bool> given_up_;
  std::map<AgentId, int> misses_;  // in a row
  std::uint64_t missed_ = 0;
  std::uint64_t given_ = 0;
  std::uint64_t taken_ = 0;
  std::size_t counted_answers_ = 0;
};

TEST(LockstepProperty, BooksAreRightWhateverTheAnswers) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomPlay play(seed);
    for (int tick = 0; tick < 40 && !HasFailure(); ++tick) play.playTick();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace crowd
