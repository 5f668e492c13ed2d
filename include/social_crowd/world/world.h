#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "social_crowd/common/stop_request.h"
#include "social_crowd/common/thread_pool.h"
#include "social_crowd/geometry/neighbour_grid.h"
#include "social_crowd/geometry/neighbour_search.h"
#include "social_crowd/geometry/solid_motion.h"
#include "social_crowd/geometry/wall_index.h"
#include "social_crowd/scenario/robot.h"
#include "social_crowd/scenario/scene.h"
#include "social_crowd/world/agent.h"
#include "social_crowd/world/agent_map.h"
#include "social_crowd/world/departed_agents.h"
#include "social_crowd/world/occlusion.h"
#include "social_crowd/world/perception.h"
#include "social_crowd/world/protective_stop.h"
#include "social_crowd/world/relative_action.h"

namespace crowd {

/// @brief Bodies that overlap by more than this are in contact [m].
constexpr double CONTACT_OVERLAP = 1e-3;

/// @brief State of agents, obstacles, robots and walls: moves them tick by tick and computes the perceptions.
///
/// A tick is either one step(), in which all agents move simultaneously, so that their order does not matter, or one
/// moveAgent() for each agent followed by endTick(): then each agent perceives the moves of the agents before it
/// (Order::SEQUENTIAL). Obstacles and robots move at the end of the tick in both cases.
///
/// Contacts and collisions are measured at the end of a tick. In a ghost world bodies pass through each other; an agent
/// is in contact if it overlaps something by more than CONTACT_OVERLAP. In a solid world bodies stop where they touch
/// (SolidMotion); then an agent is also in contact if it took part in an impact during the tick. An agent is in
/// collision if the rim of another body, or a wall, is within the scene's collision radius of its centre (thesis, 4.1).
/// Contacts and collisions with robots count as well. Robots are not in the grid of bodies: there are few of them, and
/// agents perceive them as discs that are larger than their footprints, or not at all.
///
/// Not thread-safe, except that any number of threads may call perceiveSome() while no thread changes the world.
class World {
 public:
  /// @brief Cell size of the grid of bodies [m]; about the search radius at usual walking distances.
  static constexpr double CELL_SIZE = 2.0;

  /// @brief In a world of more than MANY_WALLS, agents perceive the walls within this distance only [m]: there can be
  /// hundreds within the radius of vision, and walls farther away are left to way-finding.
  static constexpr double NEAR_WALLS = 1.2;
  static constexpr std::size_t MANY_WALLS = 100;

  /// @param stop long work on the world looks at it: the population, way-finding and decisions throw Stopped
  explicit World(const Scene& scene, StopRequest stop = {});

  std::uint64_t tick() const { return tick_; }
  /// @brief Time since the start of the episode [s].
  double time() const { return static_cast<double>(tick_) * tick_duration_; }
  double tickDuration() const { return tick_duration_; }
  Contact contact() const { return contact_; }
  const StopRequest& stopRequest() const { return stop_; }

