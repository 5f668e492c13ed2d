#include "ros/node/reconfigure_server.h"

#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <dynamic_reconfigure/config_tools.h>

#include <sstream>
#include <utility>

#include "common/text/quotes.h"
#include "ros/messages/publish_latched.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

constexpr bool ONE_SHOT = true;  // of a timer
constexpr bool STARTED = true;
const ros::WallDuration UPDATE_PERIOD(0.1);
constexpr std::size_t MAX_REQUEST = 10'000;               // [bytes]
constexpr const char* SET_PARAMETERS = "set_parameters";  // of the protocol of dynamic_reconfigure
constexpr const char* GROUP = "Default";                  // clients expect a group with the number 0
constexpr double INSIDE = 1e-6;                           // distance of a shown limit from an open one

dynamic_reconfigure::Config toMessage(const std::vector<LiveDescription>& parameters, const LiveValues& values) {
  dynamic_reconfigure::Config message;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto append = [&](const auto& value) {
      dynamic_reconfigure::ConfigTools::appendParameter(message, parameters[i].name, value);
    };
    std::visit(append, values[i]);
  }
  message.groups.emplace_back();
  message.groups.front().name = GROUP;
  message.groups.front().state = 1;
  return message;
}

/// The lowest or highest value of a parameter. Clients take the limits for permitted values: an open one is moved
/// inside.
LiveValue limitOf(const LiveValue& value, const NumberRange& range, bool highest) {
  const double limit =
      highest ? range.high - (range.below_high ? INSIDE : 0.0) : range.low + (range.above_low ? INSIDE : 0.0);
  if (std::holds_alternative<bool>(value)) return highest;
  if (std::holds_alternative<int>(value)) return static_cast<int>(limit);
  if (std::holds_alternative<double>(value)) return limit;
  return std::string();
}

/// A Python expression from which clients make a list of the choices; empty without choices.
std::string editMethod(const LiveDescription& about) {
  std::ostringstream entries;
  for (const std::string& choice : about.choices) {
    entries << "{'name': '" << choice << "', 'value': '" << choice << "', 'type': 'str', 'ctype': 'std::string', "
            << "'cconsttype': 'const char * const', 'description': '', 'srcfile': '', 'srcline': 0}, ";
  }
  return about.choices.empty() ? "" : "{'enum': [" + entries.str() + "], 'enum_description': ''}";
}

dynamic_reconfigure::ConfigDescription toDescription(const std::vector<LiveDescription>& parameters,
                                                     const LiveValues& defaults) {
  dynamic_reconfigure::ConfigDescription message;
  message.groups.emplace_back();
  message.groups.front().name = GROUP;
  LiveValues lowest;
  LiveValues highest;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    dynamic_reconfigure::ParamDescription about;
    about.name = parameters[i].name;
    about.type = typeOf(defaults[i]);
    about.description = parameters[i].meaning;
    about.edit_method = editMethod(parameters[i]);
    message.groups.front().parameters.push_back(about);
    lowest.push_back(limitOf(defaults[i], parameters[i].range, false));
    highest.push_back(limitOf(defaults[i], parameters[i].range, true));
  }
  message.dflt = toMessage(parameters, defaults);
  message.min = toMessage(parameters, lowest);
  message.max = toMessage(parameters, highest);
  return message;
}

}  // namespace

LiveChanges changesOf(const dynamic_reconfigure::Config& request) {
  LiveChanges changes;
  for (const auto& entry : request.bools) changes.emplace_back(entry.name, entry.value != 0);
  for (const auto& entry : request.ints) changes.emplace_back(entry.name, static_cast<int>(entry.value));
  for (const auto& entry : request.doubles) changes.emplace_back(entry.name, entry.value);
  for (const auto& entry : request.strs) changes.emplace_back(entry.name, entry.value);
  return changes;
}

ReconfigureServer::ReconfigureServer(ros::NodeHandle private_node, std::vector<LiveDescription> parameters,
                                     const LiveValues& defaults, Functions functions)
    : parameters_(std::move(parameters)), functions_(std::move(functions)) {
  description_publisher_ =
      private_node.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, LATCHED);
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
      "parameter_updates", SHORT_QUEUE, send_present_values, stop_without_subscribers);
}

void ReconfigureServer::serve(Services& services, MainLoop& loop) {
  services.serveAs<dynamic_reconfigure::Reconfigure>(SET_PARAMETERS, [this, &loop](auto& request, auto& response) {
    response.config = loop.ask<dynamic_reconfigure::Config>([&] { return change(request.config); });
  });
}

dynamic_reconfigure::Config ReconfigureServer::change(const dynamic_reconfigure::Config& request) {
  try {
    functions_.change(changesOf(request));
  } catch (const Error& error) {
    // The response has no room for a message.
    ROS_WARN("%s: nothing has changed: %s", SET_PARAMETERS, shortened(error.what(), MAX_REQUEST).c_str());
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
