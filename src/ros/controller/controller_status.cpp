#include "ros/controller/controller_status.h"

#include <utility>

#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

const ros::WallDuration STATUS_CHECK_PERIOD(0.1);

}  // namespace

void toMessage(const World& world, social_crowd::ControllerStatus& message) {
  message.tick = world.tick();
  message.time = world.time();
  message.walking = static_cast<std::uint32_t>(world.activeCount());
  const DepartedAgents& departed = world.departed();
  message.agents = message.arrived = departed.arrived;
  message.touched = departed.touched;
  message.collided = departed.collided;
  for (const Agent& agent : world.agents()) {
    if (agent.status == AgentStatus::REMOVED) continue;
    ++message.agents;
    if (agent.hasArrived()) ++message.arrived;
    if (agent.touched) ++message.touched;
    if (agent.collided) ++message.collided;
  }
}

ControllerStatusPublisher::ControllerStatusPublisher(ros::NodeHandle node,
                                                     std::function<social_crowd::ControllerStatus()> status)
    : status_(std::move(status)) {
  const auto greet = [this](const ros::SingleSubscriberPublisher& subscriber) { subscriber.publish(status_()); };
  publisher_ = node.advertise<social_crowd::ControllerStatus>(names::CONTROLLER_STATUS, SHORT_QUEUE, greet);
  timer_ = node.createWallTimer(STATUS_CHECK_PERIOD, [this](const ros::WallTimerEvent& /*event*/) { publish(); });
}

void ControllerStatusPublisher::publish() {
  if (publisher_.getNumSubscribers() == 0) return;
  social_crowd::ControllerStatus status = status_();
  last_.header = status.header;  // the time alone is not a change
  if (status == last_) return;
  last_ = std::move(status);
  publisher_.publish(last_);
}

}  // namespace crowd
