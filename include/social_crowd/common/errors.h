#pragma once

#include <stdexcept>
#include <string>

namespace crowd {

/// @brief Base of all errors this package throws; what() is a sentence for a person.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @brief Something given to the package is wrong: a file's content, a parameter, a name. what() says where and what
/// was expected.
class InputError : public Error {
 public:
  using Error::Error;
};

/// @brief A file cannot be read or written. what() names the file and the system's reason.
class FileError : public Error {
 public:
  using Error::Error;
};

/// @brief A Q-table does not fit where it was to go: other shape, other state set or other action set.
class ShapeError : public Error {
 public:
  using Error::Error;
};

}  // namespace crowd
