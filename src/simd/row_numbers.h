#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief One digit of row numbers: the class of a value, which is the number of limits that sign * value reaches (>=).
struct ClassDigit {
  const float* values;  ///< one for each row number; readable up to the next multiple of VALUES_PADDED
  float sign;           ///< 1 or -1
  const float* limits;
  std::size_t limit_count;
};
constexpr std::size_t VALUES_PADDED = 24;

/// @brief The last digit of row numbers, common to all of them.
struct LastDigit {
  std::uint32_t classes;  ///< number of classes
  std::uint32_t digit;
};

/// @brief Computes row numbers from the classes of several values each; the first digit is the most significant.
/// @param rows output, `count` elements
using FindRowNumbers = void(const ClassDigit* digits, std::size_t digit_count, LastDigit last, std::size_t count,
                            std::uint32_t* rows);

}  // namespace crowd::simd
