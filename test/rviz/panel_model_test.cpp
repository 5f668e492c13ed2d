#include "rviz/panel_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/panels.h"

namespace crowd::panel_model_test {
namespace {

using namespace panels;  // NOLINT(google-build-using-namespace): all of it is for these tests
using Kind = PanelRequest::Kind;

TEST(PanelModel, enablesNothingBeforeNodesAreThere) {
  PanelModel model(CONTROLLER, MARKERS);
  const PanelView view = model.view(NOW);
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
  EXPECT_EQ(model.view(NOW).state, "waiting for /crowd_controller");
  EXPECT_FALSE(model.view(NOW).has_controller);
}

TEST(PanelModel, offersPauseWhileWalkingAndPlayAndStepWhilePaused) {
  PanelModel model = present();
  model.take(walking(), 0.0);
  PanelView view = model.view(NOW);
  EXPECT_TRUE(view.has_controller && view.can_pause);
  EXPECT_FALSE(view.can_play || view.can_step);
  EXPECT_EQ(view.state, "walking");
  model.take(paused(), 0.1);
  view = model.view(NOW);
  EXPECT_TRUE(view.can_play && view.can_step);
  EXPECT_FALSE(view.can_pause);
  EXPECT_EQ(view.state, "paused");
}

TEST(PanelModel, greysOutWhileTheControllerIsAwayAndComesBackWithIt) {
  PanelModel model = present();
  model.take(paused(), 0.0);
  model.noteReachable(CONTROLLER, false);
  EXPECT_FALSE(model.view(NOW).has_controller);
  EXPECT_TRUE(model.view(NOW).has_markers);
  model.noteReachable(CONTROLLER, true);
  EXPECT_TRUE(model.view(NOW).can_step) << "a paused controller does not publish the same status again";
  model.take(walking(), 1.0);
  EXPECT_TRUE(model.view(NOW).can_pause);
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
  EXPECT_EQ(model.view(NOW).message, "gone");
  EXPECT_TRUE(model.view(NOW).is_error);
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
  EXPECT_DOUBLE_EQ(model.view(NOW).speed, 4.0) << "what the user wants, until it is answered";
  model.noteDone(first[0], true, "done");
  const std::vector<PanelRequest> second = model.takeRequests();
  ASSERT_EQ(second.size(), 1U);
  EXPECT_DOUBLE_EQ(second[0].number, 4.0);
  model.noteDone(second[0], false, "refused");
  EXPECT_DOUBLE_EQ(model.view(NOW).speed, 1.0) << "the present value after a refusal";
  const std::vector<PanelRequest> third = model.takeRequests();
  ASSERT_EQ(third.size(), 1U);
  EXPECT_EQ(third[0].kind, Kind::PAUSE);
  EXPECT_TRUE(third[0].flag);
}

TEST(PanelModel, savesAllFilesThatWereAskedForWhileACallIsInProgress) {
  PanelModel model = present();
  model.reset();
  PanelRequest running = model.takeRequests().at(0);
  for (const char* const file : {"a.yaml", "b.yaml", "b.yaml"}) model.saveScenario(file, false);
  std::vector<std::string> saved;
  while (true) {
    model.noteDone(running, true, "");
    const std::vector<PanelRequest> requests = model.takeRequests();
    if (requests.empty()) break;
    running = requests.at(0);
    if (running.kind == Kind::SAVE_SCENARIO) saved.push_back(running.text);
  }
  EXPECT_EQ(saved, (std::vector<std::string>{"a.yaml", "b.yaml"}));
}

TEST(PanelModel, replacesAFileOnlyIfTheUserWantsThat) {
  PanelModel model = present();
  addLearner(model, learner("/learner", {0}));
  for (const bool overwrite : {false, true}) {
    model.saveScenario("a.yaml", overwrite);
    model.saveTable("a.txt", overwrite);
    const std::vector<PanelRequest> requests = model.takeRequests();
    ASSERT_EQ(requests.size(), 2U);
    for (const PanelRequest& request : requests) {
      EXPECT_EQ(request.flag, overwrite);
      model.noteDone(request, false, "");
    }
  }
}

TEST(PanelModel, knowsTheFolderOfTheFilesOfTheController) {
  PanelModel model = present();
  EXPECT_EQ(model.dataFolder(), "");
  model.takeScenarios({"circle6"}, "/home/ada/.ros/social_crowd");
  EXPECT_EQ(model.dataFolder(), "/home/ada/.ros/social_crowd");
}

TEST(PanelModel, saysThatAWaitingSaveIsNotDoneWhenItsNodeGoesAway) {
  PanelModel model = present();
  model.reset();
  ASSERT_EQ(model.takeRequests().size(), 1U);
  model.saveScenario("a.yaml", false);
  model.noteReachable(CONTROLLER, false);
  EXPECT_EQ(model.view(NOW).message, "a.yaml is not saved: /crowd_controller is away");
  EXPECT_TRUE(model.view(NOW).is_error);
}

TEST(PanelModel, pausesWhileStepsAreInProgress) {
  PanelModel model = present();
  model.take(paused(), 0.0);
  model.step(1000);
  const std::vector<PanelRequest> steps = model.takeRequests();
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_DOUBLE_EQ(steps[0].number, 1000.0);
  EXPECT_FALSE(model.view(NOW).can_step);
  EXPECT_EQ(model.view(NOW).state, "stepping");
  model.play();
  EXPECT_EQ(model.takeRequests().size(), 1U);
  model.noteDone(steps[0], true, "now at episode 0, tick 1000");
  EXPECT_TRUE(model.view(NOW).can_step);
  EXPECT_EQ(model.view(NOW).message, "now at episode 0, tick 1000");
}

TEST(PanelModel, showsCountsAndRates) {
  PanelModel model = present();
  ControllerStatus info = walking();
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
  const PanelView view = model.view(10.5);
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
  ControllerStatus info = paused();
  model.take(info, 0.0);
  info.decisions = 100;
  model.take(info, 1.0);
  EXPECT_EQ(model.view(1.0).decisions, "0");
  model.step(5);
  EXPECT_EQ(model.view(1.0).decisions, "100");
}

TEST(PanelModel, countsDecisionsOfTheLastSecondsOnly) {
  PanelModel model = present();
  ControllerStatus info = walking();
  for (const auto& [now, decisions] :
       std::vector<std::pair<double, std::uint64_t>>{{0, 0}, {1, 1000}, {2, 1000}, {3, 1000}}) {
    info.decisions = decisions;
    model.take(info, now);
  }
  EXPECT_EQ(model.view(3.0).decisions, "0");
  info.decisions = 3;  // the controller was restarted
  model.take(info, 3.1);
  EXPECT_EQ(model.view(3.2).decisions, "0");
}

TEST(PanelModel, countsNoDecisionsWhenTheStatusStopsChanging) {
  PanelModel model = present();
  ControllerStatus info = walking();
  model.take(info, 0.0);
  info.decisions = 100;
  model.take(info, 1.0);
  EXPECT_EQ(model.view(1.0).decisions, "100");
  EXPECT_EQ(model.view(2.0).decisions, "50");
  EXPECT_EQ(model.view(3.1).decisions, "0");
}

TEST(PanelModel, shortensLongListsOfAgents) {
  PanelModel model = present();
  ControllerStatus info = walking();
  for (std::uint32_t agent = 0; agent < 1000; ++agent) info.unanswered.push_back(agent);
  model.take(info, 0.0);
  EXPECT_EQ(model.view(NOW).missing, "0, 1, 2, 3, 4 and 995 more");
}

TEST(PanelModel, asksForScenariosAgainWhenAFileIsSavedAndAfterARestart) {
  PanelModel model = present();
  ControllerStatus status = walking();
  status.episode = 3;
  model.take(status, 0.0);
  model.saveScenario("/tmp/floor.yaml", false);
  const std::vector<PanelRequest> saves = model.takeRequests();
  ASSERT_EQ(saves.size(), 1U);
  model.noteDone(saves[0], true, "saved");
  std::vector<PanelRequest> requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].kind, Kind::LIST_SCENARIOS);
  model.noteDone(requests[0], true, "");
  EXPECT_EQ(model.view(NOW).message, "saved");
  model.take(status, 0.1);
  EXPECT_TRUE(model.takeRequests().empty());
  status.episode = 0;  // of another node of the same name
  model.take(status, 0.2);
  requests = model.takeRequests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].kind, Kind::LIST_SCENARIOS);
}

}  // namespace
}  // namespace crowd::panel_model_test
