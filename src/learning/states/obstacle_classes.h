#pragma once

#include <vector>

#include "learning/rl/rows.h"
#include "world/perception.h"

namespace crowd {

/// @brief Distance classes that the rows of a state set encode. Implemented by state sets that the reward of the thesis
/// can be combined with.
class RowDistanceClasses {
 public:
  virtual ~RowDistanceClasses() = default;
  /// @brief Returns the distance classes of a row, one per obstacle or sector that it distinguishes: 0 (empty) to
  /// DistanceClasses::COUNT; zeros may be omitted. Empty if the row encodes no obstacle, and for a terminal row.
  /// The reward calls it for every row when it is created, and sums the penalties of the classes.
  virtual std::vector<int> distanceClasses(Row row) const = 0;
};

/// @brief An occupied sector around an agent and its distance class.
struct OccupiedSector {
  double from = 0.0;       ///< right limit, agent frame [rad]
  double to = 0.0;         ///< left limit, agent frame [rad]; not below `from`
  int distance_class = 0;  ///< 1 is the nearest
};

/// @brief Sectors and rings around an agent, for pictures and recordings. Implemented by state sets whose states can be
/// drawn. The functions may be called concurrently.
class SectorPicture {
 public:
  virtual ~SectorPicture() = default;
  /// @brief Returns the sectors that are occupied in a perception. They may overlap; each is drawn.
  virtual std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const = 0;
  /// @brief Outer limits of the distance classes 1, 2, ..., ascending: distances from the agent's centre to the other's
  /// rim [m].
  virtual std::vector<double> distanceLimits() const = 0;
};

}  // namespace crowd
