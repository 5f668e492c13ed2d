#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "world/world.h"

namespace crowd {

/// @brief A change of a world that is about to be made, or was just made; the lists are those after it. What is null
/// stays as it is.
struct WorldChange {
  const Agent* agent = nullptr;       ///< as it is then; a new one if there is `start`
  const AgentStart* start = nullptr;  ///< of the new agent
  bool new_goal = false;              ///< the agent gets another goal
  const std::vector<Obstacle>* obstacles = nullptr;
  const std::vector<Segment>* walls = nullptr;
  bool fewer_walls = false;  ///< walls may be gone
};

/// @brief Changes a world between two ticks. Each function checks all that it is given before it changes anything, and
/// throws InputError if a number is out of range, a place is taken, there is no such agent, obstacle, wall or robot, or
/// an obstacle is a recorded person. Whoever knows more about the world derives from it, and may refuse changes, too.
class WorldEditor {
 public:
  explicit WorldEditor(World& world) : world_(world) {}
  WorldEditor(const WorldEditor&) = delete;
  WorldEditor& operator=(const WorldEditor&) = delete;
  virtual ~WorldEditor() = default;

  /// @brief Adds an agent and returns its id.
  AgentId spawnAgent(const AgentStart& start);
  /// @brief Replaces all agents, also by others of the same ids. @param agents by ascending id @return the former
  /// agents
  std::vector<Agent> replaceAgents(std::vector<Agent> agents);
  void removeAgent(AgentId id);
  /// @brief Lets an agent arrive now, as at its last goal.
  void arrive(AgentId id);
  /// @brief The same, but it leaves the world in any case, as at a sink.
  void leave(AgentId id);
  /// @brief Replaces all goals of an agent by one [m], `map`.
  void setGoal(AgentId id, const Vector2& goal);
  /// @brief Moves an agent to another place at once. @param pose in `map`
  void teleport(AgentId id, const Pose& pose);
  /// @brief Moves a robot to another place at once, where it stands. @param pose in `map`
  void teleportRobot(RobotId id, const Pose& pose);

  /// @brief Adds an obstacle, whose path begins now, and returns its index. It may overlap anything but agents and
  /// robots. @param position [m], `map` @param velocity [m/s], `map` @param radius [m]
  std::size_t spawnObstacle(const Vector2& position, const Vector2& velocity, double radius);
  /// @brief Moves an obstacle to another place. It keeps its velocity; one that follows waypoints stays there.
  /// @param position [m], `map`
  void moveObstacle(std::size_t number, const Vector2& position);
  /// @brief Removes an obstacle; the indices of later obstacles decrease by one.
  void removeObstacle(std::size_t number);
  /// @brief Adds a wall that overlaps no agent or robot, and returns its id (Walls).
  std::size_t addWall(const Segment& wall);
  void removeWall(std::size_t id);
  /// @brief Replaces all walls; their ids begin after the last one ever used. Agents may overlap them.
  void replaceWalls(std::vector<Segment> walls);

 protected:
  /// @brief Called before a valid change of the floor, of a place or of a goal is made. @throws InputError to refuse it
  virtual void review(const WorldChange& /*change*/) {}
  /// @brief Called after each change.
  virtual void note(const WorldChange& /*change*/) {}

  World& world_;

 private:
  void requireFreePlace(const Vector2& centre, double radius, bool agents_only,
                        std::optional<AgentId> except = std::nullopt,
                        std::optional<RobotId> except_robot = std::nullopt) const;
  /// An obstacle that may be changed: recorded people may not.
  const Obstacle& requireObstacle(std::size_t number) const;
  void replaceAgent(const Agent& agent, bool new_goal);
  void replaceObstacles(std::vector<Obstacle> obstacles);
  /// Notes a change of walls or obstacles.
  void noteLayout(const WorldChange& change);
  /// Takes an agent off the floor.
  void end(AgentId id, AgentStatus status);
};

}  // namespace crowd
