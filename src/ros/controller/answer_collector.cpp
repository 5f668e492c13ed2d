#include "ros/controller/answer_collector.h"

#include <ros/master.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "ros/messages/agent_list.h"
#include "ros/messages/motion_fields.h"
#include "ros/messages/names.h"
#include "ros/messages/tick_subscriber.h"
#include "ros/messages/topic_defaults.h"
#include "ros/messages/topic_publishers.h"
#include "ros/messages/vision.h"

namespace crowd {
namespace {

const ros::WallDuration WARNING_PERIOD(5.0);   // of warnings about missing answers
constexpr double SILENCE_LIMIT = 1.0;          // [s]
constexpr double USUAL_START = 3.0;            // [s] of a learner, without a warning
const ros::WallDuration FIRST_ASK_AGAIN(0.1);  // doubled each time

std::vector<AgentId> agentsToAsk(const Perceptions& perceptions) {
  std::vector<AgentId> agents;
  for (const AgentPerception& self : perceptions.agents) {
    if (!self.arrived) agents.push_back(self.agent);
  }
  return agents;
}

std::vector<AgentId> walkingAgents(const World& world) {
  std::vector<AgentId> walking;
  for (const Agent& agent : world.agents()) {
    if (agent.isWalking()) walking.push_back(agent.id);
  }
  return walking;
}

std::uint8_t motionSourceOf(const Episode& episode) {
  if (episode.scene().motion) return social_crowd::Perceptions::MOTION_OF_SCENARIO;
  return episode.vision().motion ? social_crowd::Perceptions::MOTION_OF_LEARNERS
                                 : social_crowd::Perceptions::MOTION_UNKNOWN;
}

}  // namespace

AnswerCollector::AnswerCollector(MainLoop& loop, ros::NodeHandle& node, const ControllerParameters& parameters)
    : parameters_(parameters),
      run_(ros::WallTime::now().toNSec()),  // no two controllers start in the same nanosecond
      loop_(loop),
      lockstep_(parameters.misses_until_absent),
      learners_(run_),
      perceptions_(node),
      actions_(subscribeToTicks<ActionsMessage>(node, names::ACTIONS, LONG_QUEUE,
                                                [this](const auto& event) { take(event); })),
      status_(node.subscribe(names::LEARNER_STATUS, LONG_QUEUE, &AnswerCollector::takeStatus, this)) {}

void AnswerCollector::take(const ros::MessageEvent<const ActionsMessage>& event) {
  const ActionsMessage& message = *event.getMessage();
  const std::string& node = event.getPublisherName();
  const LearnerId learner = learners_.numberOf(message.node.empty() ? node : message.node, node);
  const RunCheck run = learners_.checkRun(message.run, learner);
  if (run == RunCheck::OTHER) lockstep_.drop(message.content);
  if (run != RunCheck::OWN) return;
  perceptions_.markHeard(node);
  const std::vector<RefusedAnswer>& refused = lockstep_.take(message.content, learner);
  for (const RefusedAnswer& answer : refused) earlier_.late += answer.cause == Refusal::TOO_LATE ? 1 : 0;
  if (refused.size() < message.content.agents.size()) {
    learners_.noteTaken(learner);
    deciding_.insert(message.node.empty() ? node : message.node);
  }
  if (!refused.empty()) learners_.noteRefused(refused);
}

void AnswerCollector::takeStatus(const ros::MessageEvent<const social_crowd::LearnerStatus>& event) {
  const social_crowd::LearnerStatus& status = *event.getMessage();
  const Vision vision{status.vision_radius, status.max_neighbours, status.occlusion != 0,
                      wallDistanceOf(status.wall_distance),
                      fromFields({status.acceleration, status.braking, status.turn_rate})};
  const std::string& learner = status.node.empty() ? event.getPublisherName() : status.node;
  perceptions_.useTopicOf(learner, status);
  visions_.report(learner, vision);
  if (asked_episode_ != nullptr && !covers(asked_episode_->vision(), visions_.widest())) askWithWiderVision();
}

void AnswerCollector::useWidestVision(Episode& episode) {
  if (areEqual(episode.vision(), visions_.widest())) return;
  episode.setVision(visions_.widest());
}

void AnswerCollector::askWithWiderVision() {
  const MotionLimits before = asked_episode_->world().motion();
  useWidestVision(*asked_episode_);
  // A service may have added or removed agents since the turn began: then ask() has to be called again.
  // Answers that were given with other motion limits are not valid any more.
  is_outdated_ = agentsToAsk(asked_episode_->perceptions()) != asked_ || !(asked_episode_->world().motion() == before);
  if (!is_outdated_) perceptions_.publish(toMessage(*asked_episode_, header_), true);
}

PerceptionsMessage::ConstPtr AnswerCollector::toMessage(Episode& episode, const std_msgs::Header& header) const {
  const auto message = boost::make_shared<PerceptionsMessage>();
  message->header = header;
  message->run = run_;
  message->vision = episode.vision();
  message->motion_source = motionSourceOf(episode);
  message->vision.motion = requestOf(message->motion_source, episode.world().motion());
  message->shared = episode.sharedPerceptions();
  return message;
}

void AnswerCollector::ask(Episode& episode, const std_msgs::Header& header) {
  cancelled_ = false;
  is_outdated_ = false;
  asked_episode_ = &episode;
  header_ = header;
  useWidestVision(episode);
  asked_ = agentsToAsk(episode.perceptions());
  lockstep_.setMissesUntilAbsent(parameters_.misses_until_absent);
  lockstep_.open(episode.number(), episode.perceptions().tick, asked_);
  perceptions_.publish(toMessage(episode, header), true);
  asked_at_ = Clock::now();
  silent_since_.follow(episode.world().agents());
  noteSilence(asked_);
  ask_again_after_ = FIRST_ASK_AGAIN;
  ask_again_at_ = asked_at_ + ask_again_after_;
}

bool AnswerCollector::wait(const Episode& episode) {
  if (lockstep_.isDeserted() && lockstep_.areAbsent(walkingAgents(episode.world()))) {
    awaitAny(episode);
  } else {
    awaitPresent();
    awaitNewcomers(episode);
  }
  endWait();
  if (isInterrupted()) return false;
  warnOfAbsence(lockstep_.close());
  noteAnswers();
  return true;
}

void AnswerCollector::endWait() {
  perceptions_.endWait();
  asked_episode_ = nullptr;
}

void AnswerCollector::cancel() {
  cancelled_ = true;
  endWait();
  visions_.keepMotionOf(std::exchange(deciding_, {}));
  earlier_ = totals();
  lockstep_.resetCounts();
}

AnswerCounts AnswerCollector::totals() const {
  return {earlier_.missed + missedCount(), earlier_.dropped + droppedCount(), earlier_.late};
}

void AnswerCollector::publishLast(Episode& episode, const std_msgs::Header& header) {
  useWidestVision(episode);
  perceptions_.publish(toMessage(episode, header), false);
}

void AnswerCollector::serveUntil(const Clock& deadline) {
  loop_.run(std::max(ros::WallDuration(0.0), std::min(IDLE, deadline - Clock::now())));
}

void AnswerCollector::awaitPresent() {
  const auto deadline = [this] { return deadlineOf(parameters_.answer_deadline); };
  while (!isInterrupted() && !lockstep_.isComplete() && Clock::now() < deadline()) {
    askAgain();
    serveUntil(deadline());
  }
}

void AnswerCollector::awaitNewcomers(const Episode& episode) {
  const auto deadline = [this] { return deadlineOf(parameters_.start_deadline); };
  while (!isInterrupted() && lockstep_.awaitsNewcomer()) {
    warnOfSilence();
    askAgain();
    if (Clock::now() >= deadline()) return giveUpOnNewcomers(episode);
    serveUntil(deadline());
  }
}

void AnswerCollector::giveUpOnNewcomers(const Episode& episode) {
  const std::vector<AgentId> agents = lockstep_.giveUpOnNewcomers(walkingAgents(episode.world()));
  noteSilence(agents);  // in a sequential scenario some have not had a turn yet
  warnOfAbsence(agents);
}

void AnswerCollector::awaitAny(const Episode& episode) {
  // If all agents are absent, a tick lasts as long as in real time, so that learners can come back during the episode.
  const double turn = episode.scene().tick_duration / static_cast<double>(episode.turnsOfTick());
  const Clock deadline = deadlineOf(std::min(parameters_.answer_deadline, turn));
  while (!isInterrupted() && lockstep_.isDeserted() && Clock::now() < deadline) {
    warnOfSilence();
    serveUntil(deadline);
  }
}

void AnswerCollector::askAgain() {
  if (Clock::now() < ask_again_at_ || !lockstep_.awaitsNewcomer()) return;
  const std::optional<TopicNodes> nodes = nodesOf(actions_.getTopic());
  if (nodes && perceptions_.isAnyUnheard(nodes->publishers)) perceptions_.publishAgain();
  ask_again_after_ += ask_again_after_;
  ask_again_at_ = Clock::now() + ask_again_after_;
}

void AnswerCollector::noteSilence(const std::vector<AgentId>& asked) {
  for (const AgentId agent : asked) {
    Clock& since = silent_since_.add(agent);
    if (since.isZero()) since = asked_at_;
  }
}

void AnswerCollector::noteAnswers() {
  for (const AgentAction& answer : lockstep_.answers()) silent_since_[answer.agent] = Clock();
}

double AnswerCollector::silence(const std::vector<AgentId>& agents) const {
  Clock since = Clock::now();
  const Clock now = since;
  for (const AgentId agent : agents) since = std::min(since, silent_since_[agent]);
  return (now - since).toSec();
}

std::vector<AgentId> AnswerCollector::unanswered(const World& world) const {
  std::vector<AgentId> agents = walkingAgents(world);
  const Clock limit = Clock::now() - ros::WallDuration(SILENCE_LIMIT);
  const auto is_answered = [&](AgentId agent) {
    const Clock* const since = silent_since_.find(agent);
    return since == nullptr || since->isZero() || *since > limit;
  };
  agents.erase(std::remove_if(agents.begin(), agents.end(), is_answered), agents.end());
  return agents;
}

std::string AnswerCollector::reasonForSilence() const {
  const std::string topic = actions_.getTopic();
  const std::optional<TopicNodes> nodes = nodesOf(topic);
  if (nodes && nodes->has_this_node) return learners_.reasonForSilence(nodes->publishers, topic);
  // The learners are not the cause: those that were started after the master cannot connect.
  const std::string cause = "the ROS master at " + ros::master::getURI() +
                            (nodes ? " does not know this node yet, as after a new roscore" : " does not answer");
  const std::vector<std::string> known = learners_.nodes();
  return known.empty() ? cause : cause + "; " + learners_.reasonForSilence(known, topic);
}

void AnswerCollector::warnOfSilence() {
  const Clock now = Clock::now();
  if (now - last_warning_ < WARNING_PERIOD) return;
  const std::vector<AgentId> missing = lockstep_.missing();
  if (silence(missing) < USUAL_START) return;
  last_warning_ = now;
  ROS_WARN("no answer for %s for %.1f s: %s. They stay in place", namedAgents(missing).c_str(), silence(missing),
           reasonForSilence().c_str());
}

void AnswerCollector::warnOfAbsence(const std::vector<AgentId>& agents) {
  if (agents.empty()) return;
  last_warning_ = Clock::now();
  ROS_WARN("no answer for %s for %.1f s: %s. They are absent: they are not waited for until an answer for them arrives",
           namedAgents(agents).c_str(), silence(agents), reasonForSilence().c_str());
}

}  // namespace crowd
