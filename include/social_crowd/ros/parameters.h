#pragma once

#include <ros/ros.h>

#include <map>
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

  /// @brief The parameter, or the default where it is not set or wrong (then noted). An empty text, which a launch file
  /// sets for an argument that was left empty, counts as not set.
  std::string text(const std::string& name, const std::string& otherwise);
  bool flag(const std::string& name, bool otherwise);
  /// @brief From `low` to `high`, both included; infinite ones are no limits.
  double number(const std::string& name, double otherwise, double low, double high);
  std::int64_t whole(const std::string& name, std::int64_t otherwise, std::int64_t low, std::int64_t high);
  /// @brief A list of whole numbers of at least 0, or a text that is such a list in YAML.
  std::vector<std::int64_t> wholes(const std::string& name);
  /// @brief Whether it is set, and to more than an empty text.
  bool isSet(const std::string& name);

  /// @brief Notes something wrong with a parameter in the caller's words.
  void complain(const std::string& name, const std::string& what);
  /// @brief The same of one that must be set and is not. Where an unknown one is set whose name is like it, that one is
  /// told instead.
  void complainMissing(const std::string& name, const std::string& what);

  /// @throws InputError naming every parameter that is wrong or unknown, one a line.
  void finish();

 private:
  XmlRpc::XmlRpcValue* find(const std::string& name);
  void expect(const std::string& name, const std::string& expected, XmlRpc::XmlRpcValue& got);
  std::set<std::string> findUnknown() const;
  void noteUnknown();

  ros::NodeHandle node_;
  std::set<std::string> asked_;
  std::vector<std::string> problems_;
  std::map<std::string, std::string> missing_;  // what is wrong, by name
  XmlRpc::XmlRpcValue value_;
};

}  // namespace crowd
