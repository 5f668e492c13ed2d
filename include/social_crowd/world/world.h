#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "social_crowd/common/thread_pool.h"
#include "social_crowd/world/neighbour_grid.h"
#include "social_crowd/world/neighbour_search.h"
#include "social_crowd/world/occlusion.h"
#include "social_crowd/world/perception.h"
#include "social_crowd/world/relative_action.h"
#include "social_crowd/world/scene.h"
#include "social_crowd/world/solid_motion.h"

namespace crowd {

/// @brief Bodies that overlap by more than this are in contact [m].
constexpr double CONTACT_OVERLAP = 1e-3;

/// @brief Whether an agent is on its way, or why it is not on the floor any more.
enum class AgentStatus : std::uint8_t { WALKING = 0, ARRIVED = 1, REMOVED = 2 };

/// @brief An agent in the world.
struct Agent {
  AgentId id = 0;
  Pose pose;                           ///< in `map`
  Vector2 ahead = Vector2::UnitX();    ///< unit vector of the heading
  Vector2 velocity = Vector2::Zero();  ///< of the last tick, `map` [m/s]
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< [m]
  std::vector<Vector2> goals;          ///< [m], `map`
  std::size_t next_goal = 0;
  Vector2 present_goal = Vector2::Zero();  ///< that it walks to, or has arrived at [m]
  std::uint32_t goal_number = 0;           ///< counts the goals it has had
  AgentStatus status = AgentStatus::WALKING;
  std::uint64_t arrival_tick = 0;   ///< the tick at whose start it was there, if arrived
  bool acted = false;               ///< an action of its own was carried out in the last tick
  bool blocked = false;             ///< and its move was cut short where it touched something; solid worlds only
  std::uint64_t blocked_moves = 0;  ///< how often that was so
  bool in_contact = false;          ///< in the last tick
  bool bumped = false;              ///< walked into something since the last tick ended, or was walked into
  bool touched = false;             ///< in contact in any tick so far
  bool in_collision = false;        ///< at the end of the last tick something was within the collision radius
  bool collided = false;            ///< in collision in any tick so far

  bool isWalking() const { return status == AgentStatus::WALKING; }
  bool hasArrived() const { return status == AgentStatus::ARRIVED; }
  /// @brief The goal that it walks to; of one that has arrived the last.
  const Vector2& goal() const { return present_goal; }
};

/// @brief The floor with everybody on it: moves agents and obstacles tick by tick and tells what each agent perceives.
///
/// A tick is either one step(), in which all agents move at the same time, so that their order does not matter, or a
/// moveAgent() for each agent and an endTick(): each agent then perceives where the agents before it have gone
/// (Order::SEQUENTIAL). Obstacles move at the end of the tick in both cases.
///
/// Contacts and collisions are measured at the end of a tick. In a ghost world bodies walk through each other; an agent
/// is in contact if it overlaps something by more than CONTACT_OVERLAP. In a solid world bodies stop where they touch
/// (SolidMotion); an agent that walked into something in the tick, or was walked into, was in contact, too. An agent is
/// in collision if the rim of another body, or a wall, is within the scene's collision radius of its centre
/// (thesis, 4.1).
class World {
 public:
  /// @brief Of the grid of bodies [m]; about the reach of a look around at walking distances.
  static constexpr double CELL_SIZE = 2.0;

  explicit World(const Scene& scene);

  std::uint64_t tick() const { return tick_; }
  /// @brief Time since the episode's start [s].
  double time() const { return static_cast<double>(tick_) * tick_duration_; }
  double tickDuration() const { return tick_duration_; }
  Contact contact() const { return contact_; }

  /// @brief All agents ever there, arrived ones too, in order of their ids.
  const std::vector<Agent>& agents() const { return agents_; }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }
  const std::vector<Segment>& walls() const { return walls_; }
  /// @brief Agents that are still on their way.
  std::size_t activeCount() const { return active_count_; }
  /// @brief Whether the agent is there and still on its way.
  bool isActive(AgentId id) const;

  /// @brief What every agent perceives that is on its way, or arrived in the last tick. Sets everything but `episode`
  /// and `last`.
  void perceive(const Vision& vision, Perceptions& perceptions);

  /// @brief The same for one agent, which isPerceiving(), or for none.
  void perceiveAgent(const Vision& vision, std::optional<AgentId> id, Perceptions& perceptions);
  /// @brief Whether perceive() tells of the agent: it is on its way, or arrived in the last tick.
  bool isPerceiving(AgentId id) const { return id < agents_.size() && isPerceiving(agents_[id]); }

  /// @brief Working space of one thread that perceives.
  struct PerceptionWorkspace {
    NeighbourSearch search;
    Occlusion occlusion;
    NeighbourList near;                 ///< all near one agent, some perhaps hidden
    std::vector<Neighbour> neighbours;  ///< those that are not
    std::vector<Segment> walls;         ///< of all agents it looked for
  };

  /// @brief Bodies on the floor: agents on their way and obstacles.
  std::size_t bodyCount() const { return grid_.size(); }
  /// @brief The same as perceive(), for those agents alone that are among the bodies first .. last-1, in the order of
  /// these. Who has just arrived is not. Neighbours stand one after the other. Any number of threads may do that, each
  /// with working space and perceptions of its own.
  void perceiveSome(const Vision& vision, std::size_t first, std::size_t last, PerceptionWorkspace& workspace,
                    Perceptions& perceptions) const;

