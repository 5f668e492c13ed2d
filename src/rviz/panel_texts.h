#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace crowd {

/// @brief "4 of 6 (67 %)"; "-" if there are none.
std::string shareText(std::uint64_t count, std::uint64_t all);

/// @brief "none", "0, 4, 7", or "0, 1, 2, 3, 4 and 995 more".
std::string agentsText(const std::vector<std::uint32_t>& agents);

/// @brief Number of an agent, tick or similar with a narrow gap between groups of three digits: "1 234 567".
std::string countText(std::uint64_t count);

}  // namespace crowd
