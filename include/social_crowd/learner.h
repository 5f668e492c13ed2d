#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "social_crowd/perception.h"
#include "social_crowd/q_table.h"

namespace crowd {
class Learner;
}

namespace crowd::library {

/// @brief Decides for the agents of an Episode, or of your own simulator, with a Q-table, and learns if it is told to.
///
/// A decision depends only on what the agent perceives, its table, and (seed, episode, tick, agent), not on the other
/// agents. Use an object from one thread at a time.
class Learner {
 public:
  /// @brief Decides greedily and does not learn, until startLearning(). @param seed of random decisions
  explicit Learner(const QTable& table, std::uint64_t seed = 1);
  Learner(Learner&&) noexcept;
  Learner& operator=(Learner&&) noexcept;
  ~Learner();

  /// @brief Decides for each agent that has not arrived, unless `last` is set. Call it once in each tick. Neighbours
  /// beyond the limits of QTable::vision() are ignored; with its occlusion, hidden ones must not be among
  /// them. Walls beyond its wall_distance must not be among the walls.
  /// @param perceptions any agents; a change of `episode`, or a gap in `tick`, begins anew
  /// @return an action for each of these agents @throws InputError if a number is not finite, or the neighbours of an
  /// agent are not sorted, nearest rim first
  std::vector<Action> decide(const Perceptions& perceptions);

  /// @brief From now on learns from the outcome of the last decisions in decide(), with the learning rate and discount
  /// of the table. @param epsilon probability of a random action, 0 to 1 @throws InputError if it is not
  void startLearning(double epsilon);
  /// @brief Decides greedily from now on.
  void stopLearning();
  /// @brief A copy of the present table.
  QTable table();

  /// @brief For this library only.
  crowd::Learner& learner();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crowd::library
