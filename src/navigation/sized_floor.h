#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "maps/agent_size.h"
#include "navigation/mesh_cache.h"
#include "navigation/walking_floor.h"
#include "world/world.h"

namespace crowd {

/// @brief The floor of a world for agents of one size, with searches on its meshes. Used by one thread at a time.
class SizedFloor {
 public:
  /// @param floor of agents of this size (walkingFloor()); its bounds contain all starts and goals
  /// @param size see sizeOf() [m] @param gates walls of the gates, whether they are closed or not
  /// @throws InputError if the floor is too large, Stopped if `stop` is made
  SizedFloor(FloorPlan floor, double size, const std::vector<Segment>& gates, const StopRequest& stop);

  /// @brief Searches on the mesh that keeps COMFORTABLE_MARGIN.
  NavigationMesh::Query& comfortable();
  /// @brief Searches on the mesh that keeps TIGHT_MARGIN.
  NavigationMesh::Query& tight();
  /// @brief Whether a gate is closed.
  bool hasClosedGates() const { return opened_.has_value(); }
  /// @brief Searches on the tight mesh with all gates open; hasClosedGates() must be true.
  /// @throws Stopped if `stop` is made
  NavigationMesh::Query& open(const StopRequest& stop);

 private:
  double size_;
  std::shared_ptr<const NavigationData> data_;
  std::optional<FloorPlan> opened_;  // with all gates open, if any is closed
  // Made when they are needed.
  std::optional<NavigationMesh::Query> comfortable_;
  std::optional<NavigationMesh::Query> tight_;
  std::optional<NavigationMesh::Query> open_;
};

/// @brief Does nothing if ways can be found in a world after a change, for all agents in it, and the smallest and
/// the largest ones that the sources of a scene may create. @throws InputError if its floor is too large
void requireNavigableFloor(const World& world, const WorldChange& change, const Scene& scene);

}  // namespace crowd
