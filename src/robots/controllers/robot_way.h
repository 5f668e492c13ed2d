#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "maps/floor_plan.h"
#include "navigation/mesh_cache.h"
#include "navigation/path_follower.h"
#include "world/world.h"

namespace crowd {

/// @brief Leads one robot round walls and obstacles at rest, as WayFinder leads agents, but without lanes, turns
/// and gates: it keeps COMFORTABLE_MARGIN from walls where there is room, for the smallest disc that contains its
/// footprint. The caller calls next() once a tick.
class RobotWay {
 public:
  /// @brief The point to drive straight to: the next corner of a way to the goal, or the goal where there is nothing to
  /// drive round or no way. @param goal [m], `map` @return [m], `map`
  Vector2 next(const World& world, const Robot& robot, const Vector2& goal);

 private:
  void adoptLayout(const World& world, const Robot& robot, const Vector2& goal);

  std::optional<std::uint64_t> layout_changes_;  // of the world that `data_` belongs to
  FloorPlan::Bounds bounds_;                     // of the floor of `data_`
  std::shared_ptr<const NavigationData> data_;   // null: nothing to drive round, or the floor is too large
  std::optional<NavigationMesh::Query> query_;
  std::optional<PathFollower> follower_;
  bool is_tight_ = false;  // `query_` is on the tight mesh
};

}  // namespace crowd
