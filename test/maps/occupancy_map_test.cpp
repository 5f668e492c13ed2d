#include "maps/occupancy_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/maps.h"

namespace crowd::occupancy_map_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// 3 columns, 2 rows, cells of 0.5 m, origin at (10, 20).
OccupancyMap smallMap(double yaw = 0.0) { return maps::drawn({"..#", ".?."}, 0.5, {{10.0, 20.0}, yaw}); }

TEST(OccupancyMap, OnlyFreeCellsOfTheMapAreFree) {
  const OccupancyMap map = smallMap();
  EXPECT_TRUE(map.isFree({0, 0}));
  EXPECT_FALSE(map.isFree({1, 0}));  // unknown
  EXPECT_TRUE(map.isFree({2, 0}));
  EXPECT_TRUE(map.isFree({1, 1}));
  EXPECT_FALSE(map.isFree({2, 1}));  // occupied
  for (const Cell& outside : {Cell{-1, 0}, Cell{0, -1}, Cell{3, 0}, Cell{0, 2}}) EXPECT_FALSE(map.isFree(outside));
}

TEST(OccupancyMap, CellsArePlacedFromTheOrigin) {
  const CellFrame frame(smallMap());
  EXPECT_EQ(frame.cornerOf({0, 0}), Vector2(10.0, 20.0));
  EXPECT_EQ(frame.cornerOf({3, 2}), Vector2(11.5, 21.0));
  EXPECT_EQ(frame.centreOf({2, 1}), Vector2(11.25, 20.75));
  EXPECT_EQ(frame.toCells({11.25, 20.25}), Vector2(2.5, 0.5));
  EXPECT_EQ(frame.cellAt({11.25, 20.75}), (Cell{2, 1}));
}

TEST(OccupancyMap, PointsOutsideAreInNoCell) {
  const OccupancyMap map = smallMap();
  const CellFrame frame(map);
  EXPECT_EQ(frame.cellAt({9.999, 21.001}), (Cell{-1, 2}));
  EXPECT_EQ(frame.cellAt({1e300, -1e300}), (Cell{3, -1}));
  EXPECT_FALSE(map.contains(frame.cellAt({std::nan(""), 20.25})));
}

TEST(OccupancyMap, YawRotatesTheRows) {
  const CellFrame frame(smallMap(PI / 2.0));  // rows lead to +y, columns to -x
  EXPECT_TRUE(frame.cornerOf({3, 2}).isApprox(Vector2(9.0, 21.5)));
  EXPECT_TRUE(frame.centreOf({2, 0}).isApprox(Vector2(9.75, 21.25)));
  EXPECT_EQ(frame.cellAt({9.75, 21.25}), (Cell{2, 0}));
  EXPECT_EQ(frame.cellAt({9.25, 20.25}), (Cell{0, 1}));
}

TEST(OccupancyMap, CentresOfCellsAreInTheCells) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    const OccupancyMap map = maps::random(random);
    const CellFrame frame(map);
    const Cell cell{static_cast<std::int32_t>(random.below(map.width)),
                    static_cast<std::int32_t>(random.below(map.height))};
    EXPECT_EQ(frame.cellAt(frame.centreOf(cell)), cell);
    EXPECT_NEAR((frame.centreOf(cell) - frame.cornerOf(cell)).norm(), map.resolution * std::sqrt(0.5), 1e-12);
  }
}

TEST(OccupancyMap, GridValuesHaveThreeStates) {
  const OccupancyMap layout = maps::drawn({"........"});
  const OccupancyMap map = mapFromGrid(layout, {-1, 0, 25, 26, 64, 65, 100, -128});
  const auto f = CellState::FREE;
  const auto o = CellState::OCCUPIED;
  const auto u = CellState::UNKNOWN;
  EXPECT_EQ(map.cells, (std::vector<CellState>{u, f, f, u, u, o, o, u}));
  EXPECT_EQ(map.resolution, layout.resolution);
}

/// The error message about a map after an invalid change.
template <typename Change>
std::string problemAfter(const Change& change) {
  OccupancyMap map = smallMap();
  change(map);
  return errorOf<InputError>([&] { requireValid(map); });
}

TEST(OccupancyMap, ValidMapIsAccepted) { EXPECT_EQ(problemOf(smallMap()), ""); }

TEST(OccupancyMap, MapWithoutCellsIsRefused) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.width = 0; }),
            "the map has no cells, expected at least one, got 0 x 2 cells");
  EXPECT_EQ(errorOf<InputError>([] { mapFromGrid({}, {}); }),
            "the map has no cells, expected at least one, got 0 x 0 cells");
}

TEST(OccupancyMap, WrongNumberOfCellsIsRefused) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.cells.pop_back(); }),
            "the map has 3 x 2 cells, expected 6 values, got 5");
  EXPECT_EQ(errorOf<InputError>([] {
              mapFromGrid(smallMap(), {0, 0, 0, 0, 0, 0, 0});
            }),
            "the map has 3 x 2 cells, expected 6 values, got 7");
}

TEST(OccupancyMap, TooLargeMapIsRefused) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.width = map.height = 4'000'000'000; }),
            "the map is too large: expected up to 100000000 cells, got 4000000000 x 4000000000 cells");
}

TEST(OccupancyMap, ResolutionMustBeFiniteAndAboveZero) {
  for (const double resolution : {0.0, -0.1, INFINITE, std::nan("")}) {
    const std::string problem = problemAfter([&](OccupancyMap& map) { map.resolution = resolution; });
    EXPECT_TRUE(contains(problem, "resolution: expected a finite number of metres above 0, got ")) << problem;
  }
}

TEST(OccupancyMap, OriginMustBeFinite) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.origin.position.y() = INFINITE; }),
            "origin: expected finite numbers, got [10, inf, 0]");
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.origin.heading = -INFINITE; }),
            "origin: expected finite numbers, got [10, 20, -inf]");
}

TEST(OccupancyMap, CellsMustBeDistinctAtTheirPlace) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) {
              map.resolution = 0.0005;
              map.origin.position.x() = -5e5;
            }),
            "the map is too far away for its resolution: expected coordinates of up to 1e9 times 5e-04 m, got "
            "500000.0025 m");
  EXPECT_EQ(problemAfter([](OccupancyMap& map) {
              map.resolution = 0.0005;
              map.origin.position.x() = -4e5;
            }),
            "no error");
  const std::string problem = problemAfter([](OccupancyMap& map) { map.resolution = 1e308; });
  EXPECT_TRUE(contains(problem, "too far away")) << problem;
}

TEST(OccupancyMap, PlacesMustBeWithinTheLimit) {
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.origin.position.x() = 1e6; }),
            "the map is too large or too far away: expected coordinates of up to 1e+06 m, got 1000002.5 m");
  EXPECT_EQ(problemAfter([](OccupancyMap& map) { map.origin.position.x() = -999'997.0; }), "no error");
}

}  // namespace
}  // namespace crowd::occupancy_map_test
