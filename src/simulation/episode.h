#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/object_pool.h"
#include "navigation/way_finder.h"
#include "navigation/way_lengths.h"
#include "population/population.h"
#include "robots/robot_monitor.h"
#include "scenario/scene.h"
#include "simulation/decider.h"
#include "simulation/episode_editor.h"
#include "simulation/episode_monitor.h"
#include "world/perceiver.h"

namespace crowd {

/// @brief One episode: runs a world until all agents have arrived or the maximum number of ticks is reached. Headless
/// runs, the ROS node, ranks and benchmarks use the same class, each with its own Decider.
///
/// A tick is one turn of all agents together (Order::SIMULTANEOUS), or one turn for each agent (Order::SEQUENTIAL). The
/// caller repeats walk() until isOver(). Not thread-safe.
class Episode {
 public:
  /// @param number of the episode; it is part of the perceptions, and learners seed their exploration with it
  /// @param thread_pool its threads share the agents; it must outlive the episode. Results do not depend on their
  /// number.
  /// @param stop ends the constructor, walk() and edit() early: they throw Stopped, and the episode must not
  /// be used any more
  Episode(Scene scene, std::uint64_t number, const Vision& vision, ThreadPool& thread_pool = ThreadPool::callerOnly(),
          StopRequest stop = {});

  /// @brief Changes the vision, and the motion limits of the agents unless the scene has them; perceptions() reflect
  /// both immediately.
  void setVision(const Vision& vision);
  const Vision& vision() const { return vision_; }

  /// @brief Perceptions of the agents whose turn it is; once the episode is over, of all agents, with `last` set. Valid
  /// until the next change of the world.
  const Perceptions& perceptions();
  /// @brief The same as a shared object that does not change while the caller holds it.
  std::shared_ptr<const Perceptions> sharedPerceptions();
  /// @brief One turn: perceive, decide, move; at the end of a tick also population and measures.
  /// @throws InputError as World::step() does; the world is unchanged then
  /// @return false if the decider does not let the agents move: the episode is over, or it was ended early
  bool walk(Decider& decider);
  /// @brief The rest of a turn with these actions; agents without one stay. @throws InputError as walk() does
  /// @return whether that was the last turn of the tick
  bool step(const std::vector<AgentAction>& actions, Decider* decider = nullptr);
  /// @brief Whether a tick begins, else there was a turn of it already.
  bool beginsTick() const { return begins_tick_; }
  /// @brief Whether the maximum number of ticks is reached, or no agent is on its way, no source has any left and no
  /// robot is on its way to a goal; agents do not count with Ends::ROBOTS. A scene without agents, sources and goals of
  /// robots lasts for the maximum number of ticks. A turn changes this only at the end of a tick.
  bool isOver() const;

  /// @brief Number of turns in the present tick: one, or one for each agent on its way.
  std::size_t turnsOfTick() const { return isSequential() ? std::max<std::size_t>(1, world_.activeCount()) : 1; }

  std::uint64_t number() const { return number_; }
  const Scene& scene() const { return scene_; }
  const World& world() const { return world_; }
  const Population& population() const { return population_; }
  const EpisodeMonitor& monitor() const { return monitor_; }
  const RobotMonitor& robotMonitor() const { return robot_monitor_; }
  EpisodeResult result() const;

  /// @brief Number of changes of the world, ticks included.
  std::uint64_t changes() const { return changes_; }

  /// @brief Changes the world; perceptions() reflect it.
  EpisodeEditor edit() { return EpisodeEditor(*this); }
  /// @brief Commands robots, places them and sets their goals.
  Robots& robots() { return world_.robots(); }

 private:
  friend class EpisodeEditor;

  /// Notes a change of the world: waypoints are updated, and the perceptions are not current any more.
  void noteChange();
  /// Whether ways are found.
  bool findsWays() const { return scene_.way_finding && way_finding_problem_.empty(); }
  bool isSequential() const { return scene_.order == Order::SEQUENTIAL; }
  /// Those who perceive in this turn.
  const Viewers& viewersOfTurn();
  /// Advances `turn_` to the next agent that has a turn in this tick, starting with `turn_` itself; false if none.
  bool findTurn();
  /// Moves the agents whose turn it is. Returns whether that was the last turn of the tick.
  bool move(const std::vector<AgentAction>& actions, Decider* decider);

  Scene scene_;
  World world_;
  Vision vision_;
  ThreadPool* thread_pool_;
  EpisodeMonitor monitor_;
  RobotMonitor robot_monitor_;
  Population population_;
  WayFinder way_finder_;
  WayLengths way_lengths_;  // for changes by users, which do not affect the ways of the population if they are refused
  std::string way_finding_problem_;  // see EpisodeResult
  std::uint64_t number_;
  std::uint64_t changes_ = 0;
  ObjectPool<std::shared_ptr<Perceptions>> buffers_;
  std::shared_ptr<Perceptions> perceptions_ = buffers_.next();  // latest
  bool may_be_held_ = false;                                    // `perceptions_` were shared with a caller
  bool are_current_ = false;
  Viewers viewers_;
  Perceiver perceiver_;
  AgentId turn_ = 0;  // agent whose turn it is (sequential only), or the number of agents if no turn is left
  bool begins_tick_ = true;
  std::vector<AgentAction> actions_;  // of walk()
};

}  // namespace crowd
