#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/random.h"
#include "maps/occupancy_map.h"

/// Builders of maps for tests.
namespace crowd::maps {

/// A map drawn with characters, its top row first: '.' is free, '#' occupied, '?' unknown.
inline OccupancyMap drawn(const std::vector<std::string>& rows, double resolution = 1.0, const Pose& origin = {}) {
  OccupancyMap map;
  map.resolution = resolution;
  map.origin = origin;
  map.width = static_cast<std::uint32_t>(rows.front().size());
  map.height = static_cast<std::uint32_t>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char cell : *row) {
      const CellState blocked = cell == '#' ? CellState::OCCUPIED : CellState::UNKNOWN;
      map.cells.push_back(cell == '.' ? CellState::FREE : blocked);
    }
  }
  return map;
}

/// A map of any size up to `max_size` x `max_size` cells, at any place, with any yaw and any share of free cells.
inline OccupancyMap random(KeyedRandom& random, std::uint32_t max_size = 30) {
  OccupancyMap map;
  map.resolution = random.uniform(0.02, 1.0);
  map.origin.position = {random.uniform(-100.0, 100.0), random.uniform(-100.0, 100.0)};
  map.origin.heading = random.below(4) == 0 ? 0.0 : random.uniform(-PI, PI);
  map.width = 1 + random.below(max_size);
  map.height = 1 + random.below(max_size);
  const double free = random.uniform();
  for (std::uint32_t i = map.width * map.height; i > 0; --i) {
    const CellState blocked = random.below(2) == 0 ? CellState::OCCUPIED : CellState::UNKNOWN;
    map.cells.push_back(random.uniform() < free ? CellState::FREE : blocked);
  }
  return map;
}

}  // namespace crowd::maps
