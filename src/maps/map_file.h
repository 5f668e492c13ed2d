#pragma once

#include <string>

#include "maps/occupancy_map.h"

namespace crowd {

/// @brief Reads a map in map_server's format: a YAML file with the keys below and an image.
///
/// | key | what |
/// |---|---|
/// | `image` | PGM (P2 or P5) or PNG file; its path is relative to the YAML file |
/// | `resolution` | side of a cell [m] |
/// | `origin` | [x, y, yaw]: lower left corner of the image [m] and direction of its rows [rad], in `map` |
/// | `negate` | 0 or 1; 1: white is occupied and black is free |
/// | `occupied_thresh`, `free_thresh` | darkness (0 to 1) above which a cell is occupied, and below which it is free |
/// | `mode` | `trinary` (default), `scale` or `raw`, as in map_server |
///
/// The cells are those that mapFromGrid() makes of the message that map_server publishes: in mode `scale` a darkness
/// between the thresholds becomes an occupancy of 1 to 99 %, and in mode `raw` values of pixels are occupancies. As in
/// map_server, mode `trinary` averages transparency with the colours. Two things differ from map_server: colours of
/// palettes count instead of their indices, and brightness is corrected for the gamma of a PNG file unless it is
/// sRGB's.
/// @throws FileError if the YAML file cannot be read; InputError with file, line and key for anything else
OccupancyMap readMap(const std::string& yaml_file);

}  // namespace crowd
