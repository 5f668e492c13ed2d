#include "ros/node/master_watch.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include <chrono>

namespace crowd {
namespace {

constexpr double PERIOD = 2.0;           // [s] between two looks
constexpr double OTHERS_REGISTER = 3.0;  // [s] in which other nodes look, too, and register what they publish
constexpr int TOLD_AFTER = 3;            // looks without an answer

}  // namespace

std::shared_ptr<MasterWatch> MasterWatch::ofProcess() {
  static std::mutex mutex;
  static std::weak_ptr<MasterWatch> present;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<MasterWatch> watch = present.lock();
  if (watch == nullptr) {
    watch.reset(new MasterWatch());  // the constructor is private
    present = watch;
  }
  return watch;
}

MasterWatch::MasterWatch()
    : master_(ros::master::getHost(), static_cast<int>(ros::master::getPort()), [this] { return isEnding(); }),
      registrations_([this] { return isEnding(); }),
      thread_([this] { run(); }) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool MasterWatch::isEnding() const { return ending_ || ros::isShuttingDown() || !ros::ok(); }

void MasterWatch::run() {
  while (!isEnding()) {
    try {
      check();
    } catch (const XmlRpc::XmlRpcException& error) {
      ROS_WARN_ONCE("unexpected answer of the ROS master at %s: %s", ros::master::getURI().c_str(),
                    error.getMessage().c_str());
    }
    pause(PERIOD);
  }
}

void MasterWatch::pause(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return ending_.load(); });
}

void MasterWatch::check() {
  const std::optional<RosApi::Answer> node = master_.call("lookupNode", {ros::this_node::getName()});
  std::optional<RosApi::Answer> pid = node ? master_.call("getPid", {}) : std::nullopt;
  if (isEnding()) return;  // roscpp takes back its registrations
  if (!pid) return noteSilence();
  noteAnswer();
  const int present = pid->value;
  is_forgotten_ = isForgottenBy(*node, present) || is_forgotten_;
  pid_ = present;
  if (is_forgotten_) registerAgain();
}

bool MasterWatch::isForgottenBy(const RosApi::Answer& node, int pid) {
  if (!node.success) return true;
  const bool is_new = pid_ != 0 && pid != pid_;
  XmlRpc::XmlRpcValue uri = node.value;
  if (static_cast<std::string>(uri) == ros::XMLRPCManager::instance()->getServerURI()) return is_new;
  // Registering would end the other node.
  if (is_new) {
    ROS_WARN(
        "there is a new ROS master at %s, on which another node has the name %s: this one stays unknown to it. Stop "
        "one of both, and start it again",
        ros::master::getURI().c_str(), ros::this_node::getName().c_str());
  }
  return false;
}

void MasterWatch::noteSilence() {
  if (++silent_checks_ != TOLD_AFTER) return;
  ROS_WARN(
      "the ROS master at %s does not answer. Connected nodes go on; others cannot connect, and services cannot be "
      "called. When there is a master again, this node registers with it",
      ros::master::getURI().c_str());
}

void MasterWatch::noteAnswer() {
  if (silent_checks_ >= TOLD_AFTER) ROS_INFO("there is a ROS master at %s again", ros::master::getURI().c_str());
  silent_checks_ = 0;
}

void MasterWatch::registerAgain() {
  if (!registrations_.registerOffers(master_)) return;
  pause(OTHERS_REGISTER);
  if (isEnding() || !registrations_.registerSubscriptions(master_)) return;
  is_forgotten_ = false;
  ROS_WARN(
      "the ROS master at %s did not know this node, as after a new roscore: registered %zu topics and %zu services "
      "again. Parameters of the earlier master are lost; nodes that do not register again, such as those with rospy, "
      "have to be started again",
      ros::master::getURI().c_str(), registrations_.topicCount(), registrations_.serviceCount());
}

}  // namespace crowd
