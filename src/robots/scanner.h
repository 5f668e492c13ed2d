#pragma once

#include <vector>

#include "common/span.h"
#include "geometry/geometry.h"
#include "geometry/ray.h"
#include "geometry/wall_index.h"
#include "robots/scan.h"
#include "scenario/robot_sensors.h"

namespace crowd {

/// @brief A disc that rays hit.
struct ScanTarget {
  Vector2 centre = Vector2::Zero();  ///< [m], `map`
  double radius = 0.0;               ///< [m]
  BodyNumber body = 0;
};

/// @brief An edge of a polygon that rays hit, [m], `map`.
struct ScanEdge {
  Segment edge;
  BodyNumber body = 0;
};

/// @brief Exact ray casting of one laser scanner. Results do not depend on the order of bodies and walls. It allocates
/// nothing after its first scan. Not thread-safe.
class Scanner {
 public:
  explicit Scanner(const ScanSpec& spec);

  const ScanSpec& spec() const { return spec_; }
  /// @brief The result of the last call of scan().
  const Scan& last() const { return scan_; }
  /// @brief Casts all rays. Of bodies at the same distance, the lowest number counts.
  /// @param sensor in `map` @return valid until the next call
  const Scan& scan(const Pose& sensor, const Span<ScanTarget>& targets, const Span<ScanEdge>& edges,
                   const WallIndex& walls);

  /// @brief Whether the ray of the last scan that is nearest to the direction of a point reaches it. @param point `map`
  bool reaches(const Vector2& point) const;

 private:
  /// Calls test(ray number) for all rays whose bearing is from `low` to `high` [rad] from that of the first ray, and
  /// some beside them.
  template <typename Test>
  void forEachBetween(double low, double high, const Test& test) const;
  void castAt(const ScanTarget& target);
  void castAt(const ScanEdge& edge);
  void castAt(const WallIndex& walls);
  void note(std::size_t ray, double distance, BodyNumber body);

  ScanSpec spec_;
  double increment_;            // [rad]
  std::vector<Vector2> units_;  // of the rays, sensor frame
  double first_bearing_ = 0.0;  // of the first ray, `map` [rad]
  std::vector<Ray> rays_;       // `map`
  Scan scan_;
};

}  // namespace crowd
