// Epsilon-greedy choices, and greedy decisions among equal values.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "learning/learner.h"
#include "learning/rl/policy.h"
#include "support/learners.h"

namespace crowd::ties_test {
namespace {

using learners::actionOf;
using learners::decide;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;

constexpr AgentId AGENTS = 30;
constexpr std::uint64_t TICKS = 300;

using Counts = std::array<int, 8>;

/// In row 0 the actions 1, 4 and 6 have the same value, the highest one.
QTable threeAlike() {
  QTable table = emptyTable();
  for (const Action action : {1U, 4U, 6U}) table.set(0, action, 2.0, 1);
  table.set(0, 7, 1.0, 1);
  return table;
}

Learner::Options breaking(Ties ties, Mode mode, std::uint64_t seed = 1) {
  Learner::Options made = options(mode);
  made.plan.parameters.ties = ties;
  made.seed = seed;
  return made;
}

/// All agents in row 0; nothing is learned, because no answer is carried out.
PerceptionsBuilder allAhead(std::uint64_t tick, std::uint64_t episode = 0) {
  PerceptionsBuilder scene(episode, tick);
  for (AgentId agent = 0; agent < AGENTS; ++agent) scene.agent(agent, goalIn(0, 4.0)).missed();
  return scene;
}

std::vector<Action> toActions(const std::vector<AgentAction>& answers) {
  std::vector<Action> actions;
  for (const AgentAction& answer : answers) actions.push_back(actionOf(answer));
  return actions;
}

/// The chosen actions by tick.
std::vector<Action> chosen(const Learner::Options& options, std::uint64_t episode = 0) {
  Learner learner(model(), options, threeAlike());
  std::vector<Action> all;
  for (std::uint64_t tick = 0; tick < TICKS; ++tick) {
    const std::vector<Action> now = toActions(decide(learner, allAhead(tick, episode)).agents);
    all.insert(all.end(), now.begin(), now.end());
  }
  return all;
}

/// The same with decideGreedily(), which keeps no state.
std::vector<Action> chosenGreedily(const Learner::Options& options, std::uint64_t episode = 0) {
  const Learner learner(model(), options, threeAlike());
  DecisionWorkspace workspace;
  std::vector<AgentAction> actions;
  for (std::uint64_t tick = 0; tick < TICKS; ++tick) {
    learner.decideGreedily(allAhead(tick, episode).all(), workspace, actions);
  }
  return toActions(actions);
}

Counts countOf(const std::vector<Action>& actions) {
  Counts counts{};
  for (const Action action : actions) ++counts.at(action);
  return counts;
}

TEST(Ties, AreBrokenByTheFirstActionByDefault) {
  EXPECT_EQ(LearningParameters().ties, Ties::FIRST);
  for (const Mode mode : {Mode::TRAINING, Mode::DEMO}) {
    const std::vector<Action> expected(AGENTS * TICKS, 1);
    EXPECT_EQ(chosen(breaking(Ties::FIRST, mode)), expected);
    EXPECT_EQ(chosenGreedily(breaking(Ties::FIRST, mode)), expected);
  }
}

TEST(Ties, RandomTiesSelectEqualActionsEquallyOften) {
  // Of 9000 decisions 3000 for each of the three. Five standard deviations of such a count are 224.
  for (const Mode mode : {Mode::TRAINING, Mode::DEMO}) {
    const Counts counts = countOf(chosen(breaking(Ties::RANDOM, mode)));
    for (Action action = 0; action < 8; ++action) {
      const bool best = action == 1 || action == 4 || action == 6;
      EXPECT_NEAR(counts.at(action), best ? 3000 : 0, best ? 224 : 0) << "action " << action;
    }
  }
}

TEST(Ties, AreEqualInTrainingModeDemoModeAndDecideGreedily) {
  for (const std::uint64_t episode : {0U, 9U}) {
    const std::vector<Action> actions = chosen(breaking(Ties::RANDOM, Mode::DEMO), episode);
    EXPECT_EQ(chosen(breaking(Ties::RANDOM, Mode::TRAINING), episode), actions);
    EXPECT_EQ(chosenGreedily(breaking(Ties::RANDOM, Mode::DEMO), episode), actions);
  }
}

TEST(Ties, ReportedChoicesAgreeWithTheAnswers) {
  const Learner::Options options = breaking(Ties::RANDOM, Mode::DEMO);
  const std::vector<Action> actions = chosen(options, 9);
  const Learner learner(model(), options, threeAlike());
  DecisionWorkspace workspace;
  for (std::uint64_t tick = 0; tick < 20; ++tick) {
    std::vector<AgentAction> answers;
    learner.decideGreedily(allAhead(tick, 9).all(), workspace, answers);
    ASSERT_EQ(workspace.choices.size(), AGENTS);
    for (AgentId agent = 0; agent < AGENTS; ++agent) {
      EXPECT_EQ(workspace.choices[agent].row, 0U);
      EXPECT_EQ(workspace.choices[agent].action, actions[tick * AGENTS + agent]) << "tick " << tick;
    }
  }
}

TEST(Ties, RandomTiesDependOnlyOnSeedEpisodeTickAndAgent) {
  const Learner::Options options = breaking(Ties::RANDOM, Mode::DEMO);
  const std::vector<Action> actions = chosen(options);
  EXPECT_EQ(chosen(options), actions);
  EXPECT_NE(chosen(breaking(Ties::RANDOM, Mode::DEMO, 2)), actions);
  EXPECT_NE(chosen(options, 1), actions);
  const std::vector<Action> first_tick(actions.begin(), actions.begin() + AGENTS);
  const std::vector<Action> next_tick(actions.begin() + AGENTS, actions.begin() + 2 * AGENTS);
  EXPECT_NE(first_tick, next_tick);
  EXPECT_NE(first_tick, std::vector<Action>(AGENTS, first_tick.front()));
  // One agent and one tick on their own.
  const Learner learner(model(), options, threeAlike());
  DecisionWorkspace workspace;
  std::vector<AgentAction> alone;
  learner.decideGreedily(PerceptionsBuilder(0, 1).agent(17, goalIn(0, 4.0)).all(), workspace, alone);
  EXPECT_EQ(toActions(alone), std::vector<Action>{next_tick[17]});
}

TEST(Ties, DoNotChangeDecisionsWithASingleBestAction) {
  Learner::Options exploring = breaking(Ties::FIRST, Mode::TRAINING);
  exploring.plan.epsilon = EpsilonSchedule::constant(0.5);
  Learner first(model(), exploring, learners::randomTable(1));
  exploring.plan.parameters.ties = Ties::RANDOM;
  Learner random(model(), exploring, learners::randomTable(1));
  for (std::uint64_t tick = 0; tick < 40; ++tick) {
    const PerceptionsBuilder scene = learners::randomTick(3, 0, tick, AGENTS);
    EXPECT_EQ(toActions(decide(first, scene).agents), toActions(decide(random, scene).agents)) << "tick " << tick;
  }
  EXPECT_TRUE(first.tables().of(0) == random.tables().of(0));
}

TEST(Ties, ExplorationUsesASeparateRandomNumber) {
  // Half of the decisions explore, evenly; the others go to the three: 9000 * (1/16 + 1/6) = 2062.5 for each of those,
  // 562.5 for each of the others. Five standard deviations are 200 and 116.
  Learner::Options exploring = breaking(Ties::RANDOM, Mode::TRAINING);
  exploring.plan.epsilon = EpsilonSchedule::constant(0.5);
  const Counts counts = countOf(chosen(exploring));
  for (Action action = 0; action < 8; ++action) {
    const bool best = action == 1 || action == 4 || action == 6;
    EXPECT_NEAR(counts.at(action), best ? 2062.5 : 562.5, best ? 200 : 116) << "action " << action;
  }
}

TEST(Ties, RandomTiesDoNotCutTraces) {
  // Whichever of the equal actions was taken in the second tick, it is greedy: what it earns reaches the first.
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Learner::Options tracing = breaking(Ties::RANDOM, Mode::TRAINING, seed);
    tracing.plan.parameters.lambda = 0.5;
    QTable table = threeAlike();
    table.set(1, 3, 2.0, 1);  // the only best action of row 1
    Learner learner(model(), tracing, table);
    EXPECT_EQ(learners::decideOne(learner, learners::tick(0, 1, 4.0)), 3U);
    const Action tied = learners::decideOne(learner, learners::tick(1, 0, 4.0));
    // Nothing was gained: 2 + 0.5 * (0 + 0.5 * 2 - 2) = 1.5.
    EXPECT_EQ(learner.tables().of(0).value(1, 3), 1.5);
    EXPECT_EQ(learner.tables().of(0).value(0, tied), 2.0);
    decide(learner, learners::tick(2, 2, 1.0));
    // 3 m were gained, and row 2 promises nothing: half of 3 - 2 is a step of 0.5, of which 0.5 * 0.5 reach row 1.
    EXPECT_EQ(learner.tables().of(0).value(0, tied), 2.5);
    EXPECT_EQ(learner.tables().of(0).value(1, 3), 1.625);
  }
}

TEST(Policy, ChoosesTheFirstOfEqualValues) {
  const Row row = 0;
  QTable table(1, 4);
  EXPECT_EQ(chooseGreedy(table, {&row, 0}), 0U);
  table.set(0, 1, 2.0, 1);
  table.set(0, 3, 2.0, 1);
  EXPECT_EQ(chooseGreedy(table, {&row, 0}), 1U);
}

TEST(Policy, ExploresIfTheDrawIsBelowEpsilon) {
  const Row row = 0;
  QTable table(1, 4);
  table.set(0, 2, 1.0, 1);
  const auto choose = [&](double epsilon, double draw, double any) {
    return chooseEpsilonGreedy(table, {&row, 0}, epsilon, {draw, any});
  };
  EXPECT_EQ(choose(0.25, 0.25, 0.0), 2U);
  EXPECT_EQ(choose(0.25, std::nextafter(0.25, 0.0), 0.0), 0U);
  EXPECT_EQ(choose(0.0, 0.0, 0.0), 2U);
  EXPECT_EQ(choose(1.0, std::nextafter(1.0, 0.0), 0.0), 0U);
}

TEST(Policy, ExploresUniformly) {
  const Row row = 0;
  const QTable table(1, 4);
  const auto explore = [&](double any) { return chooseEpsilonGreedy(table, {&row, 0}, 1.0, {0.0, any}); };
  EXPECT_EQ(explore(0.0), 0U);
  EXPECT_EQ(explore(std::nextafter(0.25, 0.0)), 0U);
  EXPECT_EQ(explore(0.25), 1U);
  EXPECT_EQ(explore(0.5), 2U);
  EXPECT_EQ(explore(0.75), 3U);
  EXPECT_EQ(explore(std::nextafter(1.0, 0.0)), 3U);
}

}  // namespace
}  // namespace crowd::ties_test
