#include "ros/node/ros_api.h"

#include <ros/this_node.h>
#include <ros/time.h>

namespace crowd {
namespace {

using XmlRpc::XmlRpcValue;

const ros::WallDuration LIMIT(3.0);  // of a call
constexpr double LOOK = 0.1;         // [s] between two checks whether a call is cancelled

std::optional<RosApi::Answer> toAnswer(XmlRpcValue& response) {
  const bool is_valid = response.getType() == XmlRpcValue::TypeArray && response.size() == 3 &&
                        response[0].getType() == XmlRpcValue::TypeInt;
  if (!is_valid) return std::nullopt;
  return RosApi::Answer{static_cast<int&>(response[0]) == 1, response[2]};
}

}  // namespace

std::optional<RosApi::Answer> RosApi::call(const std::string& function, const std::vector<XmlRpcValue>& arguments) {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  for (std::size_t i = 0; i < arguments.size(); ++i) request[static_cast<int>(i) + 1] = arguments[i];
  XmlRpcValue response;
  if (client_.executeNonBlock(function.c_str(), request) && isAnswered(response)) return toAnswer(response);
  client_.close();
  return std::nullopt;
}

bool RosApi::isAnswered(XmlRpcValue& response) {
  const ros::SteadyTime deadline = ros::SteadyTime::now() + LIMIT;
  while (!client_.executeCheckDone(response)) {
    const bool is_failed = client_._disp._sources.empty();  // it is the only source, and is removed after an error
    if (is_failed || is_cancelled_() || ros::SteadyTime::now() >= deadline) return false;
    client_._disp.work(LOOK);
  }
  return response.valid();
}

}  // namespace crowd
