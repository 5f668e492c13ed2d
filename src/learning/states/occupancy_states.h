#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "learning/states/obstacle_sectors.h"
#include "learning/states/row_meaning.h"
#include "learning/states/sector_states.h"

namespace crowd {

/// @brief The thesis's state set 2 (3.2.2.1, (3.5)): sector of the goal, and a distance class for every sector,
/// computed in two steps for each body:
/// 1. the segment that joins the agent and the body's centre gives one sector, which takes the class of the distance
///    from the agent's centre to the body's rim;
/// 2. the limiting vectors of the sectors, with the lengths of the distance classes, are intersected with the body: the
///    sectors on both sides of a vector that is cut take the class of the shortest length that is cut.
/// A sector has the smallest, that is the nearest, class of all bodies. Walls, which the thesis does not have, are
/// treated the same way, with their nearest point in place of the centre.
///
/// The classes (0: empty) are the digits of a number of base 3, sector 0 first; with 8 sectors the state is
/// 3^8 * G + code, terminal 3^8 * 8. The sectors of the obstacles are equal, as those of the goal are, or by limits:
/// those of state set 1, whose number may be another one.
class OccupancyStates : public SectorStates, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "occupancy";
  /// @brief Reads a map of the keys of readOccupancyParameters(). @throws InputError
  static std::shared_ptr<const StateSet> read(YamlMap& map, const ActionSet& action_set);
  static constexpr int MAX_SECTORS = 12;  // a table of 3^12 * 12 rows is the largest practical one

  struct Parameters {
    int sectors = 8;                       ///< equal ones of the goal, and of the obstacles without obstacle_sectors
    std::vector<double> obstacle_sectors;  ///< outer limits on each side [degrees], as NearestObstacleStates has them
    DistanceClasses distances;
  };

  /// @brief The contents of a state; the classes of unused sectors are 0.
  struct Situation {
    int goal_sector = 0;
    std::array<int, MAX_SECTORS> distance_classes{};
  };

  OccupancyStates() : OccupancyStates(Parameters()) {}
  explicit OccupancyStates(const Parameters& parameters);

  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  Row mirrored(Row row) const override;
  std::vector<int> distanceClasses(Row row) const override;
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override;
  std::string spec() const override;
  RowMeaning meaning() const override;

  /// @brief Returns the contents of the state that a perception maps to.
  Situation describe(const Perception& perception) const;
  /// @brief Returns the row of a situation or of a perception, (3.5).
  Row rowOf(const Situation& situation) const;
  Row rowOf(const Perception& perception) const;
  /// @brief Inverse of rowOf(). @param row not the terminal row
  Situation situationOf(Row row) const;
  Row terminal() const override { return codes_ * static_cast<Row>(goal_sectors_.count()); }
  const EvenSectors& goalSectors() const { return goal_sectors_; }
  const ObstacleSectors& obstacleSectors() const { return sectors_; }
  /// @brief Returns spec() with another type.
  std::string specOf(const char* type) const;

 private:
  static constexpr int BASE = DistanceClasses::COUNT + 1;

  /// A set of sectors, or of their right limits; bit p is the sector at position p.
  using SectorSet = std::uint32_t;
  /// The occupied sectors of each distance class; index 0 is class 1.
  using Occupied = std::array<SectorSet, DistanceClasses::COUNT>;

  SectorSet allSectors() const { return (1U << static_cast<unsigned>(sectors_.count())) - 1U; }
  /// Returns the sectors on both sides of the limits.
  SectorSet sectorsBeside(SectorSet limits) const;
  SectorSet sectorOf(const Vector2& point) const {
    return 1U << static_cast<unsigned>(sectors_.positionOf(bearingOf(point)));
  }
  /// Returns the limiting vectors of a length [m] that a body intersects.
  SectorSet limitsCut(const Vector2& centre, double radius, double length) const;
  SectorSet limitsCut(const Segment& wall, double length) const;
  static void occupy(Occupied& occupied, SectorSet sectors, int distance_class) {
    occupied[static_cast<std::size_t>(distance_class) - 1] |= sectors;
  }
  void addNeighbour(const Vector2& centre, double radius, Occupied& occupied) const;
  void addWall(const Segment& wall, Occupied& occupied) const;

  EvenSectors goal_sectors_;
  ObstacleSectors sectors_;
  std::array<double, MAX_SECTORS> limit_xs_{};  // unit vectors of the right limit of each sector, by position
  std::array<double, MAX_SECTORS> limit_ys_{};
  Row codes_;                   // 3^(sectors of obstacles)
  std::vector<Row> set_codes_;  // code of each set of sectors, with class 1 in its sectors and 0 elsewhere
};

/// @brief Reads the keys sectors, obstacle_sectors, collision_radius and vision_radius, all optional. @throws
/// InputError
OccupancyStates::Parameters readOccupancyParameters(YamlMap& map);

}  // namespace crowd
