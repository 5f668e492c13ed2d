#pragma once

#include <cstdint>

namespace crowd {

using AgentId = std::uint32_t;

}  // namespace crowd
