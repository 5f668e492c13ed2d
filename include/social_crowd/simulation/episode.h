#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "social_crowd/common/object_pool.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/simulation/greedy_crowd.h"
#include "social_crowd/world/scene.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief One episode: a world that is walked until all agents have arrived or time is up. The same steps serve the
/// headless runs and the ROS node; whoever drives it brings the actions.
///
/// A tick is one turn of all agents together (Order::SIMULTANEOUS), or a turn for each agent (Order::SEQUENTIAL).
/// The caller repeats: perceptions() of the agents whose turn it is, their actions, step(); until isOver().
class Episode {
 public:
  /// @param number goes into the perceptions; learners draw their exploration from it.
  /// @param thread_pool its threads share out the agents as long as the episode lives; what comes of it does not depend
  /// on their number
  Episode(Scene scene, std::uint64_t number, const Vision& vision, ThreadPool& thread_pool = ThreadPool::callerOnly());

  /// @brief What the agents perceive whose turn it is; once the episode is over that is all of them, with `last`.
  const Perceptions& perceptions();
  /// @brief The same to be kept: it stays as it is while somebody holds it.
  std::shared_ptr<const Perceptions> sharedPerceptions();
  /// @brief What the learner decides on perceptions(): the same as Learner::decide(). Where all agents have their turn
  /// in demo mode it is faster (see GreedyCrowd), in another order of agents, and the learner does not come to know
  /// them.
  void decide(Learner& learner, RelativeActions& actions);
  /// @brief Moves the agents whose turn it is; those without an action stay. @throws InputError, nothing has moved
  /// then.
  /// @return whether that was the last turn of the tick
  bool step(const std::vector<AgentAction>& actions);
  /// @brief Whether all agents have arrived or time is up, which a step() notes at the end of a tick only.
  bool isOver() const;

  /// @brief Turns that a tick has now: one, or one for each agent on its way.
  std::size_t turnsOfTick() const { return isSequential() ? std::max<std::size_t>(1, world_.activeCount()) : 1; }

  std::uint64_t number() const { return number_; }
  const Scene& scene() const { return scene_; }
  const World& world() const { return world_; }
  EpisodeResult result() const { return monitor_.result(); }

  /// @brief Changes the world between two ticks; perceptions() follow. @throws InputError, nothing has changed then.
  AgentId spawnAgent(const AgentStart& start);
  void removeAgent(AgentId id);
  void setGoal(AgentId id, const Vector2& goal);
  std::size_t spawnObstacle(const Vector2& position, const Vector2& velocity, double radius);
  void removeObstacle(std::size_t number);

 private:
  bool isSequential() const { return scene_.order == Order::SEQUENTIAL; }
  void perceiveTurn();
  /// Goes on to the next agent that is to have a turn in this tick, beginning with `turn_`; whether there is one.
  bool findTurn();
  bool endTick();

  Scene scene_;
  World world_;
  Vision vision_;
  ThreadPool* thread_pool_;
  EpisodeMonitor monitor_;
  std::uint64_t number_;
  ObjectPool<std::shared_ptr<Perceptions>> buffers_;
  std::shared_ptr<Perceptions> perceptions_ = buffers_.next();  // those of the last time that somebody asked
  bool may_be_held_ = false;                                    // by others: they were shared
  bool are_current_ = false;
  AgentId turn_ =
      0;  // the agent whose turn it is, sequential only; the number of agents if no turn is left in the tick
  GreedyCrowd crowd_;
};

}  // namespace crowd
