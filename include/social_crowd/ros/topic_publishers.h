#pragma once

#include <string>
#include <vector>

namespace crowd {

/// @brief Asks the ROS master which nodes publish a topic. Blocks for one call to the master.
/// @param topic its full name
/// @return full names of the nodes; none if the master does not answer
std::vector<std::string> publishersOf(const std::string& topic);

}  // namespace crowd
