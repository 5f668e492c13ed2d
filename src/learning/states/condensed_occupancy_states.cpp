#include <string>
#include <vector>

#include "learning/states/occupancy_states.h"
#include "learning/states/row_meaning.h"
#include "learning/states/sector_states.h"

namespace crowd {
namespace {

/// The thesis's state set 2, condensed as its future work suggests (5.2: the nearest distance "as a whole circle
/// and not slices"): sector of the goal, whether anything is within the collision radius in any sector, and for every
/// sector whether it is occupied within the radius of vision.
///
/// With g sectors of the goal and n of obstacles the state is G * 2 * 2^n + near * 2^n + code, where the code's binary
/// digits are the sectors, sector 0 first as in (3.5); terminal g * 2 * 2^n.
class CondensedOccupancyStates : public SectorStates, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "condensed_occupancy";
  static std::shared_ptr<const StateSet> read(YamlMap& map, const ActionSet& action_set);

  explicit CondensedOccupancyStates(const OccupancyStates::Parameters& parameters);

  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  Row mirrored(Row row) const override;
  /// 1 if anything is within the collision radius, then 2 for each occupied sector.
  std::vector<int> distanceClasses(Row row) const override;
  /// With the distance class of each sector; the row holds less.
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override {
    return occupancy_.occupiedSectors(perception);
  }
  std::string spec() const override { return occupancy_.specOf(TYPE); }
  RowMeaning meaning() const override;
  Row terminal() const override { return 2 * codes_ * static_cast<Row>(occupancy_.goalSectors().count()); }

 private:
  /// Returns the row of a situation of state set 2.
  Row rowOf(const OccupancyStates::Situation& situation) const;
  /// The value of a sector's digit in the code of a row.
  Row digitOf(int sector) const { return Row{1} << static_cast<unsigned>(sectors().count() - 1 - sector); }

  const ObstacleSectors& sectors() const { return occupancy_.obstacleSectors(); }

  OccupancyStates occupancy_;
  Row codes_;  // 2^(sectors of obstacles)
};

CondensedOccupancyStates::CondensedOccupancyStates(const OccupancyStates::Parameters& parameters)
    : SectorStates(parameters.distances),
      occupancy_(parameters),
      codes_(Row{1} << static_cast<unsigned>(occupancy_.obstacleSectors().count())) {}

void CondensedOccupancyStates::findRows(const PerceptionBatch& batch, const MoveBlock* /*moves*/, Row* rows) const {
  for (const Perception& seen : batch) *rows++ = rowOf(occupancy_.describe(seen));
}

Row CondensedOccupancyStates::rowOf(const OccupancyStates::Situation& situation) const {
  Row near = 0;
  Row code = 0;
  for (int sector = 0; sector < sectors().count(); ++sector) {
    const int distance_class = situation.distance_classes[static_cast<std::size_t>(sector)];
    if (distance_class == 1) near = 1;
    if (distance_class > 0) code += digitOf(sector);
  }
  return (2 * static_cast<Row>(situation.goal_sector) + near) * codes_ + code;
}

Row CondensedOccupancyStates::mirrored(Row row) const {
  if (row >= terminal()) return row;
  const auto goal_sector = static_cast<int>(row / (2 * codes_));
  const Row near = row / codes_ % 2;
  Row code = 0;
  for (int sector = 0; sector < sectors().count(); ++sector) {
    if ((row & digitOf(sector)) != 0) code += digitOf(sectors().mirrored(sector));
  }
  return (2 * static_cast<Row>(occupancy_.goalSectors().mirrored(goal_sector)) + near) * codes_ + code;
}

std::vector<int> CondensedOccupancyStates::distanceClasses(Row row) const {
  std::vector<int> classes;
  if (row >= terminal()) return classes;
  if (row / codes_ % 2 == 1) classes.push_back(1);
  for (int sector = 0; sector < sectors().count(); ++sector) {
    if ((row & digitOf(sector)) != 0) classes.push_back(2);
  }
  return classes;
}

RowMeaning CondensedOccupancyStates::meaning() const {
  const std::string near = "any body within " + shortText(distances().collision_radius) + " m";
  RowMeaning meaning{{{"goal", namesOf(occupancy_.goalSectors())}, {near, {"no", "yes"}}}, {}, true};
  for (const std::string& sector : namesOf(sectors())) meaning.quantities.push_back({"body " + sector, {"no", "yes"}});
  return meaning;
}

std::shared_ptr<const StateSet> CondensedOccupancyStates::read(YamlMap& map, const ActionSet& /*action_set*/) {
  return std::make_shared<CondensedOccupancyStates>(readOccupancyParameters(map));
}

}  // namespace

StateSetType condensedOccupancyStates() {
  return {CondensedOccupancyStates::TYPE, "set 2 with one nearest distance for all sectors",
          CondensedOccupancyStates::read};
}

}  // namespace crowd
