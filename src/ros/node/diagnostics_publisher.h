#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <cstdint>
#include <functional>
#include <string>

namespace crowd {

/// @brief A report that is published on /diagnostics.
using DiagnosticReport = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

/// @brief Publishes diagnostics of a node with diagnostic_updater, each `period` of the wall clock. Without subscribers
/// no report is made. Owned by a node; all functions run in its main loop.
class DiagnosticsPublisher {
 public:
  /// @param node whose callbacks the main loop serves
  /// @param private_node for parameters and the name of the node
  /// @param period between two reports [s]
  /// @param sample called before each report, also without subscribers, so that rates can be computed
  DiagnosticsPublisher(ros::NodeHandle node, const ros::NodeHandle& private_node, double period,
                       std::function<void()> sample);

  /// @param name without that of the node, which comes before it
  void add(const std::string& name, const DiagnosticReport& report) { updater_.add(name, report); }

 private:
  void update();

  std::function<void()> sample_;
  diagnostic_updater::Updater updater_;
  ros::Publisher watchers_;  // for the number of subscribers, which the updater does not report
  ros::WallTimer timer_;
};

/// @brief Number of events per second. @param seconds may be 0
double rateOf(std::uint64_t events, double seconds);

}  // namespace crowd
