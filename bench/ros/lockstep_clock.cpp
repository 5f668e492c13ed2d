#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <social_crowd/Reset.h>
#include <social_crowd/Step.h>

#include <iostream>

#include "any_message.h"
#include "commands.h"
#include "social_crowd/errors.h"

namespace crowd::bench {
namespace {

template <typename Service>
void call(const char* name, Service& service) {
  const bool reached = ros::service::call(name, service);
  if (!reached || service.response.success == 0) throw Error(name + (": " + service.response.message));
}

void reset() {
  social_crowd::Reset reset;
  reset.request.keep_seed = 1;
  call("crowd_controller/reset", reset);
}

/// Executes a number of ticks; returns the time that they take [s].
double walk(unsigned ticks) {
  social_crowd::Step step;
  step.request.ticks = ticks;
  const ros::WallTime begin = ros::WallTime::now();
  call("crowd_controller/step", step);
  return (ros::WallTime::now() - begin).toSec();
}

/// Measures the size of the messages of a topic.
class Scales {
 public:
  Scales(ros::NodeHandle& node, const std::string& topic) {
    const boost::function<void(const boost::shared_ptr<AnyMessage const>&)> weigh = [this](const auto& message) {
      bytes_ = message->size;
    };
    subscriber_ = node.subscribe<AnyMessage>(topic, 1, weigh);
  }

  /// Executes ticks until a message arrives, as messages before the connection are lost.
  std::size_t weigh() const {
    while (ros::ok() && bytes_ == 0) {
      walk(1);
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
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
  reset();
  walk(warm_up);
  const double seconds = walk(ticks);
  // After the measurement, because further subscribers take time.
  const Scales perceptions(node, "perceptions");
  const Scales actions(node, "actions");
  std::cout << ticks / seconds << " " << perceptions.weigh() << " " << actions.weigh() << std::endl;
}

}  // namespace crowd::bench