  /// @brief Moves everybody for one tick; who has no action stays. Actions of unknown or arrived agents are ignored.
  /// @param thread_pool its threads share out the agents; what becomes of them does not depend on their number
  /// @throws InputError if any action is not finite or its fraction of the maximum speed is not in 0..1; nothing has
  /// moved then.
  void step(const std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());
  /// @brief Moves one agent now, by the action of that agent among the given ones; without one it stays.
  /// @throws InputError as step() does; nothing has moved then.
  void moveAgent(AgentId id, const std::vector<AgentAction>& actions);
  /// @brief Ends a tick in which agents moved one after the other. Agents that had no turn in it stayed.
  void endTick(ThreadPool& thread_pool = ThreadPool::callerOnly());

  /// @brief Puts one more agent on the floor. Returns its number. @throws InputError if its place is taken, it has no
  /// goal, or a number is out of its range.
  AgentId spawnAgent(const AgentStart& start);
  /// @brief Takes an agent off the floor. @throws InputError unless it is on its way.
  void removeAgent(AgentId id);
  /// @brief Gives an agent one goal in place of all it had [m]. @throws InputError unless it is on its way.
  void setGoal(AgentId id, const Vector2& goal);
  /// @brief Puts one more obstacle on the floor; its path begins now. Returns its number. @throws InputError if it is
  /// not valid or overlaps an agent.
  std::size_t spawnObstacle(const Vector2& position, const Vector2& velocity, double radius);
  /// @brief Takes an obstacle off the floor; the numbers of those behind it go down by one. @throws InputError
  void removeObstacle(std::size_t number);

 private:
  void takeOrders(const std::vector<AgentAction>& actions);
  void beginMove(Agent& agent, const RelativeAction* action) const;
  /// Moves the solid bodies that `moves` tells of (agents by number, then obstacles); the others stand still.
  template <typename Moves>
  void moveSolids(const Moves& moves);
  void finishTick(ThreadPool& thread_pool);
  /// Puts an agent that has moved into its new place in the grid.
  void updateGridOf(const Agent& agent);
  void endMove(Agent& agent, std::size_t& arrivals) const;
  /// Whether the rim of another body, or a wall, is within the distance of the agent's centre.
  bool isAnythingWithin(double distance, const Agent& agent) const;
  void placeObstacles();
  void moveObstacles();
  void rebuildGrid();
  /// Everybody who was on the floor when the grid was built has moved.
  void updateGrid();
  void lookOneByOne(const Vision& vision, Perceptions& perceptions);
  /// Neighbours one after the other.
  void lookInOrder(const Vision& vision, Perceptions& perceptions);
  void orderAgents(Perceptions& perceptions);
  bool hasJustArrived(const Agent& agent) const { return agent.hasArrived() && agent.arrival_tick == tick_; }
  bool isPerceiving(const Agent& agent) const { return agent.isWalking() || hasJustArrived(agent); }
  /// For so many agents, with the space that they need.
  void begin(const Vision& vision, std::size_t agents, PerceptionWorkspace& workspace, Perceptions& perceptions) const;
  /// Writes what the agent perceives that comes after `before` others.
  void look(const Vision& vision, const Agent& agent, std::size_t before, PerceptionWorkspace& workspace,
            AgentPerception& self, Perceptions& perceptions) const;
  void lookAtSelf(const Agent& agent, const Rotation& frame, AgentPerception& self) const;
  /// Writes the bodies that the search has found.
  void writeNeighbours(const Span<NearDisc>& found, const Agent& agent, std::size_t first,
                       NeighbourList& neighbours) const;
  void findWalls(const Vision& vision, const Agent& agent, const Rotation& frame, PerceptionWorkspace& workspace) const;
  void hide(const Vision& vision, AgentPerception& self, PerceptionWorkspace& workspace) const;
  Agent& findWalking(AgentId id);
  void requireFreePlace(const Vector2& centre, double radius, bool agents_only);
  void refresh();

  double tick_duration_;
  double goal_tolerance_;
  double collision_radius_;
  Contact contact_;
  std::uint64_t tick_ = 0;
  std::vector<Agent> agents_;
  std::vector<Obstacle> obstacles_;
  std::vector<Segment> walls_;
  std::size_t active_count_ = 0;
  std::size_t just_arrived_count_ = 0;  // in the last tick

  std::vector<Vector2> obstacle_positions_;   // now
  std::vector<Vector2> obstacle_velocities_;  // now
  std::vector<std::size_t> moving_obstacles_;
  NeighbourGrid grid_;                    // of the agents on their way and the obstacles
  std::vector<std::uint32_t> found_;      // scratch
  std::vector<SolidMotion::Disc> discs_;  // scratch
  SolidMotion solid_motion_;
  std::vector<const RelativeAction*> orders_;  // of each agent, during step() only
  std::vector<bool> had_turn_;                 // of each agent, since the last tick ended
  PerceptionWorkspace workspace_;              // of perceive()
  std::vector<std::uint32_t> places_;          // place in Perceptions::agents of each agent
};

}  // namespace crowd
