#include "learning/learner.h"

#include <gtest/gtest.h>

#include <utility>

#include "learning/states/obstacle_classes.h"
#include "support/error_of.h"
#include "support/learners.h"
#include "support/parts.h"

namespace crowd::learner_test {
namespace {

using learners::decide;
using learners::decideOne;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;
using learners::tick;

std::vector<AgentId> agentsOf(const RelativeActions& actions) {
  std::vector<AgentId> agents;
  for (const AgentAction& action : actions.agents) agents.push_back(action.agent);
  return agents;
}

/// A table in which the best action of rows 0 .. 3 is the one that turns to the goal.
QTable towardsGoal() {
  QTable table = emptyTable();
  for (Row row = 0; row < 4; ++row) table.set(row, 2 * row, 1.0, 1);
  return table;
}

TEST(Learner, AnswersThePerceivedTick) {
  Learner learner(model(), options(Mode::DEMO));
  RelativeActions actions;
  actions.agents.push_back({99, {}});  // of an earlier tick
  learner.decide(PerceptionsBuilder(3, 17).agent(5, {1.0, 0.0}).agent(2, {1.0, 0.0}).all(), actions);
  EXPECT_EQ(actions.episode, 3U);
  EXPECT_EQ(actions.tick, 17U);
  EXPECT_EQ(agentsOf(actions), (std::vector<AgentId>{5, 2}));
}

TEST(Learner, AnswersForItsAgentsThatHaveNotArrived) {
  Learner::Options some = options(Mode::TRAINING);
  some.agents = {1, 2, 4};
  Learner learner(model(), some);
  EXPECT_FALSE(learner.servesAll());
  EXPECT_TRUE(learner.serves(2));
  EXPECT_FALSE(learner.serves(3));
  const RelativeActions actions = decide(
      learner, PerceptionsBuilder().agent(1, {1, 0}).agent(2, {0, 0}).arrived().agent(3, {1, 0}).agent(4, {1, 0}));
  EXPECT_EQ(agentsOf(actions), (std::vector<AgentId>{1, 4}));
  EXPECT_EQ(learner.servedAgents(), (std::vector<AgentId>{1, 2, 4}));
}

TEST(Learner, AnswersForItsShareOfAgentsItDidNotKnow) {
  Learner::Options third = options(Mode::TRAINING);
  third.share = {2, 3};
  Learner learner(model(), third);
  EXPECT_FALSE(learner.servesAll());
  EXPECT_TRUE(learner.serves(2));
  EXPECT_FALSE(learner.serves(3));
  EXPECT_TRUE(learner.serves(3000002));
  EXPECT_TRUE(learner.servedAgents().empty());
  PerceptionsBuilder scene;
  for (const AgentId agent : {8U, 3U, 1U, 2U, 0U}) scene.agent(agent, {1.0, 0.0});
  EXPECT_EQ(agentsOf(decide(learner, scene)), (std::vector<AgentId>{8, 2}));
  EXPECT_EQ(learner.servedAgents(), (std::vector<AgentId>{2, 8}));
}

TEST(Learner, EachAgentIsInOneShare) {
  for (const std::uint32_t count : {1U, 2U, 7U}) {
    for (AgentId agent = 0; agent < 100; ++agent) {
      int shares = 0;
      for (std::uint32_t index = 0; index < count; ++index) shares += AgentShare{index, count}.contains(agent) ? 1 : 0;
      EXPECT_EQ(shares, 1) << "agent " << agent << ", " << count << " shares";
    }
  }
}

TEST(Learner, ServesAllAgentsByDefault) {
  Learner learner(model(), options(Mode::DEMO));
  EXPECT_TRUE(learner.servesAll());
  EXPECT_TRUE(learner.serves(12345));
  EXPECT_TRUE(learner.servedAgents().empty());
  PerceptionsBuilder scene;
  for (const AgentId agent : {70U, 3U, 1000000U, 12U, 0U}) scene.agent(agent, {1.0, 0.0});
  decide(learner, scene);
  EXPECT_EQ(learner.servedAgents(), (std::vector<AgentId>{0, 3, 12, 70, 1000000}));
}

/// Each tick an agent comes and another one leaves; agent 0 stays. Of 4 of the 5 the last decision is learned from.
TEST(Learner, ForgetsAgentsThatHaveLeft) {
  constexpr AgentId TICKS = 5000;
  for (const Mode mode : {Mode::DEMO, Mode::TRAINING}) {
    Learner learner(model(), options(mode));
    for (AgentId t = 0; t < TICKS; ++t) {
      PerceptionsBuilder scene(3, t);
      scene.agent(0, {1.0, 0.5});
      for (AgentId agent = t + 1; agent <= t + 4; ++agent) scene.agent(agent, {1.0, 0.0});
      ASSERT_EQ(decide(learner, scene).agents.size(), 5U);
      ASSERT_LE(learner.servedAgents().size(), 1020U);
    }
    EXPECT_EQ(learner.servedAgents().front(), 0U);
    EXPECT_EQ(learner.servedAgents().back(), TICKS + 3);
    EXPECT_EQ(learner.decisions(), mode == Mode::TRAINING ? 4U * (TICKS - 1) : 0U);
  }
  Learner own(model(), options(Mode::DEMO, TableUse::OWN));
  for (AgentId agent = 0; agent < 2000; ++agent) decide(own, PerceptionsBuilder(3, agent).agent(agent, {1.0, 0.0}));
  EXPECT_EQ(own.servedAgents().size(), 2000U);
}

TEST(Learner, AnswersNothingAfterTheEpisode) {
  Learner learner(model(), options(Mode::TRAINING));
  EXPECT_TRUE(decide(learner, tick(5, 0, 1.0).last()).agents.empty());
}

TEST(Learner, DecidesGreedilyInDemoMode) {
  Learner learner(model(), options(Mode::DEMO), towardsGoal());
  for (Row row = 0; row < 4; ++row) EXPECT_EQ(decideOne(learner, tick(row, row, 2.0)), 2 * row);
}

TEST(Learner, LearnsNothingInDemoMode) {
  Learner::Options demo = options(Mode::DEMO);
  demo.plan.epsilon = EpsilonSchedule::constant(1.0);  // has no effect
  Learner learner(model(), demo, towardsGoal());
  for (std::uint64_t i = 0; i < 20; ++i) {
    EXPECT_EQ(decideOne(learner, tick(i, i % 4, 20.0 - static_cast<double>(i))), 2 * (i % 4));
  }
  decide(learner, tick(20, 0, 0.0).arrived());
  EXPECT_EQ(learner.tables().of(0), towardsGoal());
  EXPECT_EQ(learner.decisions(), 0U);
}

TEST(Learner, ContinuesTheCountOfDecisions) {
  Learner learner(model(), options(Mode::TRAINING));
  learner.setDecisions(1000);
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(1, 0, 3.0));
  EXPECT_EQ(learner.decisions(), 1001U);
}

TEST(Learner, AppliesNewParametersAtOnce) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  learner.setPlan({{0.25, 0.0, 0.0, 0.0}, EpsilonSchedule::constant(0.0)});
  decide(learner, tick(1, 0, 0.0));
  EXPECT_EQ(learner.tables().of(0).value(0, 0), 1.0);  // a quarter of 4
  EXPECT_EQ(learner.parameters().alpha, 0.25);
}

