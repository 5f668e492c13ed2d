#include "maps/occupancy_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// Index of the unit interval that a coordinate is in; -1 below 0 (or not a number), `count` from `count` on.
std::int32_t indexOf(double coordinate, std::uint32_t count) {
  if (!(coordinate >= 0.0)) return -1;
  return static_cast<std::int32_t>(std::min(coordinate, static_cast<double>(count)));
}

constexpr double MAX_CELLS_FROM_ZERO = 1e9;  // beyond it, corners of cells are rounded by more than 1e-7 of a cell

/// An upper limit of the coordinates of the corners, for every yaw [m].
double extentOf(const OccupancyMap& map) {
  const double sides = (static_cast<double>(map.width) + static_cast<double>(map.height)) * map.resolution;
  return map.origin.position.cwiseAbs().maxCoeff() + sides;
}

std::string cellCounts(const OccupancyMap& map) {
  return std::to_string(map.width) + " x " + std::to_string(map.height) + " cells";
}

std::string problemOfSize(const OccupancyMap& map) {
  if (map.width == 0 || map.height == 0) return "the map has no cells, expected at least one, got " + cellCounts(map);
  const std::uint64_t count = std::uint64_t{map.width} * map.height;
  if (count > limits::CELLS)
    return "the map is too large: expected up to " + std::to_string(limits::CELLS) + " cells, got " + cellCounts(map);
  if (count != map.cells.size())
    return "the map has " + cellCounts(map) + ", expected " + std::to_string(count) + " values, got " +
           std::to_string(map.cells.size());
  return "";
}

std::string problemOfPlace(const OccupancyMap& map) {
  if (!std::isfinite(map.resolution) || map.resolution <= 0.0)
    return "resolution: expected a finite number of metres above 0, got " + toText(map.resolution);
  const Vector2& position = map.origin.position;
  if (!position.allFinite() || !std::isfinite(map.origin.heading))
    return "origin: expected finite numbers, got " +
           toText(std::vector<double>{position.x(), position.y(), map.origin.heading});
  const double extent = extentOf(map);
  if (!std::isfinite(extent) || extent > MAX_CELLS_FROM_ZERO * map.resolution)
    return "the map is too far away for its resolution: expected coordinates of up to 1e9 times " +
           toText(map.resolution) + " m, got " + toText(extent) + " m";
  if (extent > limits::PLACE.most)
    return "the map is too large or too far away: expected coordinates of up to " + toText(limits::PLACE.most) +
           " m, got " + toText(extent) + " m";
  return "";
}

}  // namespace

std::string problemOf(const OccupancyMap& map) {
  std::string problem = problemOfSize(map);
  return problem.empty() ? problemOfPlace(map) : problem;
}

void requireValid(const OccupancyMap& map) {
  const std::string problem = problemOf(map);
  if (!problem.empty()) throw InputError(problem);
}

OccupancyMap mapFromGrid(OccupancyMap layout, const std::vector<std::int8_t>& data) {
  layout.cells.resize(data.size());
  std::transform(data.begin(), data.end(), layout.cells.begin(), cellStateOf);
  requireValid(layout);
  return layout;
}

Cell CellFrame::cellAt(const Vector2& point) const {
  const Vector2 cells = toCells(point);
  return {indexOf(cells.x(), width_), indexOf(cells.y(), height_)};
}

}  // namespace crowd
