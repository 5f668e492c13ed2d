#include "learning/states/occupancy_states.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

/// A wall that is nearer than this passes through the agent's centre, so that the direction to it is undefined [m].
constexpr double NO_DIRECTION = 1e-9;

}  // namespace

OccupancyStates::OccupancyStates(const Parameters& parameters)
    : SectorStates(parameters.distances),
      goal_sectors_(parameters.sectors),
      sectors_(parameters.sectors, parameters.obstacle_sectors),
      codes_(1) {
  for (int i = 0; i < sectors_.count(); ++i) {
    codes_ *= BASE;
    const Vector2 limit = unitVector(sectors_.rightLimit(sectors_.sectorAt(i)));
    limit_xs_.at(static_cast<std::size_t>(i)) = limit.x();
    limit_ys_.at(static_cast<std::size_t>(i)) = limit.y();
  }
  for (SectorSet set = 0; set <= allSectors(); ++set) {
    Situation situation;
    for (int i = 0; i < sectors_.count(); ++i) {
      const auto sector = static_cast<std::size_t>(sectors_.sectorAt(i));
      situation.distance_classes[sector] = static_cast<int>(set >> static_cast<unsigned>(i) & 1U);
    }
    set_codes_.push_back(rowOf(situation));
  }
}

void OccupancyStates::findRows(const PerceptionBatch& batch, const MoveBlock* /*moves*/, Row* rows) const {
  for (const Perception& seen : batch) *rows++ = rowOf(seen);
}

Row OccupancyStates::rowOf(const Perception& perception) const {
  Occupied occupied{};
  // Reads the arrays: a Neighbour would be assembled in memory first, with fields that are not needed.
  const NeighbourSpan& neighbours = perception.neighbours;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    addNeighbour({neighbours.xs()[i], neighbours.ys()[i]}, neighbours.radii()[i], occupied);
  }
  for (const Segment& wall : perception.walls) addWall(wall, occupied);
  Row row = codes_ * static_cast<Row>(goal_sectors_.indexOf(bearingOf(perception.self.goal)));  // (3.5)
  Row distance_class = 0;
  SectorSet nearer = 0;
  for (const SectorSet set : occupied) {
    row += ++distance_class * set_codes_[set & ~nearer];
    nearer |= set;
  }
  return row;
}

OccupancyStates::Situation OccupancyStates::describe(const Perception& perception) const {
  return situationOf(rowOf(perception));
}

OccupancyStates::SectorSet OccupancyStates::sectorsBeside(SectorSet limits) const {
  // Limit i lies between the sectors at positions i - 1 and i.
  const auto last = static_cast<unsigned>(sectors_.count()) - 1U;
  return limits | limits >> 1U | (limits & 1U) << last;
}

inline OccupancyStates::SectorSet OccupancyStates::limitsCut(const Vector2& centre, double radius,
                                                             double length) const {
  SectorSet cut = 0;
  for (unsigned i = 0; i < static_cast<unsigned>(sectors_.count()); ++i) {
    const double along = limit_xs_[i] * centre.x() + limit_ys_[i] * centre.y();
    const double across = limit_xs_[i] * centre.y() - limit_ys_[i] * centre.x();
    const double beyond = along - std::clamp(along, 0.0, length);
    cut |= static_cast<SectorSet>(beyond * beyond + across * across <= radius * radius) << i;
  }
  return cut;
}

OccupancyStates::SectorSet OccupancyStates::limitsCut(const Segment& wall, double length) const {
  SectorSet cut = 0;
  for (unsigned i = 0; i < static_cast<unsigned>(sectors_.count()); ++i) {
    const Vector2 limit(limit_xs_[i], limit_ys_[i]);
    const double from = cross(limit, wall.from);
    const double to = cross(limit, wall.to);
    if (from == to || from * to > 0.0) continue;  // the wall does not cross the line of the limit, or lies along it
    const Vector2 crossing = wall.from + from / (from - to) * (wall.to - wall.from);
    const double along = limit.dot(crossing);
    cut |= static_cast<SectorSet>(along >= 0.0 && along <= length) << i;
  }
  return cut;
}

inline void OccupancyStates::addNeighbour(const Vector2& centre, double radius, Occupied& occupied) const {
  const DistanceClasses& distances = this->distances();
  const int distance_class = distances.classOf(centre.norm() - radius);
  if (distance_class == 0) return;
  occupy(occupied, sectorOf(centre), distance_class);
  if (distance_class == 1) occupy(occupied, sectorsBeside(limitsCut(centre, radius, distances.collision_radius)), 1);
  occupy(occupied, sectorsBeside(limitsCut(centre, radius, distances.vision_radius)), 2);
}

