#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ros/node/ros_api.h"

namespace crowd {

/// @brief Registers all topics and services of this process with a ROS master that does not have them: roscpp registers
/// each of them only once. Existing connections between nodes are kept. Not thread-safe but for addService().
class Registrations {
 public:
  /// @param is_cancelled as that of RosApi
  explicit Registrations(const std::function<bool()>& is_cancelled);

  /// @brief Adds a service of this process. (roscpp lists the topics of a process, but not its services.) It may be
  /// shut down later. Thread-safe.
  static void addService(const std::string& name);

  /// @brief Registers what is published, and the services. @return whether all was registered
  bool registerOffers(RosApi& master);
  /// @brief Registers what is subscribed to, and connects to the publishers that the master lists. The master informs a
  /// subscriber of every new publisher by a list of all; a publisher that is not in the list is disconnected. So the
  /// other nodes should have registered what they publish before. @return whether all was registered
  bool registerSubscriptions(RosApi& master);

  std::size_t topicCount() const { return published_ + subscribed_; }
  std::size_t serviceCount() const { return served_; }

 private:
  using Values = std::vector<XmlRpc::XmlRpcValue>;

  bool registerServices(RosApi& master);
  /// Connects a subscription to its present publishers and to those that the master lists.
  bool connect(const std::string& topic, std::set<std::string> publishers, const XmlRpc::XmlRpcValue& listed);
  /// Returns the list that a function of this node gives.
  std::optional<Values> own(const std::string& function);

  RosApi node_;  // of this process
  std::size_t published_ = 0;
  std::size_t subscribed_ = 0;
  std::size_t served_ = 0;
};

}  // namespace crowd
