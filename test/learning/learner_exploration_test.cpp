// How random numbers and the distribution of agents over learners affect decisions.

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "learning/learner.h"
#include "support/learners.h"

namespace crowd::learner_exploration_test {
namespace {

using learners::actionOf;
using learners::decide;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;
using learners::randomTable;
using learners::randomTick;

constexpr AgentId MANY = 8000;
constexpr Action BEST = 5;  // of the rows 0 .. 3 in bestIsFive()

QTable bestIsFive() {
  QTable table = emptyTable();
  for (Row row = 0; row < 4; ++row) table.set(row, BEST, 1.0, 1);
  return table;
}

Learner::Options exploring(double epsilon, std::uint64_t seed = 1) {
  Learner::Options made = options(Mode::TRAINING);
  made.plan.epsilon = EpsilonSchedule::constant(epsilon);
  made.seed = seed;
  return made;
}

/// Counts how often each action was chosen by many agents in one tick.
std::array<int, 8> countActions(Learner& learner, std::uint64_t episode, std::uint64_t tick) {
  PerceptionsBuilder scene(episode, tick);
  for (AgentId agent = 0; agent < MANY; ++agent) scene.agent(agent, goalIn(agent % 4, 4.0));
  std::array<int, 8> counts{};
  for (const AgentAction& action : decide(learner, scene).agents) ++counts.at(actionOf(action));
  return counts;
}

TEST(Exploration, HasFrequencyEpsilonAndIsUniform) {
  // Of 8000 decisions 40 % are drawn, 400 for each action. Five standard deviations of a count of 400 are about 100.
  Learner learner(model(), exploring(0.4), bestIsFive());
  for (const std::uint64_t tick : {0U, 7U}) {
    const std::array<int, 8> counts = countActions(learner, 0, tick);
    for (Action action = 0; action < 8; ++action) {
      EXPECT_NEAR(counts.at(action), action == BEST ? 5200 : 400, action == BEST ? 220 : 100);
    }
  }
}

TEST(Exploration, NeverHappensWithEpsilonZeroAndAlwaysWithOne) {
  Learner never(model(), exploring(0.0), bestIsFive());
  EXPECT_EQ(countActions(never, 0, 0).at(BEST), static_cast<int>(MANY));
  Learner always(model(), exploring(1.0), bestIsFive());
  EXPECT_NEAR(countActions(always, 0, 0).at(BEST), 1000, 150);
}

TEST(Exploration, DiffersInEachTickAndEpisode) {
  Learner learner(model(), exploring(1.0));
  const auto explore = [&](std::uint64_t episode, std::uint64_t first_tick) {
    std::vector<Action> actions;
    for (std::uint64_t tick = first_tick; tick < first_tick + 20; ++tick) {
      const PerceptionsBuilder scene = PerceptionsBuilder(episode, tick).agent(3, goalIn(0, 4.0));
      actions.push_back(actionOf(decide(learner, scene).agents.at(0)));
    }
    return actions;
  };
  const std::vector<Action> actions = explore(0, 0);
  EXPECT_NE(actions, std::vector<Action>(20, actions[0]));
  EXPECT_NE(explore(0, 20), actions);
  EXPECT_NE(explore(1, 0), actions);
  EXPECT_EQ(explore(0, 0), actions);
}

TEST(Exploration, FollowsTheScheduleOverTheEpisodes) {
  Learner::Options falling = exploring(0.0);
  falling.plan.epsilon = {0.8, 0.0, 4, EpsilonSchedule::Shape::LINEAR};
  Learner learner(model(), falling, bestIsFive());
  // 7/8 of the random actions are not the best one.
  EXPECT_NEAR(countActions(learner, 0, 0).at(BEST), 2400, 210);  // 8000 * (1 - 0.8 * 7/8)
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.8);
  EXPECT_NEAR(countActions(learner, 3, 0).at(BEST), 6600, 210);  // 8000 * (1 - 0.2 * 7/8)
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.2);
  EXPECT_EQ(countActions(learner, 4, 0).at(BEST), static_cast<int>(MANY));
  EXPECT_EQ(learner.parameters().epsilon, 0.0);
  countActions(learner, 1, 0);  // an earlier episode again
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.6);
}

