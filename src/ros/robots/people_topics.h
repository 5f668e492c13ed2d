#pragma once

#include <std_msgs/Header.h>

#include <vector>

#include "robots/person_tracker.h"
#include "ros/messages/topic_group.h"

namespace crowd {

/// Topics of the people whom a robot tracks. The header is that of the messages, in `map`.
using PeopleTopics = TopicGroup<const std::vector<PersonTrack>&, const std_msgs::Header&>;

/// @brief Advertises them, without those whose messages were not found when the package was built.
/// @param own namespace of the robot
PeopleTopics peopleTopics(ros::NodeHandle& own);

}  // namespace crowd