TEST(Learner, KeepsItsParametersIfNewOnesAreInvalid) {
  Learner learner(model(), options(Mode::TRAINING));
  const std::string message = errorOf<InputError>([&] { learner.setPlan({{2.0, 0.25, 0.5, 0.75}, {}}); });
  EXPECT_TRUE(contains(message, "alpha: expected")) << message;
  EXPECT_EQ(learner.parameters().alpha, 0.5);
  EXPECT_EQ(learner.parameters().gamma, 0.5);
  EXPECT_EQ(learner.parameters().lambda, 0.0);
  EXPECT_EQ(learner.parameters().epsilon, 0.0);
  decide(learner, PerceptionsBuilder(5, 0).agent(0, goalIn(0, 1.0)));
  EXPECT_EQ(learner.parameters().epsilon, 0.0);
}

TEST(Learner, RefusesInvalidParametersAndShapes) {
  Learner::Options wrong = options(Mode::DEMO);
  wrong.plan.parameters.gamma = 1.0;
  EXPECT_THROW(Learner(model(), wrong), InputError);
  EXPECT_THROW(Learner(model(), options(Mode::DEMO), QTable(69, 7)), ShapeError);
  EXPECT_THROW(Learner(model(), options(Mode::DEMO), QTable(68, 8)), ShapeError);
}

TEST(LearnerNames, ReadBackAllNames) {
  for (const Mode mode : {Mode::TRAINING, Mode::DEMO}) EXPECT_EQ(MODES.parse(MODES.nameOf(mode)), mode);
  for (const TableUse use : {TableUse::SHARED, TableUse::OWN}) EXPECT_EQ(TABLE_USES.parse(TABLE_USES.nameOf(use)), use);
  for (const TakeMethod method : {TakeMethod::REPLACE, TakeMethod::MERGE}) {
    EXPECT_EQ(TAKE_METHODS.parse(TAKE_METHODS.nameOf(method)), method);
  }
  EXPECT_EQ(MODES.parse("training"), Mode::TRAINING);
  EXPECT_EQ(TABLE_USES.parse("own"), TableUse::OWN);
  EXPECT_EQ(TAKE_METHODS.parse("merge"), TakeMethod::MERGE);
}

