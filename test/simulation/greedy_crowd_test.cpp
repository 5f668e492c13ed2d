#include "social_crowd/simulation/greedy_crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "support/learners.h"
#include "support/scenes.h"
#include "support/worlds.h"

namespace crowd::greedy_crowd_test {
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

/// Reference: decisions of World::perceive() and Learner::decide(), in order of the agents.
std::vector<Decision> decideAtOnce(World& world, const Vision& vision, Learner& learner) {
  Perceptions perceptions;
  RelativeActions actions;
  perceive(world, vision, perceptions);
  perceptions.episode = EPISODE;
  learner.decide(perceptions, actions);
  return toDecisions(actions.agents);
}

/// Crowds with 1, 2 and 7 threads, which are kept from tick to tick.
class Crowds {
 public:
  /// Their decisions, in order of the agents. Requires equal decisions of all crowds.
  std::vector<Decision> decide(const World& world, const Vision& vision, const Learner& learner) {
    std::vector<Decision> first;
    for (std::size_t i = 0; i < crowds_.size(); ++i) {
      std::vector<AgentAction> actions = {{12345, {6.0, 7.0}}};  // to be overwritten
      crowds_[i].decide(world, EPISODE, vision, learner, actions, thread_pool_[i]);
      if (i == 0) first = toDecisions(actions);
      EXPECT_EQ(toDecisions(actions), first) << thread_pool_[i].count() << " threads";
    }
    std::sort(first.begin(), first.end());
    return first;
  }

 private:
  std::array<GreedyCrowd, 3> crowds_;
  std::array<ThreadPool, 3> thread_pool_ = {ThreadPool(1), ThreadPool(2), ThreadPool(7)};
};

/// Models with and without limited vision, with one row for all actions and with one row per action.
std::vector<Model> models() {
  const std::string thesis = "action_set: {type: kings_moves}, reward: {goal: distance_gained, obstacle_cost: 10}";
  const std::string goal_relative =
      "state_set: {type: anticipation}, action_set: {type: goal_relative, gap_sharing: moving}, ";
  const std::string human =
      "state_set: {type: anticipation}, action_set: {type: goal_relative, time_gap: 1, time_gap_width: 0.8}, ";
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
std::size_t compareDecisions(std::uint64_t seed, Learner& asked, const Learner& unasked) {
  constexpr int TICKS = 12;
  const Vision vision = asked.model().vision();
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {1});
  World world(scenes::randomCrowd(seed));
  Crowds crowds;
  std::size_t compared = 0;
  for (int tick = 0; tick < TICKS; ++tick) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", tick " << tick);
    const std::vector<Decision> expected = decideAtOnce(world, vision, asked);
    EXPECT_EQ(crowds.decide(world, vision, unasked), expected);
    compared += expected.size();
    world.step(scenes::purposefulActions(world, random));
  }
  EXPECT_LT(world.activeCount(), world.agents().size()) << "seed " << seed << ": no agent has arrived";
  return compared;
}

TEST(GreedyCrowd, DecidesAsTheLearnerDoes) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Learner asked = makeLearner(model);
      compared += compareDecisions(seed, asked, makeLearner(model));
    }
    EXPECT_GT(compared, 5000U);
  }
}

TEST(GreedyCrowd, BreaksTiesAsTheLearnerDoes) {
  Learner::Options options;
  options.seed = 5;
  options.plan.parameters.ties = Ties::RANDOM;
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    Learner asked(model, options);  // an empty table: all actions have equal values
    EXPECT_GT(compareDecisions(1, asked, Learner(model, options)), 1500U);
  }
  // Another episode or another seed gives other decisions.
  const Model model = models().front();
  const Learner learner(model, options);
  const World world(scenes::randomCrowd(1));
  const auto decide = [&](std::uint64_t episode, const Learner& asked) {
    std::vector<AgentAction> actions;
    GreedyCrowd().decide(world, episode, model.vision(), asked, actions);
    return toDecisions(actions);
  };
  EXPECT_EQ(decide(EPISODE, learner), decide(EPISODE, learner));
  EXPECT_NE(decide(EPISODE, learner), decide(EPISODE + 1, learner));
  options.seed = 6;
  EXPECT_NE(decide(EPISODE, learner), decide(EPISODE, Learner(model, options)));
}

TEST(GreedyCrowd, DecidesOnlyForAgentsThatTheLearnerServes) {
  Learner::Options options;
  options.agents = {0, 1, 7, 200, 201, 9999};
  const Model model = models()[2];
  Learner asked = makeLearner(model, options);
  EXPECT_GT(compareDecisions(1, asked, makeLearner(model, options)), 12U * 2U);
  World world(scenes::randomCrowd(1));
  std::vector<AgentId> answered;
  for (const Decision& decision : Crowds().decide(world, model.vision(), asked)) {
    answered.push_back(std::get<0>(decision));
  }
  EXPECT_EQ(answered, (std::vector<AgentId>{0, 1, 7, 200, 201}));
}

TEST(GreedyCrowd, UsesOwnTables) {
  Learner::Options options;
  options.tables = TableUse::OWN;
  const Model model = models()[2];
  Learner asked = makeLearner(model, options);
  Learner unasked = makeLearner(model, options);
  for (const AgentId agent : {3U, 4U, 100U}) {
    const QTable table = learners::randomTable(model, 1000 + agent);
    asked.takeTable(agent, table, TakeMethod::REPLACE);
    unasked.takeTable(agent, table, TakeMethod::REPLACE);
  }
  compareDecisions(2, asked, unasked);
  // With a shared table, these three decide differently in at least one of some worlds.
  for (const AgentId agent : {3U, 4U, 100U}) {
    std::size_t different = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const World world(scenes::randomCrowd(seed));
      Crowds crowds;
      const std::vector<Decision> own = crowds.decide(world, model.vision(), unasked);
      const std::vector<Decision> one = crowds.decide(world, model.vision(), makeLearner(model));
      different += own.at(agent) != one.at(agent) ? 1 : 0;
      EXPECT_EQ(own.at(5), one.at(5));
    }
    EXPECT_GT(different, 0U) << "agent " << agent;
  }
}

TEST(GreedyCrowd, DoesNotDependOnThePreviousWorld) {
  const Model model = models()[2];
  const Learner learner = makeLearner(model);
  ThreadPool many(7);
  GreedyCrowd crowd;
  std::vector<AgentAction> actions;
  crowd.decide(World(scenes::randomCrowd(1)), EPISODE, model.vision(), learner, actions, many);
  ASSERT_GT(actions.size(), 2 * ThreadPool::FEW_SHORT_ITEMS);
  const World small(scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::wanderer({3.0, 0.0})}));
  crowd.decide(small, EPISODE, model.vision(), learner, actions);
  std::vector<AgentAction> expected;
  GreedyCrowd().decide(small, EPISODE, model.vision(), learner, expected);
  EXPECT_EQ(expected.size(), 2U);
  EXPECT_EQ(toDecisions(actions), toDecisions(expected));
}

TEST(GreedyCrowd, DecidesNothingWithoutWalkingAgents) {
  const Model model = models()[2];
  std::vector<AgentAction> actions = {{1, {}}};
  GreedyCrowd().decide(World(scenes::scene({}, {scenes::pillar({0.0, 0.0}, 0.5)})), EPISODE, model.vision(),
                       makeLearner(model), actions);
  EXPECT_TRUE(actions.empty());
}

}  // namespace
}  // namespace crowd::greedy_crowd_test
