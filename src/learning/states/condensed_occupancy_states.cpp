#include "learning/states/condensed_occupancy_states.h"

namespace crowd {

CondensedOccupancyStates::CondensedOccupancyStates(const Parameters& parameters)
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

std::shared_ptr<const StateSet> readCondensedOccupancyStates(YamlMap& map, const ActionSet& /*action_set*/) {
  return std::make_shared<CondensedOccupancyStates>(readOccupancyParameters(map));
}

}  // namespace crowd
