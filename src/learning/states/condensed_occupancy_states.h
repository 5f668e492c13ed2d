#pragma once

#include <string>
#include <vector>

#include "learning/states/occupancy_states.h"
#include "learning/states/row_meaning.h"
#include "learning/states/sector_states.h"

namespace crowd {

/// @brief The thesis's state set 2, condensed as its future work suggests (5.2: the nearest distance "as a whole circle
/// and not slices"): sector of the goal, whether anything is within the collision radius in any sector, and for every
/// sector whether it is occupied within the radius of vision.
///
/// With g sectors of the goal and n of obstacles the state is G * 2 * 2^n + near * 2^n + code, where the code's binary
/// digits are the sectors, sector 0 first as in (3.5); terminal g * 2 * 2^n.
class CondensedOccupancyStates : public SectorStates, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "condensed_occupancy";

  using Parameters = OccupancyStates::Parameters;

  CondensedOccupancyStates() : CondensedOccupancyStates(Parameters()) {}
  explicit CondensedOccupancyStates(const Parameters& parameters);

  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  Row mirrored(Row row) const override;
  /// @brief 1 if anything is within the collision radius, then 2 for each occupied sector.
  std::vector<int> distanceClasses(Row row) const override;
  /// @brief With the distance class of each sector; the row holds less.
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override {
    return occupancy_.occupiedSectors(perception);
  }
  std::string spec() const override { return occupancy_.specOf(TYPE); }
  RowMeaning meaning() const override;

  /// @brief Returns the row of a situation of state set 2.
  Row rowOf(const OccupancyStates::Situation& situation) const;
  Row terminal() const override { return 2 * codes_ * static_cast<Row>(occupancy_.goalSectors().count()); }

 private:
  /// The value of a sector's digit in the code of a row.
  Row digitOf(int sector) const { return Row{1} << static_cast<unsigned>(sectors().count() - 1 - sector); }

  const ObstacleSectors& sectors() const { return occupancy_.obstacleSectors(); }

  OccupancyStates occupancy_;
  Row codes_;  // 2^(sectors of obstacles)
};

/// @brief Reads a map of the keys of readOccupancyParameters(). @throws InputError
std::shared_ptr<const StateSet> readCondensedOccupancyStates(YamlMap& map, const ActionSet& action_set);

}  // namespace crowd
