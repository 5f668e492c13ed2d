#include "rviz/panel_model.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace crowd {
namespace {

using Kind = PanelRequest::Kind;

constexpr const char* CONTROLLER = "/crowd_controller";
constexpr const char* MARKERS = "/crowd_markers";

ControllerInfo walking() {
  ControllerInfo info;
  info.node = CONTROLLER;
  info.scenario = "circle6";
  info.agents = 6;
  return info;
}

ControllerInfo paused() {
  ControllerInfo info = walking();
  info.paused = true;
  return info;
}

LearnerInfo learner(const std::string& node, std::vector<std::uint32_t> agents, bool own = false) {
  LearnerInfo info;
  info.node = node;
  info.mode = "demo";
  info.agents = std::move(agents);
  info.has_own_tables = own;
  info.epsilon = 0.1;
  return info;
}

/// A panel whose controller and markers are there; its list of scenarios has been asked for.
PanelModel present() {
  PanelModel model(CONTROLLER, MARKERS);
  model.noteReachable(CONTROLLER, true);
  model.noteReachable(MARKERS, true);
  for (const PanelRequest& request : model.takeRequests()) model.noteDone(request, true, "");
  return model;
}

void addLearner(PanelModel& model, const LearnerInfo& info) {
  model.take(info);
  model.noteReachable(info.node, true);
}

std::vector<std::string> nodesOf(const std::vector<PanelRequest>& requests) {
  std::vector<std::string> nodes;
  for (const PanelRequest& request : requests) nodes.push_back(request.node);
  return nodes;
}

TEST(PanelModel, enablesNothingBeforeNodesAreThere) {
  PanelModel model(CONTROLLER, MARKERS);
  const PanelView view = model.view();
  EXPECT_FALSE(view.has_controller || view.can_play || view.can_pause || view.can_step || view.has_learner ||
               view.can_share || view.has_markers);
  EXPECT_EQ(view.state, "/crowd_controller is away");
  EXPECT_EQ(view.table, "no learner");
  model.play();
  model.setMode("training");
  EXPECT_TRUE(model.takeRequests().empty());
}

TEST(PanelModel, asksForScenariosWhenTheControllerComes) {
  PanelModel model(CONTROLLER, MARKERS);
  model.noteReachable(CONTROLLER, true);
  const std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].kind, Kind::LIST_SCENARIOS);
  EXPECT_EQ(model.view().state, "waiting for /crowd_controller");
  EXPECT_FALSE(model.view().has_controller);
}

TEST(PanelModel, offersPauseWhileWalkingAndPlayAndStepWhilePaused) {
  PanelModel model = present();
  model.take(walking(), 0.0);
  PanelView view = model.view();
  EXPECT_TRUE(view.has_controller && view.can_pause);
  EXPECT_FALSE(view.can_play || view.can_step);
  EXPECT_EQ(view.state, "walking");
  model.take(paused(), 0.1);
  view = model.view();
  EXPECT_TRUE(view.can_play && view.can_step);
  EXPECT_FALSE(view.can_pause);
  EXPECT_EQ(view.state, "paused");
}

TEST(PanelModel, greysOutWhileTheControllerIsAwayAndComesBackWithIt) {
  PanelModel model = present();
  model.take(paused(), 0.0);
  model.noteReachable(CONTROLLER, false);
  EXPECT_FALSE(model.view().has_controller);
  EXPECT_TRUE(model.view().has_markers);
  model.noteReachable(CONTROLLER, true);
  EXPECT_FALSE(model.view().has_controller) << "the old status is not that of the new node";
  model.take(walking(), 1.0);
  EXPECT_TRUE(model.view().can_pause);
}

TEST(PanelModel, dropsWaitingRequestsOfANodeThatGoesAway) {
  PanelModel model = present();
  model.take(paused(), 0.0);
  model.play();
  ASSERT_EQ(model.takeRequests().size(), 1U);
  model.reset();
  model.noteReachable(CONTROLLER, false);
  model.noteDone({Kind::PAUSE, CONTROLLER}, false, "gone");
  EXPECT_TRUE(model.takeRequests().empty());
  EXPECT_EQ(model.view().message, "gone");
  EXPECT_TRUE(model.view().is_error);
}

