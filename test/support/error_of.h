#pragma once

#include <string>

namespace crowd {

/// @brief The message of the error of this type that an action throws; a note if it throws none.
template <typename Error, typename Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// @brief Whether a text contains another.
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace crowd
