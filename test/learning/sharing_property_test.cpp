// Any sequence of learning, replacing, merging, saving and loading ends with each experience counted once.

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <set>

#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "support/learners.h"

namespace crowd::sharing_property_test {
namespace {

using learners::decide;
using learners::goalIn;
using learners::model;
using learners::options;

/// The experiences that a table was learned from, by row and action.
using Experiences = std::map<std::pair<Row, Action>, std::set<std::uint64_t>>;

std::uint64_t countOf(const Experiences& experiences) {
  std::uint64_t count = 0;
  for (const auto& [place, numbers] : experiences) count += numbers.size();
  return count;
}

/// Learners that teach each other, and for each of their tables what it should know.
class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed, KeyedRandom::PLACEMENT, {}) {
    for (const TableUse use : {TableUse::SHARED, TableUse::OWN, TableUse::SHARED, TableUse::OWN}) {
      Learner::Options exploring = options(Mode::TRAINING, use);
      exploring.seed = random_.next();
      exploring.plan.epsilon = EpsilonSchedule::constant(1.0);
      learners_.emplace_back(model(), exploring);
    }
    known_.resize(learners_.size() * AGENTS);
    for (std::size_t i = 0; i < learners_.size(); ++i) walk(i);  // so that all agents are known
  }

  void doAnything() {
    const std::uint32_t what = random_.below(10);
    const std::size_t from = random_.below(learners_.size());
    if (what < 4) return walk(from);
    const auto agent = random_.below(AGENTS);
    if (what < 7) return give(learners_[from].tables().toShare(agent), *known(from, agent));
    if (what < 9 || files_.empty()) {
      return files_.push_back({toText(trained(learners_[from].tables().toSave(agent))), *known(from, agent)});
    }
    const File& file = files_[random_.below(files_.size())];
    give(parseQTable(file.text, "file").table, file.known);
  }

  void check() {
    for (std::size_t i = 0; i < learners_.size(); ++i) {
      for (AgentId agent = 0; agent < AGENTS; ++agent) check(learners_[i].tables().of(agent), *known(i, agent));
    }
  }

 private:
  static constexpr AgentId AGENTS = 3;
  struct File {
    std::string text;
    Experiences known;
  };

  static TrainedTable trained(QTable table) { return {model(), {}, 0, 0, std::move(table)}; }

  bool shares(std::size_t learner) const { return learners_[learner].tables().use() == TableUse::SHARED; }
  Experiences* known(std::size_t learner, AgentId agent) {
    return &known_[learner * AGENTS + (shares(learner) ? 0 : agent)];
  }

  static void check(const QTable& table, const Experiences& known) {
    ASSERT_EQ(table.allVisits(), countOf(known));
    for (const auto& [place, numbers] : known) ASSERT_EQ(table.visits(place.first, place.second), numbers.size());
  }

  /// A few decisions of all its agents; what they add to a table is new experience.
  void walk(std::size_t learner) {
    std::vector<QTable> before;
    for (AgentId agent = 0; agent < AGENTS; ++agent) before.push_back(learners_[learner].tables().of(agent));
    const std::uint64_t ticks = 2 + random_.below(4);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
      PerceptionsBuilder perceptions(episode_, tick);
      for (AgentId agent = 0; agent < AGENTS; ++agent) {
        perceptions.agent(agent, goalIn(random_.below(4), random_.uniform(1.0, 9.0)));
      }
      decide(learners_[learner], perceptions);
    }
    ++episode_;
    for (AgentId agent = 0; agent < (shares(learner) ? 1 : AGENTS); ++agent) {
      noteLearned(before[agent], learners_[learner].tables().of(agent), *known(learner, agent));
    }
  }

  void noteLearned(const QTable& before, const QTable& after, Experiences& known) {
    for (Row row = 0; row < after.rows(); ++row) {
      for (Action action = 0; action < after.actions(); ++action) {
        for (std::uint32_t i = before.visits(row, action); i < after.visits(row, action); ++i) {
          known[{row, action}].insert(experiences_++);
        }
      }
    }
  }

  /// Gives a table to a random agent, or to all agents of a random learner.
  void give(const QTable& table, const Experiences& given) {
    const std::size_t to = random_.below(learners_.size());
    const TakeMethod method = random_.below(3) == 0 ? TakeMethod::REPLACE : TakeMethod::MERGE;
    if (random_.below(3) == 0) {
      learners_[to].tables().take(table, method);
      for (AgentId agent = 0; agent < AGENTS; ++agent) teach(*known(to, agent), given, method);
    } else {
      const AgentId agent = random_.below(AGENTS);
      const QTable old = learners_[to].tables().of(agent);
      const AgentTables::Taken taken = learners_[to].tables().take(agent, table, method);
      if (method == TakeMethod::MERGE)
        checkValues(old, *known(to, agent), table, given, learners_[to].tables().of(agent));
      const std::uint64_t news = teach(*known(to, agent), given, method);
      EXPECT_EQ(taken.new_visits, news);
      EXPECT_EQ(taken.visits, countOf(*known(to, agent)));
      const QTable before = learners_[to].tables().of(agent);
      EXPECT_EQ(learners_[to].tables().take(agent, table, TakeMethod::MERGE).new_visits, 0U);
      EXPECT_EQ(learners_[to].tables().of(agent), before);
    }
  }

  /// Values are means, weighted by the visits that only one of both tables has.
  static void checkValues(const QTable& mine, const Experiences& my_known, const QTable& theirs,
                          const Experiences& their_known, const QTable& merged) {
    Experiences all = my_known;
    all.insert(their_known.begin(), their_known.end());
    for (const auto& [place, unused] : all) {
      const auto [row, action] = place;
      const double only_mine = countOnlyIn(my_known, their_known, place);
      const double only_theirs = countOnlyIn(their_known, my_known, place);
      const double sum = only_mine * mine.value(row, action) + only_theirs * theirs.value(row, action);
      const double expected = only_theirs > 0.0 ? sum / (only_mine + only_theirs) : mine.value(row, action);
      EXPECT_NEAR(merged.value(row, action), expected, 1e-12);
    }
  }

  static double countOnlyIn(const Experiences& one, const Experiences& other, const std::pair<Row, Action>& place) {
    const auto found = one.find(place);
    if (found == one.end()) return 0.0;
    const auto excluded = other.find(place);
    double count = 0.0;
    for (const std::uint64_t number : found->second) {
      count += excluded == other.end() || excluded->second.count(number) == 0 ? 1.0 : 0.0;
    }
    return count;
  }

  /// Returns how many were new.
  static std::uint64_t teach(Experiences& known, const Experiences& given, TakeMethod method) {
    Experiences both = known;
    for (const auto& [place, numbers] : given) both[place].insert(numbers.begin(), numbers.end());
    const std::uint64_t news = countOf(both) - countOf(known);
    known = method == TakeMethod::MERGE ? both : given;
    return news;
  }

  KeyedRandom random_;
  std::deque<Learner> learners_;
  std::vector<Experiences> known_;
  std::vector<File> files_;
  std::uint64_t experiences_ = 0;
  std::uint64_t episode_ = 0;
};

TEST(SharingProperty, EachExperienceCountsOnce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Crowd crowd(seed);
    for (int step = 0; step < 60; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      crowd.doAnything();
      crowd.check();
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace crowd::sharing_property_test
