#include "ros/learner/learner_node.h"

#include <algorithm>

#include "ros/messages/motion_fields.h"
#include "ros/messages/names.h"
#include "ros/messages/tick_subscriber.h"
#include "ros/messages/topic_defaults.h"
#include "ros/messages/vision.h"

namespace crowd {
namespace {

constexpr unsigned LEARNER_SERVICE_THREADS = 2;
const ros::WallDuration STATUS_PATIENCE(3.0);  // until the controller should have received the status
constexpr double VISION_WARNING_PERIOD = 5.0;  // [s]
const ros::WallDuration STATUS_PERIOD(0.5);    // minimum time between two status messages, unless something changes

}  // namespace

LearnerNode::LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : LearnerNode(node, private_node, readLearnerParameters(private_node)) {}

LearnerNode::LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node, LearnerParameters parameters)
    : node_(loop_.adopt(node)),
      name_(private_node.getNamespace()),
      on_share_(parameters.on_share),
      save_to_(parameters.save_to),
      data_folder_(parameters.data_folder),
      save_every_(parameters.save_every),
      thread_pool_(parameters.threads),
      learner_(parameters.table.model, parameters.options, std::move(parameters.table.table)),
      limiter_(learner_.model().vision()),
      // Latched, because the first answer may be published before the controller has connected.
      actions_publisher_(node_, names::ACTIONS, QUEUE),
      decision_publisher_(node_, name_),
      reconfigure_(loop_.adopt(private_node), live_.descriptions(), live_.valuesOf(settings()),
                   {[this] { return live_.valuesOf(settings()); },
                    [this](const LiveChanges& changes) { use(live_.changed(settings(), changes)); }}),
      diagnostics_(node_, private_node, parameters.diagnostic_period, [this] { takeSample(); }),
      taking_(private_node, 1),
      sharing_(private_node, 1),
      files_(private_node, 1),
      services_(private_node, LEARNER_SERVICE_THREADS) {
  learner_.setDecisions(parameters.table.decisions);
  for (const std::string& warning : parameters.warnings) ROS_WARN("%s", warning.c_str());
  // roscpp keeps one latched message for each topic of a process, and nodelets share the topic. So each of them also
  // sends its own status to new subscribers of other processes, and in its own process when it is needed, see
  // isSufficient(). Other learners do not, because it may overtake a status that was published before.
  const auto send_status = [this](const ros::SingleSubscriberPublisher& subscriber) {
    if (isNodelet()) subscriber.publish(status());
  };
  status_publisher_ =
      node_.advertise<social_crowd::LearnerStatus>(names::LEARNER_STATUS, QUEUE, send_status, {}, {}, LATCHED);
  status_subscriber_ = node_.subscribe(names::LEARNER_STATUS, QUEUE, &LearnerNode::noteStatus, this);
  const std::string own = names::perceptionsOf(node_.resolveName(names::PERCEPTIONS), name_);
  perceptions_subscriber_ =
      subscribeToTicks<PerceptionsMessage>(node_, learner_.servesAll() ? names::PERCEPTIONS : own, QUEUE,
                                           [this](const auto& event) { takePerceptions(*event.getMessage()); });
  advertiseServices();
  addDiagnostics();
}

void LearnerNode::run() {
  publishStatus();
  for (Services* const services : {&taking_, &sharing_, &files_, &services_}) services->start();
  while (!loop_.isClosed()) {
    loop_.run(IDLE);
    askForPerceptions();
  }
  loop_.close();
  for (Services* const services : {&services_, &files_, &sharing_, &taking_}) services->stop();
  if (!save_to_.empty()) saveAll(false);
}

void LearnerNode::askForPerceptions() {
  // The controller advertises the topic when it has received the status. If it is in the same process as nodelets, it
  // may have received only that of another one.
  if (!isNodelet() || learner_.servesAll() || perceptions_subscriber_.getNumPublishers() > 0) return;
  if (ros::WallTime::now() - last_status_ >= STATUS_PERIOD) publishStatus();
}

void LearnerNode::takePerceptions(const PerceptionsMessage& message) {
  try {
    answer(message);
  } catch (const Error& error) {
    ROS_ERROR_THROTTLE(5.0, "perceptions were dropped: %s", error.what());
  }
}

void LearnerNode::answer(const PerceptionsMessage& message) {
  last_perceptions_ = ros::WallTime::now();
  if (isRepeated(message)) return actions_publisher_.repeat();
  if (!isSufficient(message)) return;
  requireValid(message.content());
  const Perceptions& perceptions = limiter_.limit(message.content(), message.vision);
  const bool new_run = message.run != run_;
  if (new_run) learner_.forgetDecisions();
  const bool new_episode = new_run || episodes_ == 0 || perceptions.episode != episode_;
  run_ = message.run;
  episode_ = perceptions.episode;
  tick_ = perceptions.tick;
  const ActionsMessage::Ptr reply = replies_.next();
  learner_.decide(perceptions, reply->content, thread_pool_);
  answered_ += reply->content.agents.size();
  if (!reply->content.agents.empty()) {
    answered_turn_ = perceptions.turn;
    reply->run = message.run;
    reply->node = name_;
    reply->header.stamp = message.header.stamp;
    reply->header.frame_id = names::MAP_FRAME;
    actions_publisher_.publish(reply);
    decision_publisher_.publish(learner_, perceptions, *reply);
  }
  if (new_episode) noteEpisode();
}

