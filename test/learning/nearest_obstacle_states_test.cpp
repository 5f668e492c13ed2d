#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "common/random.h"
#include "learning/states/sector_states.h"
#include "support/error_of.h"
#include "support/parts.h"
#include "support/perceptions.h"
#include "support/rows.h"
#include "support/sector_cases.h"

namespace crowd::nearest_obstacle_states_test {
namespace {

using sector_cases::SectorCase;

/// The contents of a state.
struct Situation {
  int goal_sector;
  int obstacle_sector;
  int distance_class;  // 0: nothing perceived
};

const SectorStates& states() {
  static const auto STATES = statesOf("{type: nearest_obstacle}");
  return dynamic_cast<const SectorStates&>(*STATES);
}

/// Inverse of (3.2) and (3.3), with 8 sectors of each kind.
Situation describe(const StateSet& states, const PerceptionsBuilder& scene) {
  const auto row = static_cast<int>(rowsOf(states, scene.perception()).at(0));
  if (row < 8) return {row, 0, 0};
  return {(row - 8) / 16, (row - 8) % 16 / 2, (row - 8) % 2 + 1};
}

Situation describe(const PerceptionsBuilder& scene) { return describe(states(), scene); }

/// An agent whose goal lies 5 m straight ahead.
PerceptionsBuilder agentAlone() { return PerceptionsBuilder().agent(0, {5.0, 0.0}); }

/// The row of a state with 8 sectors of each kind.
Row rowOf(const Situation& situation) {
  PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(45.0 * situation.goal_sector, 5.0));
  const std::vector<double> bearings = {7.5, 30.0, 67.5, 135.0, -7.5, -30.0, -67.5, -135.0};
  if (situation.distance_class > 0) {
    const double rim = situation.distance_class == 1 ? 0.3 : 0.8;
    scene.neighbour(polar(bearings.at(static_cast<std::size_t>(situation.obstacle_sector)), rim + 0.1), 0.1);
  }
  return rowsOf(states(), scene.perception()).at(0);
}

int goalSectorOf(const Vector2& goal) { return describe(PerceptionsBuilder().agent(0, goal)).goal_sector; }

int classOfNeighbour(const Vector2& position, double radius) {
  return describe(agentAlone().neighbour(position, radius)).distance_class;
}

int classOfWall(const Vector2& from, const Vector2& to) { return describe(agentAlone().wall(from, to)).distance_class; }

TEST(NearestObstacleStates, HasEightGoalSectors) {
  for (const SectorCase& edge : sector_cases::EVEN) {
    EXPECT_EQ(goalSectorOf(polar(edge.degrees, 0.01)), edge.sector) << edge.degrees << " degrees";
    EXPECT_EQ(goalSectorOf(polar(edge.degrees, 1e4)), edge.sector) << edge.degrees << " degrees";
  }
}

TEST(NearestObstacleStates, HasUnevenObstacleSectors) {
  for (const SectorCase& edge : sector_cases::UNEVEN) {
    const Situation neighbour = describe(agentAlone().neighbour(polar(edge.degrees, 0.7), 0.1));
    EXPECT_EQ(neighbour.obstacle_sector, edge.sector) << edge.degrees << " degrees";
    // A wall with one end towards the agent.
    const Situation wall = describe(agentAlone().wall(polar(edge.degrees, 3.0), polar(edge.degrees, 0.7)));
    EXPECT_EQ(wall.obstacle_sector, edge.sector) << edge.degrees << " degrees";
  }
}

TEST(NearestObstacleStates, LimitsBelongToTheNearerClass) {
  // 0.75 - 0.25 = 0.5 and 1.25 - 0.25 = 1, both exactly.
  EXPECT_EQ(classOfNeighbour({0.75, 0.0}, 0.25), 1);
  EXPECT_EQ(classOfNeighbour({std::nextafter(0.75, 1.0), 0.0}, 0.25), 2);
  EXPECT_EQ(classOfNeighbour({0.0, -1.25}, 0.25), 2);
  EXPECT_EQ(classOfNeighbour({0.0, -std::nextafter(1.25, 2.0)}, 0.25), 0);
  EXPECT_EQ(classOfWall({0.5, -3.0}, {0.5, 3.0}), 1);
  EXPECT_EQ(classOfWall({std::nextafter(0.5, 1.0), -3.0}, {std::nextafter(0.5, 1.0), 3.0}), 2);
  EXPECT_EQ(classOfWall({-3.0, 1.0}, {3.0, 1.0}), 2);
  EXPECT_EQ(classOfWall({-3.0, std::nextafter(1.0, 2.0)}, {3.0, std::nextafter(1.0, 2.0)}), 0);
}

TEST(NearestObstacleStates, OverlapIsClassOne) {
  EXPECT_EQ(classOfNeighbour({0.2, 0.1}, 0.3), 1);  // the agent's centre lies within
  EXPECT_EQ(classOfNeighbour({0.0, 0.0}, 0.3), 1);
  EXPECT_EQ(classOfWall({-1.0, 0.0}, {1.0, 0.0}), 1);
}

TEST(NearestObstacleStates, PerceivesNothingBeyondItsRadius) {
  const Situation alone = describe(agentAlone());
  EXPECT_EQ(alone.distance_class, 0);
  EXPECT_EQ(classOfNeighbour({3.0, 0.0}, 0.5), 0);
  EXPECT_EQ(classOfWall({1.5, -1.0}, {1.5, 1.0}), 0);
  // A body beyond the radius of vision does not change the row.
  for (double degrees = -175.0; degrees < 180.0; degrees += 10.0) {
    EXPECT_EQ(rowsOf(states(), agentAlone().neighbour(polar(degrees, 2.0), 0.5).perception()).at(0), 0U);
  }
}

TEST(NearestObstacleStates, UsesTheNearestRim) {
  // Rims: 0.9 - 0.1 = 0.8 at the left, 1.5 - 1.1 = 0.4 at the right.
  const Situation situation = describe(agentAlone().neighbour(polar(60.0, 0.9), 0.1).neighbour(polar(-60.0, 1.5), 1.1));
  EXPECT_EQ(situation.obstacle_sector, 6);
  EXPECT_EQ(situation.distance_class, 1);
}

TEST(NearestObstacleStates, TreatsBodiesAndWallsEqually) {
  const Situation wall = describe(agentAlone().neighbour(polar(60.0, 0.9), 0.1).wall({-2.0, -0.3}, {2.0, -0.3}));
  EXPECT_EQ(wall.obstacle_sector, 7);  // 0.3 at -90 degrees: a limit goes to the sector behind it
  EXPECT_EQ(wall.distance_class, 1);
  const Situation neighbour = describe(agentAlone().neighbour(polar(60.0, 0.9), 0.1).wall({-2.0, -0.9}, {2.0, -0.9}));
  EXPECT_EQ(neighbour.obstacle_sector, 2);
  EXPECT_EQ(neighbour.distance_class, 2);
  // By a centimetre: rim 0.8 at the left, wall at the right.
  EXPECT_EQ(describe(agentAlone().neighbour(polar(60.0, 0.9), 0.1).wall({-2.0, -0.81}, {2.0, -0.81})).obstacle_sector,
            2);
  EXPECT_EQ(describe(agentAlone().neighbour(polar(60.0, 0.9), 0.1).wall({-2.0, -0.79}, {2.0, -0.79})).obstacle_sector,
            7);
}

TEST(NearestObstacleStates, FindsTheNearestObstacleInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const int count = 1 + static_cast<int>(random.below(8));
    const int nearest = static_cast<int>(random.below(static_cast<std::uint32_t>(count)));
    PerceptionsBuilder scene = agentAlone();
    double bearing = 0.0;
    for (int i = 0; i < count; ++i) {
      const double degrees = random.uniform(-179.0, 179.0);
      const double radius = random.uniform(0.05, 0.5);
      const double rim = i == nearest ? random.uniform(0.1, 0.2) : random.uniform(0.3, 2.0);
      scene.neighbour(polar(degrees, rim + radius), radius);
      if (i == nearest) bearing = degrees;
    }
    const double side = std::abs(bearing);
    const int expected = (side < 15.0 ? 0 : side < 45.0 ? 1 : side < 90.0 ? 2 : 3) + (bearing < 0.0 ? 4 : 0);
    EXPECT_EQ(describe(scene).obstacle_sector, expected);
    EXPECT_EQ(describe(scene).distance_class, 1);
  }
}

