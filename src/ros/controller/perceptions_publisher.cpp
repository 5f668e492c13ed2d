#include "ros/controller/perceptions_publisher.h"

#include <ros/names.h>

#include <algorithm>
#include <iterator>

#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

// Messages to a learner whose host is slow or cut off: answers to older ones would come too late, but the messages
// would delay the present one when the host is back.
const ros::WallDuration TIME_TO_ANSWER(0.05);  // of a node that has just connected

/// Returns the message with only these agents. The perceptions are not copied.
PerceptionsMessage::ConstPtr selected(const PerceptionsMessage& all, PerceptionRows rows) {
  const auto message = boost::make_shared<PerceptionsMessage>();
  message->header = all.header;
  message->run = all.run;
  message->vision = all.vision;
  message->motion_source = all.motion_source;
  message->shared = all.shared;
  message->rows = std::move(rows);
  return message;
}

}  // namespace

PerceptionsPublisher::PerceptionsPublisher(const ros::NodeHandle& node)
    : node_(node),
      publisher_(node_.advertise<PerceptionsMessage>(
          names::PERCEPTIONS, QUEUE,
          [this](const ros::SingleSubscriberPublisher& subscriber) { addSubscriber(subscriber); })) {}

void PerceptionsPublisher::addSubscriber(const ros::SingleSubscriberPublisher& subscriber) {
  subscribers_[subscriber.getSubscriberName()] = {ros::WallTime::now(), false};
  if (awaited_ != nullptr) subscriber.publish(*awaited_);
}

void PerceptionsPublisher::addSubscriberOf(const std::string& topic, const ros::SingleSubscriberPublisher& subscriber) {
  subscribers_[subscriber.getSubscriberName()] = {ros::WallTime::now(), false};
  if (awaited_ != nullptr) subscriber.publish(*selected(*awaited_, routes_.rowsOf(topic, awaited_->content())));
}

void PerceptionsPublisher::publish(const PerceptionsMessage::ConstPtr& message, bool awaited) {
  awaited_ = awaited ? message : nullptr;
  publishOwn(*message, false);
  publisher_.publish(message);
}

void PerceptionsPublisher::publishAgain() {
  if (awaited_ == nullptr) return;
  publishOwn(*awaited_, true);
  publisher_.publish(awaited_);
}

void PerceptionsPublisher::publishOwn(const PerceptionsMessage& all, bool again) {
  if (own_.empty()) return;
  const Perceptions& content = all.content();
  std::vector<PerceptionRows> rows = routes_.split(content);
  auto rows_of_topic = rows.begin();  // own_ has the order of the routes
  for (auto& [topic, own] : own_) {
    PerceptionRows& its_rows = *rows_of_topic++;
    // Learners count episodes and report the last tick, also without agents in it.
    const bool is_told = !again && (content.last || own.episode != content.episode);
    if (!own.publisher || own.publisher.getNumSubscribers() == 0 || (its_rows.empty() && !is_told)) continue;
    own.episode = content.episode;
    own.publisher.publish(selected(all, std::move(its_rows)));
  }
}

void PerceptionsPublisher::publishAgainOn(const std::string& topic) {
  if (awaited_ == nullptr) return;
  const ros::Publisher& publisher = own_.at(topic).publisher;
  PerceptionRows rows = routes_.rowsOf(topic, awaited_->content());
  if (publisher && !rows.empty()) publisher.publish(selected(*awaited_, std::move(rows)));
}

void PerceptionsPublisher::useTopicOf(const std::string& learner, const social_crowd::LearnerStatus& status) {
  const std::string problem = problemOf(status);
  if (!problem.empty() && told_.emplace(learner, problem).second) {
    ROS_WARN(
        "'%s' reports the perceptions_topic '%s': %s. It is not published. This warning is printed once for each "
        "cause",
        learner.c_str(), status.perceptions_topic.c_str(), problem.c_str());
  }
  const std::string topic = problem.empty() ? status.perceptions_topic : "";
  if (!routes_.claim(learner, topic, status.agents, {status.share, status.shares})) return;
  const bool was_there = own_.count(topic) != 0;
  updateTopics();
  // A learner that was restarted may have connected before its status arrived, and got those of its former agents.
  if (was_there) publishAgainOn(topic);
}

std::string PerceptionsPublisher::problemOf(const social_crowd::LearnerStatus& status) const {
  const std::string& topic = status.perceptions_topic;
  if (topic.empty()) return {};
  const std::string parent = publisher_.getTopic() + "/";
  std::string error;
  const bool is_below = topic.size() > parent.size() && topic.compare(0, parent.size(), parent) == 0;
  if (!is_below || !ros::names::validate(topic, error) || ros::names::clean(topic) != topic) {
    return "expected the full name of a topic below '" + parent + "', such as '" + parent + "my_learner'";
  }
  if (status.serves_all != 0) return "expected a learner that serves a list or a share of agents, this one serves all";
  if (status.shares <= 1 || status.share < status.shares) return {};
  return "expected a share below " + std::to_string(status.shares) + ", got " + std::to_string(status.share);
}

void PerceptionsPublisher::updateTopics() {
  const std::vector<std::string>& topics = routes_.topics();
  for (auto own = own_.begin(); own != own_.end();) {
    own = std::binary_search(topics.begin(), topics.end(), own->first) ? std::next(own) : own_.erase(own);
  }
  for (const std::string& topic : topics) {
    if (own_.count(topic) == 0) own_.emplace(topic, advertise(topic));
  }
}

PerceptionsPublisher::OwnTopic PerceptionsPublisher::advertise(const std::string& topic) {
  // roscpp reports an error and returns an empty publisher if its process uses the name for messages of another type.
  return {node_.advertise<PerceptionsMessage>(
              topic, SHORT_QUEUE,
              [this, topic](const ros::SingleSubscriberPublisher& subscriber) { addSubscriberOf(topic, subscriber); }),
          {}};
}

void PerceptionsPublisher::markHeard(const std::string& node) {
  const auto found = subscribers_.find(node);
  if (found != subscribers_.end()) found->second.heard = true;
}

bool PerceptionsPublisher::isAnyUnheard(const std::vector<std::string>& nodes) const {
  const ros::WallTime before = ros::WallTime::now() - TIME_TO_ANSWER;
  return std::any_of(nodes.begin(), nodes.end(), [&](const std::string& node) {
    if (node == ros::this_node::getName()) return true;  // several nodelet learners may have this node name
    const auto found = subscribers_.find(node);
    return found != subscribers_.end() && !found->second.heard && found->second.since <= before;
  });
}

}  // namespace crowd
