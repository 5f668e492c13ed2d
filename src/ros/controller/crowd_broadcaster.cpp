#include "ros/controller/crowd_broadcaster.h"

#include <geometry_msgs/PoseArray.h>
#include <nav_msgs/OccupancyGrid.h>
#include <rosgraph_msgs/Clock.h>
#include <social_crowd/Walls.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publish_latched.h"
#include "ros/messages/topic_defaults.h"
#include "ros/robots/robot_messages.h"

namespace crowd {

CrowdBroadcaster::CrowdBroadcaster(ros::NodeHandle node, const ControllerParameters& parameters)
    : node_(node),
      publish_clock_(parameters.publish_clock),
      clock_(1, 0),  // ROS takes zero as no time received yet
      parameters_(parameters),
      // A new subscriber gets the agents also during a pause.
      agents_(node.advertise<social_crowd::AgentStates>(
          names::AGENTS, QUEUE, [this](const ros::SingleSubscriberPublisher& /*new*/) { agents_published_.reset(); })),
      poses_(node.advertise<geometry_msgs::PoseArray>("agent_poses", QUEUE)),
      scenario_(node.advertise<social_crowd::Scenario>(names::SCENARIO, QUEUE, LATCHED)),
      walls_(node.advertise<social_crowd::Walls>(names::WALLS, QUEUE, LATCHED)),
      results_(node.advertise<social_crowd::EpisodeResult>("episode_results", QUEUE)) {
  if (publish_clock_) clock_publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", QUEUE);
  if (parameters.publish_tf) {
    frames_broadcaster_.emplace();
    // Publishers of one topic in one process share their connections, so this one has the broadcaster's subscribers.
    frames_subscribers_ = ros::NodeHandle().advertise<tf2_msgs::TFMessage>("/tf", QUEUE);
  }
}

std_msgs::Header CrowdBroadcaster::header() const {
  std_msgs::Header header;
  header.frame_id = names::MAP_FRAME;
  header.stamp = publish_clock_ ? clock_ : ros::Time::now();
  return header;
}

void CrowdBroadcaster::advanceClock(double seconds) {
  if (publish_clock_) clock_ += ros::Duration(seconds);
}

void CrowdBroadcaster::publishClock() {
  if (!publish_clock_) return;
  rosgraph_msgs::Clock message;
  message.clock = clock_;
  clock_publisher_.publish(message);
}

bool CrowdBroadcaster::hasPublishedAgents(const Episode& episode) const {
  return agents_published_ == std::pair(episode.number(), episode.changes());
}

bool CrowdBroadcaster::isDueToPublishAgents() const {
  const double rate = parameters_.agents_rate;
  return rate <= 0.0 || (ros::SteadyTime::now() - agents_published_at_).toSec() * rate >= 1.0;
}

void CrowdBroadcaster::publishAgents(const Episode& episode) {
  publishWalls(episode);
  if (isDueToPublishAgents()) publishAgentsNow(episode);
}

void CrowdBroadcaster::publishAgentsNow(const Episode& episode) {
  publishWalls(episode);
  if (hasPublishedAgents(episode)) return;
  agents_published_ = {episode.number(), episode.changes()};
  agents_published_at_ = ros::SteadyTime::now();
  if (agents_.getNumSubscribers() > 0) publishStates(episode);
  if (poses_.getNumSubscribers() > 0) publishPoses(episode);
  if (frames_broadcaster_ && frames_subscribers_.getNumSubscribers() > 0) publishFrames(episode);
}

void CrowdBroadcaster::publishStates(const Episode& episode) {
  const social_crowd::AgentStatesPtr message = states_.next();
  toMessage(episode.world(), *message);
  message->header = header();
  message->episode = episode.number();
  agents_.publish(message);
}

void CrowdBroadcaster::publishPoses(const Episode& episode) {
  geometry_msgs::PoseArray message;
  message.header = header();
  for (const Agent& agent : episode.world().agents()) {
    if (agent.isPresent()) message.poses.push_back(toMessage(agent.pose));
  }
  poses_.publish(message);
}

void CrowdBroadcaster::publishFrames(const Episode& episode) {
  const std_msgs::Header now = header();
  std::size_t count = 0;
  frames_.resize(episode.world().agents().size());
  for (const Agent& agent : episode.world().agents()) {
    if (!agent.isPresent()) continue;
    geometry_msgs::TransformStamped& frame = frames_[count++];
    frame.header = now;
    frame.child_frame_id = names::AGENT_FRAME_PREFIX + std::to_string(agent.id);
    frame.transform.translation = toVector3(agent.pose.position);
    frame.transform.rotation = toQuaternion(agent.pose.heading);
  }
  frames_.resize(count);
  frames_broadcaster_->sendTransform(frames_);
}

void CrowdBroadcaster::publishScenario(const Episode& episode, std::uint64_t instance) {
  social_crowd::Scenario message;
  toMessage(episode.scene(), episode.world(), message);
  message.header = header();
  message.episode = episode.number();
  message.instance = instance;
  publishLatched(scenario_, message);
  publishWalls(episode);
  publishMap(episode);
}

void CrowdBroadcaster::publishWalls(const Episode& episode) {
  const std::pair now(episode.number(), episode.world().layoutChanges());
  if (walls_published_ == now) return;
  walls_published_ = now;
  social_crowd::Walls message;
  message.header = header();
  message.episode = episode.number();
  toMessages(episode.world().walls().list(), message.walls);
  message.numbers.assign(episode.world().walls().ids().begin(), episode.world().walls().ids().end());
  publishLatched(walls_, message);
}

void CrowdBroadcaster::publishMap(const Episode& episode) {
  const std::shared_ptr<const OccupancyMap>& map = episode.scene().map;
  if (map == map_published_) return;
  map_published_ = map;
  if (!map_) map_ = node_.advertise<nav_msgs::OccupancyGrid>(names::MAP, 1, LATCHED);
  nav_msgs::OccupancyGrid message;
  toMessage(map != nullptr ? *map : OccupancyMap(), message);
  message.header = header();
  message.info.map_load_time = message.header.stamp;
  publishLatched(map_, message);
}

void CrowdBroadcaster::publishResult(const EpisodeResult& result, std::uint64_t number, std::uint64_t instance,
                                     std::uint64_t missed, std::uint64_t dropped) {
  social_crowd::EpisodeResult message;
  toMessage(result, message);
  message.header = header();
  message.episode = number;
  message.instance = instance;
  message.missed_answers = missed;
  message.dropped_answers = dropped;
  results_.publish(message);
}

}  // namespace crowd
