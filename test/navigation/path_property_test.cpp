// Properties of ways on random floors. Each failure names the seed of its floor.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "navigation/mesh_cache.h"
#include "support/floors.h"
#include "support/seeds.h"

namespace crowd::path_property_test {
namespace {

using Query = NavigationMesh::Query;

constexpr double RADIUS = 0.2;
constexpr std::uint64_t FLOORS = 150;
constexpr int PAIRS = 12;  // of start and goal on each floor

/// A grid over the room of floors::random() with the distances to walls and obstacles, computed one by one.
class FineGrid {
 public:
  static constexpr double SPACING = 0.02;
  static constexpr int COLUMNS = 300;
  static constexpr int ROWS = 250;

  explicit FineGrid(const FloorPlan& floor) {
    for (int i = 0; i < COLUMNS * ROWS; ++i) clearances_.push_back(floors::clearanceAt(floor, place(i)));
  }

  static Vector2 place(int i) {
    const int row = i / COLUMNS;
    return SPACING * Vector2(i % COLUMNS + 0.5, row + 0.5);
  }
  static int at(const Vector2& point) {
    return static_cast<int>(point.y() / SPACING) * COLUMNS + static_cast<int>(point.x() / SPACING);
  }
  double clearance(int i) const { return clearances_[static_cast<std::size_t>(i)]; }

  /// Length of the shortest way to each point over neighbours of which each has this clearance; infinite without one.
  std::vector<double> lengthsFrom(int start, double clearance) const {
    std::vector<double> lengths(clearances_.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto reach = [&](int i, double length) {
      if (this->clearance(i) < clearance || length >= lengths[static_cast<std::size_t>(i)]) return;
      lengths[static_cast<std::size_t>(i)] = length;
      open.emplace(length, i);
    };
    reach(start, 0.0);
    while (!open.empty()) {
      const auto [length, i] = open.top();
      open.pop();
      if (length > lengths[static_cast<std::size_t>(i)]) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int column = i % COLUMNS + dx;
          const int row = i / COLUMNS + dy;
          if (column < 0 || row < 0 || column >= COLUMNS || row >= ROWS) continue;
          reach(row * COLUMNS + column, length + SPACING * std::hypot(dx, dy));
        }
      }
    }
    return lengths;
  }

 private:
  std::vector<double> clearances_;
};

Vector2 drawPoint(KeyedRandom& random) {
  const double x = random.uniform(0.01, 5.99);
  return {x, random.uniform(0.01, 4.99)};
}

/// Runs check(floor, random) for random floors.
template <typename Check>
void forRandomFloors(std::uint64_t count, const Check& check) {
  forSeeds(count, KeyedRandom::CONTENT, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const FloorPlan floor = floors::random(random);
    check(floor, random);
  });
}

/// Runs check(from, to) for random pairs of points that are both on a mesh.
template <typename Check>
void forPairsOnMesh(Query& query, KeyedRandom& random, const Check& check) {
  for (int pair = 0; pair < PAIRS; ++pair) {
    const Vector2 from = drawPoint(random);
    const Vector2 to = drawPoint(random);
    if (query.contains(from) && query.contains(to)) check(from, to);
  }
}

TEST(PathProperty, TheMeshKeepsItsClearance) {
  forRandomFloors(FLOORS / 3, [](const FloorPlan& floor, KeyedRandom& random) {
    const NavigationMesh mesh(floor, random.uniform(0.1, 0.4));
    for (const auto& polygon : mesh.polygons()) {
      Vector2 from = polygon.back();
      for (const Vector2& corner : polygon) {
        ASSERT_GE(floors::clearanceAlong(floor, from, corner), mesh.clearance() - mesh.tolerance() - 1e-6);
        from = corner;
      }
    }
  });
}

TEST(PathProperty, PathsKeepTheRadiusFromWallsAndObstacles) {
  std::size_t paths = 0;
  forRandomFloors(FLOORS, [&](const FloorPlan& floor, KeyedRandom& random) {
    for (const double margin : {COMFORTABLE_MARGIN, TIGHT_MARGIN}) {
      const NavigationMesh mesh(floor, RADIUS + margin);
      Query query(mesh);
      forPairsOnMesh(query, random, [&](const Vector2& from, const Vector2& to) {
        const auto path = query.findPath(from, to);
        if (!path) return;
        ++paths;
        const double clearance = floors::clearanceOf(floor, from, *path);
        ASSERT_GE(clearance, RADIUS - 1e-3) << from.transpose() << " to " << to.transpose();
        ASSERT_GE(clearance, mesh.clearance() - mesh.tolerance() - 1e-4);
      });
    }
  });
  EXPECT_GT(paths, FLOORS);
}

