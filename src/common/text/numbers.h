#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace crowd {

/// @brief Shortest decimal text that is read back as the same double, bit for bit ("nan", "inf", "-inf" included).
std::string toText(double value);

/// @brief A number, or 1 or 0 for true or false, as a field of a CSV file.
template <typename Number>
std::string toField(Number value) {
  if constexpr (std::is_floating_point_v<Number>) return toText(value);
  return std::to_string(value);
}

/// @brief A word as such a field.
inline std::string toField(const std::string& word) { return word; }

/// @brief The bits of a number: equal for the same double only.
std::uint64_t bitsOf(double value);

/// @brief Appends the text of a number without a temporary string.
void appendText(double value, std::string& text);
void appendText(std::uint32_t value, std::string& text);

/// @brief A list as a YAML flow sequence: "[1, 2.5]".
std::string toText(const std::vector<double>& values);

/// @brief Parses all of `text` as a double, independent of the locale; std::nullopt if it is not a number.
std::optional<double> toNumber(std::string_view text);

/// @brief A number with a fixed number of decimals, padded with blanks on the left to `width` characters.
std::string toFixedText(double value, int decimals, int width = 0);

/// @brief A whole number padded with zeros on the left to `width` characters.
std::string toPaddedText(std::uint64_t value, int width);

/// @brief A number as 16 hexadecimal digits.
std::string toHexText(std::uint64_t value);

}  // namespace crowd
