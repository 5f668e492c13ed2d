#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/neighbour_grid.h"
#include "geometry/robot_sweep.h"
#include "geometry/wall_index.h"

namespace crowd {

/// @brief Moves solid bodies for one tick: an agent that walks into something stops at the point of contact.
///
/// Each disc moves on a straight line at constant speed, and each robot as its RobotSweep. Impacts are computed exactly
/// and resolved in the order of time, simultaneous impacts together, so that the result does not depend on the order of
/// the bodies:
/// - an agent that walks into an agent, a wall or an obstacle stops there for the rest of the tick; an agent that is
///   hit, but does not itself move towards the other, continues;
/// - an obstacle never yields: it pushes an agent that it hits, with the component of its velocity towards the agent. A
///   pushed agent stops at the next thing it touches; the obstacle then passes over it;
/// - a robot follows the rules of agents, but is not pushed and pushes nobody. One that may slide goes on along the
///   walls that it drives into, as slideAlongWalls() says, and stops at its MAX_SLIDES-th wall in a tick. One that
///   cannot be stopped (`is_agent` is false) passes over everything; agents that walk into it stop.
///
/// Hence agents that do not overlap other agents, walls or static obstacles never will (beyond TOUCH_TOLERANCE).
class SolidMotion {
 public:
  /// @brief A body, and its displacement if nothing is in the way.
  struct Disc {
    Vector2 position = Vector2::Zero();  ///< [m]
    Vector2 way = Vector2::Zero();       ///< in this tick [m]
    double radius = 0.0;                 ///< [m]
    bool is_agent = true;                ///< else an obstacle
    /// Motion of a robot, which must outlive the call; `way` is not used then, and `radius` is that of the smallest
    /// disc about its position that contains it. Null: a disc.
    const RobotSweep* sweep = nullptr;
    std::optional<WallSliding> sliding = std::nullopt;  ///< of a robot that slides along walls; else it stops there
  };
  static constexpr int MAX_SLIDES = 8;
  /// @brief The resulting state of a body.
  struct Outcome {
    Vector2 position = Vector2::Zero();  ///< at the end of the tick [m]
    bool touched = false;                ///< it took part in an impact
    bool diverted = false;               ///< its motion was changed by an impact
    /// Checksum of the changes of its motion, with their times: equal for equal motions, also in another set of bodies.
    std::uint64_t history = 0;
  };
  /// @brief Indices of a disc that is not a robot, and a robot, that took part in a common impact.
  struct Touch {
    std::uint32_t disc = 0;
    std::uint32_t robot = 0;
  };

  /// @brief Returns the outcome for each disc, in their order; valid until the next call.
  const std::vector<Outcome>& move(const std::vector<Disc>& discs, const WallIndex& walls);
  /// @brief The outcomes of the last call of move().
  std::vector<Outcome>& outcomes() { return outcomes_; }
  /// @brief The motions of the robots after all impacts, in their order; valid until the next call of move().
  const std::vector<RobotSweep>& sweeps() const { return sweeps_; }
  /// @brief Index of the first robot among the discs of the last call, which are followed by robots only.
  std::uint32_t firstRobot() const { return static_cast<std::uint32_t>(outcomes_.size() - sweeps_.size()); }
  /// @brief Common impacts of discs and robots in the last call; a pair may be repeated.
  const std::vector<Touch>& touches() const { return touches_; }

 private:
  using Index = std::uint32_t;
  static constexpr Index NO_SWEEP = UINT32_MAX;

  /// A moving disc. Times are fractions of the tick.
  struct Body {
    Vector2 position = Vector2::Zero();  // at the time `since`
    Vector2 way = Vector2::Zero();       // displacement in a whole tick
    double radius = 0.0;
    bool is_agent = true;
    double since = 0.0;
    std::uint32_t changes = 0;  // number of changes of `way`
    bool touched = false;
    bool pushed = false;
    bool judged = false;  // impacts of this instant change its way
    int pushes = 0;       // number of obstacles that push it at this instant
    Vector2 push = Vector2::Zero();
    double speed = 0.0;  // upper bound of the displacement of its points in a whole tick
    std::uint64_t history = 0;
    Index sweep = NO_SWEEP;  // index of its motion, if it is a robot
    std::optional<WallSliding> sliding;
    int slides = 0;      // along walls so far
    bool stops = false;  // an impact of this instant stops it

    bool isRobot() const { return sweep != NO_SWEEP; }
    Vector2 at(double time) const { return position + (time - since) * way; }
  };
  /// Predicted impact of two bodies, or of a body and a wall; stale once one of them has changed its way.
  struct Impact {
    double time = 0.0;
    Index agent = 0;
    Index other = 0;
    std::uint32_t agent_changes = 0;
    std::uint32_t other_changes = 0;
  };
  /// A total order, so that impacts of one instant are judged in the same order with all standard libraries.
  struct Later {
    bool operator()(const Impact& a, const Impact& b) const {
      return std::tie(a.time, a.agent, a.other) > std::tie(b.time, b.agent, b.other);
    }
  };

  void begin(const std::vector<Disc>& discs);
  void findNeighbours();
  void predictImpact(Index agent, Index other, double now);
  void predictWallImpacts(Index agent, double now);
  /// Time of the first impact of two bodies, at least one of which is a robot, from `now` on; or NO_IMPACT.
  double touchOfRobot(const Body& first, const Body& second, double now) const;
  double touchOfWall(const Body& body, const Segment& wall, double now) const;
  /// Distance of two bodies, at least one of which is a robot, at times of their own.
  double distanceBetween(const Body& first, double first_time, const Body& second, double second_time) const;
  void judgeRobot(const Impact& impact);
  void predictImpacts(Index agent, double now);
  void add(const Impact& impact);
  bool isStale(const Impact& impact) const;
  /// Moves the impacts of the next instant from the heap to `simultaneous_`; returns their time, or NO_IMPACT.
  double takeNext();
  void judge(const Impact& impact);
  void stop(Index agent);
  void meetWall(Index agent);
  void slide(Body& body, double now);
  void settle(double now);

  /// Adds the change of a body's way to its history.
  void record(Body& body) const;

  const WallIndex* walls_ = nullptr;  // during move() only
  double instant_ = 0.0;              // of the impacts that are settled
  std::uint64_t round_ = 0;           // number of rounds of impacts at this instant so far
  std::vector<Body> bodies_;
  std::vector<RobotSweep> sweeps_;  // of the robots
  NeighbourGrid grid_;
  std::vector<Index> neighbours_;          // bodies that each agent may meet in this tick, agent by agent
  std::vector<std::size_t> first_;         // index of the first neighbour of each body
  std::vector<std::uint32_t> near_walls_;  // scratch
  std::vector<WallContact> contacts_;      // scratch
  std::vector<Impact> impacts_;            // heap, the earliest in front
  std::vector<Impact> simultaneous_;       // impacts of one instant
  std::vector<Index> judged_;              // bodies whose way these change
  std::vector<Outcome> outcomes_;
  std::vector<Touch> touches_;
};

}  // namespace crowd
