#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/files/checksum.h"
#include "social_crowd/errors.h"

namespace crowd {

/// @brief Reads a text line by line and counts the lines.
class LineReader {
 public:
  /// @param lines_before number of lines before the text, for messages
  LineReader(std::string_view text, std::string name, std::size_t lines_before = 0)
      : rest_(text), unsummed_(text), name_(std::move(name)), line_(lines_before) {}

  bool atEnd() const { return rest_.empty(); }

  /// @brief Returns the next line without its line end; fails if there is none.
  std::string_view next(const std::string& expected) {
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) fail(expected, rest_.empty() ? "the end of the file" : "a line cut short");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  /// @brief Reads the next line if it is the expected one; returns whether it is.
  bool nextIs(std::string_view expected) {
    const bool is_it = rest_.size() > expected.size() && rest_.substr(0, expected.size()) == expected &&
                       rest_[expected.size()] == '\n';
    if (is_it) next(std::string(expected));
    return is_it;
  }

  /// @brief Throws the InputError "NAME: line L: expected ..., got ...".
  [[noreturn]] void fail(const std::string& expected, const std::string& got) const {
    throw InputError(name_ + ": line " + std::to_string(line_) + ": expected " + expected + ", got " + got);
  }

  const std::string& name() const { return name_; }

  /// @brief Adds the text before `end` that is not in the checksum yet; returns the checksum of all text before `end`.
  /// Frequent calls are fast, because the text is still in the cache.
  const Checksum& sumUpTo(const char* end) {
    const auto length = static_cast<std::size_t>(end - unsummed_.data());
    checksum_.add(unsummed_.substr(0, length));
    unsummed_.remove_prefix(length);
    return checksum_;
  }

 private:
  std::string_view rest_;
  std::string_view unsummed_;
  Checksum checksum_;
  std::string name_;
  std::size_t line_;
};

}  // namespace crowd
