#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "navigation/congestion_map.h"
#include "navigation/deadlock_resolver.h"
#include "navigation/group_walking.h"
#include "navigation/path_follower.h"
#include "navigation/robot_lanes.h"
#include "navigation/sized_floor.h"
#include "navigation/turn_taking.h"
#include "navigation/walking_floor.h"
#include "world/world.h"

namespace crowd {

/// @brief Leads agents round walls and obstacles at rest: an agent whose goal is hidden perceives the next corner of a
/// way to it instead (World::setWaypoint). Learners and learning are the same as without. Members of groups are led
/// beside each other (GroupWalking), also where there are no walls.
///
/// Ways are found for the size of each agent (SizedFloor). They keep COMFORTABLE_MARGIN from walls where there is room,
/// and lead round crowds if that saves time (CongestionMap). In narrow places agents take turns (TurnTaking). They step
/// aside from robots that wait (RobotLanes), also where there are no walls.
/// Deterministic; depends only on the world.
///
/// An agent whose goal is behind closed gates walks up to them. One whose goal is out of reach stays, unless it sees
/// it.
///
/// Call contract: update() before the first perceptions of an episode, after each tick and after each change of the
/// world by a user. Not thread-safe.
class WayFinder {
 public:
  WayFinder() = default;
  /// @param scene its gates and sources are used
  explicit WayFinder(const Scene& scene)
      : finds_ways_(scene.way_finding), least_radius_(largestSourceRadius(scene)), gates_(gateWalls(scene)) {}

  /// @throws InputError if the floor is too large (NavigationMesh), Stopped if the world's stop request is made; the
  /// object must not be used any more then.
  void update(World& world) {
    findWays(world);
    lanes_.update(world, finds_ways_ && is_needed_);
  }
  /// @brief Makes all agents of a world perceive their goals again, and leads only groups from now on.
  void giveUp(World& world);

  /// @brief Whether there is no way from an agent's place to its goal, as of the last update(), even with all gates
  /// open.
  bool isOutOfReach(AgentId agent) const {
    const Way* const way = ways_.find(agent);
    return way != nullptr && way->out_of_reach;
  }

 private:
  /// Where to pass a corner.
  struct Lane {
    Vector2 place;
    Vector2 forward;  // unit vector of the direction there
  };
  /// What a way is found on. OPEN: the tight mesh with all gates open.
  enum class Floor : std::uint8_t { COMFORTABLE, TIGHT, OPEN };
  /// The point that an agent walks to, and when it was chosen: it is kept until the agent has moved on.
  struct Aim {
    Vector2 point;
    Vector2 corner;  // the next corner of the path then
    Vector2 from;    // place of the agent then
  };
  /// Way of one agent.
  struct Way {
    std::optional<Lane> lane;  // present
    std::optional<Aim> aim;
    std::optional<PathFollower> follower;
    Floor floor = Floor::COMFORTABLE;
    double search_time = 0.0;  // time from which it is compared with others [s]
    double around_time = 0.0;  // time from which a way round a crowd is searched [s]
    bool out_of_reach = false;
  };

  void findWays(World& world);
  static void release(World& world);
  void adoptLayout(World& world);
  void leadGroups(World& world);
  void lead(Agent& agent, Way& way, SizedFloor& floor, const World& world);
  void reconsider(const Agent& agent, Way& way, SizedFloor& floor, const World& world);
  double timeOf(const Agent& agent, Span<Vector2> corners) const;
  static double timeOf(const Agent& agent, double length, double delay);
  bool passOutside(const Agent& agent, double max_time, Way& way, NavigationMesh::Query& query) const;
  Vector2 nextPoint(const Agent& agent, Way& way, SizedFloor& floor, const StopRequest& stop) const;
  SizedFloor& floorOf(const Agent& agent, const World& world);
  Vector2 keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const;
  Vector2 chooseAim(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const;
  bool isCorridor(const Vector2& from, const Vector2& to, const Vector2& forward, double radius) const;
  Vector2 laneBeside(const Vector2& place, const Vector2& forward, double radius) const;

  bool finds_ways_ = true;
  std::uint64_t layout_changes_ = 0;  // of the world that the floors belong to
  bool is_needed_ = false;            // there is anything to walk round
  FloorPlan::Bounds bounds_;          // of the floors
  double radius_ = 0.0;               // of the agents that the ruler is for [m]
  double least_radius_ = 0.0;         // of the agents that may appear [m]
  std::vector<Segment> gates_;
  std::map<double, SizedFloor> floors_;  // by size; made when an agent of the size appears
  std::shared_ptr<const FloorRuler> ruler_;
  GroupWalking groups_;
  CongestionMap congestion_;
  std::optional<TurnTaking> turns_;
  DeadlockResolver deadlocks_;
  RobotLanes lanes_;
  AgentMap<Way> ways_;
  AgentMap<RemainingPath> paths_;
};

}  // namespace crowd
