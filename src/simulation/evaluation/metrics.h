#pragma once

#include <cstdint>
#include <limits>

#include "simulation/episode_result.h"

namespace crowd {

/// @brief Metrics over many episodes, as printed by the scorer of the steering benchmark.
class Metrics {
 public:
  void add(const EpisodeResult& result);

  std::uint64_t episodes() const { return episodes_; }
  /// @brief Share of the expected agents that arrived; NaN if nobody was to arrive, such as on routes that repeat.
  double successPercent() const { return meanOf(100.0 * static_cast<double>(arrived_), expected_); }
  double contactPercent() const { return percent(touched_, agents_); }
  double collisionPercent() const { return percent(collided_, agents_); }
  double cleanPercent() const { return percent(clean_, episodes_); }
  /// @brief Mean over the agents that arrived; NaN if none did. The same holds for the next two.
  double pathRatio() const { return meanOf(path_ratio_, arrived_); }
  double timeRatio() const { return meanOf(time_ratio_, arrived_); }
  double turnPerMetre() const { return meanOf(turn_per_metre_, arrived_); }
  double maxSpeedRatio() const { return max_speed_ratio_; }
  /// @brief Mean number of blocked moves per agent; NaN without agents.
  double blockedMovesPerAgent() const { return meanOf(static_cast<double>(blocked_moves_), agents_); }

 private:
  static double percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  }
  static double meanOf(double sum, std::uint64_t count) {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(count);
  }

  std::uint64_t episodes_ = 0;
  std::uint64_t clean_ = 0;
  std::uint64_t agents_ = 0;
  std::uint64_t expected_ = 0;
  std::uint64_t arrived_ = 0;
  std::uint64_t touched_ = 0;
  std::uint64_t collided_ = 0;
  std::uint64_t blocked_moves_ = 0;
  double path_ratio_ = 0.0;
  double time_ratio_ = 0.0;
  double turn_per_metre_ = 0.0;
  double max_speed_ratio_ = 0.0;
};

}  // namespace crowd
