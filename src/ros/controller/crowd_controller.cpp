#include "ros/controller/crowd_controller.h"

#include <algorithm>
#include <utility>

#include "common/files/files.h"
#include "common/text/quotes.h"
#include "maps/map_walls.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "ros/node/launch_end.h"
#include "scenario/reading/scenario_reader.h"

namespace crowd {
namespace {

constexpr unsigned SERVICE_THREADS = 3;
const ros::WallDuration FLUSH(0.25);       // until the last messages have left the process
const ros::WallDuration LAUNCH_END(20.0);  // until roslaunch has shut the node down
constexpr double MAX_LAG = 0.5;            // [s] behind real time; a larger lag is not caught up
constexpr double MAX_WAIT = 1e6;           // [s] for the next tick; ros::WallDuration holds no more than 68 years

}  // namespace

CrowdController::CrowdController(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(readControllerParameters(private_node)),
      data_folder_(parameters_.data_folder),
      scenario_folder_(parameters_.scenario_folder),
      node_(loop_.adopt(node)),
      answers_(loop_, node_, parameters_),
      broadcaster_(node_, parameters_),
      name_(private_node.getNamespace()),
      robots_(loop_, node_, parameters_, [this] { return broadcaster_.header().stamp; }),
      seed_(parameters_.seed),
      thread_pool_(parameters_.threads),
      status_(node_, [this] { return status(); }),
      reconfigure_(loop_.adopt(private_node), live_.descriptions(), live_.valuesOf(ControllerParameters()),
                   {[this] { return live_.valuesOf(parameters_); },
                    [this](const LiveChanges& changes) { use(live_.changed(parameters_, changes)); }}),
      diagnostics_(node_, private_node, parameters_.diagnostic_period, [this] { takeSample(); }),
      files_(private_node, 1),
      services_(private_node, SERVICE_THREADS) {
  ScenarioList scenarios = readScenarios(parameters_.scenarios, stop_);
  scenarios.scene(seed_, 0, stop_);
  useScenarios(std::move(scenarios), parameters_.name);
  advertiseServices();
  addDiagnostics();
  if (!parameters_.map_topic.empty()) {
    map_subscriber_ = node_.subscribe<nav_msgs::OccupancyGrid>(parameters_.map_topic, 1,
                                                               [this](const auto& message) { takeMap(*message); });
  }
}

void CrowdController::run() {
  files_.start();
  services_.start();
  try {
    while (!loop_.isClosed() && (parameters_.episodes == 0 || ended_episodes_ < parameters_.episodes)) {
      if (episode_->beginsTick()) waitWhilePaused();
      if (loop_.isClosed()) break;
      cut_off_ = false;
      if (episode_->walk(*this) && episode_->beginsTick()) endTick();
    }
  } catch (const Stopped&) {  // the node shuts down during a long tick
  }
  finishSteps();
  noteRest();
  linger();
  loop_.close();
}

void CrowdController::linger() {
  results_.logAll();
  // ROS does not report when a message has left the process.
  serveUntil(Clock::now() + FLUSH);
  if (parameters_.ends_launch && !loop_.isClosed() && endLaunch()) awaitShutdown(Clock::now() + LAUNCH_END);
}

void CrowdController::awaitShutdown(const Clock& deadline) {
  // Service calls must not end the node now: roslaunch would report its exit as the cause of the shutdown.
  while (!loop_.isClosed() && Clock::now() < deadline) loop_.run(IDLE);
}

void CrowdController::useScenarios(ScenarioList scenarios, const std::string& name) {
  // What can fail is done before anything is replaced.
  Recordings recordings(parameters_, name);
  for (const std::string& warning : scenarios.warnings()) ROS_WARN("%s", warning.c_str());
  scenarios_ = std::move(scenarios);
  scenario_name_ = name;
  restart(std::move(recordings));
}

void CrowdController::restart(Recordings recordings) {
  if (pending_steps_ != nullptr && pending_steps_->observe) finishSteps();  // robots of another episode would be driven
  instance_ = 0;
  headings_.clear();
  recordings_ = std::move(recordings);
  beginEpisode();
}

Scene CrowdController::nextScene() const {
  Scene scene = scenarios_.scene(seed_, instance_, stop_);
  keepHeadings(headings_, scene);
  scene.robot_metrics = parameters_.robot_metrics;
  if (map_ != nullptr) {
    scene.map = map_;
    scene.walls.resize(scene.own_walls);
    scene.walls.insert(scene.walls.end(), map_walls_.begin(), map_walls_.end());
  }
  return scene;
}

void CrowdController::takeMap(const nav_msgs::OccupancyGrid& message) {
  std::vector<Segment> map_walls;
  std::shared_ptr<const OccupancyMap> map;
  try {
    if (message.header.frame_id != names::MAP_FRAME && !message.header.frame_id.empty()) {
      throw InputError("header.frame_id: expected 'map', got " + inQuotes(message.header.frame_id));
    }
    map = std::make_shared<const OccupancyMap>(fromMessage(message));
    map_walls = traceWalls(*map);
    episode_->edit().replaceMap(map, map_walls);
  } catch (const Error& error) {
    ROS_ERROR("the map on %s is not used: %s", parameters_.map_topic.c_str(), error.what());
    return;
  }
  map_ = std::move(map);
  map_walls_ = std::move(map_walls);
  broadcaster_.publishWalls(*episode_);
  broadcaster_.publishMap(*episode_);
  ROS_INFO("map of %u x %u cells from %s: %zu walls", message.info.width, message.info.height,
           parameters_.map_topic.c_str(), map_walls_.size());
}

void CrowdController::beginEpisode() {
  cut_off_ = true;
  episode_ = std::make_unique<Episode>(nextScene(), next_episode_++, Vision(), thread_pool_, stop_);
  answers_.cancel();
  robots_.begin(*episode_);
  recordings_->begin();
  recordings_->record(instance_, *episode_);
  next_tick_ = Clock::now();
  broadcaster_.advanceClock(episode_->scene().tick_duration);
  robots_.publish(broadcaster_.header().stamp, true);
  broadcaster_.publishClock();
  broadcaster_.publishScenario(*episode_, instance_);
  broadcaster_.publishAgentsNow(*episode_);
  warnOfWays(episode_->result(), episode_->number(), "at its start");
}

void CrowdController::endEpisode() {
  broadcaster_.publishAgentsNow(*episode_);
  answers_.publishLast(*episode_, broadcaster_.header());
  EpisodeResult result = episode_->result();
  robots_.writeInput(result.robots);
  recordings_->finish();  // before the result: its subscribers may read the files
  broadcaster_.publishResult(result, episode_->number(), instance_, answers_.missedCount(), answers_.droppedCount());
  headings_ = result.headings();
  results_.add(result, episode_->number(), instance_, answers_);
  ++instance_;
  if (++ended_episodes_ != parameters_.episodes && robots_.awaitLast()) beginEpisode();
}

void CrowdController::waitWhilePaused() {
  while (!loop_.isClosed() && !mayWalk()) {
    broadcaster_.publishAgentsNow(*episode_);
    robots_.publishChanges();
    noteRest();
    loop_.run(IDLE);
    next_tick_ = Clock::now();
  }
}

bool CrowdController::decide(Episode& episode, std::vector<AgentAction>& actions) {
  answers_.ask(episode, broadcaster_.header());
  const bool begins_tick = episode.beginsTick();
  if (begins_tick) robots_.ask();
  // Published while the learners decide; between turns the tick is incomplete.
  if (begins_tick) broadcaster_.publishAgents(episode);
  if (!answers_.wait(episode)) return false;  // ask again, or another episode has begun, or the node shuts down
  if (begins_tick && !robots_.wait([&] { return broadcaster_.timeIn(episode.scene().tick_duration); })) return false;
  actions = answers_.answers();
  decisions_ += actions.size();
  return true;
}

void CrowdController::endTick() {
  ++ticks_;
  broadcaster_.advanceClock(episode_->scene().tick_duration);
  robots_.observe();
  robots_.publish(broadcaster_.header().stamp, false);
  broadcaster_.publishClock();
  recordings_->record(instance_, *episode_);
  keepPace();
  observeSteps();
  if (!cut_off_ && episode_->isOver()) endEpisode();
  noteStep();
}

void CrowdController::serveUntil(const Clock& until) {
  do {
    loop_.run(std::max(ros::WallDuration(0.0), std::min(IDLE, until - Clock::now())));
  } while (!loop_.isClosed() && !cut_off_ && Clock::now() < until);
}

double CrowdController::presentFactor() const {
  const double factor = parameters_.real_time_factor;
  // The controller of the robot can start or come back during the episode.
  const bool waits = (factor <= 0.0 || factor > 1.0) && robots_.commands().isAnyUnattended();
  return waits ? 1.0 : factor;
}

void CrowdController::use(const ControllerParameters& parameters) {
  if (parameters.real_time_factor != parameters_.real_time_factor) next_tick_ = Clock::now();
  const bool pauses = parameters.paused != parameters_.paused;
  parameters_ = parameters;
  if (pauses) pause(parameters.paused);
  status_.publish();
}

void CrowdController::keepPace() {
  const double factor = presentFactor();
  if (factor <= 0.0) return;
  next_tick_ += ros::WallDuration(std::min(episode_->scene().tick_duration / factor, MAX_WAIT));
  if ((Clock::now() - next_tick_).toSec() > MAX_LAG) next_tick_ = Clock::now();
  if (Clock::now() >= next_tick_) return;
  broadcaster_.publishAgents(*episode_);
  serveUntil(next_tick_);
}

void CrowdController::observeSteps() {
  if (pending_steps_ == nullptr || pending_steps_->observe == nullptr) return;
  const bool is_over = !cut_off_ && episode_->isOver();
  if (is_over) pending_steps_->left = 1;
  if (pending_steps_->left == 1) pending_steps_->observe(is_over);
}

void CrowdController::noteStep() {
  if (pending_steps_ != nullptr && --pending_steps_->left == 0) finishSteps();
}

void CrowdController::noteRest() {
  for (std::promise<void>& waiting : waiting_for_rest_) waiting.set_value();
  waiting_for_rest_.clear();
}

void CrowdController::finishSteps() {
  if (pending_steps_ == nullptr) return;
  robots_.endSteps();
  pending_steps_->done.set_value();
  pending_steps_.reset();
}

}  // namespace crowd
