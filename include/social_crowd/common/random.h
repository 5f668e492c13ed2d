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
  enum Stream : std::uint64_t { PLACEMENT = 1, EXPLORATION = 2, SCENARIO_CHOICE = 3, TIES = 4, CONTENT = 5 };

  KeyedRandom(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> key)
      : state_(mix(mix(seed + GOLDEN_GAMMA) + stream)) {
    for (const std::uint64_t part : key) state_ = mix(state_ + GOLDEN_GAMMA + part);
  }

  /// @brief The generator whose key is this one's and one part more; to be called before anything is drawn. Saves the
  /// work for the parts that many keys have in common.
  KeyedRandom with(std::uint64_t part) const { return KeyedRandom(mix(state_ + GOLDEN_GAMMA + part)); }

  /// @brief 64 random bits.
  std::uint64_t next() {
    state_ += GOLDEN_GAMMA;
    return mix(state_);
  }
  /// @brief Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  /// @brief Uniform in [low, high); exactly `low` if both are equal.
  double uniform(double low, double high);
  /// @brief Uniform in 0 .. count-1; `count` must be above 0.
  std::uint32_t below(std::uint32_t count);

 private:
  static constexpr std::uint64_t GOLDEN_GAMMA = 0x9E3779B97F4A7C15ULL;

  explicit KeyedRandom(std::uint64_t state) : state_(state) {}
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

}  // namespace crowd
