#pragma once

#include <string>

namespace crowd {

/// @brief What the error of this type says that an action throws; a note if it throws none.
template <typename Error, typename Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// @brief Whether a text holds another.
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace crowd
