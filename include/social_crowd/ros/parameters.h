#pragma once

#include <ros/ros.h>

#include <set>
#include <string>
#include <vector>

#include "social_crowd/common/errors.h"

namespace crowd {

/// @brief Reads a node's private parameters and collects everything that is wrong with them, so that all of it is told
/// at once. Unknown private parameters are wrong too: a mistyped name must not be silently ignored.
class Parameters {
 public:
  explicit Parameters(const ros::NodeHandle& private_node) : node_(private_node) {}

  /// @brief The parameter, or the default where it is not set or wrong (then noted).
  std::string text(const std::string& name, const std::string& otherwise);
  bool flag(const std::string& name, bool otherwise);
  /// @brief From `low` to `high`, both included. An empty text counts as not set.
  double number(const std::string& name, double otherwise, double low, double high);
  std::int64_t whole(const std::string& name, std::int64_t otherwise, std::int64_t low, std::int64_t high);
  /// @brief A list of whole numbers of at least 0.
  std::vector<std::int64_t> wholes(const std::string& name);
  /// @brief Whether it is set, and to more than an empty text.
  bool isSet(const std::string& name);

  /// @brief Notes something wrong with a parameter in the caller's words.
  void complain(const std::string& name, const std::string& what);

  /// @throws InputError naming every parameter that is wrong or unknown, one a line.
  void finish();

 private:
  XmlRpc::XmlRpcValue* find(const std::string& name);
  void expect(const std::string& name, const std::string& expected, XmlRpc::XmlRpcValue& got);
  void noteUnknown();

  ros::NodeHandle node_;
  std::set<std::string> asked_;
  std::vector<std::string> problems_;
  XmlRpc::XmlRpcValue value_;
};

}  // namespace crowd
