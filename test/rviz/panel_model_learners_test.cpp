#include "rviz/panel_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/panels.h"

namespace crowd::panel_model_learners_test {
namespace {

using namespace panels;  // NOLINT(google-build-using-namespace): all of it is for these tests
using Kind = PanelRequest::Kind;

TEST(PanelModelLearners, changesTheOnlyLearner) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1}));
  EXPECT_EQ(model.view(NOW).learners, std::vector<std::string>{"/learner"});
  EXPECT_TRUE(model.view(NOW).has_learner);
  EXPECT_FALSE(model.view(NOW).can_share) << "there is one table";
  model.setParameter("epsilon", 0.25);
  const std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].text, "epsilon");
  EXPECT_DOUBLE_EQ(requests[0].number, 0.25);
  EXPECT_DOUBLE_EQ(model.view(NOW).epsilon, 0.25);
  EXPECT_DOUBLE_EQ(model.view(NOW).alpha, 0.0);
}

TEST(PanelModelLearners, changesOfDifferentParametersAreAllMade) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0}));
  model.setMode("training");
  ASSERT_EQ(model.takeRequests().size(), 1U);
  model.setParameter("alpha", 0.1);
  model.setParameter("gamma", 0.8);
  model.setParameter("alpha", 0.2);
  EXPECT_EQ(model.view(NOW).mode, "training");
  EXPECT_DOUBLE_EQ(model.view(NOW).alpha, 0.2);
  EXPECT_DOUBLE_EQ(model.view(NOW).gamma, 0.8);
  model.noteDone({Kind::SET_MODE, "/learner", "training"}, true, "");
  std::vector<PanelRequest> made = model.takeRequests();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].text, "gamma");
  model.noteDone(made[0], true, "");
  made = model.takeRequests();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_DOUBLE_EQ(made[0].number, 0.2);
}

TEST(PanelModelLearners, changesAllLearnersAndTheTableOfTheShownAgent) {
  PanelModel model = present();
  for (const std::uint32_t agent : {0U, 1U, 2U})
    addLearner(model, learner("/learner_" + std::to_string(agent), {agent}));
  EXPECT_EQ(model.view(NOW).learner, PanelModel::ALL_LEARNERS);
  EXPECT_TRUE(model.view(NOW).can_share);
  model.takeChosenAgent(1);
  model.setMode("training");
  EXPECT_EQ(nodesOf(model.takeRequests()), (std::vector<std::string>{"/learner_0", "/learner_1", "/learner_2"}));
  PanelModel other = model;
  other.shareTable("merge");
  EXPECT_TRUE(other.takeRequests().empty()) << "that learner is busy";
  model.noteDone({Kind::SET_MODE, "/learner_1", "training"}, true, "");
  model.shareTable("merge");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner_1"});
  model.chooseLearner("/learner_2");
  model.setMode("demo");
  model.noteDone({Kind::SET_MODE, "/learner_2", "training"}, true, "");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner_2"});
}

TEST(PanelModelLearners, namesTheShownAgentWhenItsTableIsItsOwn) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1, 2}, true));
  model.takeChosenAgent(2);
  EXPECT_TRUE(model.view(NOW).can_share);
  model.saveTable("/tmp/table.txt", false);
  std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_DOUBLE_EQ(requests[0].number, 2.0);
  EXPECT_EQ(requests[0].text, "/tmp/table.txt");
  model.noteDone(requests[0], true, "saved");
  model.take(learner("/learner", {0, 1, 2}));  // one table now
  model.saveTable("/tmp/table.txt", false);
  requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_DOUBLE_EQ(requests[0].number, 0.0);
  model.noteDone(requests[0], true, "saved");
  model.take(learner("/learner", {0, 1, 2}, true));
  model.takeChosenAgent(7);  // no learner serves it
  model.saveTable("/tmp/table.txt", false);
  EXPECT_DOUBLE_EQ(model.takeRequests().at(0).number, 0.0);
}

TEST(PanelModelLearners, greysOutALearnerThatIsAway) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0}));
  model.noteReachable("/learner", false);
  EXPECT_FALSE(model.view(NOW).has_learner);
  EXPECT_EQ(model.view(NOW).table, "/learner is away");
  model.setMode("training");
  EXPECT_TRUE(model.takeRequests().empty());
  model.noteReachable("/learner", true);
  EXPECT_TRUE(model.view(NOW).has_learner);
}

TEST(PanelModelLearners, changesManyLearnersAlthoughFewAreWatched) {
  PanelModel model = present();
  for (std::uint32_t agent = 0; agent < 50; ++agent) model.take(learner("/learner_" + std::to_string(agent), {agent}));
  model.setMode("training");
  EXPECT_EQ(model.takeRequests().size(), 50U);
}

TEST(PanelModelLearners, leavesOutLearnersThatAreAway) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1}));
  model.noteReachable("/learner", false);
  addLearner(model, learner("/learner_1", {1}));
  model.takeChosenAgent(1);
  EXPECT_TRUE(model.view(NOW).has_learner);
  model.setMode("training");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner_1"});
  model.take(learner("/learner", {0, 1}));  // it is back
  model.setMode("demo");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner"}) << "the other one is busy";
}

TEST(PanelModelLearners, watchesFewOfManyLearners) {
  PanelModel model = present();
  for (std::uint32_t agent = 0; agent < 1000; ++agent)
    model.take(learner("/learner_" + std::to_string(agent), {agent}));
  model.takeChosenAgent(777);
  model.chooseLearner("/learner_555");
  std::vector<std::string> watched = model.watchedNodes();
  EXPECT_LE(watched.size(), 10U);
  for (const char* const node : {CONTROLLER, MARKERS, "/learner_555"}) {
    EXPECT_EQ(std::count(watched.begin(), watched.end(), node), 1) << node;
  }
  model.chooseLearner(PanelModel::ALL_LEARNERS);
  watched = model.watchedNodes();
  EXPECT_EQ(std::count(watched.begin(), watched.end(), "/learner_777"), 1);
}

}  // namespace
}  // namespace crowd::panel_model_learners_test
