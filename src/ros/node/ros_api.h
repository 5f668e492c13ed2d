#pragma once

#include <xmlrpcpp/XmlRpc.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace crowd {

/// @brief Calls functions of the ROS master, or of a node. Unlike ros::master::execute(), a call ends at a deadline,
/// and when it is cancelled, also if the other side is cut off. Not thread-safe.
class RosApi {
 public:
  struct Answer {
    bool success = false;
    XmlRpc::XmlRpcValue value;
  };

  /// @param is_cancelled is called during calls; thread-safe
  RosApi(const std::string& host, int port, std::function<bool()> is_cancelled)
      : client_(host.c_str(), port, "/"), is_cancelled_(std::move(is_cancelled)) {}

  /// @brief Calls a function. @param arguments those after the name of this node
  /// @return nothing if there was no answer
  std::optional<Answer> call(const std::string& function, const std::vector<XmlRpc::XmlRpcValue>& arguments);

 private:
  bool isAnswered(XmlRpc::XmlRpcValue& response);

  XmlRpc::XmlRpcClient client_;
  std::function<bool()> is_cancelled_;
};

}  // namespace crowd
