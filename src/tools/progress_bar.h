#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace crowd {

/// @brief A bar on the terminal (standard error) that shows how far a long run is, how it goes and how long it will
/// take. Where standard error is no terminal it writes a plain line now and then.
class ProgressBar {
 public:
  ProgressBar(std::string label, std::uint64_t total);
  /// @brief Draws at most a few times a second. @param note what to show behind the bar.
  void show(std::uint64_t done, const std::string& note) { draw(done, note, done == total_); }
  /// @brief Whether the next show() would draw; saves making notes that nobody sees.
  bool isDue(std::uint64_t done) const;
  /// @brief Ends the line.
  void finish(std::uint64_t done, const std::string& note);
  /// @brief Takes the bar away again.
  void clear();
  /// @brief Since the start [s].
  double seconds() const;

 private:
  void draw(std::uint64_t done, const std::string& note, bool always);

  std::string label_;
  std::uint64_t total_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

/// @brief Seconds as m:ss or h:mm:ss.
std::string formatDuration(double seconds);
/// @brief A number with a unit letter that a person reads at a glance: 950, 12.3 k, 4.56 M.
std::string formatCount(double count);

}  // namespace crowd
