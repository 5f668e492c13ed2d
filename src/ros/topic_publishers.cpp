#include "social_crowd/ros/topic_publishers.h"

#include <ros/master.h>
#include <ros/this_node.h>

namespace crowd {

std::vector<std::string> publishersOf(const std::string& topic) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;  // lists of publishers, subscribers and services; entries: topic, list of nodes
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return {};
  XmlRpc::XmlRpcValue& published = state[0];
  std::vector<std::string> nodes;
  // XmlRpcValue::begin() is for structs only.
  for (int i = 0; i < published.size(); ++i) {  // NOLINT(modernize-loop-convert)
    if (static_cast<std::string>(published[i][0]) != topic) continue;
    for (int k = 0; k < published[i][1].size(); ++k) nodes.push_back(published[i][1][k]);
  }
  return nodes;
}

}  // namespace crowd