TEST(PanelModel, callsANodeForOneRequestAtATimeAndTheNewestOfAKindWins) {
  PanelModel model = present();
  model.take(walking(), 0.0);
  model.setSpeed(2.0);
  const std::vector<PanelRequest> first = model.takeRequests();
  ASSERT_EQ(first.size(), 1U);
  model.setSpeed(3.0);
  model.setSpeed(4.0);
  model.pause();
  EXPECT_TRUE(model.takeRequests().empty());
  EXPECT_DOUBLE_EQ(model.view().speed, 4.0) << "what the user wants, until it is answered";
  model.noteDone(first[0], true, "done");
  const std::vector<PanelRequest> second = model.takeRequests();
  ASSERT_EQ(second.size(), 1U);
  EXPECT_DOUBLE_EQ(second[0].number, 4.0);
  model.noteDone(second[0], false, "refused");
  EXPECT_DOUBLE_EQ(model.view().speed, 1.0) << "the present value after a refusal";
  const std::vector<PanelRequest> third = model.takeRequests();
  ASSERT_EQ(third.size(), 1U);
  EXPECT_EQ(third[0].kind, Kind::PAUSE);
  EXPECT_TRUE(third[0].flag);
}

TEST(PanelModel, savesAllFilesThatWereAskedForWhileACallIsInProgress) {
  PanelModel model = present();
  model.reset();
  PanelRequest running = model.takeRequests().at(0);
  for (const char* const file : {"a.yaml", "b.yaml", "b.yaml"}) model.saveScenario(file);
  std::vector<std::string> saved;
  while (true) {
    model.noteDone(running, true, "");
    const std::vector<PanelRequest> requests = model.takeRequests();
    if (requests.empty()) break;
    running = requests.at(0);
    saved.push_back(running.text);
  }
  EXPECT_EQ(saved, (std::vector<std::string>{"a.yaml", "b.yaml"}));
}

TEST(PanelModel, saysThatAWaitingSaveIsNotDoneWhenItsNodeGoesAway) {
  PanelModel model = present();
  model.reset();
  ASSERT_EQ(model.takeRequests().size(), 1U);
  model.saveScenario("a.yaml");
  model.noteReachable(CONTROLLER, false);
  EXPECT_EQ(model.view().message, "a.yaml is not saved: /crowd_controller is away");
  EXPECT_TRUE(model.view().is_error);
}

TEST(PanelModel, pausesWhileStepsAreInProgress) {
  PanelModel model = present();
  model.take(paused(), 0.0);
  model.step(1000);
  const std::vector<PanelRequest> steps = model.takeRequests();
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_DOUBLE_EQ(steps[0].number, 1000.0);
  EXPECT_FALSE(model.view().can_step);
  EXPECT_EQ(model.view().state, "stepping");
  model.play();
  EXPECT_EQ(model.takeRequests().size(), 1U);
  model.noteDone(steps[0], true, "now at episode 0, tick 1000");
  EXPECT_TRUE(model.view().can_step);
  EXPECT_EQ(model.view().message, "now at episode 0, tick 1000");
}

TEST(PanelModel, showsCountsAndRates) {
  PanelModel model = present();
  ControllerInfo info = walking();
  info.episode = 12;
  info.tick = 1234;
  info.time = 123.4;
  info.arrived = 4;
  info.touched = 1;
  info.decisions = 1000;
  model.take(info, 10.0);
  info.decisions = 1600;
  info.unanswered = {2, 5};
  info.missed_answers = 7;
  model.take(info, 10.5);
  const PanelView view = model.view();
  EXPECT_EQ(view.episode, "12");
  EXPECT_EQ(view.tick, "1 234 (123.4 s)");
  EXPECT_EQ(view.success, "4 of 6 (67 %)");
  EXPECT_EQ(view.contact, "1 of 6 (17 %)");
  EXPECT_EQ(view.collision, "0 of 6 (0 %)");
  EXPECT_EQ(view.decisions, "1 200") << "600 in half a second";
  EXPECT_EQ(view.missing, "2, 5; 7 answers missed");
}

TEST(PanelModel, countsNoDecisionsWhilePaused) {
  PanelModel model = present();
  ControllerInfo info = paused();
  model.take(info, 0.0);
  info.decisions = 100;
  model.take(info, 1.0);
  EXPECT_EQ(model.view().decisions, "0");
  model.step(5);
  EXPECT_EQ(model.view().decisions, "100");
}

TEST(PanelModel, countsDecisionsOfTheLastSecondsOnly) {
  PanelModel model = present();
  ControllerInfo info = walking();
  for (const auto& [now, decisions] :
       std::vector<std::pair<double, std::uint64_t>>{{0, 0}, {1, 1000}, {2, 1000}, {3, 1000}}) {
    info.decisions = decisions;
    model.take(info, now);
  }
  EXPECT_EQ(model.view().decisions, "0");
  info.decisions = 3;  // the controller was restarted
  model.take(info, 3.1);
  EXPECT_EQ(model.view().decisions, "0");
}

