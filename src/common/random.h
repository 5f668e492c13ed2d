#pragma once

#include <cstdint>
#include <initializer_list>

namespace crowd {

/// @brief Random number generator whose sequence depends only on its key.
///
/// Each random choice constructs its own generator from the seed of the run, a stream (the kind of choice), and then
/// episode, tick and agent. A run is therefore independent of the order of agents, of the number of threads and of the
/// distribution of agents over learners. The mixing function is splitmix64 (Steele et al. 2014).
class KeyedRandom {
 public:
  /// @brief Kind of random choice; choices of different streams are independent.
  enum Stream : std::uint64_t {
    PLACEMENT = 1,
    EXPLORATION = 2,
    SCENARIO_CHOICE = 3,
    TIES = 4,
    CONTENT = 5,
    POPULATION = 6,
    ROBOT_PLACEMENT = 7,
    SENSOR = 8,
    ODOMETRY = 9,
    GAIT = 10,
    GROUPS = 11,
    ATTRACTIONS = 12,
    ALARMS = 13,
    KIND = 14,
    DISTRACTION = 15,
    REACTIONS = 16,
    TRACKS = 17
  };

  KeyedRandom(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> key)
      : state_(mix(mix(seed + GOLDEN_GAMMA) + stream)) {
    for (const std::uint64_t part : key) state_ = mix(state_ + GOLDEN_GAMMA + part);
  }

  /// @brief Returns a generator with one more part in its key; call it before the first draw. Avoids repeated mixing of
  /// parts that many keys share.
  KeyedRandom with(std::uint64_t part) const { return KeyedRandom(mix(state_ + GOLDEN_GAMMA + part)); }

  /// @brief 64 random bits.
  std::uint64_t next() {
    state_ += GOLDEN_GAMMA;
    return mix(state_);
  }
  /// @brief Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  /// @brief Uniform in [low, high); `low` if both are equal.
  double uniform(double low, double high);
  /// @brief Normally distributed with mean 0 and standard deviation 1 (Box and Muller 1958).
  double normal();
  /// @brief Uniform in 0 .. count - 1; `count` must be above 0.
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
