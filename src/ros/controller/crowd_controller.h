#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <social_crowd/LoadScenario.h>
#include <social_crowd/SaveScenario.h>
#include <social_crowd/StepRobots.h>

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/thread_pool.h"
#include "ros/controller/answer_collector.h"
#include "ros/controller/controller_diagnostics.h"
#include "ros/controller/controller_parameters.h"
#include "ros/controller/controller_status.h"
#include "ros/controller/crowd_broadcaster.h"
#include "ros/controller/recordings.h"
#include "ros/controller/result_log.h"
#include "ros/node/diagnostics_publisher.h"
#include "ros/node/main_loop.h"
#include "ros/node/reconfigure_server.h"
#include "ros/node/services.h"
#include "ros/robots/robot_interface.h"
#include "scenario/scenario.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Node that owns world, clock and episodes. In each tick it publishes perceptions, waits for the answers
/// (lockstep with a deadline) and moves the agents. docs/protocol.md describes the protocol.
class CrowdController final : private Decider {
 public:
  /// @throws InputError that lists invalid parameters or describes an error of the scenario file; FileError; Stopped
  /// if ROS shuts down meanwhile
  CrowdController(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Walks episodes until ~episodes are done, stop() is called, or ROS shuts down.
  void run();
  /// @brief Makes run() return soon. Thread-safe.
  void stop() { loop_.close(); }

 private:
  using Clock = ros::WallTime;

  /// Request to walk a number of ticks while paused.
  struct PendingSteps {
    std::uint32_t left = 0;
    std::promise<void> done;
    /// Called after the last of them, or after one that ends the episode, before the next episode begins.
    std::function<void(bool over)> observe;
  };

  void advertiseServices();
  void advertiseRobotServices();
  void advertiseScenarioServices();
  void addDiagnostics();
  void takeSample();

  /// Changes parameters while the crowd walks, for services and dynamic_reconfigure.
  void use(const ControllerParameters& parameters);
  /// @param scenarios their first scene can be made with the present seed
  void useScenarios(ScenarioList scenarios, const std::string& name);
  /// Replaces the map of the running episode and of all later ones; logs an error and changes nothing if it is invalid.
  void takeMap(const nav_msgs::OccupancyGrid& message);
  Scene nextScene() const;
  void restart(Recordings recordings);
  void beginEpisode();
  void endEpisode();
  void linger();
  void awaitShutdown(const Clock& deadline);

  void waitWhilePaused();
  bool mayWalk() const { return !parameters_.paused || pending_steps_ != nullptr; }
  /// Asks the learners, and waits for their answers and for commands of robots.
  bool decide(Episode& episode, std::vector<AgentAction>& actions) override;
  void endTick();
  /// Serves callbacks until `until`, or until the tick is cut off by a reset.
  void serveUntil(const Clock& until);
  /// The factor of real time that is kept at present; 0: as fast as possible.
  double presentFactor() const;
  void keepPace();
  void noteStep();
  void finishSteps();

  /// @return ready when the crowd has paused, or immediately if it is to walk
  std::future<void> pause(bool paused);
  void noteRest();
  std::future<void> beginSteps(std::uint32_t ticks, std::function<void(bool over)> observe = nullptr);
  /// Begins the steps of a request, whose response is complete when the result is ready.
  std::future<void> beginRobotSteps(const social_crowd::StepRobots::Request& request,
                                    const std::shared_ptr<social_crowd::StepRobots::Response>& response);
  /// Calls observe() of the steps that are pending, if this tick was the last of them.
  void observeSteps();
  /// Waits in a service thread; false after the timeout. @throws Error if the node shuts down first
  bool waitFor(const std::future<void>& done, std::chrono::milliseconds timeout) const;
  std::string place() const;
  social_crowd::ControllerStatus status() const;

  void loadScenario(const std::string& name, social_crowd::LoadScenario::Response& response);
  void saveScenario(const social_crowd::SaveScenario::Request& request, social_crowd::SaveScenario::Response& response);

  ControllerParameters parameters_;  // those of LiveParameters have the present values
  const DataFolder data_folder_;
  const std::string scenario_folder_;
  MainLoop loop_;
  const StopRequest stop_{[this] { return loop_.isClosed(); }};  // for ticks and preparations that take long
  ros::NodeHandle node_;
  AnswerCollector answers_;
  CrowdBroadcaster broadcaster_;
  std::string name_;  // of the node; its services are below it
  RobotInterface robots_;

  ScenarioList scenarios_;
  std::string scenario_name_;
  ros::Subscriber map_subscriber_;
  std::shared_ptr<const OccupancyMap> map_;  // from ~map_topic, in place of those of the scenarios; null: none so far
  std::vector<Segment> map_walls_;           // of this map
  std::uint64_t seed_;
  ThreadPool thread_pool_;  // used by the episode
  std::unique_ptr<Episode> episode_;
  std::uint64_t next_episode_ = 0;  // never repeats, so that an old answer cannot be mistaken for a new one
  std::uint64_t instance_ = 0;      // since the scenario was loaded or reset
  std::uint64_t ended_episodes_ = 0;
  std::vector<double> headings_;  // of the agents at the end of the last episode [rad]
  bool cut_off_ = false;          // the episode was replaced during a tick
  ResultLog results_;

  Clock next_tick_;
  std::uint64_t ticks_ = 0;      // walked since the start of the node
  std::uint64_t decisions_ = 0;  // executed since the start of the node
  std::unique_ptr<PendingSteps> pending_steps_;
  std::vector<std::promise<void>> waiting_for_rest_;

  std::optional<Recordings> recordings_;  // of the present scenario

  ControllerStatusPublisher status_;
  const LiveParameters<ControllerParameters> live_ = liveControllerParameters();
  ReconfigureServer reconfigure_;
  ControllerSample last_sample_;
  ControllerSample sample_;
  DiagnosticsPublisher diagnostics_;
  Services files_;     // those that read or write files, in a thread of their own
  Services services_;  // last member: its threads use all others
};

}  // namespace crowd