TEST(NearestObstacleStates, NumbersRowsAsTheThesisDoes) {
  EXPECT_EQ(states().rowCount(), 137U);
  EXPECT_EQ(states().terminal(), 136U);  // 8 * 8 * 2 + 8
  EXPECT_EQ(rowOf({0, 0, 0}), 0U);       // (3.2): G
  EXPECT_EQ(rowOf({3, 0, 0}), 3U);
  EXPECT_EQ(rowOf({7, 0, 0}), 7U);
  EXPECT_EQ(rowOf({0, 0, 1}), 8U);    // 7 + 0 * 16 + 0 * 2 + 1
  EXPECT_EQ(rowOf({0, 7, 2}), 23U);   // 7 + 0 * 16 + 7 * 2 + 2
  EXPECT_EQ(rowOf({1, 0, 1}), 24U);   // 7 + 1 * 16 + 0 * 2 + 1
  EXPECT_EQ(rowOf({5, 3, 2}), 95U);   // 7 + 5 * 16 + 3 * 2 + 2
  EXPECT_EQ(rowOf({7, 7, 2}), 135U);  // 7 + 7 * 16 + 7 * 2 + 2
}

TEST(NearestObstacleStates, NumbersRowsOfOtherSectors) {
  const auto four = statesOf("{type: nearest_obstacle, goal_sectors: 4, obstacle_sectors: [90, 180]}");
  EXPECT_EQ(four->rowCount(), 37U);  // 4 * 4 * 2 + 4, and the terminal row
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(0, polar(180.0, 5.0)).neighbour(polar(-135.0, 0.4), 0.1);
  EXPECT_EQ(rowsOf(*four, scene.perception()).at(0), 26U);  // 3 + 2 * 8 + 3 * 2 + 1
}

