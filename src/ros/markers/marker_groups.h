#pragma once

#include <social_crowd/AgentStates.h>
#include <visualization_msgs/Marker.h>

namespace crowd {

/// @brief Lines between people who walk together: of each group those on the floor, joined by the shortest lines.
visualization_msgs::Marker drawGroups(const social_crowd::AgentStates& states);

}  // namespace crowd