void OccupancyStates::addWall(const Segment& wall, Occupied& occupied) const {
  const DistanceClasses& distances = this->distances();
  const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
  if (nearest.norm() <= NO_DIRECTION) return occupy(occupied, allSectors(), 1);
  const int distance_class = distances.classOf(nearest.norm());
  if (distance_class == 0) return;
  occupy(occupied, sectorOf(nearest), distance_class);
  occupy(occupied, sectorsBeside(limitsCut(wall, distances.collision_radius)), 1);
  occupy(occupied, sectorsBeside(limitsCut(wall, distances.vision_radius)), 2);
}

Row OccupancyStates::rowOf(const Situation& situation) const {
  Row code = 0;
  for (int sector = 0; sector < sectors_.count(); ++sector) {
    code = code * BASE + static_cast<Row>(situation.distance_classes[static_cast<std::size_t>(sector)]);
  }
  return codes_ * static_cast<Row>(situation.goal_sector) + code;  // (3.5)
}

OccupancyStates::Situation OccupancyStates::situationOf(Row row) const {
  Situation situation;
  situation.goal_sector = static_cast<int>(row / codes_);
  Row code = row % codes_;
  for (auto sector = static_cast<std::size_t>(sectors_.count()); sector-- > 0; code /= BASE) {
    situation.distance_classes[sector] = static_cast<int>(code % BASE);
  }
  return situation;
}

Row OccupancyStates::mirrored(Row row) const {
  if (row >= terminal()) return row;
  const Situation situation = situationOf(row);
  Situation mirrored;
  mirrored.goal_sector = goal_sectors_.mirrored(situation.goal_sector);
  for (int sector = 0; sector < sectors_.count(); ++sector) {
    const auto other_side = static_cast<std::size_t>(sectors_.mirrored(sector));
    mirrored.distance_classes[other_side] = situation.distance_classes[static_cast<std::size_t>(sector)];
  }
  return rowOf(mirrored);
}

std::vector<int> OccupancyStates::distanceClasses(Row row) const {
  if (row >= terminal()) return {};
  const Situation situation = situationOf(row);
  return {situation.distance_classes.begin(), situation.distance_classes.begin() + sectors_.count()};
}

std::vector<OccupiedSector> OccupancyStates::occupiedSectors(const Perception& perception) const {
  const Situation situation = describe(perception);
  std::vector<OccupiedSector> occupied;
  for (int sector = 0; sector < sectors_.count(); ++sector) {
    const int distance_class = situation.distance_classes[static_cast<std::size_t>(sector)];
    if (distance_class == 0) continue;
    occupied.push_back({sectors_.rightLimit(sector), sectors_.leftLimit(sector), distance_class});
  }
  return occupied;
}

std::string OccupancyStates::spec() const { return specOf(TYPE); }

std::string OccupancyStates::specOf(const char* type) const {
  const MirroredSectors* const limited = sectors_.byLimits();
  return std::string("{type: ") + type + ", sectors: " + std::to_string(goal_sectors_.count()) +
         (limited != nullptr ? ", " + sectorLimitsSpec(limited->degrees()) : "") + distancesSpec() + "}";
}

RowMeaning OccupancyStates::meaning() const {
  RowMeaning meaning{{{"goal", namesOf(goal_sectors_)}}, {}, true};
  std::vector<std::string> classes = namesOf(distances());
  classes.insert(classes.begin(), "empty");
  for (const std::string& sector : namesOf(sectors_)) meaning.quantities.push_back({"body " + sector, classes});
  return meaning;
}

OccupancyStates::Parameters readOccupancyParameters(YamlMap& map) {
  map.allow({"type", "sectors", "obstacle_sectors", "collision_radius", "vision_radius"});
  OccupancyStates::Parameters parameters;
  parameters.sectors = static_cast<int>(map.whole("sectors", 2, OccupancyStates::MAX_SECTORS, parameters.sectors));
  parameters.obstacle_sectors = readSectorLimits(map, {});
  constexpr std::size_t MOST = OccupancyStates::MAX_SECTORS / 2;
  if (parameters.obstacle_sectors.size() > MOST) {
    throwExpected(map.placeOf("obstacle_sectors"), map.find("obstacle_sectors"),
                  "at most " + std::to_string(MOST) + " limits");
  }
  parameters.distances = readDistanceClasses(map);
  return parameters;
}

std::shared_ptr<const StateSet> OccupancyStates::read(YamlMap& map, const ActionSet& /*action_set*/) {
  return std::make_shared<OccupancyStates>(readOccupancyParameters(map));
}

StateSetType occupancyStates() {
  return {OccupancyStates::TYPE, "thesis set 2: goal sector; distance class of each sector", OccupancyStates::read};
}

}  // namespace crowd
