#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crowd {

/// @brief The shortest decimal text that reads back as the same double, bit for bit ("nan", "inf", "-inf" included).
std::string toText(double value);

/// @brief Appends toText() of a number; for large files.
void appendText(double value, std::string& text);
void appendText(std::uint32_t value, std::string& text);

/// @brief A list as YAML writes it: "[1, 2.5]".
std::string toText(const std::vector<double>& values);

/// @brief The double that the whole of `text` stands for, independent of the locale; nothing if it is no number.
std::optional<double> toNumber(std::string_view text);

/// @brief A number for the eye: so many decimals, filled up with blanks on the left to the width.
std::string toFixedText(double value, int decimals, int width = 0);

/// @brief A whole number filled up with zeros on the left to the width.
std::string toPaddedText(std::uint64_t value, int width);

}  // namespace crowd