TEST(PanelModel, shortensLongListsOfAgents) {
  PanelModel model = present();
  ControllerInfo info = walking();
  for (std::uint32_t agent = 0; agent < 1000; ++agent) info.unanswered.push_back(agent);
  model.take(info, 0.0);
  EXPECT_EQ(model.view().missing, "0, 1, 2, 3, 4 and 995 more");
}

TEST(PanelModel, changesTheOnlyLearner) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1}));
  EXPECT_EQ(model.view().learners, std::vector<std::string>{"/learner"});
  EXPECT_TRUE(model.view().has_learner);
  EXPECT_FALSE(model.view().can_share) << "there is one table";
  model.setParameter("epsilon", 0.25);
  const std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].text, "epsilon");
  EXPECT_DOUBLE_EQ(requests[0].number, 0.25);
  EXPECT_DOUBLE_EQ(model.view().epsilon, 0.25);
  EXPECT_DOUBLE_EQ(model.view().alpha, 0.0);
}

TEST(PanelModel, changesOfDifferentParametersAreAllMade) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0}));
  model.setMode("training");
  ASSERT_EQ(model.takeRequests().size(), 1U);
  model.setParameter("alpha", 0.1);
  model.setParameter("gamma", 0.8);
  model.setParameter("alpha", 0.2);
  EXPECT_EQ(model.view().mode, "training");
  EXPECT_DOUBLE_EQ(model.view().alpha, 0.2);
  EXPECT_DOUBLE_EQ(model.view().gamma, 0.8);
  model.noteDone({Kind::SET_MODE, "/learner", "training"}, true, "");
  std::vector<PanelRequest> made = model.takeRequests();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0].text, "gamma");
  model.noteDone(made[0], true, "");
  made = model.takeRequests();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_DOUBLE_EQ(made[0].number, 0.2);
}

TEST(PanelModel, changesAllLearnersAndTheTableOfTheShownAgent) {
  PanelModel model = present();
  for (const std::uint32_t agent : {0U, 1U, 2U})
    addLearner(model, learner("/learner_" + std::to_string(agent), {agent}));
  EXPECT_EQ(model.view().learner, PanelModel::ALL_LEARNERS);
  EXPECT_TRUE(model.view().can_share);
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

TEST(PanelModel, namesTheShownAgentWhenItsTableIsItsOwn) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1, 2}, true));
  model.takeChosenAgent(2);
  EXPECT_TRUE(model.view().can_share);
  model.saveTable("/tmp/table.txt");
  std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_DOUBLE_EQ(requests[0].number, 2.0);
  EXPECT_EQ(requests[0].text, "/tmp/table.txt");
  model.noteDone(requests[0], true, "saved");
  model.take(learner("/learner", {0, 1, 2}));  // one table now
  model.saveTable("/tmp/table.txt");
  requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_DOUBLE_EQ(requests[0].number, 0.0);
  model.noteDone(requests[0], true, "saved");
  model.take(learner("/learner", {0, 1, 2}, true));
  model.takeChosenAgent(7);  // nobody's
  model.saveTable("/tmp/table.txt");
  EXPECT_DOUBLE_EQ(model.takeRequests().at(0).number, 0.0);
}

TEST(PanelModel, greysOutALearnerThatIsAway) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0}));
  model.noteReachable("/learner", false);
  EXPECT_FALSE(model.view().has_learner);
  EXPECT_EQ(model.view().table, "/learner is away");
  model.setMode("training");
  EXPECT_TRUE(model.takeRequests().empty());
  model.noteReachable("/learner", true);
  EXPECT_TRUE(model.view().has_learner);
}

TEST(PanelModel, changesManyLearnersAlthoughFewAreWatched) {
  PanelModel model = present();
  for (std::uint32_t agent = 0; agent < 50; ++agent) model.take(learner("/learner_" + std::to_string(agent), {agent}));
  model.setMode("training");
  EXPECT_EQ(model.takeRequests().size(), 50U);
}

TEST(PanelModel, leavesOutLearnersThatAreAway) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0, 1}));
  model.noteReachable("/learner", false);
  addLearner(model, learner("/learner_1", {1}));
  model.takeChosenAgent(1);
  EXPECT_TRUE(model.view().has_learner);
  model.setMode("training");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner_1"});
  model.take(learner("/learner", {0, 1}));  // it is back
  model.setMode("demo");
  EXPECT_EQ(nodesOf(model.takeRequests()), std::vector<std::string>{"/learner"}) << "the other one is busy";
}

TEST(PanelModel, watchesFewOfManyLearners) {
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
}  // namespace crowd
