#include "office.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/random.h"
#include "maps/free_space.h"
#include "maps/map_file.h"
#include "maps/map_walls.h"
#include "scenario/scenario.h"

namespace crowd {
namespace {

constexpr Range SPEEDS{0.9, 1.6};  // [m/s]
constexpr Range RADII{0.2, 0.3};   // [m]
constexpr int GOALS = 3;           // of each agent

// Of the office [cells].
constexpr int WIDTH = 500;
constexpr int HEIGHT = 400;
constexpr int ROOM = 50;  // width of a room
constexpr int WALL = 2;
constexpr int DOOR = 10;

/// Columns left .. right - 1 of the rows bottom .. top - 1.
struct Box {
  int left;
  int bottom;
  int right;
  int top;
};

void fill(OccupancyMap& map, const Box& box, CellState state) {
  for (int row = box.bottom; row < box.top; ++row) {
    for (int column = box.left; column < box.right; ++column) map.cells[map.indexOf({column, row})] = state;
  }
}

/// Walls between rooms, doors to the corridor, and desks.
void drawRooms(OccupancyMap& map, int bottom, int top, int wall_of_doors, KeyedRandom& random) {
  const auto below = [&](int count) { return static_cast<int>(random.below(static_cast<std::uint32_t>(count))); };
  for (int left = 0; left < WIDTH; left += ROOM) {
    fill(map, {left, bottom, left + WALL, top}, CellState::OCCUPIED);
    const int door = left + 5 + below(ROOM - DOOR - 10);
    fill(map, {door, wall_of_doors, door + DOOR, wall_of_doors + WALL}, CellState::FREE);
    for (int desk = 0; desk < 4; ++desk) {
      const int x = left + 12 + below(20);
      const int y = bottom + 12 + below(top - bottom - 32);
      fill(map, {x, y, x + 16, y + 8}, CellState::OCCUPIED);
    }
  }
}

/// Draws places for discs of the greatest radius in the largest connected part of a map.
class Places {
 public:
  Places(const OccupancyMap& map, const FloorPlan& floor, KeyedRandom& random) : space_(map, floor, RADII.high + 0.05) {
    if (space_.empty()) throw std::runtime_error("there is no free place on the map");
    std::map<std::uint32_t, int> hits;
    for (int i = 0; i < 1000; ++i) ++hits[space_.component(space_.draw(random))];
    const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
    component_ = std::max_element(hits.begin(), hits.end(), fewer)->first;
  }

  Vector2 drawStart(KeyedRandom& random) {
    for (int trial = 0; trial < 1000; ++trial) {
      Vector2 place = drawGoal(random);
      if (isTaken(place)) continue;
      starts_.push_back(place);
      return place;
    }
    throw std::runtime_error("the map has free places for " + std::to_string(starts_.size()) +
                             " people only, fewer than the benchmark walks; expected a larger map");
  }

  Vector2 drawGoal(KeyedRandom& random) const {
    Vector2 place = space_.draw(random);
    while (space_.component(place) != component_) place = space_.draw(random);
    return place;
  }

 private:
  bool isTaken(const Vector2& place) const {
    for (const Vector2& other : starts_) {
      if ((other - place).norm() < 2.0 * RADII.high + 0.05) return true;
    }
    return false;
  }

  FreeSpace space_;
  std::uint32_t component_ = 0;
  std::vector<Vector2> starts_;
};

}  // namespace

OccupancyMap drawOffice() {
  OccupancyMap map;
  map.resolution = 0.1;
  map.width = WIDTH;
  map.height = HEIGHT;
  map.cells.assign(std::size_t{WIDTH} * HEIGHT, CellState::FREE);
  for (const int wall : {0, 90, 112, 198, 285, 307, HEIGHT - WALL}) {
    fill(map, {0, wall, WIDTH, wall + WALL}, CellState::OCCUPIED);
  }
  KeyedRandom random(1, KeyedRandom::CONTENT, {});
  drawRooms(map, 2, 90, 90, random);
  drawRooms(map, 114, 198, 112, random);
  drawRooms(map, 200, 285, 285, random);
  drawRooms(map, 309, 398, 307, random);
  fill(map, {0, 0, WALL, HEIGHT}, CellState::OCCUPIED);
  fill(map, {WIDTH - WALL, 0, WIDTH, HEIGHT}, CellState::OCCUPIED);
  // Two rooms connect the corridors.
  for (const int left : {20, 470}) fill(map, {left, 198, left + DOOR, 198 + WALL}, CellState::FREE);
  return map;
}

OccupancyMap benchmarkMap() {
  const char* file = std::getenv("SOCIAL_CROWD_BENCH_MAP");  // NOLINT(concurrency-mt-unsafe)
  return file == nullptr ? drawOffice() : readMap(file);
}

Scene makeMapCrowd(const OccupancyMap& map, std::size_t agents) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {agents});
  Scene scene;
  scene.name = "map crowd";
  scene.max_ticks = UINT64_MAX;
  scene.goal_tolerance = 0.3;
  scene.walls = traceWalls(map);
  FloorPlan floor;
  floor.walls = scene.walls;
  Places places(map, floor, random);
  while (scene.agents.size() < agents) {
    AgentStart& agent = scene.agents.emplace_back();
    agent.position = places.drawStart(random);
    for (int i = 0; i < GOALS; ++i) agent.goals.push_back(places.drawGoal(random));
    agent.heading = bearingOf(agent.goals.front() - agent.position);
    agent.max_speed = SPEEDS.draw(random);
    agent.radius = RADII.draw(random);
  }
  return scene;
}

}  // namespace crowd