bool LearnerNode::isRepeated(const PerceptionsMessage& message) const {
  const ActionsMessage::ConstPtr& last = actions_publisher_.last();
  return last != nullptr && message.run == run_ && message.content().episode == last->content.episode &&
         message.content().tick == last->content.tick && message.content().turn == answered_turn_ &&
         message.header.stamp == last->header.stamp && last->content.agents.size() == countToAnswer(message.content());
}

std::size_t LearnerNode::countToAnswer(const Perceptions& perceptions) const {
  return static_cast<std::size_t>(
      std::count_if(perceptions.agents.begin(), perceptions.agents.end(),
                    [&](const AgentPerception& self) { return !self.arrived && learner_.serves(self.agent); }));
}

bool LearnerNode::isSufficient(const PerceptionsMessage& message) {
  const Vision& needed = limiter_.vision();
  const ros::WallTime now = ros::WallTime::now();
  if (covers(message.vision, needed)) {
    insufficient_since_ = ros::WallTime();
    return true;
  }
  if (insufficient_since_.isZero()) insufficient_since_ = now;
  if (now - last_status_ >= STATUS_PERIOD) publishStatus();
  if (lacksVision()) {
    ROS_WARN_THROTTLE(VISION_WARNING_PERIOD,
                      "perceptions are not answered, because they contain less than the model needs: %s instead of %s. "
                      "Does the crowd controller receive '%s'?",
                      toText(message.vision).c_str(), toText(needed).c_str(), status_publisher_.getTopic().c_str());
  }
  return false;
}

bool LearnerNode::lacksVision() const {
  return !insufficient_since_.isZero() && last_perceptions_ - insufficient_since_ > STATUS_PATIENCE;
}

void LearnerNode::noteEpisode() {
  // A table is saved after n episodes, which is when the next one begins.
  if (save_every_ > 0 && episodes_ > 0 && episodes_ % save_every_ == 0) saveAll(true);
  ++episodes_;
  if (episodes_ == 1 || ros::WallTime::now() - last_status_ >= STATUS_PERIOD) publishStatus();
}

void LearnerNode::use(const LearnerSettings& settings) {
  learner_.setPlan(settings.plan);  // may throw; nothing has changed yet
  learner_.setMode(settings.mode);
  publishStatus();
}

void LearnerNode::noteStatus(const social_crowd::LearnerStatus::ConstPtr& status) {
  if (status->node != name_) others_[status->node] = *status;
}

void LearnerNode::publishStatus() {
  last_status_ = ros::WallTime::now();
  status_publisher_.publish(status());
}

social_crowd::LearnerStatus LearnerNode::status() const {
  const AgentId first = firstAgent();
  social_crowd::LearnerStatus status;
  status.header.stamp = ros::Time::now();
  status.header.frame_id = names::MAP_FRAME;
  status.episode = episode_;
  status.tick = tick_;
  status.node = name_;
  status.mode = MODES.nameOf(learner_.mode());
  status.tables = TABLE_USES.nameOf(learner_.tables().use());
  status.serves_all = learner_.servesAll() ? 1 : 0;
  status.agents = learner_.servedAgents();
  status.share = learner_.share().index;
  status.shares = learner_.share().count;
  if (!learner_.servesAll()) status.perceptions_topic = perceptions_subscriber_.getTopic();
  status.model = learner_.model().spec();
  status.rows = learner_.tables().of(first).rows();
  status.actions = learner_.tables().of(first).actions();
  status.visited_rows = learner_.tables().of(first).visitedRows();
  status.decisions = learner_.decisions();
  status.alpha = learner_.parameters().alpha;
  status.gamma = learner_.parameters().gamma;
  status.trace_decay = learner_.parameters().lambda;
  status.epsilon = learner_.parameters().epsilon;
  status.vision_radius = limiter_.vision().radius;
  status.max_neighbours = limiter_.vision().max_neighbours;
  status.occlusion = limiter_.vision().occlusion ? 1 : 0;
  status.wall_distance = wallDistanceField(limiter_.vision());
  const MotionFields motion = toFields(*limiter_.vision().motion);
  status.acceleration = motion.acceleration;
  status.braking = motion.braking;
  status.turn_rate = motion.turn_rate;
  return status;
}

TrainedTable LearnerNode::trained(QTable table) const {
  return {learner_.model(), learner_.parameters(), learner_.decisions(), learner_.seed(), std::move(table)};
}

AgentId LearnerNode::firstAgent() const {
  const std::vector<AgentId> served = learner_.servedAgents();
  return served.empty() ? 0 : served.front();
}

}  // namespace crowd