TEST(NearestObstacleStates, MapsSituationsToRowsOneToOne) {
  std::set<Row> rows = {states().terminal()};
  std::size_t situations = 1;
  for (int goal = 0; goal < 8; ++goal, ++situations) {
    rows.insert(rowOf({goal, 0, 0}));
    EXPECT_EQ(states().distanceClasses(rowOf({goal, 0, 0})), std::vector<int>{});
    for (int sector = 0; sector < 8; ++sector) {
      for (int distance_class = 1; distance_class <= 2; ++distance_class, ++situations) {
        const Row row = rowOf({goal, sector, distance_class});
        rows.insert(row);
        EXPECT_EQ(states().distanceClasses(row), std::vector<int>{distance_class});
      }
    }
  }
  EXPECT_EQ(situations, 137U);
  EXPECT_EQ(rows.size(), 137U);
  EXPECT_EQ(*rows.begin(), 0U);
  EXPECT_EQ(*rows.rbegin(), 136U);
  EXPECT_EQ(states().distanceClasses(states().terminal()), std::vector<int>{});
}

TEST(NearestObstacleStates, ReturnsTheOccupiedSectorForPictures) {
  EXPECT_TRUE(states().occupiedSectors(agentAlone().neighbour({3.0, 0.0}, 0.5).perception()).empty());
  const auto occupied = states().occupiedSectors(agentAlone().neighbour(polar(-30.0, 0.8), 0.1).perception());
  ASSERT_EQ(occupied.size(), 1U);
  EXPECT_NEAR(occupied[0].from, toRadians(-45.0), 1e-9);
  EXPECT_NEAR(occupied[0].to, toRadians(-15.0), 1e-9);
  EXPECT_EQ(occupied[0].distance_class, 2);
}

TEST(NearestObstacleStates, CanBeRelativeToTheMap) {
  const auto absolute = statesOf("{type: nearest_obstacle, directions: absolute}");
  // The goal is ahead, which is 90 degrees in the map; the obstacle is at 90 + 170 = 260 degrees, which is -100.
  const PerceptionsBuilder scene = agentAlone().heading(90.0).neighbour(polar(170.0, 0.8), 0.1);
  EXPECT_EQ(describe(*absolute, scene).goal_sector, 2);
  EXPECT_EQ(describe(*absolute, scene).obstacle_sector, 7);  // -180 to -90 degrees
  const auto occupied = dynamic_cast<const SectorPicture&>(*absolute).occupiedSectors(scene.perception());
  // In the agent's frame.
  EXPECT_NEAR(occupied.at(0).from, toRadians(-180.0 - 90.0), 1e-9);
  EXPECT_NEAR(occupied.at(0).to, toRadians(-90.0 - 90.0), 1e-9);
  EXPECT_TRUE(contains(absolute->spec(), "vision_radius: 1, directions: absolute}"));
}

TEST(NearestObstacleStates, UsesItsParameters) {
  const std::string spec =
      "{type: nearest_obstacle, goal_sectors: 4, obstacle_sectors: [22.5, 180], collision_radius: 0.25, "
      "vision_radius: 3}";
  const auto four = statesOf(spec);
  const auto& sectors = dynamic_cast<const SectorStates&>(*four);
  EXPECT_EQ(sectors.distanceLimits(), (std::vector<double>{0.25, 3.0}));
  EXPECT_EQ(four->rowsPerPerception(), 1U);
  EXPECT_EQ(four->spec(), spec);
  const auto class_at = [&](double rim) {
    const auto scene = agentAlone().neighbour({rim + 0.5, 0.0}, 0.5);
    const std::vector<int> classes = sectors.distanceClasses(rowsOf(*four, scene.perception()).at(0));
    return classes.empty() ? 0 : classes[0];
  };
  EXPECT_EQ(class_at(0.25), 1);
  EXPECT_EQ(class_at(0.5), 2);
  EXPECT_EQ(class_at(3.0), 2);
  EXPECT_EQ(class_at(3.125), 0);
}

}  // namespace
}  // namespace crowd::nearest_obstacle_states_test
