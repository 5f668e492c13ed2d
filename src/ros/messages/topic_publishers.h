#pragma once

#include <optional>
#include <string>
#include <vector>

namespace crowd {

/// @brief What the ROS master knows of a topic.
struct TopicNodes {
  std::vector<std::string> publishers;  ///< full names of nodes
  bool has_this_node = false;           ///< among the subscribers
};

/// @brief Asks the ROS master for the nodes of a topic, and blocks for that. Nothing if the master does not answer.
/// @param topic full name
std::optional<TopicNodes> nodesOf(const std::string& topic);

}  // namespace crowd
