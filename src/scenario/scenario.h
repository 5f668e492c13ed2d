#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "common/stop_request.h"
#include "maps/floor_reach.h"
#include "maps/free_space.h"
#include "scenario/group_share.h"
#include "scenario/scene.h"

namespace crowd {

/// @brief Minimum gap between a randomly placed body and all other bodies and walls [m].
constexpr double DRAWN_GAP = 0.05;

/// @brief A number, or a range from which one is drawn for each body in each episode.
struct Range {
  double low = 0.0;
  double high = 0.0;
  double draw(KeyedRandom& random) const { return random.uniform(low, high); }
  /// @brief As draw(), but takes no random number if the value is fixed, so that other draws stay the same.
  double drawUnlessFixed(KeyedRandom& random) const { return isFixed() ? low : draw(random); }
  bool isFixed() const { return low == high; }
};

/// @brief A point, or a region in which one is drawn for each episode [m].
struct Region {
  enum class Kind { POINT, BOX, RING, FREE };  ///< FREE: anywhere on the map where an agent fits
  Kind kind = Kind::POINT;
  Vector2 first = Vector2::Zero();   ///< the point; the box's lower left corner; the ring's centre
  Vector2 second = Vector2::Zero();  ///< the box's upper right corner
  Range radius;                      ///< the ring's inner and outer radius [m]; inner 0: a disc

  /// @param free_space for FREE: where agents fit
  Vector2 draw(KeyedRandom& random, const FreeSpace* free_space = nullptr) const;
  bool isFixed() const { return kind == Kind::POINT; }
};

/// @brief Whom the agents of an entry follow.
struct LeaderDescription {
  AgentId agent = 0;
  std::string robot;               ///< its name; empty: the agent leads
  std::uint32_t robot_number = 0;  ///< index of this robot
};

/// @brief One entry under `groups`: agents that walk together, each to its own goal.
struct GroupDescription {
  int line = 0;  ///< in the file, for messages
  std::vector<AgentId> members;
};

/// @brief A kind of people in an entry of agents, and its share of them, in proportion to the other shares.
struct KindShare {
  std::size_t kind = 0;  ///< index of a kind of the population
  double share = 1.0;
};

/// @brief A reaction to robots in an entry of agents, and its share of them.
struct ReactionShare {
  Reaction reaction = Reaction::REGULAR;
  double share = 1.0;
};

/// @brief One entry under `agents`: `count` agents with the same description.
struct AgentGroup {
  int line = 0;  ///< in the file, for messages
  int count = 1;
  Region position;
  std::vector<Region> goals;        ///< one after the other; empty: the start mirrored at `opposite`, or a `route`
  std::optional<Vector2> opposite;  ///< [m]
  std::vector<KindShare> kinds;     ///< that they are drawn from; empty: none, see drawKind()
  Range max_speed;                  ///< [m/s]; with `speed_of_kind` that of all its kinds together
  Range radius;                     ///< [m]; with `radius_of_kind` that of all its kinds together
  bool speed_of_kind = false;       ///< drawn as the kind of the agent describes it
  bool radius_of_kind = false;      ///< the same
  std::vector<ReactionShare> reactions = {};               ///< that theirs are drawn from; empty: REGULAR
  std::optional<Range> heading;                            ///< [rad]; absent: towards the first goal
  Vector2 velocity = Vector2::Zero();                      ///< at the start [m/s]
  bool keeps_heading = false;                              ///< see AgentStart
  std::optional<std::size_t> route = std::nullopt;         ///< index of a route of the population, instead of goals
  Range reaction_time;                                     ///< [s], see AgentStart
  std::optional<LeaderDescription> leader = std::nullopt;  ///< instead of goals
  GroupShare groups;                                       ///< of agents that share the goals of the first one
  Range hurry{1.0, 1.0};                                   ///< factor of the speed
  /// Where its agents can walk, for drawing places; null: nothing is drawn, or nothing is in the way.
  std::shared_ptr<const FloorReach> reach = nullptr;
};

/// @brief A position relative to the straight line from an agent's start to its first goal.
struct Between {
  std::size_t agent = 0;
  Range share;  ///< position along the line, 0 at the start and 1 at the goal
  Range aside;  ///< offset to the left of the line [m]

