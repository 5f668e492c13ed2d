#pragma once

#include "maps/occupancy_map.h"
#include "scenario/scene.h"

namespace crowd {

/// @brief Draws the map of an office floor of 50 m x 40 m in cells of 0.1 m: two corridors of 2 m, 40 rooms of 5 m x 8
/// m with doors of 1 m and four desks each; deterministic.
OccupancyMap drawOffice();

/// @brief The map of the benchmarks: that of the file which the environment variable SOCIAL_CROWD_BENCH_MAP names, or
/// the office.
OccupancyMap benchmarkMap();

/// @brief Start and goals of agents at random on a map, mixed speeds and sizes; all goals can be reached.
/// @throws std::runtime_error if they do not find places
Scene makeMapCrowd(const OccupancyMap& map, std::size_t agents);

}  // namespace crowd
