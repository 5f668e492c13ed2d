#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief State of a cell of a map. Agents can stand on free cells only.
enum class CellState : std::uint8_t { FREE, OCCUPIED, UNKNOWN };

/// @brief Column and row of a cell; column 0 is at the left, row 0 at the bottom of a map that is not turned.
struct Cell {
  std::int32_t column = 0;
  std::int32_t row = 0;
};

inline bool operator==(const Cell& a, const Cell& b) { return a.column == b.column && a.row == b.row; }
inline bool operator!=(const Cell& a, const Cell& b) { return !(a == b); }

/// @brief A map of square cells, laid out as in nav_msgs/OccupancyGrid: row by row from the bottom.
struct OccupancyMap {
  double resolution = 0.0;   ///< length of the side of a cell [m]
  Pose origin;               ///< outer corner of cell (0, 0) and direction of the rows, in `map` [m, rad]
  std::uint32_t width = 0;   ///< number of columns
  std::uint32_t height = 0;  ///< number of rows
  std::vector<CellState> cells;

  /// @brief Whether the map has this cell.
  bool contains(const Cell& cell) const {
    return cell.column >= 0 && cell.row >= 0 && static_cast<std::uint32_t>(cell.column) < width &&
           static_cast<std::uint32_t>(cell.row) < height;
  }
  /// @brief Index of a cell of the map in `cells`.
  std::size_t indexOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.row) * width + static_cast<std::size_t>(cell.column);
  }
  /// @brief Whether the cell is free; cells outside of the map are not.
  bool isFree(const Cell& cell) const { return contains(cell) && cells[indexOf(cell)] == CellState::FREE; }
};

/// @brief What is wrong with a map, and what was expected; empty if the map is valid: it has cells and not more than
/// limits::CELLS, as many as its size says, a finite resolution above 0 m, a finite origin, and coordinates of at most
/// 1e9 times its resolution and within limits::PLACE.
std::string problemOf(const OccupancyMap& map);

/// @brief Throws InputError with the text of problemOf() unless it is empty.
void requireValid(const OccupancyMap& map);

/// @brief The map of the cells of a nav_msgs/OccupancyGrid, in which -1 is unknown and 0 to 100 the probability of
/// occupancy [%]. As in map_server's map_saver, 0 to 25 are free and 65 and more are occupied; all others are unknown.
/// @param layout resolution, origin and size of the map; its cells are ignored
/// @throws InputError if the map is not valid
OccupancyMap mapFromGrid(OccupancyMap layout, const std::vector<std::int8_t>& data);

/// @brief The state of a cell of a nav_msgs/OccupancyGrid, see mapFromGrid().
constexpr CellState cellStateOf(std::int8_t value) {
  if (value >= 0 && value <= 25) return CellState::FREE;
  return value >= 65 ? CellState::OCCUPIED : CellState::UNKNOWN;
}

/// @brief Conversions between the cells of a valid map and points in `map`; stores sine and cosine of the map's yaw.
class CellFrame {
 public:
  explicit CellFrame(const OccupancyMap& map)
      : origin_(map.origin.position),
        rotation_(map.origin.heading),
        resolution_(map.resolution),
        width_(map.width),
        height_(map.height) {}

  /// @brief The lower left corner of a cell [m]; columns up to `width` and rows up to `height` give the outer corners.
  Vector2 cornerOf(const Cell& cell) const { return toMap(Vector2(cell.column, cell.row)); }
  /// @brief The centre of a cell [m].
  Vector2 centreOf(const Cell& cell) const { return toMap(Vector2(cell.column + 0.5, cell.row + 0.5)); }
  /// @brief The point at this column and row [m], both of which may be fractions.
  Vector2 toMap(const Vector2& cells) const { return origin_ + rotation_.outOfFrame(resolution_ * cells); }
  /// @brief Column and row of a point [m], both of which may be fractions.
  Vector2 toCells(const Vector2& point) const { return rotation_.intoFrame(point - origin_) / resolution_; }
  /// @brief The cell that a point [m] is in. Outside of the map, column or row is -1 or the number of columns or rows.
  Cell cellAt(const Vector2& point) const;

 private:
  Vector2 origin_;
  Rotation rotation_;
  double resolution_;
  std::uint32_t width_;
  std::uint32_t height_;
};

}  // namespace crowd
