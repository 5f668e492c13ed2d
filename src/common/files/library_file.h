#pragma once

#include <string>

namespace crowd {

/// @brief Returns the file of the library social_crowd_core; empty if the system does not tell.
std::string libraryFile();

}  // namespace crowd
