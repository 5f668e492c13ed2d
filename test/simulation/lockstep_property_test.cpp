#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "common/random.h"
#include "simulation/lockstep.h"
#include "support/answers.h"

namespace crowd::lockstep_property_test {
namespace {

using answers::agentsOf;
using answers::answersOf;
using answers::Ids;

/// Plays random ticks, and computes the expected state of each agent independently.
class RandomPlay {
  using Taken = std::tuple<LearnerId, std::uint64_t, std::uint64_t>;  // learner, episode, tick

 public:
  explicit RandomPlay(std::uint64_t seed)
      : random_(seed, KeyedRandom::EXPLORATION, {}),
        patience_(1 + static_cast<int>(random_.below(4))),
        lockstep_(patience_) {}

  void playTick() {
    if (random_.below(10) == 0) ++episode_;
    ++tick_;
    askSomeAgents();
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
  void askSomeAgents() {
    asked_.clear();
    for (AgentId id = 0; id < 6; ++id) {
      if (random_.below(4) > 0) asked_.push_back(id);
    }
    for (const AgentId id : asked_) known_[id] = true;
    answered_.clear();
    lockstep_.open(episode_, tick_, asked_);
  }

  void answer(std::uint64_t tick, bool open) {
    const AgentId id = random_.below(8);
    const bool valid = random_.below(6) > 0;
    const LearnerId learner = random_.below(2);
    const std::size_t refused =
        lockstep_.take(answersOf(tick, {id}, {0.0, valid ? 1.0 : 2.0}, episode_), learner).size();
    refused_ += refused;
    if (!known_[id] || !valid) {
      EXPECT_EQ(refused, 1U);
      return;
    }
    heard_[id] = true;
    misses_[id] = 0;
    given_up_[id] = false;
    const Taken now{learner, episode_, tick};
    if (open && isAsked(id) && tick == tick_ && !answered(id)) {
      answered_.push_back(id);
      last_[id] = now;
      EXPECT_EQ(refused, 0U);
    } else {
      const bool is_repeated = last_.count(id) > 0 && last_[id] == now;
      EXPECT_EQ(refused, is_repeated ? 0U : 1U);
    }
  }

  void giveUp() {
    lockstep_.giveUpOnNewcomers(asked_);
    for (const AgentId id : asked_) {
      if (!heard_[id]) given_up_[id] = true;
    }
  }

  bool isAsked(AgentId id) const { return std::count(asked_.begin(), asked_.end(), id) > 0; }
  bool answered(AgentId id) const { return std::count(answered_.begin(), answered_.end(), id) > 0; }
  bool isPresent(AgentId id) { return !given_up_[id] && misses_[id] < patience_; }

  void check() {
    Ids missing;
    bool any_present = false;
    bool awaited = false;
    bool newcomer = false;
    for (const AgentId id : asked_) {
      any_present = any_present || isPresent(id);
      if (answered(id)) continue;
      missing.push_back(id);
      awaited = awaited || isPresent(id);
      newcomer = newcomer || (isPresent(id) && !heard_[id]);
    }
    EXPECT_EQ(agentsOf(lockstep_.answers()), answered_);
    EXPECT_EQ(lockstep_.missing(), missing);
    EXPECT_EQ(lockstep_.isComplete(), !awaited);
    EXPECT_EQ(lockstep_.isDeserted(), !asked_.empty() && !any_present);
    EXPECT_EQ(lockstep_.awaitsNewcomer(), newcomer);
    EXPECT_EQ(lockstep_.droppedCount(), refused_);
  }

  KeyedRandom random_;
  int patience_;
  Lockstep lockstep_;
  std::uint64_t episode_ = 0;
  std::uint64_t tick_ = 0;
  Ids asked_;
  Ids answered_;
  std::map<AgentId, bool> known_;  // has been asked
  std::map<AgentId, bool> heard_;
  std::map<AgentId, bool> given_up_;
  std::map<AgentId, int> misses_;  // consecutive
  std::uint64_t missed_ = 0;
  std::map<AgentId, Taken> last_;  // answer that was taken
  std::uint64_t refused_ = 0;
};

TEST(LockstepProperty, AgreesWithAReferenceForRandomAnswers) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomPlay play(seed);
    for (int tick = 0; tick < 40 && !HasFailure(); ++tick) play.playTick();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace crowd::lockstep_property_test
