#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crowd {

/// @brief The shortest decimal text that reads back as the same double, bit for bit ("nan", "inf", "-inf" included).
std::string toText(double value);

/// @brief The double that the whole of `text` stands for, independent of the locale; nothing if it is no number.
std::optional<double> toNumber(std::string_view text);

}  // namespace crowd