TEST(LearnerNames, ErrorsListExpectedNames) {
  EXPECT_EQ(errorOf<InputError>([] { MODES.parse("Demo"); }), "mode: expected training or demo, got 'Demo'");
  EXPECT_EQ(errorOf<InputError>([] { TABLE_USES.parse(""); }), "tables: expected shared or own, got ''");
  EXPECT_EQ(errorOf<InputError>([] { TAKE_METHODS.parse("add"); }), "method: expected replace or merge, got 'add'");
}

/// Two rows for every perception: action 0 is looked up in row 0 or 1, action 1 in row 2 or 3, by how far the goal is.
class RowPerAction : public StateSet, public RowDistanceClasses {
 public:
  Row rowCount() const override { return 5; }
  std::size_t rowsPerPerception() const override { return 2; }
  void findRows(const PerceptionBatch& batch, const MoveBlock* /*moves*/, Row* rows) const override {
    for (const Perception& seen : batch) {
      const Row far = seen.self.goal.norm() > 2.0 ? 1 : 0;
      *rows++ = far;
      *rows++ = 2 + far;
    }
  }
  Row mirrored(Row row) const override { return row; }
  std::vector<int> distanceClasses(Row /*row*/) const override { return {}; }
  double visionRadius() const override { return 1.0; }
  std::string spec() const override { return "{type: row_per_action}"; }
};

TEST(Learner, LooksUpEachActionInItsOwnRow) {
  Model model = parseModel(
      "{state_set: {type: occupancy}, action_set: {type: kings_moves, rotations: 2}, "
      "reward: {goal: distance_gained, obstacle_cost: 10}}");
  const auto state_set = std::make_shared<RowPerAction>();
  model.state_set = state_set;
  model.reward = rewardOf("{goal: distance_gained, obstacle_cost: 10}", *state_set);
  QTable table(5, 2);
  table.set(1, 0, 4.0, 1);  // far: action 0
  table.set(3, 1, 2.0, 1);
  table.set(0, 0, 1.0, 1);
  table.set(2, 1, 6.0, 1);  // near: action 1
  Learner learner(model, options(Mode::TRAINING), table);
  // Two agents, so that the second one's rows do not stand first.
  const RelativeActions first = decide(learner, PerceptionsBuilder(0, 0).agent(0, {1.0, 0.0}).agent(1, {4.0, 0.0}));
  EXPECT_NEAR(first.agents.at(0).action.rotation, PI, 1e-12);
  EXPECT_EQ(first.agents.at(1).action.rotation, 0.0);
  decide(learner, PerceptionsBuilder(0, 1).agent(0, {1.0, 0.0}).agent(1, {2.0, 0.0}));
  EXPECT_EQ(learner.tables().of(1).value(2, 1), 4.5);    // 0 + 0.5 * 6 = 3: from 6 down by half of 3
  EXPECT_EQ(learner.tables().of(1).value(1, 0), 4.125);  // 2 + 0.5 * 4.5 = 4.25: from 4 up by half of 0.25
  EXPECT_EQ(learner.tables().of(1).visits(2, 1), 2U);
  EXPECT_EQ(learner.tables().of(1).visits(1, 0), 2U);
  EXPECT_EQ(learner.tables().of(1).visits(3, 1), 1U);
}

TEST(Learner, UsesOnlyWhatIsWithinTheVisionOfItsModel) {
  const Model two_within_three_metres = parseModel(
      "{state_set: {type: anticipation, vision_radius: 3, max_neighbours: 2}, action_set: {type: goal_relative}, "
      "reward: {type: progress}}");
  KeyedRandom random(11, KeyedRandom::EXPLORATION, {});
  QTable table(two_within_three_metres.state_set->rowCount(), two_within_three_metres.action_set->size());
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) table.set(row, action, random.uniform(), 1);
  }
  Learner learner(two_within_three_metres, options(Mode::DEMO), table);
  const auto answer = [&](const PerceptionsBuilder& perceived) {
    const RelativeAction action = decide(learner, perceived).agents.at(0).action;
    return std::pair<double, double>(action.rotation, action.speed_fraction);
  };
  int differed = 0;
  for (int i = 0; i < 100; ++i) {
    const PerceptionsBuilder alone = PerceptionsBuilder().agent(0, {5.0, 0.0});
    PerceptionsBuilder seen = alone;
    for (const double distance : {0.7, 0.9}) seen.neighbour(polar(random.uniform(-90.0, 90.0), distance), 0.25);
    PerceptionsBuilder perceived = seen;
    for (const double distance : {0.95, 1.0, 4.0})
      perceived.neighbour(polar(random.uniform(-90.0, 90.0), distance), 0.25);
    EXPECT_EQ(answer(perceived), answer(seen));
    PerceptionsBuilder far = alone;
    EXPECT_EQ(answer(far.neighbour(polar(0.0, 3.3), 0.25)), answer(alone));
    differed += answer(seen) != answer(alone) ? 1 : 0;
  }
  EXPECT_GT(differed, 50);  // otherwise the test would prove nothing
}

}  // namespace
}  // namespace crowd::learner_test
