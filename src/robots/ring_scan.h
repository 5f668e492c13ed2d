#pragma once

#include <cstdint>
#include <vector>

#include "common/random.h"
#include "common/span.h"
#include "geometry/geometry.h"
#include "geometry/wall_index.h"
#include "scenario/figure.h"
#include "scenario/robot_sensors.h"

namespace crowd {

/// @brief What a scanner with several rings sees: heights [m] and shares of light that are reflected, all our choice.
namespace solids {
constexpr double WALL_HEIGHT = 2.5;
constexpr double OBSTACLE_HEIGHT = 1.0;
constexpr double ROBOT_HEIGHT = 0.6;
constexpr double ADULT_HEIGHT = 1.7;
constexpr double CHILD_HEIGHT = 1.2;
constexpr double SITTING_HEIGHT = 1.35;
constexpr double PERSON_REFLECTION = 0.5;
constexpr double BODY_REFLECTION = 0.7;
constexpr double WALL_REFLECTION = 0.8;
constexpr double FLOOR_REFLECTION = 0.2;
}  // namespace solids

/// @brief Height of a person [m].
double heightOf(Figure figure);

/// @brief An upright cylinder on the floor.
struct Column {
  Vector2 centre = Vector2::Zero();  ///< [m], `map`
  double radius = 0.0;               ///< [m]
  double height = 0.0;               ///< [m]
  double reflection = 0.0;           ///< share of the light, 0 to 1
};

/// @brief An upright rectangle on the floor.
struct Panel {
  Segment base;             ///< [m], `map`
  double height = 0.0;      ///< [m]
  double reflection = 0.0;  ///< as of a column
};

/// @brief A point that a ray hits, in the frame of the scanner.
struct ScanPoint {
  float x = 0.0F;          ///< ahead [m]
  float y = 0.0F;          ///< left [m]
  float z = 0.0F;          ///< up [m]
  float intensity = 0.0F;  ///< reflection times cosine of the angle of incidence, 0 to 1
  std::uint16_t ring = 0;  ///< the lowest is 0
};

/// @brief Elevation of a ring [rad].
double elevationOf(const ScanSpec& spec, std::uint32_t ring);

/// @brief Exact scan of all rings (ScanSpec::rings), azimuth by azimuth: of each ray the first point on a column, a
/// panel, a wall of WALL_HEIGHT or the floor, within the range, with the noise and the dropouts of the scanner.
/// @param sensor in `map` @param key of the random numbers of this scan
std::vector<ScanPoint> scanRings(const ScanSpec& spec, const Pose& sensor, const Span<Column>& columns,
                                 const Span<Panel>& panels, const WallIndex& walls, const KeyedRandom& key);

}  // namespace crowd
