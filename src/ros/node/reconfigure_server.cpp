#include "social_crowd/ros/node/reconfigure_server.h"

#include <dynamic_reconfigure/Reconfigure.h>

#include <utility>

#include "social_crowd/common/quotes.h"
#include "social_crowd/ros/messages/names.h"
#include "social_crowd/ros/messages/publish_latched.h"
#include "social_crowd/ros/messages/reconfigure_messages.h"
#include "social_crowd/ros/messages/topic_defaults.h"

namespace crowd {
namespace {

constexpr bool ONE_SHOT = true;  // of a timer
constexpr bool STARTED = true;
const ros::WallDuration UPDATE_PERIOD(0.1);
constexpr std::size_t MAX_REQUEST = 10'000;  // [bytes]

}  // namespace

ReconfigureServer::ReconfigureServer(ros::NodeHandle private_node, std::vector<LiveDescription> parameters,
                                     const LiveValues& defaults, Functions functions)
    : parameters_(std::move(parameters)), functions_(std::move(functions)) {
  description_publisher_ =
      private_node.advertise<dynamic_reconfigure::ConfigDescription>(names::PARAMETER_DESCRIPTIONS, 1, LATCHED);
  publishLatched(description_publisher_, toDescription(parameters_, defaults));
  timer_ = private_node.createWallTimer(
      UPDATE_PERIOD, [this](const ros::WallTimerEvent& /*event*/) { publish(false); }, !ONE_SHOT, !STARTED);
  // Not latched: each new subscriber gets the present values, not those of the last message.
  const auto send_present_values = [this](const ros::SingleSubscriberPublisher& subscriber) {
    subscriber.publish(toMessage(parameters_, functions_.present()));
    timer_.start();
  };
  const auto stop_without_subscribers = [this](const ros::SingleSubscriberPublisher& /*subscriber*/) {
    if (updates_publisher_.getNumSubscribers() == 0) timer_.stop();
  };
  updates_publisher_ = private_node.advertise<dynamic_reconfigure::Config>(
      names::PARAMETER_UPDATES, SHORT_QUEUE, send_present_values, stop_without_subscribers);
}

void ReconfigureServer::serve(Services& services, MainLoop& loop) {
  services.serveAs<dynamic_reconfigure::Reconfigure>(
      names::SET_PARAMETERS, [this, &loop](auto& request, auto& response) {
        response.config = loop.ask<dynamic_reconfigure::Config>([&] { return change(request.config); });
      });
}

dynamic_reconfigure::Config ReconfigureServer::change(const dynamic_reconfigure::Config& request) {
  try {
    LiveValues values = functions_.present();
    takeRequest(request, parameters_, values);
    functions_.use(values);
  } catch (const Error& error) {
    // The response has no room for a message.
    ROS_WARN("%s: nothing has changed: %s", names::SET_PARAMETERS, shortened(error.what(), MAX_REQUEST).c_str());
  }
  publish(true);
  return toMessage(parameters_, functions_.present());
}

void ReconfigureServer::publish(bool always) {
  if (updates_publisher_.getNumSubscribers() == 0) return;
  LiveValues values = functions_.present();
  if (!always && values == published_) return;
  updates_publisher_.publish(toMessage(parameters_, values));
  published_ = std::move(values);
}

}  // namespace crowd
