#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/world/neighbour_grid.h"

namespace crowd {

/// @brief Moves solid bodies for one tick: who walks into something stops where it touches.
///
/// Everybody walks a straight way at a steady speed. Impacts are found exactly and settled in the order in which they
/// happen, all those of the same instant together, so that the order of the bodies does not matter:
/// - an agent that walks into an agent, a wall or an obstacle stops there for the rest of the tick; an agent that is
///   walked into, but does not walk into the other, goes on;
/// - an obstacle yields to nobody: an agent that it runs into is pushed, with the part of the obstacle's velocity that
///   points at the agent. A pushed agent stops at the next thing it touches, and the obstacle then passes over it.
///
/// So agents that do not overlap each other, walls or obstacles at rest never will (beyond TOUCH_TOLERANCE).
class SolidMotion {
 public:
  /// @brief A body, and where it would go if nothing were in the way.
  struct Disc {
    Vector2 position = Vector2::Zero();  ///< [m]
    Vector2 way = Vector2::Zero();       ///< in this tick [m]
    double radius = 0.0;                 ///< [m]
    bool is_agent = true;                ///< else an obstacle
  };
  /// @brief What became of it.
  struct Outcome {
    Vector2 position = Vector2::Zero();  ///< at the end of the tick [m]
    bool touched = false;                ///< somebody walked or ran into the other
    bool diverted = false;               ///< it did not go its way
  };

  /// @brief What becomes of each disc; valid until the next call.
  const std::vector<Outcome>& move(const std::vector<Disc>& discs, const std::vector<Segment>& walls);

 private:
  using Index = std::uint32_t;

  /// A disc on its way. Times are shares of the tick.
  struct Body {
    Vector2 position = Vector2::Zero();  // at the time `since`
    Vector2 way = Vector2::Zero();       // in a whole tick
    double radius = 0.0;
    bool is_agent = true;
    double since = 0.0;
    std::uint32_t changes = 0;  // of the way, so far
    bool touched = false;
    bool pushed = false;
    bool judged = false;  // impacts of this instant change its way:
    int pushes = 0;       // by so many obstacles,
    Vector2 push = Vector2::Zero();

    Vector2 at(double time) const { return position + (time - since) * way; }
  };
  /// Two bodies, or a body and a wall, that will touch unless one of them changes its way before.
  struct Impact {
    double time = 0.0;
    Index agent = 0;
    Index other = 0;
    std::uint32_t agent_changes = 0;
    std::uint32_t other_changes = 0;
  };
  struct Later {
    bool operator()(const Impact& a, const Impact& b) const { return a.time > b.time; }
  };

  void begin(const std::vector<Disc>& discs);
  void findNeighbours();
  void predictImpact(Index agent, Index other, double now);
  void predictWallImpacts(Index agent, double now);
  void predictImpacts(Index agent, double now);
  void add(const Impact& impact);
  bool isStale(const Impact& impact) const;
  /// Takes the impacts of the next instant off the heap; their time, or NEVER.
  double takeNext();
  void judge(const Impact& impact);
  void stop(Index agent);
  void settle(double now);

  const std::vector<Segment>* walls_ = nullptr;  // during move() only
  std::vector<Body> bodies_;
  NeighbourGrid grid_;
  std::vector<Index> neighbours_;     // whom each agent may meet in this tick, agent by agent
  std::vector<std::size_t> first_;    // where the neighbours of each body begin
  std::vector<Impact> impacts_;       // a heap, the next one in front
  std::vector<Impact> simultaneous_;  // of one instant
  std::vector<Index> judged_;         // by those
  std::vector<Outcome> outcomes_;
};

}  // namespace crowd
