#pragma once

#include <ros/ros.h>
#include <std_msgs/Header.h>

#include <vector>

#include "robots/person_tracker.h"

namespace crowd {

/// @brief Topics of the people whom a robot tracks. Those whose messages were not found when the package was built are
/// not there.
class PeopleTopics {
 public:
  /// @param own namespace of the robot
  explicit PeopleTopics(ros::NodeHandle& own);

  bool haveSubscribers() const;
  /// @param header of the messages, in `map`
  void publish(const std::vector<PersonTrack>& tracks, const std_msgs::Header& header);

 private:
  ros::Publisher poses_;
  ros::Publisher people_;        // people_msgs/People
  ros::Publisher measurements_;  // people_msgs/PositionMeasurementArray
  ros::Publisher tracked_;       // spencer_tracking_msgs/TrackedPersons
};

}  // namespace crowd
