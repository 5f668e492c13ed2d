#include "simulation/crowd_decider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <utility>

#include "simulation/episode.h"
#include "support/learners.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::crowd_decider_test {
namespace {

constexpr std::uint64_t EPISODE = 7;

/// Agent, rotation and fraction of the maximum speed.
using Decision = std::tuple<AgentId, double, double>;

std::vector<Decision> toDecisions(const std::vector<AgentAction>& actions) {
  std::vector<Decision> decisions;
  decisions.reserve(actions.size());
  for (const AgentAction& given : actions) {
    decisions.emplace_back(given.agent, given.action.rotation, given.action.speed_fraction);
  }
  return decisions;
}

/// An episode of a crowd that walks straight through walls and obstacles.
Episode episodeOf(Scene scene, const Vision& vision, std::uint64_t number = EPISODE) {
  scene.way_finding = false;
  return {std::move(scene), number, vision};
}

/// Reference: decisions of Learner::decide() for the perceptions of all agents, in order of the agents. Requires the
/// same decisions, and what the last agent chose, of three threads.
std::vector<Decision> decideAtOnce(Episode& episode, Learner& learner) {
  const Perceptions& perceptions = episode.perceptions();
  RelativeActions actions;
  learner.decide(perceptions, actions);
  const AgentId last = actions.agents.back().agent;
  const Action chosen = learner.valuesOf(perceptions, actions, last)->chosen;
  ThreadPool thread_pool(3);
  RelativeActions shared;
  learner.decide(perceptions, shared, thread_pool);
  EXPECT_EQ(toDecisions(shared.agents), toDecisions(actions.agents));
  EXPECT_EQ(learner.valuesOf(perceptions, shared, last)->chosen, chosen);
  return toDecisions(actions.agents);
}

/// Deciders with 1, 2 and 7 threads, which are kept from tick to tick.
class Crowds {
 public:
  explicit Crowds(Learner& learner) {
    for (std::size_t i = 0; i < crowds_.size(); ++i) {
      crowds_[i] = std::make_unique<CrowdDecider>(learner, thread_pool_[i]);
    }
  }

  /// Their decisions, in order of the agents. Requires equal decisions of all crowds.
  std::vector<Decision> decide(Episode& episode) {
    std::vector<Decision> first;
    for (std::size_t i = 0; i < crowds_.size(); ++i) {
      std::vector<AgentAction> actions = {{12345, {6.0, 7.0}}};  // to be overwritten
      crowds_[i]->decide(episode, actions);
      if (i == 0) first = toDecisions(actions);
      EXPECT_EQ(toDecisions(actions), first) << thread_pool_[i].count() << " threads";
    }
    std::sort(first.begin(), first.end());
    return first;
  }

 private:
  std::array<ThreadPool, 3> thread_pool_ = {ThreadPool(1), ThreadPool(2), ThreadPool(7)};
  std::array<std::unique_ptr<CrowdDecider>, 3> crowds_;
};

/// Models with and without limited vision, with one row for all actions and with one row per action.
std::vector<Model> models() {
  const std::string thesis = "action_set: {type: kings_moves}, reward: {goal: distance_gained, obstacle_cost: 10}";
  const std::string goal_relative =
      "state_set: {type: anticipation}, action_set: {type: goal_relative, gap_sharing: moving}, ";
  const std::string human =
      "state_set: {type: anticipation}, action_set: {type: goal_relative, time_gap: 1, time_gap_width: 0.8, "
      "anticipation_time: 1}, ";
  return {
      parseModel("{state_set: {type: nearest_obstacle}, " + thesis + "}"),
      parseModel("{state_set: {type: occupancy}, " + thesis + "}"),
      parseModel("{" + goal_relative + "reward: {type: progress}}"),
      parseModel("{" + human + "reward: {type: progress}}"),
      parseModel("{" + goal_relative + "reward: {type: progress}, vision: {occlusion: true}}"),
  };
}

Learner makeLearner(const Model& model, Learner::Options options = {}) {
  return {model, std::move(options), learners::randomTable(model, 3)};
}

/// Walks a crowd for some ticks and compares the decisions. Returns their number.
std::size_t compareDecisions(std::uint64_t seed, Learner& asked, Learner& unasked) {
  constexpr int TICKS = 12;
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {1});
  Episode episode = episodeOf(scenes::randomCrowd(seed), asked.model().vision());
  Crowds crowds(unasked);
  std::size_t compared = 0;
  for (int tick = 0; tick < TICKS; ++tick) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", tick " << tick);
    const std::vector<Decision> expected = decideAtOnce(episode, asked);
    EXPECT_EQ(crowds.decide(episode), expected);
    compared += expected.size();
    episode.step(scenes::purposefulActions(episode.world(), random));
  }
  EXPECT_LT(episode.world().activeCount(), episode.world().agents().size())
      << "seed " << seed << ": nobody has arrived";
  return compared;
}

