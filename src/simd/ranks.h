#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief Maximum number of values that can be ranked.
constexpr std::size_t MAX_RANKED = 48;

/// @brief Writes the rank of each number: how many of the numbers are smaller in single precision.
/// @param numbers MAX_RANKED must be readable; those behind the first `count` are ignored
/// @param ranks capacity MAX_RANKED; elements behind the first `count` may be overwritten
/// @return the sum of the ranks; it is 0 + 1 + ... + (count - 1) if no two numbers are equal in single precision
using RankAscending = std::uint32_t(const double* numbers, std::size_t count, std::uint32_t* ranks);

}  // namespace crowd::simd
