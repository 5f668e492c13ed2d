#pragma once

#include <exception>
#include <new>

namespace crowd {

/// @brief What an error says; the standard library has only the name of a class for missing memory.
inline const char* messageOf(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "there is not enough memory" : error.what();
}

}  // namespace crowd
