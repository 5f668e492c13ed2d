#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <social_crowd/Step.h>

#include <iostream>

#include "any_message.h"
#include "commands.h"
#include "social_crowd/common/errors.h"

namespace crowd::bench {
namespace {

/// Walks so many ticks; the time it takes [s].
double walk(unsigned ticks) {
  social_crowd::Step step;
  step.request.ticks = ticks;
  const ros::WallTime begin = ros::WallTime::now();
  const bool reached = ros::service::call("crowd_controller/step", step);
  const double seconds = (ros::WallTime::now() - begin).toSec();
  if (!reached || step.response.success == 0) throw Error("crowd_controller/step: " + step.response.message);
  return seconds;
}

/// Size of the messages of a topic while the crowd walks.
class Scales {
 public:
  Scales(ros::NodeHandle& node, const std::string& topic) {
    const boost::function<void(const boost::shared_ptr<AnyMessage const>&)> weigh = [this](const auto& message) {
      bytes_ = message->size;
    };
    subscriber_ = node.subscribe<AnyMessage>(topic, 1, weigh);
  }

  std::size_t weigh() const {
    while (ros::ok() && bytes_ == 0) ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    return bytes_;
  }

 private:
  ros::Subscriber subscriber_;
  std::size_t bytes_ = 0;
};

}  // namespace

void timeLockstep(unsigned warm_up, unsigned ticks) {
  ros::NodeHandle node;
  ros::service::waitForService("crowd_controller/step");
  walk(warm_up);
  const double seconds = walk(ticks);
  // Only afterwards, as one more subscriber costs time.
  const Scales perceptions(node, "perceptions");
  const Scales actions(node, "actions");
  walk(1);
  std::cout << ticks / seconds << " " << perceptions.weigh() << " " << actions.weigh() << std::endl;
}

}  // namespace crowd::bench