  Vector2 draw(const AgentStart& start, KeyedRandom& random) const;
  bool isFixed() const { return share.isFixed() && aside.isFixed(); }
};

/// @brief One entry under `obstacles`: `count` obstacles with the same description.
struct ObstacleGroup {
  int line = 0;  ///< in the file, for messages
  int count = 1;
  Region position;
  std::optional<Between> between;  ///< replaces `position`
  Range radius;                    ///< [m]
  ObstaclePath::Kind motion = ObstaclePath::Kind::AT_REST;
  Vector2 velocity = Vector2::Zero();  ///< [m/s], for STRAIGHT
  std::vector<Region> waypoints;       ///< after the start, for TO_AND_FRO and LOOP
  Range speed;                         ///< [m/s], for TO_AND_FRO and LOOP
};

/// @brief One entry under `recorded`, with the people of its file.
struct RecordedGroup {
  int line = 0;  ///< in the file, for messages
  RecordedPeople description;
  std::vector<Obstacle> people;
};

/// @brief One entry under `robots`.
struct RobotGroup {
  int line = 0;      ///< in the file, for messages
  RobotStart start;  ///< without position, heading and goals
  Region position;
  std::optional<Range> heading;  ///< [rad]; absent: towards the first goal, else 0
  std::vector<Region> goals;     ///< one after the other; empty: none
};

struct PopulationDescription;

/// @brief A scenario as its document describes it: fixed numbers, and ranges from which each episode draws.
struct Scenario {
  std::string name;
  std::string source;                 ///< file and document, for messages
  std::vector<std::string> warnings;  ///< of what was read, for the user; in thesis units none
  double tick_duration = DEFAULT_TICK_DURATION;
  std::uint64_t max_ticks = 0;
  double goal_tolerance = 0.0;
  double collision_radius = DEFAULT_COLLISION_RADIUS;  ///< [m], see Scene
  Contact contact = Contact::GHOST;
  std::optional<MotionLimits> motion;  ///< see Scene
  Order order = Order::SIMULTANEOUS;
  std::uint64_t seed = 0;  ///< combined with the seed of the run
  std::vector<AgentGroup> agents;
  std::vector<GroupDescription> groups;
  std::vector<ObstacleGroup> obstacles;
  std::vector<RecordedGroup> recorded;
  std::vector<RobotGroup> robots;
  Ends ends = Ends::ALL;                                  ///< see Scene
  Arrived arrived = Arrived::LEAVE;                       ///< see Scene
  std::vector<Segment> walls;                             ///< of the file; those of the map are not among them
  bool way_finding = true;                                ///< see Scene
  std::shared_ptr<const OccupancyMap> map;                ///< null: none
  std::string map_file;                                   ///< that the map was read from; empty: none
  std::shared_ptr<const std::vector<Segment>> map_walls;  ///< of the map; null: none
  std::shared_ptr<const FreeSpace> free_space;            ///< of the map, for `free_radius`; null if no region is FREE
  double free_radius = 0.0;  ///< radius of discs that fit in FREE regions [m], at least that of the largest agent
  std::shared_ptr<const PopulationDescription>
      population;  ///< routes, sources, sinks, queues, gates, kinds; null: none

  /// @brief Creates the scene of one episode; depends only on scenario, seed and episode.
  ///
  /// Drawn bodies keep DRAWN_GAP from all bodies and walls. At a drawn goal its agent fits, with
  /// way-finding a way connects it with the start if any place of the region is connected, and the goal is not reached
  /// at the start; it does not overlap the goals of other agents if there is enough space.
  /// @throws InputError if fixed bodies overlap, or if no free position is found for a drawn one.
  /// @throws Stopped if `stop` is made
  Scene instantiate(std::uint64_t run_seed, std::uint64_t episode, const StopRequest& stop = {}) const;
};

/// @brief Scenarios that are played in turn, cyclically.
class ScenarioList {
 public:
  ScenarioList() = default;
  explicit ScenarioList(std::vector<Scenario> scenarios) : scenarios_(std::move(scenarios)) {}

  /// @brief The scene of an episode, drawn from scenario number `episode` modulo size().
  /// @throws InputError and Stopped as Scenario::instantiate does; InputError if the list is empty
  Scene scene(std::uint64_t run_seed, std::uint64_t episode, const StopRequest& stop = {}) const;
  /// @brief Whether any agent keeps its heading, so that an episode depends on the one before it.
  bool keepHeadings() const;
  /// @brief The warnings of all scenarios.
  std::vector<std::string> warnings() const;
  std::size_t size() const { return scenarios_.size(); }
  bool empty() const { return scenarios_.empty(); }
  const Scenario& operator[](std::size_t index) const { return scenarios_[index]; }

 private:
  std::vector<Scenario> scenarios_;
};

}  // namespace crowd