TEST(CrowdDecider, DecidesAsTheLearnerDoes) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Learner asked = makeLearner(model);
      Learner unasked = makeLearner(model);
      compared += compareDecisions(seed, asked, unasked);
    }
    EXPECT_GT(compared, 5000U);
  }
}

TEST(CrowdDecider, BreaksTiesAsTheLearnerDoes) {
  Learner::Options options;
  options.seed = 5;
  options.plan.parameters.ties = Ties::RANDOM;
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    Learner asked(model, options);  // an empty table: all actions have equal values
    Learner unasked(model, options);
    EXPECT_GT(compareDecisions(1, asked, unasked), 1500U);
  }
  // Another episode or another seed gives other decisions.
  const Model model = models().front();
  const auto decide = [&](std::uint64_t number) {
    Learner learner(model, options);
    Episode episode = episodeOf(scenes::randomCrowd(1), model.vision(), number);
    std::vector<AgentAction> actions;
    EXPECT_TRUE(CrowdDecider(learner).decide(episode, actions));
    return toDecisions(actions);
  };
  const std::vector<Decision> decisions = decide(EPISODE);
  EXPECT_EQ(decide(EPISODE), decisions);
  EXPECT_NE(decide(EPISODE + 1), decisions);
  options.seed = 6;
  EXPECT_NE(decide(EPISODE), decisions);
}

TEST(CrowdDecider, DecidesOnlyForAgentsThatTheLearnerServes) {
  Learner::Options options;
  options.agents = {0, 1, 7, 200, 201, 9999};
  const Model model = models()[2];
  Learner asked = makeLearner(model, options);
  Learner unasked = makeLearner(model, options);
  EXPECT_GT(compareDecisions(1, asked, unasked), 12U * 2U);
  Episode episode = episodeOf(scenes::randomCrowd(1), model.vision());
  std::vector<AgentId> answered;
  for (const Decision& decision : Crowds(asked).decide(episode)) {
    answered.push_back(std::get<0>(decision));
  }
  EXPECT_EQ(answered, (std::vector<AgentId>{0, 1, 7, 200, 201}));
}

TEST(CrowdDecider, UsesOwnTables) {
  Learner::Options options;
  options.tables = TableUse::OWN;
  const Model model = models()[2];
  Learner asked = makeLearner(model, options);
  Learner unasked = makeLearner(model, options);
  for (const AgentId agent : {3U, 4U, 100U}) {
    const QTable table = learners::randomTable(model, 1000 + agent);
    asked.tables().take(agent, table, TakeMethod::REPLACE);
    unasked.tables().take(agent, table, TakeMethod::REPLACE);
  }
  compareDecisions(2, asked, unasked);
  // With a shared table, these three decide differently in at least one of some worlds.
  for (const AgentId agent : {3U, 4U, 100U}) {
    std::size_t different = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Episode episode = episodeOf(scenes::randomCrowd(seed), model.vision());
      Learner shared = makeLearner(model);
      const std::vector<Decision> own = Crowds(unasked).decide(episode);
      const std::vector<Decision> one = Crowds(shared).decide(episode);
      different += own.at(agent) != one.at(agent) ? 1 : 0;
      EXPECT_EQ(own.at(5), one.at(5));
    }
    EXPECT_GT(different, 0U) << "agent " << agent;
  }
}

TEST(CrowdDecider, DoesNotDependOnThePreviousWorld) {
  const Model model = models()[2];
  Learner learner = makeLearner(model);
  ThreadPool many(7);
  CrowdDecider crowd(learner, many);
  Episode large = episodeOf(scenes::randomCrowd(1), model.vision());
  std::vector<AgentAction> actions;
  crowd.decide(large, actions);
  ASSERT_GT(actions.size(), 2 * ThreadPool::FEW_SHORT_ITEMS);
  Episode small =
      episodeOf(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({3.0, 0.0})}), model.vision());
  crowd.decide(small, actions);
  std::vector<AgentAction> expected;
  CrowdDecider(learner).decide(small, expected);
  EXPECT_EQ(expected.size(), 2U);
  EXPECT_EQ(toDecisions(actions), toDecisions(expected));
}

TEST(CrowdDecider, DecidesNothingWithoutWalkingAgents) {
  const Model model = models()[2];
  Learner learner = makeLearner(model);
  Episode empty = episodeOf(scenes::scene({}, {scenes::pillar({0.0, 0.0}, 0.5)}), model.vision());
  std::vector<AgentAction> actions = {{1, {}}};
  EXPECT_FALSE(CrowdDecider(learner).decide(empty, actions));
  EXPECT_TRUE(actions.empty());
}

}  // namespace
}  // namespace crowd::crowd_decider_test
