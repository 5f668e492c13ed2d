#include "social_crowd/ros/perceptions_publisher.h"

#include <algorithm>

#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

constexpr std::uint32_t QUEUE = 100;           // messages
const ros::WallDuration TIME_TO_ANSWER(0.05);  // of a node that has just connected

}  // namespace

PerceptionsPublisher::PerceptionsPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<PerceptionsMessage>(
          names::PERCEPTIONS, QUEUE,
          [this](const ros::SingleSubscriberPublisher& subscriber) { addSubscriber(subscriber); })) {}

void PerceptionsPublisher::addSubscriber(const ros::SingleSubscriberPublisher& subscriber) {
  subscribers_[subscriber.getSubscriberName()] = {ros::WallTime::now(), false};
  if (awaited_ != nullptr) subscriber.publish(*awaited_);
}

void PerceptionsPublisher::publish(const PerceptionsMessage::ConstPtr& message, bool awaited) {
  awaited_ = awaited ? message : nullptr;
  publisher_.publish(message);
}

void PerceptionsPublisher::publishAgain() const {
  if (awaited_ != nullptr) publisher_.publish(awaited_);
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
