#pragma once

#include <string>

namespace crowd {

/// @brief Results of a robot in an episode.
struct RobotResult {
  std::string name;
};

}  // namespace crowd
