#pragma once

#include <stdexcept>
#include <string>

namespace crowd {

/// @brief Base class of all errors that this package throws; what() is a human-readable message.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @brief Invalid input: the content of a file, a parameter or a name. what() states where the error is and what was
/// expected.
class InputError : public Error {
 public:
  using Error::Error;
};

/// @brief A file cannot be read or written. what() names the file and the system error.
class FileError : public Error {
 public:
  using Error::Error;
};

/// @brief A Q-table does not match its target: different shape, state set or action set.
class ShapeError : public Error {
 public:
  using Error::Error;
};

}  // namespace crowd
