#pragma once

#include <cstddef>

#include "common/span.h"
#include "world/perception.h"

namespace crowd {

/// @brief Maximum number of agents in a PerceptionBatch.
constexpr std::size_t MAX_BATCH = 16;

/// @brief Perceptions of agents whose decisions are computed together: each step is done for all agents before the next
/// step begins. The steps of one agent depend on each other; those of different agents overlap in the processor.
using PerceptionBatch = Span<Perception>;

}  // namespace crowd
