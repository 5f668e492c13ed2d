#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/stop_request.h"
#include "common/thread_pool.h"
#include "geometry/motion_limits.h"
#include "geometry/neighbour_grid.h"
#include "geometry/solid_motion.h"
#include "scenario/scene.h"
#include "world/agent.h"
#include "world/agent_map.h"
#include "world/departed_agents.h"
#include "world/neighbours.h"
#include "world/obstacles.h"
#include "world/relative_action.h"
#include "world/robots.h"
#include "world/walls.h"

namespace crowd {

/// @brief State of agents, obstacles, robots and walls, and the step that moves them tick by tick. A Perceiver
/// perceives it; a WorldEditor changes it between two ticks.
///
/// A tick is either one step(), in which all agents move simultaneously, so that their order does not matter, or one
/// moveAgent() for each agent followed by endTick(): then each agent perceives the moves of the agents before it
/// (Order::SEQUENTIAL). Obstacles and robots move at the end of the tick in both cases.
///
/// Contacts and collisions are measured at the end of a tick. In a ghost world bodies pass through each other; an agent
/// is in contact if it overlaps something by more than CONTACT_OVERLAP. In a solid world bodies stop where they touch
/// (SolidMotion); then an agent is also in contact if it took part in an impact during the tick. An agent is in
/// collision if the rim of another body, or a wall, is within the scene's collision radius of its centre (thesis, 4.1).
/// Contacts and collisions with robots count as well.
///
/// Not thread-safe.
class World {
 public:
  /// @brief Cell size of the grid of bodies [m]; about the search radius at usual walking distances.
  static constexpr double CELL_SIZE = 2.0;

  /// @param stop long work on the world looks at it: the population, way-finding and decisions throw Stopped
  explicit World(const Scene& scene, StopRequest stop = {});

  std::uint64_t tick() const { return tick_; }
  /// @brief Time since the start of the episode [s].
  double time() const { return static_cast<double>(tick_) * tick_duration_; }
  double tickDuration() const { return tick_duration_; }
  Contact contact() const { return contact_; }
  /// @brief Limits of the changes of velocity of the agents. Those who decide keep them, see Perceptions; the world
  /// does for agents that it holds.
  const MotionLimits& motion() const { return motion_; }
  /// @brief Changes these limits.
  void setMotion(const MotionLimits& motion) { motion_ = motion; }
  const StopRequest& stopRequest() const { return stop_; }

  /// @brief The agents by id: all agents of the scene, and those that were added later. Of the latter, an agent that
  /// leaves or is removed is there until the end of the next tick; so a tick costs what the present agents cost.
  const AgentMap<Agent>& agents() const { return agents_; }
  /// @brief An agent, to change what it is to do: its goals, waypoint, and whether it stands or leaves. Place and body
  /// are changed by WorldEditor. @throws InputError unless it is on its way
  Agent& walkingAgent(AgentId id);
  /// @brief Number of agents so far. Their ids are 0 .. enteredCount() - 1.
  std::size_t enteredCount() const { return entered_count_; }
  /// @brief What is known of the agents that are no longer among agents().
  const DepartedAgents& departed() const { return departed_; }
  /// @brief Whether any agent so far walks with others (Agent::group).
  bool hasGroups() const { return has_groups_; }
  /// @brief Number of agents on their way.
  std::size_t activeCount() const { return active_count_; }
  /// @brief Whether the agent exists and is on its way.
  bool isActive(AgentId id) const;
  /// @brief Whether the agent perceives: it is on its way, or arrived in the last tick.
  bool isPerceiving(const Agent& agent) const {
    const bool has_just_arrived = agent.hasArrived() && agent.arrival_tick == tick_;
    return agent.perceives && (agent.isWalking() || has_just_arrived);
  }

  /// @brief All obstacles, also recorded people who are not present now.
  const std::vector<Obstacle>& obstacles() const { return obstacles_.list(); }
  bool isPresent(const Obstacle& obstacle) const { return obstacle.path.isPresent(time()); }
  /// @brief The recorded people who are present, in `map`.
  std::vector<Neighbour> recordedPeople() const { return obstacles_.recordedPeople(); }
  const Walls& walls() const { return walls_; }
  /// @brief Number of changes of walls and obstacles at rest, for caches of what depends on them.
  std::uint64_t layoutChanges() const { return layout_changes_; }
  const Robots& robots() const { return robots_; }
  Robots& robots() { return robots_; }
  /// @brief The agents and the obstacles that are present. Body i is the agent at position i of agents(),
  /// or else an obstacle.
  const NeighbourGrid& grid() const { return grid_; }
  /// @brief What overlaps a disc at a place [m], `map`, such as "agent 3"; empty if nothing does.
  /// @param agents_only obstacles and walls do not count @param except an agent, or a robot, that does not count
  std::string blockerAt(const Vector2& centre, double radius, bool agents_only = false,
                        std::optional<AgentId> except = std::nullopt,
                        std::optional<RobotId> except_robot = std::nullopt) const;

