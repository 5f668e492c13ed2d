#pragma once

#include <cstdint>
#include <vector>

#include "common/random.h"
#include "scenario/person_kind.h"
#include "world/world.h"

namespace crowd {

/// @brief Lets agents slow down or stop by themselves, each at times of its own.
///
/// The time until a pause begins is drawn exponentially and that until it ends uniformly, whatever the agent does
/// meanwhile.
class Distraction {
 public:
  /// @param seed of all that is drawn during the episode
  explicit Distraction(std::uint64_t seed) : seed_(seed) {}

  /// @brief Adds an agent that appears now. @param time [s]
  void add(AgentId id, const PauseDescription& pauses, double time);
  /// @brief Begins and ends pauses that are due. Call it after each tick.
  void update(World& world);
  /// @brief The agent has no pauses any more.
  void end(AgentId id, World& world);
  bool isEmpty() const { return people_.empty(); }

 private:
  struct Person {
    AgentId id = 0;
    PauseDescription pauses;
    KeyedRandom random{0, KeyedRandom::DISTRACTION, {}};
    double next_change = 0.0;  // [s]
    bool is_distracted = false;
  };
  static double drawInterval(Person& person);
  static void apply(const Person& person, World& world);

  std::uint64_t seed_;
  std::vector<Person> people_;
};

}  // namespace crowd
