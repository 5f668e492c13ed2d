#include "simulation/agent_mind.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "support/learners.h"
#include "support/scenes.h"

namespace crowd::agent_mind_test {
namespace {

Learner makeLearner() {
  const Model model = parseModel(
      "{state_set: {type: anticipation, vision_radius: 6}, action_set: {type: goal_relative, headings: [0, 45]}, "
      "reward: {type: progress}}");
  return {model, learners::options(Mode::DEMO), learners::randomTable(model, 3)};
}

TEST(MindOf, IsWhatTheAgentChoosesInItsTurn) {
  Learner learner = makeLearner();
  Learner other = makeLearner();
  Scene crowd = scenes::randomCrowd(1);
  crowd.way_finding = false;
  Episode episode(crowd, 7, learner.model().vision());
  const Perceptions& seen = episode.perceptions();
  RelativeActions actions;
  other.decide(seen, actions);
  for (std::size_t i = 0; i < actions.agents.size(); i += 50) {
    const AgentId agent = actions.agents[i].agent;
    const std::optional<AgentMind> mind = mindOf(episode, learner, agent);
    ASSERT_TRUE(mind) << agent;
    const DecisionValues expected = *other.valuesOf(seen, actions, agent);
    EXPECT_EQ(mind->values.chosen, expected.chosen) << agent;
    ASSERT_EQ(mind->values.moves.size(), expected.moves.size()) << agent;
    for (std::size_t k = 0; k < expected.moves.size(); ++k) {
      EXPECT_EQ(mind->values.moves[k].row, expected.moves[k].row) << agent << ", move " << k;
      EXPECT_EQ(mind->values.moves[k].value, expected.moves[k].value) << agent << ", move " << k;
    }
  }
}

TEST(MindOf, NamesThoseWhomTheAgentPerceives) {
  Learner learner = makeLearner();
  // In the frame of agent 1, which looks back: agents 0 and 3 are near, 2 is beyond its vision.
  const Scene scene = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::agent({2.0, 1.0}, {-20.0, -3.0}, 1.5),
                                     scenes::wanderer({30.0, 0.0}), scenes::wanderer({2.0, -2.0})});
  const Episode episode(scene, 1, learner.model().vision());
  const std::optional<AgentMind> mind = mindOf(episode, learner, 1);
  ASSERT_TRUE(mind);
  EXPECT_EQ(mind->neighbours, (std::vector<AgentId>{0, 3}));
  EXPECT_EQ(mind->max_speed, 1.5);
  EXPECT_EQ(mindOf(episode, learner, 2)->neighbours, std::vector<AgentId>());
}

TEST(MindOf, IsOnlyOfAgentsThatDecide) {
  Learner learner = makeLearner();
  Scene scene = scenes::scene({scenes::wanderer({0.0, 0.0}), scenes::agent({5.0, 0.0}, {5.3, 0.0})});
  scene.max_ticks = 5;
  Episode episode(scene, 1, learner.model().vision());
  EXPECT_TRUE(mindOf(episode, learner, 1));
  EXPECT_FALSE(mindOf(episode, learner, 99));
  for (int tick = 0; tick < 4; ++tick) episode.step({{1, {0.0, 1.0}}});
  EXPECT_TRUE(mindOf(episode, learner, 0));
  EXPECT_FALSE(mindOf(episode, learner, 1));  // it has arrived
  episode.step({});
  ASSERT_TRUE(episode.isOver());
  EXPECT_FALSE(mindOf(episode, learner, 0));
}

}  // namespace
}  // namespace crowd::agent_mind_test
