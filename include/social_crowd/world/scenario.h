#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "social_crowd/common/random.h"
#include "social_crowd/world/scene.h"

namespace crowd {

/// @brief A body placed at random keeps at least this far from all others and from walls [m].
constexpr double DRAWN_GAP = 0.05;

/// @brief A number, or a range from which one is drawn for every body of every episode.
struct Range {
  double low = 0.0;
  double high = 0.0;
  double draw(KeyedRandom& random) const { return random.uniform(low, high); }
  bool isFixed() const { return low == high; }
};

/// @brief A point, or a region in which one is drawn anew each episode [m].
struct Region {
  enum class Kind { POINT, BOX, RING };
  Kind kind = Kind::POINT;
  Vector2 first = Vector2::Zero();   ///< the point; the box's lower left corner; the ring's centre
  Vector2 second = Vector2::Zero();  ///< the box's upper right corner
  Range radius;                      ///< the ring's inner and outer radius [m]; inner 0: a disc

  Vector2 draw(KeyedRandom& random) const;
  bool isFixed() const { return kind == Kind::POINT; }
};

/// @brief One entry under `agents`: so many agents of a kind.
struct AgentGroup {
  int line = 0;  ///< where it stands in the file, for messages
  int count = 1;
  Region position;
  std::vector<Region> goals;        ///< one after the other; empty: the goal is the start mirrored at `opposite`
  std::optional<Vector2> opposite;  ///< [m]
  Range max_speed;                  ///< [m/s]
  Range radius;                     ///< [m]
  std::optional<Range> heading;     ///< [rad]; absent: towards the first goal
  bool keeps_heading = false;       ///< see AgentStart
};

/// @brief A place on the straight line from an agent's start to its first goal.
struct Between {
  std::size_t agent = 0;
  Range share;  ///< of the line, 0 at the start and 1 at the goal
  Range aside;  ///< to the left of the line [m]

  Vector2 draw(const AgentStart& start, KeyedRandom& random) const;
  bool isFixed() const { return share.isFixed() && aside.isFixed(); }
};

/// @brief One entry under `obstacles`: so many obstacles of a kind.
struct ObstacleGroup {
  int line = 0;  ///< where it stands in the file, for messages
  int count = 1;
  Region position;
  std::optional<Between> between;  ///< in place of `position`
  Range radius;                    ///< [m]
  ObstaclePath::Kind motion = ObstaclePath::Kind::AT_REST;
  Vector2 velocity = Vector2::Zero();  ///< [m/s], for STRAIGHT
  std::vector<Region> waypoints;       ///< after the start, for TO_AND_FRO and LOOP
  Range speed;                         ///< [m/s], for TO_AND_FRO and LOOP
};

/// @brief A scenario as its document describes it: fixed numbers, and regions from which every episode draws
/// anew.
struct Scenario {
  std::string name;
  std::string source;  ///< file and document, for messages
  double tick_duration = DEFAULT_TICK_DURATION;
  std::uint64_t max_ticks = 0;
  double goal_tolerance = 0.0;
  double collision_radius = DEFAULT_COLLISION_RADIUS;  ///< [m], see Scene
  Contact contact = Contact::GHOST;
  Order order = Order::SIMULTANEOUS;
  std::uint64_t seed = 0;  ///< mixed with the run's seed
  std::vector<AgentGroup> agents;
  std::vector<ObstacleGroup> obstacles;
  std::vector<Segment> walls;

  /// @brief The scene of one episode; depends on scenario, seed and episode alone.
  ///
  /// Drawn bodies keep DRAWN_GAP from everything. A drawn goal is a place where its agent can stand, and not
  /// reached at the start; it keeps clear of the others' goals where there is room.
  /// @throws InputError if bodies that are not drawn overlap, or a free place for a drawn one is not found.
  Scene instantiate(std::uint64_t run_seed, std::uint64_t episode) const;
};

/// @brief Scenarios that are played one after the other, round and round.
class ScenarioList {
 public:
  ScenarioList() = default;
  explicit ScenarioList(std::vector<Scenario> scenarios) : scenarios_(std::move(scenarios)) {}

  /// @brief The scene of an episode: scenario number `episode` modulo their number, drawn for that episode.
  /// @throws InputError as Scenario::instantiate does, or if the list is empty.
  Scene scene(std::uint64_t run_seed, std::uint64_t episode) const;
  /// @brief Whether any agent keeps its heading, so that an episode depends on the one before it.
  bool keepHeadings() const;
  std::size_t size() const { return scenarios_.size(); }
  bool empty() const { return scenarios_.empty(); }
  const Scenario& operator[](std::size_t index) const { return scenarios_[index]; }

 private:
  std::vector<Scenario> scenarios_;
};

}  // namespace crowd
