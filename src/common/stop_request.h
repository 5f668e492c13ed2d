#pragma once

#include <exception>
#include <functional>
#include <utility>

namespace crowd {

/// @brief Thrown by work that ends early because its StopRequest was made. Not an Error: nothing is wrong.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped on request"; }
};

/// @brief Tells long work whether it is to end early. The work looks at it again and again, so that the caller waits
/// for a fraction of a second; what it leaves unfinished must not be used any more.
///
/// Copies ask the same function, which any number of threads may call at the same time.
class StopRequest {
 public:
  /// @brief One that is never made.
  StopRequest() = default;
  /// @param is_made says whether to end; once it returned true, it always does
  explicit StopRequest(std::function<bool()> is_made) : is_made_(std::move(is_made)) {}

  bool isMade() const { return is_made_ && is_made_(); }
  /// @throws Stopped if it was made
  void throwIfMade() const {
    if (isMade()) throw Stopped();
  }

 private:
  std::function<bool()> is_made_;
};

}  // namespace crowd
