#include "social_crowd/ros/crowd_broadcaster.h"

#include <geometry_msgs/TransformStamped.h>
#include <rosgraph_msgs/Clock.h>

#include "social_crowd/ros/conversions.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

constexpr std::uint32_t QUEUE = 100;  // messages
constexpr bool LATCHED = true;

}  // namespace

CrowdBroadcaster::CrowdBroadcaster(ros::NodeHandle node, const ControllerParameters& parameters)
    : run_(ros::WallTime::now().toNSec()),  // no two controllers start in the same nanosecond
      publish_clock_(parameters.publish_clock),
      clock_(1, 0),  // zero means to ROS that there is no time yet
      perceptions_(node.advertise<social_crowd::Perceptions>(names::PERCEPTIONS, QUEUE, LATCHED)),
      agents_(node.advertise<social_crowd::AgentStates>(names::AGENTS, QUEUE)),
      scenario_(node.advertise<social_crowd::Scenario>(names::SCENARIO, QUEUE, LATCHED)),
      results_(node.advertise<social_crowd::EpisodeResult>(names::EPISODE_RESULTS, QUEUE)) {
  if (publish_clock_) clock_publisher_ = node.advertise<rosgraph_msgs::Clock>(names::CLOCK, QUEUE);
  if (parameters.publish_tf) frames_ = std::make_unique<tf2_ros::TransformBroadcaster>();
}

std_msgs::Header CrowdBroadcaster::header() const {
  std_msgs::Header header;
  header.frame_id = names::MAP_FRAME;
  header.stamp = publish_clock_ ? clock_ : ros::Time::now();
  return header;
}

void CrowdBroadcaster::advanceClock(double seconds) {
  if (!publish_clock_) return;
  clock_ += ros::Duration(seconds);
  rosgraph_msgs::Clock message;
  message.clock = clock_;
  clock_publisher_.publish(message);
}

void CrowdBroadcaster::publishPerceptions(const Episode& episode) {
  const auto message = boost::make_shared<social_crowd::Perceptions>();
  toMessage(episode.perceptions(), *message);
  message->run = run_;
  message->header = header();
  perceptions_.publish(message);
  last_perceptions_ = message;
}

void CrowdBroadcaster::publishAgents(const Episode& episode) {
  if (frames_ != nullptr) publishFrames(episode);
  if (agents_.getNumSubscribers() == 0) return;
  const auto message = boost::make_shared<social_crowd::AgentStates>();
  toMessage(episode.world(), *message);
  message->header = header();
  message->episode = episode.number();
  agents_.publish(message);
}

void CrowdBroadcaster::publishFrames(const Episode& episode) {
  std::vector<geometry_msgs::TransformStamped> frames;
  for (const Agent& agent : episode.world().agents()) {
    if (!agent.isWalking()) continue;
    geometry_msgs::TransformStamped frame;
    frame.header = header();
    frame.child_frame_id = names::AGENT_FRAME_PREFIX + std::to_string(agent.id);
    frame.transform.translation = toVector3(agent.pose.position);
    frame.transform.rotation.z = std::sin(agent.pose.heading / 2.0);
    frame.transform.rotation.w = std::cos(agent.pose.heading / 2.0);
    frames.push_back(frame);
  }
  frames_->sendTransform(frames);
}

void CrowdBroadcaster::publishScenario(const Episode& episode, std::uint64_t instance) {
  social_crowd::Scenario message;
  toMessage(episode.scene(), episode.world(), message);
  message.header = header();
  message.episode = episode.number();
  message.instance = instance;
  scenario_.publish(message);
}

void CrowdBroadcaster::publishResult(const Episode& episode, std::uint64_t instance, std::uint64_t missed,
                                     std::uint64_t dropped) {
  social_crowd::EpisodeResult message;
  toMessage(episode.result(), message);
  message.header = header();
  message.episode = episode.number();
  message.instance = instance;
  message.missed_answers = missed;
  message.dropped_answers = dropped;
  results_.publish(message);
}

}  // namespace crowd
