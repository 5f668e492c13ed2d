#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief Up to so many numbers are ranked.
constexpr std::size_t MAX_RANKED = 48;

/// @brief Writes for each number how many of all are smaller in single precision.
/// @param numbers up to MAX_RANKED of them are read, whatever stands behind the first `count`
/// @param ranks room for MAX_RANKED; what is behind the first `count` is overwritten, too
/// @return the sum of the ranks; 0 + 1 + ... + (count - 1) if no two numbers are equal in single precision
using RankAscending = std::uint32_t(const double* numbers, std::size_t count, std::uint32_t* ranks);

}  // namespace crowd::simd
