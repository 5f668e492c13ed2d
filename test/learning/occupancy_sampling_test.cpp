// The occupied sectors of random worlds, compared with the two steps of the thesis (3.2.2.1) on many sample points.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/random.h"
#include "learning/states/occupancy_states.h"
#include "support/perceptions.h"

namespace crowd::occupancy_sampling_test {
namespace {

constexpr int POINTS = 4000;          // samples per body and wall
constexpr double CLEAR_ANGLE = 0.02;  // no wall's end or disc's centre is this near to a sector's limit [rad]
constexpr double CLEAR = 2e-3;        // minimum distance from any other decision boundary [m]

/// Limits of uneven sectors on each side [degrees].
const std::vector<std::vector<double>> LIMITS = {{15, 45, 90, 180}, {180}, {30, 180}, {10, 25, 50, 80, 120, 180}};

struct Disc {
  Vector2 centre;
  double radius;
};

/// Distance of the nearest point found in each sector; infinite if there is none.
using Nearest = std::array<double, OccupancyStates::MAX_SECTORS>;

Nearest nowhere() {
  Nearest nearest;
  nearest.fill(INFINITY);
  return nearest;
}

struct Sector {
  std::size_t number;
  double from;  // right limit [rad]
  double width;

  bool contains(double angle) const {
    return std::abs(std::remainder(angle - from - width / 2.0, 2.0 * PI)) <= width / 2.0;
  }
};

/// Counterclockwise, each beside the next one, and the last one beside the first.
using Sectors = std::vector<Sector>;

Sectors sectorsOf(const OccupancyStates::Parameters& parameters) {
  Sectors sectors;
  if (parameters.obstacle_sectors.empty()) {
    const double width = 2.0 * PI / parameters.sectors;
    for (int i = 0; i < parameters.sectors; ++i)
      sectors.push_back({static_cast<std::size_t>(i), (i - 0.5) * width, width});
    return sectors;
  }
  double inner = 0.0;
  for (const double outer : parameters.obstacle_sectors) {
    sectors.push_back({sectors.size(), toRadians(inner), toRadians(outer - inner)});
    inner = outer;
  }
  for (std::size_t i = sectors.size(); i-- > 0;) {
    const Sector& left = sectors[i];
    sectors.push_back({parameters.obstacle_sectors.size() + i, -left.from - left.width, left.width});
  }
  return sectors;
}

/// Returns the distance of an angle from the nearest limit of a sector [rad].
double angleToLimit(double angle, const Sectors& sectors) {
  double least = INFINITY;
  for (const Sector& sector : sectors) least = std::min(least, std::abs(std::remainder(angle - sector.from, 2.0 * PI)));
  return least;
}

void notePoint(const Vector2& point, const Sectors& sectors, Nearest& nearest) {
  for (const Sector& sector : sectors) {
    double& distance = nearest.at(sector.number);
    if (sector.contains(bearingOf(point))) distance = std::min(distance, point.norm());
  }
}

/// The class of the nearest point; 0 if there is none within vision.
int classAt(double distance) {
  if (distance > 1.0) return 0;
  return distance > 0.5 ? 2 : 1;
}

bool isNearAClassLimit(double distance) { return std::abs(distance - 0.5) < CLEAR || std::abs(distance - 1.0) < CLEAR; }

/// The limiting vector on the right of a sector, with a length.
Segment limitingVector(const Sector& sector, double length) {
  return {Vector2::Zero(), length * unitVector(sector.from)};
}

/// Whether a limiting vector grazes the disc, or the disc lies on the limit of a class or of a sector.
bool isAMatterOfOpinion(const Disc& disc, const Sectors& sectors) {
  const double rim = disc.centre.norm() - disc.radius;
  if (isNearAClassLimit(rim) || angleToLimit(bearingOf(disc.centre), sectors) < CLEAR_ANGLE) return true;
  for (const Sector& sector : sectors) {
    for (const double length : {0.5, 1.0}) {
      const double miss = distanceTo(limitingVector(sector, length), disc.centre) - disc.radius;
      if (std::abs(miss) < CLEAR) return true;
    }
  }
  return false;
}

bool cuts(const Segment& vector, const Disc& disc) {
  for (int i = 0; i <= POINTS; ++i) {
    if ((vector.to * i / POINTS - disc.centre).norm() <= disc.radius) return true;
  }
  return false;
}

void lower(int& present, int distance_class) {
  if (distance_class > 0 && (present == 0 || distance_class < present)) present = distance_class;
}

void searchDisc(const Disc& disc, const Sectors& sectors, std::array<int, OccupancyStates::MAX_SECTORS>& classes) {
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    const Sector& sector = sectors[i];
    int& distance_class = classes.at(sector.number);
    // First step: the sector in which the segment to the centre falls, at the distance of the rim.
    if (sector.contains(bearingOf(disc.centre))) lower(distance_class, classAt(disc.centre.norm() - disc.radius));
    // Second step: limiting vectors as long as the distances of the classes.
    for (const double length : {1.0, 0.5}) {
      if (!cuts(limitingVector(sector, length), disc)) continue;
      lower(distance_class, classAt(length));
      lower(classes.at(sectors[(i + sectors.size() - 1) % sectors.size()].number), classAt(length));
    }
  }
}

/// The same for a wall, whose parts have different distances. Returns whether the result is unambiguous.
bool searchWall(const Segment& wall, const Sectors& sectors, std::array<int, OccupancyStates::MAX_SECTORS>& classes) {
  Nearest found = nowhere();
  for (int i = 0; i <= POINTS; ++i) {
    notePoint(wall.from + (wall.to - wall.from) * i / POINTS, sectors, found);
  }
  bool beyond_doubt = *std::min_element(found.begin(), found.end()) > 0.05 &&
                      angleToLimit(bearingOf(wall.from), sectors) > CLEAR_ANGLE &&
                      angleToLimit(bearingOf(wall.to), sectors) > CLEAR_ANGLE;
  for (std::size_t sector = 0; sector < classes.size(); ++sector) {
    beyond_doubt = beyond_doubt && !isNearAClassLimit(found.at(sector));
    lower(classes.at(sector), classAt(found.at(sector)));
  }
  return beyond_doubt;
}

/// Compares one random world; returns false if the expected result is ambiguous.
bool compareWorld(std::uint64_t seed, std::uint32_t max_discs, std::uint32_t max_walls) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  OccupancyStates::Parameters parameters;
  parameters.sectors = seed % 2 == 0 ? 8 : 2 + static_cast<int>(random.below(11));
  if (seed % 3 == 0) parameters.obstacle_sectors = LIMITS.at(seed / 3 % LIMITS.size());
  const Sectors sectors = sectorsOf(parameters);
  PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {5.0, 0.0});
  std::array<int, OccupancyStates::MAX_SECTORS> expected{};
  for (std::uint32_t i = random.below(max_discs + 1); i > 0; --i) {
    const double distance = random.uniform(0.0, 2.0);
    const Disc disc = {polar(random.uniform(-180.0, 180.0), distance), random.uniform(0.02, 1.2)};
    if (isAMatterOfOpinion(disc, sectors)) return false;
    searchDisc(disc, sectors, expected);
    scene.neighbour(disc.centre, disc.radius);
  }
  for (std::uint32_t i = random.below(max_walls + 1); i > 0; --i) {
    const double distance = random.uniform(0.0, 2.0);
    const Vector2 from = polar(random.uniform(-180.0, 180.0), distance);
    const double length = random.uniform(0.01, 3.0);
    const Segment wall = {from, from + polar(random.uniform(-180.0, 180.0), length)};
    if (!searchWall(wall, sectors, expected)) return false;
    scene.wall(wall.from, wall.to);
  }
  EXPECT_EQ(OccupancyStates(parameters).describe(scene.perception()).distance_classes, expected);
  return true;
}

int countCompared(std::uint32_t max_discs, std::uint32_t max_walls) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    compared += compareWorld(seed, max_discs, max_walls) ? 1 : 0;
  }
  return compared;
}

TEST(OccupancySampling, FindsTheSameSectorsOfABody) { EXPECT_GT(countCompared(1, 0), 800); }

TEST(OccupancySampling, FindsTheSameSectorsOfAWall) { EXPECT_GT(countCompared(0, 1), 700); }

TEST(OccupancySampling, FindsTheSameSectorsOfSeveralBodiesAndWalls) { EXPECT_GT(countCompared(3, 2), 500); }

}  // namespace
}  // namespace crowd::occupancy_sampling_test