  /// @brief The agents by id: all agents of the scene, and those that were added later. Of the latter, an agent that
  /// arrives or is removed is there until the end of the next tick; so a tick costs what the present agents cost.
  const AgentMap<Agent>& agents() const { return agents_; }
  /// @brief Number of agents so far. Their ids are 0 .. enteredCount() - 1.
  std::size_t enteredCount() const { return entered_count_; }
  /// @brief What is known of the agents that are no longer among agents().
  const DepartedAgents& departed() const { return departed_; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  const std::vector<Robot>& robots() const { return robots_; }
  const std::vector<Segment>& walls() const { return walls_.walls(); }
  const WallIndex& wallIndex() const { return walls_; }
  /// @brief Number of agents on their way.
  std::size_t activeCount() const { return active_count_; }
  /// @brief Whether the agent exists and is on its way.
  bool isActive(AgentId id) const;

  /// @brief Writes the perceptions of all agents that are on their way or arrived in the last tick. Sets all fields but
  /// `episode`, `turn` and `last`.
  void perceive(const Vision& vision, Perceptions& perceptions);

  /// @brief The same for one agent, for which isPerceiving() must hold, or for none.
  void perceiveAgent(const Vision& vision, std::optional<AgentId> id, Perceptions& perceptions);
  /// @brief Whether perceive() includes the agent: it is on its way, or arrived in the last tick.
  bool isPerceiving(AgentId id) const {
    const Agent* const agent = agents_.find(id);
    return agent != nullptr && isPerceiving(*agent);
  }

  /// @brief Workspace of one thread for perceiveSome().
  struct PerceptionWorkspace {
    NeighbourSearch search;
    Occlusion occlusion;
    NeighbourList near;                     ///< all neighbours of one agent, hidden ones included
    std::vector<Neighbour> neighbours;      ///< the visible ones
    std::vector<Segment> walls;             ///< of all agents so far
    std::vector<std::uint32_t> near_walls;  ///< of one agent
    std::vector<NearDisc> near_discs;       ///< of one agent: bodies of the grid and robots
  };

  /// @brief Number of bodies in the grid: agents on their way and obstacles.
  std::size_t bodyCount() const { return grid_.size(); }
  /// @brief The same as perceive(), only for the agents among the bodies first .. last - 1, in the order of the bodies,
  /// which is spatial for large crowds. Agents that have just arrived are not among the bodies. Any number of threads
  /// may call it at the same time, each with its own workspace and perceptions.
  void perceiveSome(const Vision& vision, std::size_t first, std::size_t last, PerceptionWorkspace& workspace,
                    Perceptions& perceptions) const;

  /// @brief Writes what an agent in a robot's place would perceive: a disc of the radius that agents perceive, with the
  /// robot's maximum speed, and the id agentIdOf(id). Sets all fields but `episode` and `turn`. Any number of threads
  /// may call it at the same time, as perceiveSome(). @param goal that it perceives [m], `map`
  void perceiveRobot(const Vision& vision, RobotId id, const Vector2& goal, PerceptionWorkspace& workspace,
                     Perceptions& perceptions) const;

  /// @brief Executes one tick. Agents without an action stay; actions of unknown or arrived agents are ignored.
  /// @param thread_pool its threads share the agents; the result does not depend on their number
  /// @throws InputError if an action is not finite or its speed fraction is not within 0 to 1; the world is unchanged
  /// then. Stopped if the stop request is made; the world must not be used any more then.
  void step(const std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief The first half of step(): agents turn, and in a ghost world they move. In a solid world the motions are
  /// computed, but not yet carried out.
  void beginStep(const std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief Between beginStep() and endStep() of a solid world: the intended motions of the agents on their way, in the
  /// order of their ids, then of the obstacles, then of the robots.
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

  /// @brief Adds an agent and returns its id. @throws InputError if its position is occupied, it has no goal, or a
  /// number is out of range.
  AgentId spawnAgent(const AgentStart& start);
  /// @brief Replaces all agents, between two ticks. Their ids become their indices; the order of ids decides between
  /// equally near neighbours. @return the former agents
  std::vector<Agent> replaceAgents(std::vector<Agent> agents);
  /// @brief Removes an agent. @throws InputError unless it is on its way.
  void removeAgent(AgentId id);
  /// @brief Replaces all goals of an agent by one [m], `map`. @throws InputError unless the agent is on its way.
  void setGoal(AgentId id, const Vector2& goal);
  /// @brief Sets the point that the agent perceives in place of its goal, which remains the point where it arrives,
  /// until it reaches the goal or gets another one. @param waypoint [m], `map` @throws InputError unless it is on its
  /// way.
  void setWaypoint(AgentId id, const Vector2& waypoint);
  /// @brief Makes the agent perceive its goal again. @throws InputError unless it is on its way.
  void clearWaypoint(AgentId id);
  /// @brief Makes an agent stay where it is, whatever its actions, or ends that. @throws InputError unless it is on its
  /// way.
  void hold(AgentId id, bool held);
  /// @brief The same, for agents that give way to others; both are independent.
  void setYielding(AgentId id, bool yielding);
  /// @brief Whether the agent leaves the world at its last goal. @throws InputError unless it is on its way.
  void setLeaves(AgentId id, bool leaves);
  /// @brief Lets an agent arrive now, as at its last goal. @throws InputError unless it is on its way.
  void leave(AgentId id);
  /// @brief Moves an agent to another place at once. @param pose in `map` @throws InputError unless it is on its way
  /// and the place is free; the world is unchanged then.
  void teleport(AgentId id, const Pose& pose);
  /// @brief Whether a disc at this place [m], `map`, would overlap no agent, robot, obstacle or wall.
  bool isFree(const Vector2& centre, double radius) const;
  /// @brief Adds an obstacle, whose path begins now, and returns its index. @param position [m], `map`
  /// @param velocity [m/s], `map` @param radius [m] @throws InputError if a number is invalid or it overlaps an agent.
  std::size_t spawnObstacle(const Vector2& position, const Vector2& velocity, double radius);
  /// @brief Moves an obstacle to another place. It keeps its velocity; one that follows waypoints stays there.
  /// @param position [m], `map` @throws InputError if there is no such obstacle, a number is not finite, or it would
  /// overlap an agent; the world is unchanged then.
  void moveObstacle(std::size_t number, const Vector2& position);
  /// @brief Removes an obstacle; the indices of later obstacles decrease by one. @throws InputError if there is none.
  void removeObstacle(std::size_t number);
  /// @brief Adds a wall and returns its id. @param wall [m], `map` @throws InputError if a number is not finite, the
  /// wall has no length, or it overlaps an agent.
  std::size_t addWall(const Segment& wall);
  /// @brief Removes a wall. @param id as returned by addWall(); the walls of the scene have the ids 0, 1, 2 ...
  /// @throws InputError if there is no such wall.
  void removeWall(std::size_t id);
  /// @brief Replaces all walls; their ids begin after the last one ever used. Agents may overlap them.
  void replaceWalls(std::vector<Segment> walls);

  /// @brief Sets what a robot is to do from the next tick on, until the next call; it follows within its limits.
  /// @throws InputError if there is no such robot, it is EXTERNAL, or a number is not finite.
  void commandRobot(RobotId id, const Twist& wanted);
  /// @brief Sets where an EXTERNAL robot is at the end of the coming tick; it stays there until the next call. The
  /// place may be occupied. @param pose in `map` @param velocity [m/s], `map` @param jump it does not move
  /// there on a straight line: it is at the place from the start of the tick on, without a velocity. @throws InputError
  /// if there is no such EXTERNAL robot or a number is not finite.
  void placeRobot(RobotId id, const Pose& pose, const Vector2& velocity, bool jump);
  /// @brief Replaces the goals of a robot [m], `map`; none: it has no goal any more.
  /// @throws InputError if there is no such robot or a number is not finite.
  void setRobotGoals(RobotId id, std::vector<Vector2> goals);
  /// @brief Moves a robot to another place at once, where it stands. @param pose in `map` @throws InputError if there
  /// is no such robot or the place is not free; the world is unchanged then.
  void teleportRobot(RobotId id, const Pose& pose);
  /// @brief The id of each wall, in the order of walls().
  const std::vector<std::size_t>& wallIds() const { return wall_ids_; }
  /// @brief Number of changes of walls and obstacles at rest, for caches of what depends on them.
  std::uint64_t layoutChanges() const { return layout_changes_; }

 private:
  /// Where an EXTERNAL robot is at the end of a tick.
  struct RobotPlace {
    Pose pose;
    Vector2 velocity = Vector2::Zero();  // `map` [m/s]
    bool jump = false;
  };

  void assignActions(const std::vector<AgentAction>& actions);
  void beginMove(Agent& agent, const RelativeAction* action) const;
  /// Moves the solid bodies for which moves(body) holds (agents by position, then obstacles); the others stand still.
  template <typename Moves>
  void moveSolids(const Moves& moves);
  /// The two halves of moveSolids(): computes the motions, and carries them out.
  template <typename Moves>
  void computeSolidMotions(const Moves& moves);
  template <typename Moves>
  void carryOutSolidMotions(const Moves& moves);
  void finishTick(ThreadPool& thread_pool);
  /// Removes the agents that left before this tick from `agents_`. @return whether there were any
  bool dropDeparted();
  void endMove(std::size_t position, std::size_t& arrivals);
  /// Whether the rim of another body, or a wall, is within the distance of the agent's centre.
  bool isAnythingWithin(double distance, std::size_t position) const;
  void requireObstacle(std::size_t number) const;
  void placeObstacles();
  void moveObstacles();
  void rebuildGrid();
  /// Moves all bodies in the grid, which must contain them already.
  void updateGrid();
  /// The same for one agent.
  void updateGridOf(std::size_t position);
  /// Calls work(agent, body) for the agents among the bodies first .. last - 1 of the grid, in the order of its cells.
  template <typename Work>
  void forEachInGrid(std::size_t first, std::size_t last, const Work& work) const;
  bool hasJustArrived(const Agent& agent) const { return agent.hasArrived() && agent.arrival_tick == tick_; }
  bool isPerceiving(const Agent& agent) const {
    return agent.perceives && (agent.isWalking() || hasJustArrived(agent));
  }
  /// Prepares perceptions for a number of agents.
  void beginPerceptions(const Vision& vision, std::size_t agents, PerceptionWorkspace& workspace,
                        Perceptions& perceptions) const;
  /// Writes the perception of an agent to `self`; `before` agents have been written before it. `body` is its own.
  void perceiveOne(const Vision& vision, const Agent& agent, std::uint32_t body, std::size_t before,
                   PerceptionWorkspace& workspace, AgentPerception& self, Perceptions& perceptions) const;
  void perceiveSelf(const Agent& agent, const Rotation& frame, AgentPerception& self) const;
  /// Adds the robots that the agent perceives to the bodies found by the search, nearest rim first. Robot i has the
  /// number grid_.size() + i.
  Span<NearDisc> withRobots(const Span<NearDisc>& found, const Vision& vision, std::size_t max_count,
                            const Agent& agent, PerceptionWorkspace& workspace) const;
  static Neighbour seenRobot(const Robot& robot, const Agent& agent);
  /// Writes the bodies found by the search in the agent's frame.
  void writeNeighbours(const Span<NearDisc>& found, const Agent& agent, std::size_t first,
                       NeighbourList& neighbours) const;
  void findWalls(const Vision& vision, const Agent& agent, const Rotation& frame, PerceptionWorkspace& workspace) const;
  /// Reduces neighbours and walls in the workspace to their visible parts.
  void applyOcclusion(const Vision& vision, AgentPerception& self, PerceptionWorkspace& workspace) const;
  void addAgent(const AgentStart& start);
  void addRobot(const RobotStart& start);
  Robot& findRobot(RobotId id);
  /// Determines the motions of the robots in the coming tick.
  void beginRobotMoves();
  /// Motions of robots that stand still, while an agent moves alone.
  void holdRobots();
  void addRobotDiscs();
  /// Puts the robots where they are at the end of the tick.
  void moveRobots();
  /// Counts the goals that robots have reached at the end of a tick.
  void endRobotMoves();
  /// Steps without robots skip all that is for robots.
  bool hasRobots() const { return !robots_.empty(); }
  /// Whether noteGhostContacts() is to be called.
  bool hasGhostRobots() const { return hasRobots() && contact_ == Contact::GHOST; }
  /// Notes contacts of robots with an agent that has just moved by `way` in a ghost world [m].
  void noteGhostContacts(const Agent& agent, const Vector2& way);
  void noteRobotContact(RobotId id, const Agent& agent, const Vector2& start, const Vector2& way);
  void noteSolidContacts();
  bool isRobotWithin(double distance, const Vector2& place) const;
  /// The name of a robot that overlaps a disc at this place; empty if none does.
  std::string findRobotBlocker(const Vector2& centre, double radius, std::optional<RobotId> except) const;
  void setWalls(std::vector<Segment> walls);
  Agent& findWalking(AgentId id);
  /// Makes what is kept by position fit the number of agents.
  void resizeWorkspaces();
  /// Returns what overlaps a disc at this place, such as "agent 3"; empty if nothing does. @param except an agent
  std::string findBlocker(const Vector2& centre, double radius, bool agents_only,
                          std::optional<AgentId> except = std::nullopt,
                          std::optional<RobotId> except_robot = std::nullopt) const;
  void requireFreePlace(const Vector2& centre, double radius, bool agents_only,
                        std::optional<AgentId> except = std::nullopt) const;
  void refresh();

  StopRequest stop_;
  double tick_duration_;
  double goal_tolerance_;
  double collision_radius_;
  Contact contact_;
  std::uint64_t tick_ = 0;
  AgentMap<Agent> agents_;
  std::size_t lasting_count_ = 0;  // the first ones, which stay there when they have arrived: those of the scene
  std::size_t entered_count_ = 0;
  DepartedAgents departed_;
  std::vector<Obstacle> obstacles_;
  std::vector<Robot> robots_;
  std::vector<std::optional<RobotPlace>> robot_places_;    // by robot: where an EXTERNAL one is to be next
  std::vector<RobotSweep> robot_sweeps_;                   // by robot: its intended motion in this tick
  std::vector<std::vector<RobotContact>> robot_contacts_;  // by robot: those of the present tick so far
  ProtectiveStop protective_stop_;
  WallIndex walls_;
  double wall_reach_ = 0.0;            // agents perceive walls within this distance [m]
  std::vector<std::size_t> wall_ids_;  // of these
  std::size_t next_wall_id_ = 0;
  std::uint64_t layout_changes_ = 0;
  std::size_t active_count_ = 0;
  std::size_t just_arrived_count_ = 0;  // in the last tick

  std::vector<ObstaclePath::Motion> obstacle_motions_;  // at the present time
  std::vector<std::size_t> moving_obstacles_;
  // Of the agents on their way and the obstacles. Body i is the agent at position i, or else an obstacle.
  NeighbourGrid grid_;
  std::vector<SolidMotion::Disc> discs_;  // scratch
  SolidMotion solid_motion_;
  // By position of the agent:
  std::vector<const RelativeAction*> assigned_actions_;  // during step() only
  std::vector<bool> had_turn_;                           // since the end of the last tick
  std::vector<std::uint32_t> places_;                    // its index in Perceptions::agents
  PerceptionWorkspace workspace_;                        // of perceive()
};

}  // namespace crowd
