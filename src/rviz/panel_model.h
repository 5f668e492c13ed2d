#pragma once

#include <social_crowd/ControllerStatus.h>
#include <social_crowd/LearnerStatus.h>

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rviz/panel_state.h"

namespace crowd {

/// @brief The logic of the panel, without Qt and a ROS master: what is enabled, what is shown, and which services are
/// to be called. Its owner reports what it receives, and makes the calls of takeRequests(). Not thread-safe.
///
/// A node is called for one request at a time; requests wait in order, and a newer request of the same kind replaces
/// the one that waits. Steps, which may take long, have an order of their own, so that the crowd can be paused
/// meanwhile.
class PanelModel {
 public:
  /// @brief Entry of the choice of learners that stands for all of them.
  static constexpr const char* ALL_LEARNERS = "all learners";

  /// @param controller, markers full names of the nodes
  PanelModel(std::string controller, std::string markers);

  const std::string& controller() const { return controller_; }

  // What the owner receives. Times are seconds of a steady clock.
  void take(const social_crowd::ControllerStatus& status, double now);
  void take(const social_crowd::LearnerStatus& learner);
  void takeChosenAgent(std::int64_t agent) { chosen_agent_ = agent; }
  /// @param data_folder in which the controller reads and writes files
  void takeScenarios(std::vector<std::string> names, std::string data_folder) {
    scenarios_ = std::move(names);
    data_folder_ = std::move(data_folder);
  }
  /// @brief Folder in which the controller reads and writes files; empty: not known yet.
  const std::string& dataFolder() const { return data_folder_; }
  /// @brief Reports whether a node can be called.
  void noteReachable(const std::string& node, bool reachable);
  /// @brief Reports the end of a request.
  void noteDone(const PanelRequest& request, bool success, const std::string& message);
  /// @brief Nodes about which noteReachable() is to be called.
  std::vector<std::string> watchedNodes() const;

  // What the user wants. Wishes to nodes that are away are ignored.
  void play() { ask({PanelRequest::Kind::PAUSE, controller_, {}, 0.0, false}); }
  void pause() { ask({PanelRequest::Kind::PAUSE, controller_, {}, 0.0, true}); }
  void step(int ticks) { ask({PanelRequest::Kind::STEP, controller_, {}, static_cast<double>(ticks)}); }
  void reset() { ask({PanelRequest::Kind::RESET, controller_}); }
  void setSpeed(double factor) { ask({PanelRequest::Kind::SET_SPEED, controller_, {}, factor}); }
  void loadScenario(const std::string& name) { ask({PanelRequest::Kind::LOAD_SCENARIO, controller_, name}); }
  /// @param overwrite whether the user wants a file of that name to be replaced
  void saveScenario(const std::string& file, bool overwrite) {
    ask({PanelRequest::Kind::SAVE_SCENARIO, controller_, file, 0.0, overwrite});
  }
  void chooseAgent(std::int64_t agent) {
    ask({PanelRequest::Kind::CHOOSE_AGENT, markers_, {}, static_cast<double>(agent)});
  }
  /// @param entry of PanelView::learners
  void chooseLearner(const std::string& entry) { learner_ = entry; }
  /// @brief The entry that the user chose; empty: none.
  const std::string& chosenLearner() const { return learner_; }
  void setMode(const std::string& mode);
  /// @param name epsilon, alpha or gamma
  void setParameter(const std::string& name, double value);
  /// @param overwrite as of saveScenario()
  void saveTable(const std::string& file, bool overwrite);
  void loadTable(const std::string& file);
  /// @brief Gives the table of the chosen agent to all agents. @param method replace or merge
  void shareTable(const std::string& method);

  /// @brief Requests that are to be made now.
  std::vector<PanelRequest> takeRequests();
  /// @param now seconds of the clock of take()
  PanelView view(double now) const;

 private:
  void ask(PanelRequest request);
  void askLearners(const PanelRequest& request);
  void askTables(PanelRequest request);
  bool isReachable(const std::string& node) const { return reachable_.count(node) > 0; }
  bool isPending(PanelRequest::Kind kind) const;
  /// The newest unfinished request of this kind and node, and with this text unless it is empty; null: none.
  const PanelRequest* findPending(const PanelRequest& like) const;
  /// The number that such a request asks for; without one, the present value.
  double wanted(const PanelRequest& like, double present) const;
  void dropRequests(const std::string& node);
  /// Learners that the chosen entry stands for; without those that are away, if others are there.
  std::vector<const social_crowd::LearnerStatus*> learners() const;
  /// The one of these whose tables are meant; null: none.
  const social_crowd::LearnerStatus* tableLearner() const;
  /// Number of the agent whose table is meant, as services expect it.
  double tableAgent() const;
  std::string learnerEntry() const;
  /// Decisions per second of the last seconds.
  double decisionRate(double now) const;
  std::string stateText() const;
  void showController(PanelView& view, double now) const;
  void showLearner(PanelView& view) const;

  std::string controller_;
  std::string markers_;
  social_crowd::ControllerStatus status_;
  bool has_status_ = false;  // a paused controller publishes its status once, so it is kept while the node is away
  std::map<std::string, social_crowd::LearnerStatus> learners_;  // by node
  std::string learner_;                                          // entry that the user chose
  std::int64_t chosen_agent_ = -1;
  std::vector<std::string> scenarios_;
  std::string data_folder_;
  std::set<std::string> reachable_;
  std::deque<std::pair<double, std::uint64_t>> decisions_;  // times and counts of the last seconds
  std::vector<PanelRequest> waiting_;
  std::vector<PanelRequest> running_;
  std::string message_;
  bool is_error_ = false;
};

}  // namespace crowd
