#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace crowd {

/// @brief Progress bar on standard error with a note and the remaining time. If standard error is not a terminal, plain
/// lines are printed periodically.
class ProgressBar {
 public:
  ProgressBar(std::string label, std::uint64_t total);
  /// @brief Draws the bar, at most a few times per second. @param note text after the bar
  void show(std::uint64_t done, const std::string& note) { draw(done, note, done == total_); }
  /// @brief Returns whether the next show() would draw, so that callers can avoid computing unused notes.
  bool isDue(std::uint64_t done) const;
  /// @brief Draws the bar a last time and ends the line.
  void finish(std::uint64_t done, const std::string& note);
  /// @brief Removes the bar from the terminal.
  void clear();
  /// @brief Returns the time since the construction [s].
  double seconds() const;

 private:
  void draw(std::uint64_t done, const std::string& note, bool always);

  std::string label_;
  std::uint64_t total_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

/// @brief Returns seconds as m:ss or h:mm:ss.
std::string formatDuration(double seconds);
/// @brief Returns a number with a unit prefix: 950, 12.3 k, 4.56 M.
std::string formatCount(double count);

}  // namespace crowd
