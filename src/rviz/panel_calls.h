#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ros/node/service_line.h"
#include "rviz/panel_state.h"

namespace crowd {

/// @brief Result of a call of a service.
struct CallResult {
  bool success = false;
  std::string message;
  std::optional<std::vector<std::string>> scenarios = std::nullopt;  ///< of LIST_SCENARIOS
  std::string data_folder = {};                                      ///< the same
};

/// @brief Adds the call that a request means to a line. @param report called in the thread of the line
void beginCall(const PanelRequest& request, ServiceLine& line, std::function<void(const CallResult&)> report);

}  // namespace crowd
