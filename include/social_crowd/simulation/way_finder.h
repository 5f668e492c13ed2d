#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "social_crowd/navigation/mesh_cache.h"
#include "social_crowd/navigation/path_follower.h"
#include "social_crowd/simulation/deadlock_resolver.h"
#include "social_crowd/simulation/right_of_way.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief Leads agents round walls and obstacles at rest: an agent whose goal is hidden perceives the next corner of a
/// way to it instead (World::setWaypoint). Learners and learning are the same as without.
///
/// Ways are found for the radius of the largest agent. They keep COMFORTABLE_MARGIN from walls where there is room. At
/// narrow passages agents go one direction after the other (RightOfWay). Deterministic; depends only on the world.
///
/// Call contract: update() before the first perceptions of an episode, after each tick and after each change of the
/// world by a user. Not thread-safe.
class WayFinder {
 public:
  void update(World& world);

  /// @brief Whether there is no way from an agent's place to its goal, as of the last update().
  bool isOutOfReach(AgentId agent) const { return agent < agents_.size() && agents_[agent].out_of_reach; }

 private:
  /// Where to pass a corner.
  struct Lane {
    Vector2 place;
    Vector2 forward;  // unit vector of the direction there
  };
  /// Free floor beside a place [m].
  struct Sides {
    double left;
    double right;
    double width() const { return left + right; }
  };
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
    bool is_tight = false;  // on the tight mesh
    bool out_of_reach = false;
  };

  void adoptLayout(const World& world);
  void lead(const Agent& agent, World& world);
  Vector2 nextPoint(const Agent& agent, Way& way);
  Vector2 keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const;
  Vector2 chooseAim(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const;
  bool isCorridor(const Vector2& from, const Vector2& to, const Vector2& forward, double radius) const;
  Sides floorBeside(const Vector2& place, const Vector2& forward, double radius) const;
  Vector2 laneBeside(const Vector2& place, const Vector2& forward, double radius) const;

  std::uint64_t layout_changes_ = 0;  // of the world that `data_` belongs to
  bool is_needed_ = false;            // there is anything to walk round
  FloorPlan::Bounds bounds_;          // of the floor of `data_`
  std::shared_ptr<const NavigationData> data_;
  std::optional<NavigationMesh::Query> comfortable_;
  std::optional<NavigationMesh::Query> tight_;
  std::optional<RightOfWay> right_of_way_;
  DeadlockResolver deadlocks_;
  std::vector<Way> agents_;           // by id
  std::vector<RemainingPath> paths_;  // by id
};

}  // namespace crowd
