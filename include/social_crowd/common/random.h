#pragma once

#include <cstdint>
#include <initializer_list>

namespace crowd {

/// @brief Random numbers that depend on their key alone.
///
/// Every place that needs chance makes a generator of its own from what it is about: the run's seed, a stream (which
/// kind of choice), then episode, tick, agent. So a run is the same whatever the order of agents, the number of threads
/// or the way agents are split over learners. The mixing function is splitmix64 (Steele et al. 2014).
class KeyedRandom {
 public:
  /// @brief What is being drawn; keeps the choices of different parts independent of each other.
  enum Stream : std::uint64_t { PLACEMENT = 1, EXPLORATION = 2, SCENARIO_CHOICE = 3 };

  KeyedRandom(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> key);

  /// @brief 64 random bits.
  std::uint64_t next();
  /// @brief Uniform in [0, 1).
  double uniform();
  /// @brief Uniform in [low, high); exactly `low` if both are equal.
  double uniform(double low, double high);
  /// @brief Uniform in 0 .. count-1; `count` must be above 0.
  std::uint32_t below(std::uint32_t count);

 private:
  std::uint64_t state_;
};

}  // namespace crowd
