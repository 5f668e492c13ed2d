#pragma once

#include <ros/ros.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/text/number_range.h"
#include "social_crowd/errors.h"

namespace crowd {

/// @brief The greatest whole number of a parameter: XML-RPC has 32 bits.
constexpr std::int64_t MAX_WHOLE = INT32_MAX;

/// @brief Reads the private parameters of a node and collects all errors, so that they are reported together. An
/// unknown private parameter is an error, too.
class Parameters {
 public:
  /// @brief Reads all parameters in one call, so that the values belong together, and a call that fails is not taken
  /// for a parameter that is not set. Waits for the master if it is away.
  /// @throws Stopped if ROS shuts down before the master answers
  explicit Parameters(const ros::NodeHandle& private_node);

  /// @brief Returns the parameter, or the default if it is not set or invalid (then noted). An empty text, which a
  /// launch file sets for an empty argument, counts as not set.
  /// @param expected describes the valid texts
  std::string text(const std::string& name, const std::string& otherwise, const std::string& expected = "a text");
  bool flag(const std::string& name, bool otherwise);
  /// @param alternative what else the caller accepts, for errors, such as " or a schedule"
  double number(const std::string& name, double otherwise, const NumberRange& range,
                const std::string& alternative = "");
  std::int64_t whole(const std::string& name, std::int64_t otherwise, std::int64_t low, std::int64_t high);
  /// @brief A list of whole numbers of at least 0, or a text that is such a list in YAML.
  std::vector<std::int64_t> wholes(const std::string& name);
  /// @brief A map, or a text that begins with '{', as YAML, unchecked; nullopt if the parameter is not set, or is
  /// something else.
  std::optional<std::string> map(const std::string& name);
  /// @brief Whether it is set to another value than an empty text.
  bool isSet(const std::string& name);

  /// @brief Notes an error of a parameter.
  void complain(const std::string& name, const std::string& what);
  /// @brief Notes that a required parameter is not set. It is not reported if an unknown parameter has a similar name.
  void complainMissing(const std::string& name, const std::string& what);

  /// @brief Logs all parameters that were asked for, with what is expected and the default, at level debug.
  /// @throws InputError that lists all invalid and unknown parameters, one per line
  void finish();

 private:
  XmlRpc::XmlRpcValue* find(const std::string& name);
  /// Finds a parameter, as above, and notes what is expected and the default.
  XmlRpc::XmlRpcValue* find(const std::string& name, const std::string& expected, const std::string& otherwise);
  void expect(const std::string& name, const std::string& expected, XmlRpc::XmlRpcValue& got);
  std::set<std::string> findUnknown();
  void noteUnknown();

  std::string namespace_;
  XmlRpc::XmlRpcValue values_;
  std::set<std::string> asked_;
  std::map<std::string, std::string> descriptions_;  // by name
  std::vector<std::string> problems_;
  std::map<std::string, std::string> missing_;  // error, by name
};

/// @brief Reads ~threads: threads that share the agents of a tick; 0, the default: one for each processor.
unsigned readThreads(Parameters& parameters);

}  // namespace crowd
