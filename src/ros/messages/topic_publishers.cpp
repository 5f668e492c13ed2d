#include "ros/messages/topic_publishers.h"

#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>

namespace crowd {
namespace {

/// Returns the nodes of a topic. @param list entries: topic, list of nodes
std::vector<std::string> nodesIn(XmlRpc::XmlRpcValue& list, const std::string& topic) {
  std::vector<std::string> nodes;
  // XmlRpcValue::begin() is for structs only.
  for (int i = 0; i < list.size(); ++i) {  // NOLINT(modernize-loop-convert)
    if (static_cast<std::string>(list[i][0]) != topic) continue;
    for (int k = 0; k < list[i][1].size(); ++k) nodes.push_back(list[i][1][k]);
  }
  return nodes;
}

}  // namespace

std::optional<TopicNodes> nodesOf(const std::string& topic) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;  // lists of publishers, subscribers and services
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return std::nullopt;
  const std::vector<std::string> subscribers = nodesIn(state[1], topic);
  const bool has_this =
      std::find(subscribers.begin(), subscribers.end(), ros::this_node::getName()) != subscribers.end();
  return TopicNodes{nodesIn(state[0], topic), has_this};
}

}  // namespace crowd
