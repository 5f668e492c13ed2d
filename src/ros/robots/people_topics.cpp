#include "ros/robots/people_topics.h"

#include <geometry_msgs/PoseArray.h>

#ifdef SOCIAL_CROWD_PEOPLE_MSGS
#include <people_msgs/People.h>
#include <people_msgs/PositionMeasurementArray.h>
#endif
#ifdef SOCIAL_CROWD_SPENCER_MSGS
#include <spencer_tracking_msgs/TrackedPersons.h>
#endif

#include <algorithm>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/robots/robot_messages.h"

namespace crowd {
namespace {

geometry_msgs::PoseArray toPoses(const std::vector<PersonTrack>& tracks, const std_msgs::Header& header) {
  geometry_msgs::PoseArray message;
  message.header = header;
  for (const PersonTrack& track : tracks) message.poses.push_back(toMessage(track.pose));
  return message;
}

#ifdef SOCIAL_CROWD_PEOPLE_MSGS
people_msgs::People toPeople(const std::vector<PersonTrack>& tracks, const std_msgs::Header& header) {
  people_msgs::People message;
  message.header = header;
  for (const PersonTrack& track : tracks) {
    people_msgs::Person person;
    person.name = track.name;
    person.position = toPoint(track.pose.position);
    person.velocity = toPoint(track.velocity);
    person.reliability = track.reliability;
    message.people.push_back(person);
  }
  return message;
}

/// As leg_detector fills them.
people_msgs::PositionMeasurementArray toMeasurements(const std::vector<PersonTrack>& tracks,
                                                     const std_msgs::Header& header) {
  constexpr double UNKNOWN_HEIGHT = 1e4;  // variance [m^2]
  people_msgs::PositionMeasurementArray message;
  message.header = header;
  for (const PersonTrack& track : tracks) {
    people_msgs::PositionMeasurement person;
    person.header = header;
    person.name = "social_crowd";
    person.object_id = track.name;
    person.pos = toPoint(track.pose.position);
    person.reliability = track.reliability;
    person.covariance[0] = std::max(LEAST_VARIANCE, track.position_variance);
    person.covariance[4] = std::max(LEAST_VARIANCE, track.position_variance);
    person.covariance[8] = UNKNOWN_HEIGHT;
    message.people.push_back(person);
  }
  return message;
}
#endif

#ifdef SOCIAL_CROWD_SPENCER_MSGS
spencer_tracking_msgs::TrackedPersons toTracked(const std::vector<PersonTrack>& tracks,
                                                const std_msgs::Header& header) {
  const auto variances = [](double variance) {
    return Eigen::Matrix3d(Eigen::Vector3d(variance, variance, UNMEASURED).asDiagonal());
  };
  spencer_tracking_msgs::TrackedPersons message;
  message.header = header;
  for (const PersonTrack& track : tracks) {
    spencer_tracking_msgs::TrackedPerson person;
    person.track_id = track.id;
    person.is_occluded = track.detected ? 0 : 1;
    person.is_matched = track.detected ? 1 : 0;
    if (track.detected) person.detection_id = message.tracks.size();
    person.age = ros::Duration(track.age);
    person.pose.pose = toMessage(track.pose);
    writeCovariance(variances(track.position_variance), person.pose.covariance);
    person.twist.twist.linear = toVector3(track.velocity);
    writeCovariance(variances(track.velocity_variance), person.twist.covariance);
    message.tracks.push_back(person);
  }
  return message;
}
#endif

}  // namespace

PeopleTopics peopleTopics(ros::NodeHandle& own) {
  PeopleTopics topics;
  topics.advertise(own, "people_poses", toPoses);
#ifdef SOCIAL_CROWD_PEOPLE_MSGS
  topics.advertise(own, names::PEOPLE, toPeople);
  topics.advertise(own, "people_tracker_measurements", toMeasurements);
#endif
#ifdef SOCIAL_CROWD_SPENCER_MSGS
  topics.advertise(own, "tracked_persons", toTracked);
#endif
  return topics;
}

}  // namespace crowd
