#include "ros/learner/decision_publisher.h"

#include <social_crowd/DecisionValues.h>
#include <std_msgs/Int32.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <utility>

#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

social_crowd::CandidateValue toMessage(const ValuedMove& valued) {
  social_crowd::CandidateValue message;
  message.direction = bearingOf(valued.move.direction);
  message.speed_fraction = valued.move.wanted;
  message.admissible_fraction = valued.move.fraction;
  message.row = valued.row;
  message.value = valued.value;
  message.visits = valued.visits;
  return message;
}

}  // namespace

DecisionPublisher::DecisionPublisher(const ros::NodeHandle& node, std::string node_name)
    : node_(node), node_name_(std::move(node_name)) {
  const auto update_subscription = [this](const ros::SingleSubscriberPublisher& /*subscriber*/) {
    subscribeToChoice(publisher_.getNumSubscribers() > 0);
  };
  publisher_ = node_.advertise<social_crowd::DecisionValues>(names::DECISION_VALUES, SHORT_QUEUE, update_subscription,
                                                             update_subscription);
}

void DecisionPublisher::subscribeToChoice(bool wanted) {
  if (wanted == static_cast<bool>(chosen_)) return;
  agent_ = NO_AGENT;
  if (!wanted) {
    chosen_ = ros::Subscriber();
    return;
  }
  chosen_ = node_.subscribe<std_msgs::Int32>(names::CHOSEN_AGENT, SHORT_QUEUE,
                                             [this](const auto& message) { agent_ = message->data; });
}

void DecisionPublisher::publish(const Learner& learner, const Perceptions& perceptions, const ActionsMessage& answer) {
  if (agent_ < 0) return;
  const auto agent = static_cast<AgentId>(agent_);
  const auto values = learner.valuesOf(perceptions, answer.content, agent);
  if (!values) return;
  const auto self = std::find_if(perceptions.agents.begin(), perceptions.agents.end(),
                                 [agent](const AgentPerception& entry) { return entry.agent == agent; });
  const auto message = boost::make_shared<social_crowd::DecisionValues>();
  message->header.stamp = answer.header.stamp;
  message->header.frame_id = names::MAP_FRAME;
  message->episode = perceptions.episode;
  message->tick = perceptions.tick;
  message->agent = agent;
  message->pose.x = self->pose.position.x();
  message->pose.y = self->pose.position.y();
  message->pose.theta = self->pose.heading;
  message->node = node_name_;
  for (const ValuedMove& valued : values->moves) message->actions.push_back(toMessage(valued));
  message->chosen = values->chosen;
  message->exploration = values->isExploration() ? 1 : 0;
  publisher_.publish(message);
}

}  // namespace crowd
