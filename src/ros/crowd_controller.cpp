#include "social_crowd/ros/crowd_controller.h"

#include <algorithm>
#include <utility>

#include "social_crowd/common/files.h"
#include "social_crowd/ros/names.h"
#include "social_crowd/ros/tick_subscriber.h"
#include "social_crowd/world/scenario_reader.h"

namespace crowd {
namespace {

constexpr unsigned SERVICE_THREADS = 3;
constexpr std::uint32_t QUEUE = 1000;         // messages; many learners may answer at once
const ros::WallDuration IDLE(0.1);            // between two looks whether ROS still runs
const ros::WallDuration WARNING_PERIOD(5.0);  // of the warning that nobody answers
const ros::WallDuration REPEAT(0.5);          // of perceptions for learners that never answered
const ros::WallDuration FLUSH(0.25);          // for the last messages to leave the process
constexpr double MAX_LAG = 0.5;               // [s] behind real time that are made up for

std::string listOf(const std::vector<AgentId>& agents) {
  constexpr std::size_t MOST = 10;
  std::string text;
  for (std::size_t i = 0; i < agents.size() && i < MOST; ++i) text += (i > 0 ? ", " : "") + std::to_string(agents[i]);
  return agents.size() > MOST ? text + " and " + std::to_string(agents.size() - MOST) + " more" : text;
}

}  // namespace

CrowdController::CrowdController(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(readControllerParameters(private_node)),
      node_(loop_.adopt(node)),
      broadcaster_(node_, parameters_),
      seed_(parameters_.seed),
      lockstep_(parameters_.misses_until_absent),
      paused_(parameters_.paused),
      services_(private_node, SERVICE_THREADS) {
  useScenarios(readScenarios(parameters_.scenarios), parameters_.name);
  actions_ = subscribeToTicks<ActionsMessage>(node_, names::ACTIONS, QUEUE,
                                              [this](const auto& message) { takeActions(message); });
  advertiseServices();
}

void CrowdController::takeActions(const ActionsMessage::ConstPtr& message) {
  // Answers are latched: a learner may still hold one to a controller that was here before.
  if (message->run == broadcaster_.run()) {
    lockstep_.take(message->content);
  } else {
    lockstep_.drop(message->content);
  }
}

void CrowdController::run() {
  services_.start();
  while (!loop_.isClosed() && (parameters_.episodes == 0 || ended_episodes_ < parameters_.episodes)) {
    if (tick_ended_) waitWhilePaused();
    if (!loop_.isClosed()) walkTurn();
  }
  finishSteps();
  noteRest();
  linger();
  loop_.close();
}

void CrowdController::linger() {
  if (figures_.episodes() > 1) {
    ROS_INFO(
        "%lu episodes: success %.2f %%, contact %.2f %%, collision %.2f %%, clean %.1f %%, path ratio %.3f, time ratio "
        "%.3f",
        static_cast<unsigned long>(figures_.episodes()), figures_.successPercent(), figures_.contactPercent(),
        figures_.collisionPercent(), figures_.cleanPercent(), figures_.pathRatio(), figures_.timeRatio());
  }
  // ROS does not tell when a message has left the process.
  serveUntil(Clock::now() + FLUSH);
}

void CrowdController::useScenarios(ScenarioList scenarios, const std::string& name) {
  // All that can fail comes before anything is replaced.
  scenarios.scene(seed_, 0);
  std::optional<TrajectoryFile> recording = beginRecording(name);
  scenarios_ = std::move(scenarios);
  scenario_name_ = name;
  restart(std::move(recording));
}

std::optional<TrajectoryFile> CrowdController::beginRecording(const std::string& name) const {
  if (parameters_.trajectories.empty()) return std::nullopt;
  return TrajectoryFile(parameters_.trajectories, name);
}

void CrowdController::restart(std::optional<TrajectoryFile> recording) {
  instance_ = 0;
  headings_.clear();
  trajectory_file_ = std::move(recording);
  beginEpisode();
}

void CrowdController::beginEpisode() {
  cut_off_ = true;
  tick_ended_ = true;
  Scene scene = scenarios_.scene(seed_, instance_);
  keepHeadings(headings_, scene);
  episode_ = std::make_unique<Episode>(std::move(scene), next_episode_++, parameters_.vision);
  lockstep_.resetCounts();
  trajectory_.clear();
  if (trajectory_file_) appendTrajectoryRows(instance_, episode_->world(), trajectory_);
  next_tick_ = Clock::now();
  broadcaster_.advanceClock(episode_->scene().tick_duration);
  broadcaster_.publishScenario(*episode_, instance_);
  broadcaster_.tellAgentsNow(*episode_);
}

void CrowdController::endEpisode() {
  broadcaster_.tellAgentsNow(*episode_);
  broadcaster_.publishPerceptions(*episode_);  // the last ones: learners learn from them and do not answer
  broadcaster_.publishResult(*episode_, instance_, lockstep_.missedCount(), lockstep_.droppedCount());
  const EpisodeResult result = episode_->result();
  figures_.add(result);
  headings_ = result.headings();
  logResult(result);
  if (trajectory_file_) trajectory_file_->append(trajectory_);
  ++instance_;
  if (++ended_episodes_ != parameters_.episodes) beginEpisode();
}

void CrowdController::logResult(const EpisodeResult& result) {
  Figures figures;
  figures.add(result);
  ROS_INFO(
      "episode %lu (%s, instance %lu): %lu ticks, %zu of %zu agents arrived, %zu in contact, %zu in collision, path "
      "ratio %.3f, "
      "time ratio %.3f, %lu answers missed, %lu dropped",
      static_cast<unsigned long>(episode_->number()), result.scenario.c_str(), static_cast<unsigned long>(instance_),
      static_cast<unsigned long>(result.ticks), result.arrivedCount(), result.agentCount(), result.touchedCount(),
      result.collidedCount(), figures.pathRatio(), figures.timeRatio(),
      static_cast<unsigned long>(lockstep_.missedCount()), static_cast<unsigned long>(lockstep_.droppedCount()));
}

void CrowdController::waitWhilePaused() {
  while (!loop_.isClosed() && !mayWalk()) {
    broadcaster_.tellAgentsNow(*episode_);
    noteRest();
    loop_.run(IDLE);
    next_tick_ = Clock::now();
  }
}

void CrowdController::walkTurn() {
  cut_off_ = false;
  std::vector<AgentId> asked;
  for (const AgentPerception& self : episode_->perceptions().agents) {
    if (!self.arrived) asked.push_back(self.agent);
  }
  lockstep_.open(episode_->number(), episode_->perceptions().tick, asked);
  broadcaster_.publishPerceptions(*episode_);
  if (tick_ended_) broadcaster_.tellAgents(*episode_);  // while learners decide; between turns it is half of a tick
  next_repeat_ = Clock::now() + REPEAT;
  awaitAnswers();
  if (cut_off_ || loop_.isClosed()) return;  // another episode has begun
  lockstep_.close();
  tick_ended_ = episode_->step(lockstep_.answers());
  if (tick_ended_) endTick();
}

void CrowdController::endTick() {
  broadcaster_.advanceClock(episode_->scene().tick_duration);
  if (trajectory_file_) appendTrajectoryRows(instance_, episode_->world(), trajectory_);
  keepPace();
  if (!cut_off_ && episode_->isOver()) endEpisode();
  noteStep();
}

std::vector<AgentId> CrowdController::activeAgents() const {
  std::vector<AgentId> active;
  for (const Agent& agent : episode_->world().agents()) {
    if (agent.isWalking()) active.push_back(agent.id);
  }
  return active;
}

void CrowdController::awaitAnswers() {
  const Clock since = Clock::now();
  if (lockstep_.isDeserted() && lockstep_.areAbsent(activeAgents())) return awaitSomebody(since);
  const Clock deadline = since + ros::WallDuration(parameters_.answer_deadline);
  while (!loop_.isClosed() && !cut_off_ && !lockstep_.isComplete()) {
    const Clock now = Clock::now();
    repeatForNewcomers();
    if (now >= deadline) {
      if (!lockstep_.awaitsNewcomer()) return;
      return awaitNewcomers(since);
    }
    loop_.run(std::min(IDLE, deadline - now));
  }
}

void CrowdController::repeatForNewcomers() {
  // roscpp may lose a latched message that is published in the very moment in which somebody connects.
  const Clock now = Clock::now();
  if (now < next_repeat_ || !lockstep_.awaitsNewcomer()) return;
  broadcaster_.repeatPerceptions();
  next_repeat_ = now + REPEAT;
}

void CrowdController::awaitNewcomers(const Clock& since) {
  const Clock deadline = since + ros::WallDuration(parameters_.start_deadline);
  while (!loop_.isClosed() && !cut_off_ && lockstep_.awaitsNewcomer()) {
    warnOfSilence(since);
    repeatForNewcomers();
    if (Clock::now() >= deadline) return lockstep_.giveUpOnNewcomers(activeAgents());
    loop_.run(std::min(IDLE, deadline - Clock::now()));
  }
}

void CrowdController::awaitSomebody(const Clock& since) {
  // With nobody left to wait for, a tick lasts as long as in real time: the episode neither hangs nor rushes by.
  const double turn = episode_->scene().tick_duration / static_cast<double>(episode_->turnsOfTick());
  const double seconds = std::min(parameters_.answer_deadline, turn);
  const Clock deadline = since + ros::WallDuration(seconds);
  while (!loop_.isClosed() && !cut_off_ && lockstep_.isDeserted() && Clock::now() < deadline) {
    warnOfSilence(since);
    loop_.run(std::min(IDLE, deadline - Clock::now()));
  }
}

void CrowdController::warnOfSilence(const Clock& since) {
  const Clock now = Clock::now();
  if (now - last_warning_ < WARNING_PERIOD) return;
  last_warning_ = now;
  const std::string topic = actions_.getTopic();
  const std::string reason = actions_.getNumPublishers() == 0
                                 ? "no learner is there (nobody publishes on '" + topic + "')"
                                 : "their learners on '" + topic + "' are silent";
  ROS_WARN("nobody answers for agent %s since %.1f s: %s; without an answer they stay where they are",
           listOf(lockstep_.missing()).c_str(), (now - since).toSec(), reason.c_str());
}

void CrowdController::serveUntil(const Clock& until) {
  do {
    loop_.run(std::max(ros::WallDuration(0.0), std::min(IDLE, until - Clock::now())));
  } while (!loop_.isClosed() && !cut_off_ && Clock::now() < until);
}

void CrowdController::keepPace() {
  if (parameters_.pace <= 0.0) return;
  next_tick_ += ros::WallDuration(episode_->scene().tick_duration / parameters_.pace);
  if ((Clock::now() - next_tick_).toSec() > MAX_LAG) next_tick_ = Clock::now();
  if (Clock::now() >= next_tick_) return;
  broadcaster_.tellAgents(*episode_);
  serveUntil(next_tick_);
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
  pending_steps_->done.set_value();
  pending_steps_.reset();
}

}  // namespace crowd
