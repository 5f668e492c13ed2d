#pragma once

#include <string>
#include <vector>

namespace crowd {

/// @brief Returns the full names of the nodes that publish a topic. Blocks for one call to the ROS master; empty if
/// that fails.
/// @param topic full name
std::vector<std::string> publishersOf(const std::string& topic);

}  // namespace crowd