TEST(PathProperty, LengthsAreAtLeastStraightAndTheSameBothWays) {
  forRandomFloors(FLOORS, [](const FloorPlan& floor, KeyedRandom& random) {
    Query query{NavigationMesh(floor, RADIUS + TIGHT_MARGIN)};
    for (int pair = 0; pair < PAIRS; ++pair) {
      const Vector2 from = drawPoint(random);
      const Vector2 to = drawPoint(random);
      const auto path = query.findPath(from, to);
      const auto back = query.findPath(to, from);
      ASSERT_EQ(path.has_value(), back.has_value());
      ASSERT_EQ(path.has_value(), query.component(from) && query.component(from) == query.component(to));
      if (!path) continue;
      ASSERT_EQ(path->corners.back(), to);
      ASSERT_NEAR(path->length, floors::lengthOf(from, *path), 1e-9);
      ASSERT_GE(path->length, (to - from).norm() - 1e-9);
      ASSERT_NEAR(path->length, back->length, 1e-5);
    }
  });
}

TEST(PathProperty, StraightMeansFree) {
  std::size_t straight = 0;
  forRandomFloors(FLOORS, [&](const FloorPlan& floor, KeyedRandom& random) {
    const NavigationMesh mesh(floor, RADIUS + TIGHT_MARGIN);
    Query query(mesh);
    forPairsOnMesh(query, random, [&](const Vector2& from, const Vector2& to) {
      const auto path = query.findPath(from, to);
      const bool is_straight = query.isStraight(from, to);
      ASSERT_EQ(query.isStraight(to, from), is_straight);
      ASSERT_EQ(is_straight, path && path->length < (to - from).norm() + 1e-7);
      if (!is_straight) return;
      ++straight;
      ASSERT_GE(floors::clearanceAlong(floor, from, to), mesh.clearance() - mesh.tolerance() - 2e-3);
    });
  });
  EXPECT_GT(straight, FLOORS / 2);
}

/// What one can reach with more room than the mesh needs is connected by the mesh, with a way that is not longer; what
/// the mesh connects can be reached with the room that it promises.
TEST(PathProperty, ReachAgreesWithAFloodFill) {
  std::size_t connected = 0;
  std::size_t separate = 0;
  forRandomFloors(FLOORS / 5, [&](const FloorPlan& floor, KeyedRandom& random) {
    const FineGrid grid(floor);
    const NavigationMesh mesh(floor, random.uniform(0.15, 0.5));
    Query query(mesh);
    // Neighbours on the grid are at most this far apart; between them, half of it is lost or gained.
    const double step = 0.5 * std::sqrt(2.0) * FineGrid::SPACING;
    const double least = mesh.clearance() - mesh.tolerance() - 2.0 * step;
    const double ample = mesh.clearance() + mesh.cellSize() + step;
    const double plenty = mesh.clearance() + 2.0 * mesh.cellSize() + step;
    for (int start = 0; start < 3; ++start) {
      const int from = FineGrid::at(drawPoint(random));
      if (grid.clearance(from) < ample) continue;
      const auto at_least = grid.lengthsFrom(from, least);
      const auto with_ample_room = grid.lengthsFrom(from, ample);
      const auto with_plenty = grid.lengthsFrom(from, plenty);
      for (int goal = 0; goal < PAIRS; ++goal) {
        const int to = FineGrid::at(drawPoint(random));
        if (grid.clearance(to) < least) continue;
        const auto path = query.findPath(FineGrid::place(from), FineGrid::place(to));
        const auto i = static_cast<std::size_t>(to);
        const std::string points = "from " + std::to_string(from) + " to " + std::to_string(to);
        ASSERT_TRUE(path || std::isinf(with_ample_room[i])) << points;
        const bool is_on_mesh = query.contains(FineGrid::place(to));
        ASSERT_TRUE(!path || !is_on_mesh || std::isfinite(at_least[i])) << points;
        ASSERT_LE(path ? path->length : 0.0, with_plenty[i] + 1e-6) << points;
        ++(path ? connected : separate);
      }
    }
  });
  EXPECT_GT(connected, 50U);
  EXPECT_GT(separate, 10U);
}

}  // namespace
}  // namespace crowd::path_property_test