TEST(Exploration, CanFallExponentially) {
  Learner::Options falling = exploring(0.0);
  falling.plan.epsilon = {0.8, 0.2, 2, EpsilonSchedule::Shape::EXPONENTIAL};
  Learner learner(model(), falling, bestIsFive());
  EXPECT_NEAR(countActions(learner, 1, 0).at(BEST), 5200, 220);  // epsilon 0.4
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.4);
}

TEST(Exploration, StaysConstantAfterItIsSet) {
  Learner::Options falling = exploring(0.0);
  falling.plan.epsilon = {0.8, 0.0, 4, EpsilonSchedule::Shape::LINEAR};
  Learner learner(model(), falling, bestIsFive());
  countActions(learner, 1, 0);
  learner.setPlan(changedPlan(learner.plan(), "{epsilon: 0.4}", "request"));
  EXPECT_NEAR(countActions(learner, 1, 2).at(BEST), 5200, 220);  // at once
  EXPECT_NEAR(countActions(learner, 3, 0).at(BEST), 5200, 220);  // and later
  EXPECT_EQ(learner.parameters().epsilon, 0.4);
}

TEST(Exploration, KeepsFallingWhenAnotherParameterIsSet) {
  Learner::Options falling = exploring(0.0);
  falling.plan.epsilon = {0.8, 0.0, 4, EpsilonSchedule::Shape::LINEAR};
  Learner learner(model(), falling, bestIsFive());
  countActions(learner, 1, 0);
  learner.setPlan(changedPlan(learner.plan(), "{gamma: 0.25}", "request"));
  EXPECT_EQ(learner.parameters().gamma, 0.25);
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.6);  // of episode 1
  EXPECT_NEAR(countActions(learner, 2, 0).at(BEST), 5200, 220);
  EXPECT_DOUBLE_EQ(learner.parameters().epsilon, 0.4);
}

// --- dependencies of decisions ---

constexpr AgentId AGENTS = 12;

/// All decisions of a run of three episodes of 40 ticks, by agent.
using Decisions = std::map<AgentId, std::vector<Action>>;

void run(Learner& learner, Decisions& decisions, bool backwards = false) {
  for (std::uint64_t episode = 0; episode < 3; ++episode) {
    for (std::uint64_t tick = 0; tick < 40; ++tick) {
      const RelativeActions actions = decide(learner, randomTick(3, episode, tick, AGENTS, backwards));
      for (const AgentAction& action : actions.agents) decisions[action.agent].push_back(actionOf(action));
    }
  }
}

Decisions runOne(const Learner::Options& options, bool backwards = false) {
  Learner learner(model(), options, randomTable(1));
  Decisions decisions;
  run(learner, decisions, backwards);
  return decisions;
}

/// The same with one learner for the even agents and one for the odd ones.
Decisions runTwo(const Learner::Options& options) {
  Decisions decisions;
  for (const AgentId parity : {0U, 1U}) {
    Learner::Options half = options;
    for (AgentId agent = parity; agent < AGENTS; agent += 2) half.agents.insert(agent);
    Learner learner(model(), half, randomTable(1));
    run(learner, decisions);
  }
  return decisions;
}

Learner::Options walking(Mode mode, TableUse tables, std::uint64_t seed = 1) {
  Learner::Options made = exploring(0.3, seed);
  made.mode = mode;
  made.tables = tables;
  made.plan.parameters.lambda = 0.5;
  return made;
}

TEST(Decisions, AreTheSameForTheSameSeed) {
  for (const TableUse tables : {TableUse::SHARED, TableUse::OWN}) {
    EXPECT_EQ(runOne(walking(Mode::TRAINING, tables)), runOne(walking(Mode::TRAINING, tables)));
  }
}

TEST(Decisions, DependOnTheSeedOnlyWhileExploring) {
  EXPECT_NE(runOne(walking(Mode::TRAINING, TableUse::OWN, 1)), runOne(walking(Mode::TRAINING, TableUse::OWN, 2)));
  EXPECT_EQ(runOne(walking(Mode::DEMO, TableUse::OWN, 1)), runOne(walking(Mode::DEMO, TableUse::OWN, 2)));
}

