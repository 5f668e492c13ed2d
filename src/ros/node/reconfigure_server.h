#pragma once

#include <dynamic_reconfigure/Config.h>
#include <ros/ros.h>

#include <functional>
#include <vector>

#include "ros/node/live_parameters.h"
#include "ros/node/main_loop.h"
#include "ros/node/services.h"

namespace crowd {

/// @brief The changes that a request asks for.
LiveChanges changesOf(const dynamic_reconfigure::Config& request);

/// @brief Server of dynamic_reconfigure (`~set_parameters`, `~parameter_descriptions`, `~parameter_updates`) for
/// parameters that are described at run time. dynamic_reconfigure::Server needs a class that is generated from a .cfg
/// file instead, which would repeat defaults and ranges, and clamps invalid values.
///
/// Owned by a node; the functions `present` and `change` run in its main loop. A request with an invalid value changes
/// nothing; the response has the present values in any case. Changes by other ways are published within a tenth of a
/// second, if there are subscribers. The parameter server is not written to.
class ReconfigureServer {
 public:
  struct Functions {
    std::function<LiveValues()> present;
    std::function<void(const LiveChanges&)> change;  ///< makes all changes, or throws and makes none
  };

  /// @param private_node whose callbacks the main loop serves
  ReconfigureServer(ros::NodeHandle private_node, std::vector<LiveDescription> parameters, const LiveValues& defaults,
                    Functions functions);

  /// @brief Advertises `~set_parameters`, which is served as other services are.
  void serve(Services& services, MainLoop& loop);

 private:
  dynamic_reconfigure::Config change(const dynamic_reconfigure::Config& request);
  void publish(bool always);

  std::vector<LiveDescription> parameters_;
  Functions functions_;
  LiveValues published_;
  ros::Publisher description_publisher_;
  ros::Publisher updates_publisher_;
  ros::WallTimer timer_;  // runs while there are subscribers to the updates
};

}  // namespace crowd
