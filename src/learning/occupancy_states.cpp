#include "social_crowd/learning/occupancy_states.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

static_assert(OccupancyStates::MAX_SECTORS <= SectorLimits::MOST, "all limits have a place");

/// Nearer than this a wall passes through the agent's centre, and directions to its parts mean nothing [m].
constexpr double NO_DIRECTION = 1e-9;

/// Where the ray of an angle meets the line through the segment; the nearer end where they are parallel.
Vector2 meetRay(const Segment& segment, double angle) {
  const Vector2 ray = unitVector(angle);
  const Vector2 along = segment.to - segment.from;
  const double slope = cross(ray, along);
  if (slope == 0.0) return segment.from.squaredNorm() < segment.to.squaredNorm() ? segment.from : segment.to;
  const double share = std::clamp(-cross(ray, segment.from) / slope, 0.0, 1.0);
  return segment.from + share * along;
}

}  // namespace

OccupancyStates::OccupancyStates(const Parameters& parameters)
    : parameters_(parameters), sectors_(parameters.sectors), limits_(sectors_), codes_(1) {
  for (int i = 0; i < parameters.sectors; ++i) codes_ *= BASE;
  for (SectorSet set = 0; set <= allSectors(); ++set) {
    Situation situation;
    for (unsigned sector = 0; sector < MAX_SECTORS; ++sector) {
      situation.distance_classes[sector] = static_cast<int>(set >> sector & 1U);
    }
    set_codes_.push_back(rowOf(situation));
  }
}

Row OccupancyStates::rowOf(const Perception& perception) const {
  Occupied occupied{};
  // A whole body, of which two numbers are needed, would be put together in memory first.
  const PerceivedBodiesView& bodies = perception.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    addBody({bodies.xs()[i], bodies.ys()[i]}, bodies.radii()[i], occupied);
  }
  for (const Segment& wall : perception.walls) addWall(wall, occupied);
  Row row = codes_ * static_cast<Row>(goalSector(perception.self.goal));  // (3.5)
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

inline int OccupancyStates::goalSector(const Vector2& goal) const {
  const SectorSet sector = limits_.reachedBy(goal, 0.0);
  return sector != 0 ? __builtin_ctz(sector) : sectors_.indexOf(bearingOf(goal));
}

SectorSet OccupancyStates::sectorsFrom(long first, long last) const {
  const long count = std::min<long>(last - first + 1, sectors_.count());
  const SectorSet beyond_a_circle = ((1U << static_cast<unsigned>(count)) - 1U)
                                    << static_cast<unsigned>(sectors_.wrap(first));
  return (beyond_a_circle | beyond_a_circle >> static_cast<unsigned>(sectors_.count())) & allSectors();
}

SectorSet OccupancyStates::sectorsSpanned(const Vector2& centre, double distance, double radius) const {
  const double bearing = bearingOf(centre);
  const double half_span = std::asin(radius / distance);
  return sectorsFrom(sectors_.unwrappedIndexOf(bearing - half_span), sectors_.unwrappedIndexOf(bearing + half_span));
}

inline void OccupancyStates::addBody(const Vector2& centre, double radius, Occupied& occupied) const {
  const double distance = centre.norm();
  const int distance_class = parameters_.distances.classOf(distance - radius);
  if (distance_class == 0) return;
  if (distance <= radius) return occupy(occupied, allSectors(), distance_class);  // the agent stands inside
  const SectorSet reached = limits_.reachedBy(centre, radius);
  occupy(occupied, reached != 0 ? reached : sectorsSpanned(centre, distance, radius), distance_class);
}

void OccupancyStates::addWall(const Segment& wall, Occupied& occupied) const {
  if (nearestPoint(wall, Vector2::Zero()).norm() <= NO_DIRECTION) return occupy(occupied, allSectors(), 1);
  const bool counterclockwise = cross(wall.from, wall.to) >= 0.0;
  const Segment sweep = counterclockwise ? wall : Segment{wall.to, wall.from};
  const double begin = bearingOf(sweep.from);
  const double span = std::abs(wrapAngle(bearingOf(sweep.to) - begin));
  const long first = sectors_.unwrappedIndexOf(begin);
  const long last = sectors_.unwrappedIndexOf(begin + span);
  for (long sector = first; sector <= last; ++sector) {
    // A long wall is near in one sector and far in the next: only the part within the sector counts.
    const Segment part = {sector == first ? sweep.from : meetRay(sweep, sectors_.rightLimit(sector)),
                          sector == last ? sweep.to : meetRay(sweep, sectors_.rightLimit(sector + 1))};
    const int distance_class = parameters_.distances.classOf(distanceTo(part, Vector2::Zero()));
    if (distance_class > 0) occupy(occupied, sectorsFrom(sector, sector), distance_class);
  }
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
  mirrored.goal_sector = sectors_.mirrored(situation.goal_sector);
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
    occupied.push_back({sectors_.rightLimit(sector), sectors_.rightLimit(sector + 1), distance_class});
  }
  return occupied;
}

std::vector<double> OccupancyStates::distanceLimits() const {
  return {parameters_.distances.collision_radius, parameters_.distances.vision_radius};
}

std::string OccupancyStates::spec() const {
  return std::string("{type: ") + TYPE + ", sectors: " + std::to_string(parameters_.sectors) +
         ", collision_radius: " + toText(parameters_.distances.collision_radius) +
         ", vision_radius: " + toText(parameters_.distances.vision_radius) + "}";
}

}  // namespace crowd
