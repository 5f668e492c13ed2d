#pragma once

#include <emscripten/val.h>

#include <exception>
#include <string>

namespace crowd::wasm {

/// @brief Throws an Error of JavaScript.
[[noreturn]] inline void throwError(const std::string& message) {
  emscripten::val::global("Error").new_(message).throw_();
}

/// @brief Calls a function; its exceptions become Errors of JavaScript, which would see addresses otherwise.
template <typename Function>
auto guarded(const Function& function) {
  std::string message;
  try {
    return function();
  } catch (const std::exception& error) {
    message = error.what();
  }
  throwError(message);
}

/// @brief Guarded<&Crowd::step>::call is a function that embind binds as a method.
template <auto METHOD>
struct Guarded;

template <typename Class, typename Result, typename... Arguments, Result (Class::*METHOD)(Arguments...)>
struct Guarded<METHOD> {
  static Result call(Class& object, Arguments... arguments) {
    return guarded([&] { return (object.*METHOD)(arguments...); });
  }
};

}  // namespace crowd::wasm
