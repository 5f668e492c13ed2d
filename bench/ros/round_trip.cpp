#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/UInt8MultiArray.h>

#include <iostream>

#include "commands.h"

namespace crowd::bench {
namespace {

using Message = std_msgs::UInt8MultiArray;

constexpr const char* THERE = "there";
constexpr const char* BACK = "back";
constexpr std::uint32_t QUEUE = 10;  // messages
const ros::WallDuration IDLE(0.1);   // maximum interval between checks of ros::ok()

Message messageOf(std::size_t bytes) {
  Message message;
  message.data.resize(bytes);
  return message;
}

}  // namespace

void echo(std::size_t bytes_back) {
  ros::NodeHandle node;
  const ros::Publisher back = node.advertise<Message>(BACK, QUEUE);
  const Message answer = messageOf(bytes_back);
  const ros::Subscriber there = node.subscribe<Message>(
      THERE, QUEUE, [&](const Message::ConstPtr& /*message*/) { back.publish(answer); }, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  while (ros::ok()) ros::getGlobalCallbackQueue()->callAvailable(IDLE);
}

void roundTrip(std::size_t bytes, unsigned warm_up, unsigned trips) {
  ros::NodeHandle node;
  const ros::Publisher there = node.advertise<Message>(THERE, QUEUE);
  unsigned answers = 0;
  const ros::Subscriber back = node.subscribe<Message>(
      BACK, QUEUE, [&](const Message::ConstPtr& /*message*/) { ++answers; }, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  const auto wait = [] { ros::getGlobalCallbackQueue()->callAvailable(IDLE); };
  while (ros::ok() && (there.getNumSubscribers() == 0 || back.getNumPublishers() == 0)) wait();
  const Message message = messageOf(bytes);
  const auto travel = [&](unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      const unsigned before = answers;
      there.publish(message);
      while (ros::ok() && answers == before) wait();
    }
  };
  travel(warm_up);
  const ros::WallTime begin = ros::WallTime::now();
  travel(trips);
  std::cout << trips / (ros::WallTime::now() - begin).toSec() << std::endl;
}

}  // namespace crowd::bench
