// The occupied sectors of random worlds, compared with what a search over many points of every body finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "social_crowd/common/random.h"
#include "social_crowd/learning/occupancy_states.h"
#include "support/perceptions.h"

namespace crowd {
namespace {

constexpr int POINTS = 4000;          // of each body and wall
constexpr double CLEAR_ANGLE = 0.02;  // no wall's end is this near to a sector's limit [rad]
constexpr double CLEAR = 2e-3;        // and nothing else is as close to a matter of opinion [m]

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

/// How far an angle is from the nearest limit of a sector [rad].
double angleToLimit(double angle, int sectors) {
  const double width = 2.0 * PI / sectors;
  return std::abs(std::remainder(angle - width / 2.0, width));
}

void notePoint(const Vector2& point, int sectors, Nearest& nearest) {
  const double width = 2.0 * PI / sectors;
  for (int sector = 0; sector < sectors; ++sector) {
    const double from_middle = std::remainder(bearingOf(point) - sector * width, 2.0 * PI);
    double& distance = nearest.at(static_cast<std::size_t>(sector));
    if (std::abs(from_middle) <= width / 2.0) distance = std::min(distance, point.norm());
  }
}

/// The class of the nearest point; 0 if there is none within vision.
int classAt(double distance) {
  if (distance > 1.0) return 0;
  return distance > 0.5 ? 2 : 1;
}

bool isNearAClassLimit(double distance) { return std::abs(distance - 0.5) < CLEAR || std::abs(distance - 1.0) < CLEAR; }

/// Whether the outline grazes a sector's limit, or passes through the agent's centre, or lies on a class's limit.
bool isAMatterOfOpinion(const Disc& disc, int sectors) {
  const double distance = disc.centre.norm();
  if (std::abs(distance - disc.radius) < CLEAR || isNearAClassLimit(distance - disc.radius)) return true;
  for (int sector = 0; sector < sectors; ++sector) {
    const Vector2 limit = unitVector((sector - 0.5) * 2.0 * PI / sectors);
    if (std::abs(std::abs(cross(limit, disc.centre)) - disc.radius) < CLEAR) return true;
  }
  return false;
}

/// The class of each sector by a search over the disc's outline: as a whole it has one distance.
void searchDisc(const Disc& disc, int sectors, std::array<int, OccupancyStates::MAX_SECTORS>& classes) {
  Nearest found = nowhere();
  double rim = INFINITY;
  for (int i = 0; i < POINTS; ++i) {
    const Vector2 point = disc.centre + disc.radius * unitVector(2.0 * PI * i / POINTS);
    rim = std::min(rim, point.norm());
    notePoint(point, sectors, found);
  }
  const bool around_agent = disc.centre.norm() < disc.radius;
  const int disc_class = around_agent ? 1 : classAt(rim);
  for (std::size_t sector = 0; sector < classes.size(); ++sector) {
    const bool counts = found.at(sector) < INFINITY && disc_class > 0;
    if (counts && (classes.at(sector) == 0 || disc_class < classes.at(sector))) classes.at(sector) = disc_class;
  }
}

/// The same for a wall, of which every part has a distance of its own. Whether the result is beyond doubt.
bool searchWall(const Segment& wall, int sectors, std::array<int, OccupancyStates::MAX_SECTORS>& classes) {
  Nearest found = nowhere();
  for (int i = 0; i <= POINTS; ++i) {
    notePoint(wall.from + (wall.to - wall.from) * i / POINTS, sectors, found);
  }
  bool beyond_doubt = *std::min_element(found.begin(), found.end()) > 0.05 &&
                      angleToLimit(bearingOf(wall.from), sectors) > CLEAR_ANGLE &&
                      angleToLimit(bearingOf(wall.to), sectors) > CLEAR_ANGLE;
  for (std::size_t sector = 0; sector < classes.size(); ++sector) {
    beyond_doubt = beyond_doubt && !isNearAClassLimit(found.at(sector));
    const int wall_class = classAt(found.at(sector));
    if (wall_class > 0 && (classes.at(sector) == 0 || wall_class < classes.at(sector))) {
      classes.at(sector) = wall_class;
    }
  }
  return beyond_doubt;
}

/// Compares one random world; false if it has something in it that is a matter of opinion.
bool compareWorld(std::uint64_t seed, std::uint32_t max_discs, std::uint32_t max_walls) {
  KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
  OccupancyStates::Parameters parameters;
  parameters.sectors = seed % 2 == 0 ? 8 : 2 + static_cast<int>(random.below(11));
  PerceptionsBuilder scene = PerceptionsBuilder().agent(0, {5.0, 0.0});
  std::array<int, OccupancyStates::MAX_SECTORS> expected{};
  for (std::uint32_t i = random.below(max_discs + 1); i > 0; --i) {
    const double distance = random.uniform(0.0, 2.0);
    const Disc disc = {polar(random.uniform(-180.0, 180.0), distance), random.uniform(0.02, 1.2)};
    if (isAMatterOfOpinion(disc, parameters.sectors)) return false;
    searchDisc(disc, parameters.sectors, expected);
    scene.body(disc.centre, disc.radius);
  }
  for (std::uint32_t i = random.below(max_walls + 1); i > 0; --i) {
    const double distance = random.uniform(0.0, 2.0);
    const Vector2 from = polar(random.uniform(-180.0, 180.0), distance);
    const double length = random.uniform(0.01, 3.0);
    const Segment wall = {from, from + polar(random.uniform(-180.0, 180.0), length)};
    if (!searchWall(wall, parameters.sectors, expected)) return false;
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

TEST(OccupancySampling, FindsTheSameSectorsOfABody) { EXPECT_GT(countCompared(1, 0), 900); }

TEST(OccupancySampling, FindsTheSameSectorsOfAWall) { EXPECT_GT(countCompared(0, 1), 700); }

TEST(OccupancySampling, FindsTheSameSectorsOfSeveralBodiesAndWalls) { EXPECT_GT(countCompared(3, 2), 500); }

}  // namespace
}  // namespace crowd
