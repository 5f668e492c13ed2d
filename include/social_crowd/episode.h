#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "social_crowd/learner.h"
#include "social_crowd/perception.h"
#include "social_crowd/results.h"
#include "social_crowd/scenario.h"

namespace crowd {
class Episode;
}

namespace crowd::library {

/// @brief WALKING: on its way. ARRIVED, REMOVED: not in the world any more. STAYING: has arrived, and stays in the
/// world as a body at rest.
enum class AgentStatus : std::uint8_t { WALKING = 0, ARRIVED = 1, REMOVED = 2, STAYING = 3 };

/// @brief An agent between two ticks; all vectors in `map`.
struct AgentState {
  AgentId id = 0;
  AgentStatus status = AgentStatus::WALKING;
  Pose pose;
  Vector2 velocity;           ///< of the last tick [m/s]
  double max_speed = 0.0;     ///< [m/s]
  double radius = 0.0;        ///< [m]
  Vector2 goal;               ///< present goal, or the last one after arrival [m]
  bool in_contact = false;    ///< in the last tick
  bool touched = false;       ///< in contact in any tick so far
  bool in_collision = false;  ///< in the last tick (thesis, 4.1)
  bool collided = false;      ///< in collision in any tick so far
};

/// @brief The same of all agents by ascending id, as arrays with an element or a row for each.
struct AgentArrays {
  std::vector<AgentId> id;
  std::vector<std::uint8_t> status;  ///< see AgentStatus
  std::vector<double> position;      ///< x, y
  std::vector<double> heading;
  std::vector<double> velocity;  ///< x, y
  std::vector<double> max_speed;
  std::vector<double> radius;
  std::vector<double> goal;  ///< x, y
  std::vector<std::uint8_t> in_contact;
};

/// @brief An agent to be added; all vectors in `map`.
struct AgentStart {
  Vector2 position;            ///< [m]
  double heading = 0.0;        ///< [rad]
  std::vector<Vector2> goals;  ///< visited in this order, at least one [m]
  double max_speed = 1.3;      ///< [m/s]
  double radius = 0.25;        ///< [m]
};

/// @brief A robot of the scenario between two ticks; all vectors in `map`.
struct RobotState {
  std::string name;
  Pose pose;
  Vector2 velocity;             ///< at the end of the last tick [m/s]
  double radius = 0.0;          ///< of the disc that agents perceive [m]
  std::optional<Vector2> goal;  ///< present goal, or the last one after arrival [m]
  bool arrived = false;
  bool in_contact = false;  ///< with people, in the last tick
};

/// @brief What the laser scanner of a robot reports between two ticks.
struct RobotScan {
  double first_angle = 0.0;   ///< of the first ray, robot frame [rad]
  double increment = 0.0;     ///< between two rays [rad]
  std::vector<float> ranges;  ///< with the noise of the scenario; infinite or NaN as in REP 117 [m]
};

/// @brief Decides for all agents whose turn it is; agents without an action stay. Called in the thread of
/// Episode::walk(), once in each tick, with `order: sequential` once for each agent in it, and once more with `last`
/// set when the episode is over.
using Decide = std::function<std::vector<Action>(const Perceptions& perceptions)>;

/// @brief One episode of a scenario, tick by tick. The same scenario, seed, number and decisions give the same numbers,
/// bit for bit, as the programs of the package. Use an object from one thread at a time; others may run in parallel.
///
/// Functions that change the world may be called between two ticks. They throw InputError if a number is out of range,
/// a place is taken, there is no way to a goal, or there is no such agent, wall or robot; nothing has changed then.
class Episode {
 public:
  /// @param vision what agents perceive, usually QTable::vision()
  /// @param seed, number from which the scene is drawn, see Scenario
  /// @param threads that share the agents, for large crowds; 0: one per processor. Results do not depend on it
  /// @throws InputError if there is no free place for what is drawn
  Episode(const Scenario& scenario, const Vision& vision, std::uint64_t seed = 1, std::uint64_t number = 0,
          unsigned threads = 1);
  Episode(Episode&&) noexcept;
  Episode& operator=(Episode&&) noexcept;
  ~Episode();

  /// @brief One tick, in which a learner decides. @return false if the episode is over: nothing has moved
  bool walk(Learner& learner);
  /// @brief One tick with decisions of your own. @throws InputError if an action is not finite or not within 0 to 1,
  /// and whatever `decide` throws; no agent of that turn has moved then
  bool walk(const Decide& decide);
  /// @brief One tick with these actions; agents without one stay. @throws InputError as above
  bool walk(const std::vector<Action>& actions);

  /// @brief Whether all agents and all robots with goals have arrived, or the duration of the scenario is reached.
  bool isOver() const;
  std::uint64_t tick() const;
  double time() const;          ///< @brief Since the start of the episode [s].
  double tickDuration() const;  ///< @brief [s]
  /// @brief The agents by ascending id: those of the scenario, also after they have arrived, and those that were added
  /// later, until the tick after they have arrived.
  std::vector<AgentState> agents() const;
  /// @brief The same as arrays. @param arrays are overwritten; their memory is reused
  void agents(AgentArrays& arrays) const;
  std::vector<RobotState> robots() const;
  /// @brief The scan of a robot now. @param robot its index @throws InputError if there is no such robot
  RobotScan scan(std::uint32_t robot);
  /// @brief The walls by their ids, `map`; those of the scenario have the ids 0, 1, 2 ...
  std::map<std::size_t, Wall> walls() const;
  EpisodeResult result() const;

  /// @brief Adds an agent. @return its id
  AgentId spawnAgent(const AgentStart& start);
  void removeAgent(AgentId agent);
  /// @brief Replaces all goals of an agent by one [m], `map`.
  void setGoal(AgentId agent, const Vector2& goal);
  /// @brief Puts an agent at another place at once, where it stands. @param pose in `map`
  void teleport(AgentId agent, const Pose& pose);
  /// @brief Adds a wall, `map`. @return its id
  std::size_t addWall(const Wall& wall);
  void removeWall(std::size_t wall);
  /// @brief Lets a robot drive until the next command, within its limits. @param robot its index
  /// @param velocity in its own frame [m/s] @param rotation [rad/s]
  void commandRobot(std::uint32_t robot, const Vector2& velocity, double rotation);
  /// @brief Puts a robot at another place at once, where it stands. @param pose in `map`
  void teleportRobot(std::uint32_t robot, const Pose& pose);

  /// @brief For this library and its Python module only.
  crowd::Episode& episode();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crowd::library