/// A learner that serves one agent: 20 episodes, which end on the way or with the arrival.
QTable learnFromOne(Learner& learner, std::vector<Action>& decisions) {
  for (std::uint64_t episode = 0; episode < 20; ++episode) {
    for (std::uint64_t tick = 0; tick < 40; ++tick) {
      PerceptionsBuilder scene = randomTick(3, episode, tick, 1);
      if (tick == 39 && episode % 2 == 0) scene.arrived();
      if (tick == 39) scene.last();
      for (const AgentAction& action : decide(learner, scene).agents) decisions.push_back(actionOf(action));
    }
  }
  return learner.tables().of(0);
}

TEST(Decisions, OfOneAgentAreThoseOfAListOfOneAgent) {
  for (const TableUse tables : {TableUse::SHARED, TableUse::OWN}) {
    const Learner::Options options = walking(Mode::TRAINING, tables);
    Learner::Options listed = options;
    listed.agents = {0};  // a learner that does not serve all agents lists those that it serves
    Learner alone(model(), options, randomTable(1));
    Learner on_list(model(), listed, randomTable(1));
    std::vector<Action> decisions;
    std::vector<Action> expected;
    EXPECT_EQ(learnFromOne(alone, decisions), learnFromOne(on_list, expected));
    EXPECT_EQ(decisions, expected);
    EXPECT_EQ(decisions.size(), 20U * 39U);
    EXPECT_EQ(alone.decisions(), on_list.decisions());
    EXPECT_GT(alone.decisions(), 500U);
  }
}

TEST(Decisions, DoNotDependOnOtherAgentsOfTheLearner) {
  const Decisions learned_alone = runOne(walking(Mode::TRAINING, TableUse::OWN));
  ASSERT_EQ(learned_alone.size(), AGENTS);
  EXPECT_EQ(learned_alone.begin()->second.size(), 120U);
  EXPECT_EQ(learned_alone, runTwo(walking(Mode::TRAINING, TableUse::OWN)));
  for (const TableUse tables : {TableUse::SHARED, TableUse::OWN}) {
    EXPECT_EQ(runOne(walking(Mode::DEMO, tables)), runTwo(walking(Mode::DEMO, tables)));
  }
}

TEST(Decisions, DoNotDependOnTheOrderOfAgents) {
  EXPECT_EQ(runOne(walking(Mode::TRAINING, TableUse::OWN)), runOne(walking(Mode::TRAINING, TableUse::OWN), true));
  EXPECT_EQ(runOne(walking(Mode::DEMO, TableUse::SHARED)), runOne(walking(Mode::DEMO, TableUse::SHARED), true));
}

TEST(Decisions, DoNotDependOnAnEarlierUseOfTheWorkspace) {
  const std::string reward = "reward: {type: progress}}";
  const std::vector<std::string> specs = {
      "{state_set: {type: anticipation}, action_set: {type: goal_relative}, " + reward,
      "{state_set: {type: anticipation}, action_set: {type: kings_moves}, " + reward,
      "{state_set: {type: occupancy}, action_set: {type: kings_moves, rotations: 60}, " + reward,  // more blocks
      "{state_set: {type: anticipation}, action_set: {type: kings_moves, stay: true}, " + reward};
  DecisionWorkspace reused;
  for (const std::string& first : specs) {
    for (const std::string& spec : {first, specs[0], specs[1], specs[2], specs[3]}) {
      const Model model = parseModel(spec);
      const Learner learner(model, walking(Mode::DEMO, TableUse::SHARED), learners::randomTable(model, 1));
      const Perceptions perceptions = randomTick(3, 0, 0, AGENTS).all();
      DecisionWorkspace fresh;
      std::vector<AgentAction> expected;
      std::vector<AgentAction> actions;
      learner.decideGreedily(perceptions, fresh, expected);
      learner.decideGreedily(perceptions, reused, actions);
      ASSERT_EQ(actions.size(), expected.size());
      for (std::size_t i = 0; i < actions.size(); ++i) {
        EXPECT_EQ(reused.choices[i].row, fresh.choices[i].row) << spec;
        EXPECT_EQ(reused.choices[i].action, fresh.choices[i].action) << spec;
      }
    }
  }
}

TEST(Decisions, DifferForSharedAndOwnTables) {
  // Otherwise the comparisons above would prove little.
  EXPECT_NE(runOne(walking(Mode::TRAINING, TableUse::OWN)), runOne(walking(Mode::TRAINING, TableUse::SHARED)));
}

}  // namespace
}  // namespace crowd::learner_exploration_test
