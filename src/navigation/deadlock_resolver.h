#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/span.h"
#include "navigation/congestion_map.h"
#include "navigation/remaining_path.h"
#include "world/world.h"

namespace crowd {

/// @brief Resolves deadlocks of agents that block each other: some of them walk back for a while. Deterministic;
/// depends only on the world and the earlier calls.
///
/// An agent is stuck if it has not moved by PROGRESS for STUCK_TIME, or if it has moved to and fro within PACING for
/// PACING_TIME. Where agents in its direction stand (CongestionMap, STANDS), not in a dense crowd that goes on slowly,
/// it gives way to an agent ahead, or one that touches it, if that has priority:
/// - A robot that the crowd gives way to has priority over all agents, also where these get on.
/// - An agent that could not walk back at its last attempt has priority over one that could.
/// - Of agents that walk in opposite directions, the one with fewer people where its path leads to has priority, and
///   with as many, or up to two more, the one whose direction is nearer to an axis; the axis is the same for all agents
///   and turns every TURN_TIME.
/// - Of agents in the same direction that are both stuck and touch each other, as in an arch in front of a door, the
///   one with the shorter remaining path has priority, wherever the other one is.
///
/// An agent that waits gives way to one that it blocks.
///
/// An agent that gives way walks back for RETREAT_TIME, and agents that it walks towards do the same where agents in
/// their direction have not got on (CongestionMap, GETS_ON). It walks against the direction of its path. Where it
/// touches walls or other agents, it slides along them. RETREAT_TIME is short, since agents that walk back are in the
/// way of those behind them. Afterwards the agent walks on for WALK_TIME before it can be stuck again.
///
/// An agent that is stuck, and does not have to give way to another agent, slides along the walls that it touches, and
/// along the agents between which and a wall it is wedged.
///
/// Call contract: update() once per tick, after waypoints were set.
class DeadlockResolver {
 public:
  static constexpr double PROGRESS = 0.5;      ///< [m]
  static constexpr double STUCK_TIME = 3.0;    ///< [s]
  static constexpr double PACING = 1.0;        ///< [m]
  static constexpr double PACING_TIME = 10.0;  ///< [s]
  static constexpr double TURN_TIME = 6.0;     ///< [s]
  static constexpr double RETREAT_TIME = 1.5;  ///< an agent walks back for this time [s]
  static constexpr double WALK_TIME = 1.5;     ///< [s]
  /// Share of the maximum speed below which agents stand: those that are stuck give way only there.
  static constexpr double STANDS = 0.1;
  /// Share of the maximum speed at which agents get on: above it, they do not give way to those who walk back.
  static constexpr double GETS_ON = 0.4;
  static constexpr double CROWD_RADIUS = 1.5;  ///< around the point ahead, in which people are counted [m]

  /// @brief Replaces the waypoints of agents that give way (World::setWaypoint).
  /// @param paths of the agents of the world; empty for those that have none @param congestion as of this tick
  void update(World& world, const AgentMap<RemainingPath>& paths, const CongestionMap& congestion);

  /// @brief Whether an agent walks back, as of the last update().
  bool walksBack(AgentId agent) const { return walksBack(walks_[agent]); }
  /// @brief Direction of an agent's path, or back if it walks back [unit vector], as of the last update().
  const Vector2& course(AgentId agent) const { return walks_[agent].course; }

 private:
  /// Near which place an agent has been since when.
  struct Stay {
    std::optional<Vector2> place;  // [m]
    double begin = 0.0;            // [s]
  };
  struct Walk {
    Stay stay;                               // within PROGRESS
    Stay pacing;                             // within PACING
    double remaining = 0.0;                  // length of its path, while it is stuck [m]
    double retreat_until = 0.0;              // [s]; 0 unless it walks back
    Vector2 retreat_from = Vector2::Zero();  // where its last retreat began [m]
    bool cannot_walk_back = false;           // at its last attempt, and it has made no progress since
    Vector2 course = Vector2::UnitX();       // direction of its path, or back [unit vector]
    Vector2 ahead = Vector2::Zero();         // the point AHEAD on its path, before it walked back [m]
  };

  /// An agent that walks.
  struct Walker {
    double x;  // of its place [m]
    AgentId agent;
  };

  static bool walksBack(const Walk& walk) { return walk.retreat_until > 0.0; }
  static bool isStuck(const Walk& walk, double time) {
    return time - walk.stay.begin >= STUCK_TIME || time - walk.pacing.begin >= PACING_TIME;
  }
  void follow(const Agent& agent, const RemainingPath& path, double time, Walk& walk);
  static void noteProgress(const Agent& agent, double time, Walk& walk);
  void startRetreat(const Agent& agent, double time);
  void sortByX(const World& world);
  /// The walkers that may be within a distance of an agent [m], by x; the agent itself is among them.
  Span<Walker> walkersNear(const World& world, const Agent& agent, double distance);
  bool mustGiveWay(const World& world, const Agent& agent, const CongestionMap& congestion);
  bool blocksOthers(const World& world, const Agent& agent);
  bool isBlockedByRobot(const World& world, const Agent& agent) const;
  bool givesWayTo(const World& world, const Agent& agent, const Agent& other);
  double priorityOver(const World& world, const Walk& own, const Walk& its);
  void addWallContacts(const World& world, const Agent& agent, std::vector<Vector2>& contacts);
  void addAgentContacts(const World& world, const Agent& agent, std::vector<Vector2>& contacts);
  void slideAlongWalls(World& world, const Agent& agent);
  void retreat(World& world, const Agent& agent);

  AgentMap<Walk> walks_;
  std::vector<AgentId> retreating_;  // of this tick
  std::vector<std::uint32_t> near_walls_;
  std::vector<std::uint32_t> near_people_;  // by countPeopleNear()
  std::vector<Walker> walkers_;             // of this tick, by x; empty until it is needed
  double largest_radius_ = 0.0;             // of the walkers [m]
};

}  // namespace crowd
