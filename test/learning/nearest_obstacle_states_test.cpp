#include "learning/states/nearest_obstacle_states.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "common/random.h"
#include "support/perceptions.h"
#include "support/rows.h"
#include "support/sector_cases.h"

namespace crowd::nearest_obstacle_states_test {
namespace {

using Situation = NearestObstacleStates::Situation;
using sector_cases::SectorCase;

/// An agent whose goal lies 5 m straight ahead.
PerceptionsBuilder agentAlone() { return PerceptionsBuilder().agent(0, {5.0, 0.0}); }

Situation describe(const PerceptionsBuilder& scene) { return NearestObstacleStates().describe(scene.perception()); }

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
  const NearestObstacleStates states;
  for (double degrees = -175.0; degrees < 180.0; degrees += 10.0) {
    EXPECT_EQ(states.rowOf(describe(agentAlone().neighbour(polar(degrees, 2.0), 0.5))), 0U);
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
  const NearestObstacleStates states;
  EXPECT_EQ(states.rowCount(), 137U);
  EXPECT_EQ(states.terminal(), 136U);      // 8 * 8 * 2 + 8
  EXPECT_EQ(states.rowOf({0, 0, 0}), 0U);  // (3.2): G
  EXPECT_EQ(states.rowOf({3, 0, 0}), 3U);
  EXPECT_EQ(states.rowOf({7, 0, 0}), 7U);
  EXPECT_EQ(states.rowOf({0, 0, 1}), 8U);    // 7 + 0 * 16 + 0 * 2 + 1
  EXPECT_EQ(states.rowOf({0, 7, 2}), 23U);   // 7 + 0 * 16 + 7 * 2 + 2
  EXPECT_EQ(states.rowOf({1, 0, 1}), 24U);   // 7 + 1 * 16 + 0 * 2 + 1
  EXPECT_EQ(states.rowOf({5, 3, 2}), 95U);   // 7 + 5 * 16 + 3 * 2 + 2
  EXPECT_EQ(states.rowOf({7, 7, 2}), 135U);  // 7 + 7 * 16 + 7 * 2 + 2
}

TEST(NearestObstacleStates, NumbersRowsOfOtherSectors) {
  NearestObstacleStates::Parameters parameters;
  parameters.goal_sectors = 4;
  parameters.obstacle_sectors = {90.0, 180.0};
  const NearestObstacleStates states(parameters);
  EXPECT_EQ(states.terminal(), 36U);        // 4 * 4 * 2 + 4
  EXPECT_EQ(states.rowOf({2, 3, 1}), 26U);  // 3 + 2 * 8 + 3 * 2 + 1
}

TEST(NearestObstacleStates, MapsSituationsToRowsOneToOne) {
  const NearestObstacleStates states;
  std::set<Row> rows = {states.terminal()};
  std::size_t situations = 1;
  for (int goal = 0; goal < 8; ++goal, ++situations) {
    rows.insert(states.rowOf({goal, 0, 0}));
    EXPECT_EQ(states.distanceClasses(states.rowOf({goal, 0, 0})), std::vector<int>{});
    for (int sector = 0; sector < 8; ++sector) {
      for (int distance_class = 1; distance_class <= 2; ++distance_class, ++situations) {
        const Row row = states.rowOf({goal, sector, distance_class});
        rows.insert(row);
        EXPECT_EQ(states.distanceClasses(row), std::vector<int>{distance_class});
      }
    }
  }
  EXPECT_EQ(situations, 137U);
  EXPECT_EQ(rows.size(), 137U);
  EXPECT_EQ(*rows.begin(), 0U);
  EXPECT_EQ(*rows.rbegin(), 136U);
  EXPECT_EQ(states.distanceClasses(states.terminal()), std::vector<int>{});
}

TEST(NearestObstacleStates, EachRowExceptTheTerminalOneCanBePerceived) {
  const NearestObstacleStates states;
  std::set<Row> rows;
  for (double goal = 0.0; goal < 360.0; goal += 45.0) {
    const PerceptionsBuilder alone = PerceptionsBuilder().agent(0, polar(goal, 5.0));
    rows.insert(rowsOf(states, alone.perception()).at(0));
    for (const double bearing : {7.5, 30.0, 67.5, 135.0, -7.5, -30.0, -67.5, -135.0}) {
      for (const double rim : {0.3, 0.8}) {
        const PerceptionsBuilder scene =
            PerceptionsBuilder().agent(0, polar(goal, 5.0)).neighbour(polar(bearing, rim + 0.1), 0.1);
        rows.insert(rowsOf(states, scene.perception()).at(0));
      }
    }
  }
  EXPECT_EQ(rows.size(), 136U);
  EXPECT_EQ(rows.count(states.terminal()), 0U);
}

TEST(NearestObstacleStates, ReturnsTheOccupiedSectorForPictures) {
  const NearestObstacleStates states;
  EXPECT_TRUE(states.occupiedSectors(agentAlone().neighbour({3.0, 0.0}, 0.5).perception()).empty());
  const auto occupied = states.occupiedSectors(agentAlone().neighbour(polar(-30.0, 0.8), 0.1).perception());
  ASSERT_EQ(occupied.size(), 1U);
  EXPECT_NEAR(occupied[0].from, toRadians(-45.0), 1e-9);
  EXPECT_NEAR(occupied[0].to, toRadians(-15.0), 1e-9);
  EXPECT_EQ(occupied[0].distance_class, 2);
}

TEST(NearestObstacleStates, CanBeRelativeToTheMap) {
  NearestObstacleStates::Parameters parameters;
  parameters.directions = Directions::ABSOLUTE;
  const NearestObstacleStates states(parameters);
  // The goal is ahead, which is 90 degrees in the map; the obstacle is at 90 + 170 = 260 degrees, which is -100.
  const PerceptionsBuilder scene = agentAlone().heading(90.0).neighbour(polar(170.0, 0.8), 0.1);
  EXPECT_EQ(states.describe(scene.perception()).goal_sector, 2);
  EXPECT_EQ(states.describe(scene.perception()).obstacle_sector, 7);  // -180 to -90 degrees
  const auto occupied = states.occupiedSectors(scene.perception());   // in the agent's frame
  EXPECT_NEAR(occupied.at(0).from, toRadians(-180.0 - 90.0), 1e-9);
  EXPECT_NEAR(occupied.at(0).to, toRadians(-90.0 - 90.0), 1e-9);
  EXPECT_TRUE(contains(states.spec(), "vision_radius: 1, directions: absolute}"));
}

TEST(NearestObstacleStates, UsesItsParameters) {
  NearestObstacleStates::Parameters parameters;
  parameters.goal_sectors = 4;
  parameters.obstacle_sectors = {22.5, 180.0};
  parameters.distances = {0.25, 3.0};
  const NearestObstacleStates states(parameters);
  EXPECT_EQ(states.distanceLimits(), (std::vector<double>{0.25, 3.0}));
  EXPECT_EQ(states.rowsPerPerception(), 1U);
  EXPECT_EQ(states.spec(),
            "{type: nearest_obstacle, goal_sectors: 4, obstacle_sectors: [22.5, 180], collision_radius: 0.25, "
            "vision_radius: 3}");
  const auto class_at = [&](double rim) {
    return states.describe(agentAlone().neighbour({rim + 0.5, 0.0}, 0.5).perception()).distance_class;
  };
  EXPECT_EQ(class_at(0.25), 1);
  EXPECT_EQ(class_at(0.5), 2);
  EXPECT_EQ(class_at(3.0), 2);
  EXPECT_EQ(class_at(3.125), 0);
}

}  // namespace
}  // namespace crowd::nearest_obstacle_states_test
