#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "navigation/mesh_cache.h"
#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief Finds the shortest ways of a robot on a floor, round walls and obstacles at rest, with all gates open, for
/// the smallest disc about its origin that contains its footprint. Where there is none, that for the largest disc about
/// the origin in the footprint.
///
/// The mesh is made at the first search, and shared with others for the same floor (navigationData()). Not thread-safe.
class ShortestWay {
 public:
  struct Way {
    double length = 0.0;  ///< [m]; NaN: there is no way
    double turn = 0.0;    ///< sum of the absolute changes of direction on it, from the first heading on [rad]
  };

  ShortestWay() = default;
  /// @param gates walls of the gates, whether they are closed or not
  ShortestWay(const ObservedScene& scene, const std::vector<Segment>& gates, const Footprint& footprint);

  /// @brief The shortest way from a pose via some places [m]. Where the floor is too large for way-finding, straight
  /// lines.
  Way via(const Pose& from, const std::vector<Vector2>& places);

 private:
  std::optional<Path> find(const Vector2& from, const Vector2& to);
  std::optional<Path> findFor(double radius, const Vector2& from, const Vector2& to);

  FloorPlan floor_;
  double outer_radius_ = 0.0;  // [m]
  double inner_radius_ = 0.0;
  bool is_too_large_ = false;
  double radius_ = 0.0;                         // that `query_` is for
  std::shared_ptr<const NavigationData> data_;  // kept while `query_` uses it
  std::optional<NavigationMesh::Query> query_;
};

}  // namespace crowd