  /// @brief Executes one tick. Agents without an action stay; actions of unknown or arrived agents are ignored.
  /// @param thread_pool its threads share the agents; the result does not depend on their number
  /// @throws InputError if an action is not finite or its speed fraction is not within 0 to 1; the world is unchanged
  /// then. Stopped if the stop request is made; the world must not be used any more then.
  void step(const std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief The first half of step(): agents turn, and in a ghost world they move. In a solid world the motions are
  /// computed, but not yet carried out.
  void beginStep(const std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief Between beginStep() and endStep() of a solid world: the intended motions of the agents that are present, in
  /// the order of their ids, then of the obstacles that are present, then of the robots.
  const std::vector<SolidMotion::Disc>& solidDiscs() const { return discs_; }
  /// @brief The outcomes of these motions; endStep() carries out those that are here then.
  std::vector<SolidMotion::Outcome>& solidOutcomes() { return solid_motion_.outcomes(); }
  /// @brief The second half of step(): carries out the motions of a solid world, then measures contacts, collisions and
  /// arrivals.
  void endStep(ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief Moves one agent now, by its action among the given ones; without one it stays.
  /// @throws InputError as step() does; the world is unchanged then.
  void moveAgent(AgentId id, const std::vector<AgentAction>& actions);
  /// @brief Ends a tick of moveAgent() calls. Agents that had no turn in it stay.
  void endTick(ThreadPool& thread_pool = ThreadPool::callerOnly());

 private:
  friend class WorldEditor;

  /// Bodies of a solid world: agents by position, then obstacles.
  struct BodyRange {
    std::size_t begin = 0;
    std::size_t end = static_cast<std::size_t>(-1);

    static BodyRange all() { return {}; }
    bool contains(std::size_t body) const { return begin <= body && body < end; }
  };

  double endOfTick() const { return static_cast<double>(tick_ + 1) * tick_duration_; }
  void hold(Agent& agent, const RelativeAction* action) const;
  void beginMove(Agent& agent, const RelativeAction* action) const;
  /// Computes the motions of solid bodies; those outside the range stand still.
  void computeSolidMotions(const BodyRange& moving);
  /// Carries out these motions.
  void carryOutSolidMotions(const BodyRange& moving);
  void finishTick(ThreadPool& thread_pool);
  /// Removes the agents that left before this tick from `agents_`. @return whether there were any
  bool dropDeparted();
  void endMove(std::size_t position, std::size_t& arrivals);
  void followPace(Agent& agent) const;
  /// Whether the rim of another body, or a wall, is within the distance of the agent's centre.
  bool isAnythingWithin(double distance, std::size_t position) const;
  /// The motions of recorded people in the coming tick; none without robots.
  std::vector<PersonMotion> recordedMotions() const;
  void rebuildGrid();
  /// Moves all bodies in the grid, which must contain them already.
  void updateGrid();

  StopRequest stop_;
  double tick_duration_;
  MotionLimits motion_;
  double goal_tolerance_;
  double collision_radius_;
  Contact contact_;
  std::uint64_t tick_ = 0;
  AgentMap<Agent> agents_;
  std::size_t lasting_count_ = 0;  // the first ones, which stay there when they have arrived: those of the scene
  std::size_t entered_count_ = 0;
  bool has_groups_ = false;
  DepartedAgents departed_;
  Obstacles obstacles_;
  Robots robots_;
  Walls walls_;
  std::uint64_t layout_changes_ = 1;
  std::size_t active_count_ = 0;

  NeighbourGrid grid_;
  std::vector<SolidMotion::Disc> discs_;  // scratch
  SolidMotion solid_motion_;
  // By position of the agent:
  std::vector<const RelativeAction*> assigned_actions_;  // during step() only
  std::vector<bool> had_turn_;                           // since the end of the last tick
};

}  // namespace crowd
