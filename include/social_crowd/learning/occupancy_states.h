#pragma once

#include <array>
#include <vector>

#include "social_crowd/learning/distance_classes.h"
#include "social_crowd/learning/sector_limits.h"
#include "social_crowd/learning/sectors.h"
#include "social_crowd/learning/state_set.h"

namespace crowd {

/// @brief The thesis's state set 2 (3.5): sector of the goal, and for every sector the smallest distance class of
/// anything that lies in it or reaches into it.
///
/// The classes (0: empty) are the digits of a number of base 3, sector 0 first; with 8 sectors the state is
/// 3^8 * G + code, terminal 3^8 * 8.
class OccupancyStates : public StateSet {
 public:
  static constexpr const char* TYPE = "occupancy";
  static constexpr int MAX_SECTORS = 12;  // 3^12 * 12 rows are the most that make sense as a table

  struct Parameters {
    int sectors = 8;  ///< of the goal and of the obstacles
    DistanceClasses distances;
  };

  /// @brief What a state says; classes of sectors beyond the set's number are 0.
  struct Situation {
    int goal_sector = 0;
    std::array<int, MAX_SECTORS> distance_classes{};
  };

  OccupancyStates() : OccupancyStates(Parameters()) {}
  explicit OccupancyStates(const Parameters& parameters);

  Row rowCount() const override { return terminal() + 1; }
  void findRows(const Chooser& chooser) const override { *chooser.rows = rowOf(chooser.seen); }
  Row mirrored(Row row) const override;
  std::vector<int> distanceClasses(Row row) const override;
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override;
  std::vector<double> distanceLimits() const override;
  std::string spec() const override;

  Situation describe(const Perception& perception) const;
  Row rowOf(const Situation& situation) const;
  Row rowOf(const Perception& perception) const;
  /// @brief What a row says; it must not be the terminal one.
  Situation situationOf(Row row) const;
  /// @brief The row of an agent that has arrived.
  Row terminal() const { return codes_ * static_cast<Row>(sectors_.count()); }

 private:
  static constexpr int BASE = DistanceClasses::COUNT + 1;

  /// By distance class, from 1, the sectors that something of that class reaches into.
  using Occupied = std::array<SectorSet, DistanceClasses::COUNT>;

  SectorSet allSectors() const { return (1U << static_cast<unsigned>(sectors_.count())) - 1U; }
  /// From one sector to another, counterclockwise; numbers not yet taken modulo, at most a full circle apart.
  SectorSet sectorsFrom(long first, long last) const;
  int goalSector(const Vector2& goal) const;
  /// All sectors between the tangents of a body that the agent stands outside of: seen from it, the body spans the
  /// angles between those.
  SectorSet sectorsSpanned(const Vector2& centre, double distance, double radius) const;
  static void occupy(Occupied& occupied, SectorSet sectors, int distance_class) {
    occupied[static_cast<std::size_t>(distance_class) - 1] |= sectors;
  }
  void addBody(const Vector2& centre, double radius, Occupied& occupied) const;
  void addWall(const Segment& wall, Occupied& occupied) const;

  Parameters parameters_;
  EvenSectors sectors_;
  SectorLimits limits_;
  Row codes_;                   // 3^sectors
  std::vector<Row> set_codes_;  // of each set of sectors, if class 1 is in all of it and no other is occupied
};

}  // namespace crowd
