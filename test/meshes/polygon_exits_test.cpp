#include "meshes/polygon_exits.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "common/random.h"
#include "meshes/mesh_data.h"
#include "support/floors.h"

namespace crowd::polygon_exits_test {
namespace {

using Data = NavigationMesh::Data;

Data dataOf(const FloorPlan& floor) { return Data(floor, 0.3, NavigationMesh::DEFAULT_CELL_SIZE, {}); }

/// The polygons that are connected with one by paths that do not pass another one.
std::vector<bool> reachedWithout(const dtMeshTile& mesh, std::size_t avoided, std::size_t first) {
  std::vector<bool> reached(static_cast<std::size_t>(mesh.header->polyCount), false);
  std::vector<std::size_t> open = {first};
  reached[first] = true;
  while (!open.empty()) {
    const dtPoly& polygon = mesh.polys[open.back()];
    open.pop_back();
    for (std::size_t edge = 0; edge < polygon.vertCount; ++edge) {
      const std::size_t behind = polygon.neis[edge] - 1U;
      if (polygon.neis[edge] == 0 || behind == avoided || reached[behind]) continue;
      reached[behind] = true;
      open.push_back(behind);
    }
  }
  return reached;
}

/// Compares all exits of all polygons, for all goals. Returns how many exits do not lead to a goal.
std::size_t compareWithSearches(const Data& mesh) {
  const dtMeshTile& tile = mesh.tile();
  std::size_t blind = 0;
  for (std::size_t polygon = 0; polygon < mesh.polygonCount(); ++polygon) {
    for (std::size_t edge = 0; edge < tile.polys[polygon].vertCount; ++edge) {
      if (tile.polys[polygon].neis[edge] == 0) continue;
      const std::vector<bool> reached = reachedWithout(tile, polygon, tile.polys[polygon].neis[edge] - 1U);
      for (std::size_t goal = 0; goal < mesh.polygonCount(); ++goal) {
        if (goal == polygon || mesh.components()[goal] != mesh.components()[polygon]) continue;
        EXPECT_EQ(mesh.exits().doesLead(polygon, edge, goal), reached[goal]) << polygon << ' ' << edge << ' ' << goal;
        if (!reached[goal]) ++blind;
      }
    }
  }
  return blind;
}

/// Rooms of 4 m x 4 m in rows. Some of the walls between them have a door, some are missing.
FloorPlan drawRooms(KeyedRandom& random) {
  constexpr double SIZE = 4.0;
  constexpr std::uint32_t COUNT = 3;
  FloorPlan floor = floors::room({0.0, 0.0}, {COUNT * SIZE, COUNT * SIZE});
  const auto add_wall = [&](const Vector2& from, const Vector2& along) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) return;
    if (kind == 1) return floor.walls.push_back({from, from + SIZE * along});
    const double door = random.uniform(0.5, SIZE - 1.7);
    floor.walls.push_back({from, from + door * along});
    floor.walls.push_back({from + (door + 1.2) * along, from + SIZE * along});
  };
  for (std::uint32_t i = 1; i < COUNT; ++i) {
    for (std::uint32_t k = 0; k < COUNT; ++k) {
      add_wall({i * SIZE, k * SIZE}, Vector2::UnitY());
      add_wall({k * SIZE, i * SIZE}, Vector2::UnitX());
    }
  }
  return floor;
}

TEST(PolygonExits, AWallWithADoorSeparatesTwoRooms) {
  const Data mesh = dataOf(floors::roomWithDoor(1.2));
  EXPECT_GT(compareWithSearches(mesh), 0U);
}

TEST(PolygonExits, BesideAnObstacleBothSidesLeadToTheGoal) {
  FloorPlan floor = floors::room({0.0, 0.0}, {10.0, 8.0});
  floor.obstacles = {{{5.0, 4.0}, 1.5}};
  const Data mesh = dataOf(floor);
  compareWithSearches(mesh);
}

TEST(PolygonExits, AgreesWithSearchesInRandomRooms) {
  std::size_t blind = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    blind += compareWithSearches(dataOf(drawRooms(random)));
  }
  EXPECT_GT(blind, 0U);
}

}  // namespace
}  // namespace crowd::polygon_exits_test
