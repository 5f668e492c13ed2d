#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/terminal/terminal.h"

namespace crowd {

/// @brief Progress bar on standard error with a note and the remaining time, and on request lines above it. If standard
/// error is not a terminal, plain lines are printed periodically, without the lines above.
class ProgressBar {
 public:
  /// @param done_before what was done before the construction, by an earlier run
  ProgressBar(std::string label, std::uint64_t total, std::uint64_t done_before = 0);
  /// @brief Ends the line of the bar, so that what is printed next has a line of its own.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @brief Draws the bar, at most a few times per second. @param note text after the bar
  void show(std::uint64_t done, const std::string& note, const std::vector<std::string>& above = {}) {
    draw(done, note, above, done == total_);
  }
  /// @brief Returns whether the next show() would draw, so that callers can avoid computing unused notes.
  bool isDue(std::uint64_t done) const;
  /// @brief Draws the bar a last time and ends the line.
  void finish(std::uint64_t done, const std::string& note, const std::vector<std::string>& above = {});
  /// @brief Removes the bar from the terminal.
  void clear();
  /// @brief Returns the time since the construction [s].
  double seconds() const;

 private:
  void draw(std::uint64_t done, const std::string& note, const std::vector<std::string>& above, bool always);
  std::string textOf(std::uint64_t done, const std::string& note) const;
  void endLine();

  std::string label_;
  std::uint64_t total_;
  std::uint64_t done_before_;
  bool terminal_;
  bool has_line_ = false;  // the cursor is at the end of the bar
  LineBlock block_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

/// @brief Returns seconds as m:ss or h:mm:ss.
std::string formatDuration(double seconds);
/// @brief Returns a number with a unit prefix: 950, 12.3 k, 4.56 M.
std::string formatCount(double count);

}  // namespace crowd
