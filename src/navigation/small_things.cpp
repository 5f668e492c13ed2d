#include "navigation/small_things.h"

#include <Eigen/Geometry>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace crowd {
namespace {

/// Diagonal of the bounding box of a small thing, at most [m].
constexpr double SMALL = 0.8;

/// The root of a wall's set, in a forest where each element refers to another one of its set.
std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t element) {
  while (parents[element] != element) element = parents[element] = parents[parents[element]];
  return element;
}

}  // namespace

FloorPlan withoutSmallThings(const FloorPlan& floor) {
  std::vector<std::size_t> parents(floor.walls.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  std::map<std::pair<double, double>, std::size_t> wall_at;
  for (std::size_t i = 0; i < floor.walls.size(); ++i) {
    for (const Vector2& end : {floor.walls[i].from, floor.walls[i].to}) {
      const auto [other, is_new] = wall_at.emplace(std::make_pair(end.x(), end.y()), i);
      if (!is_new) parents[rootOf(parents, i)] = rootOf(parents, other->second);
    }
  }
  std::vector<Eigen::AlignedBox2d> boxes(floor.walls.size());
  for (std::size_t i = 0; i < floor.walls.size(); ++i) {
    boxes[rootOf(parents, i)].extend(floor.walls[i].from).extend(floor.walls[i].to);
  }
  FloorPlan large = floor;
  large.walls.clear();
  for (std::size_t i = 0; i < floor.walls.size(); ++i) {
    if (boxes[rootOf(parents, i)].diagonal().norm() >= SMALL) large.walls.push_back(floor.walls[i]);
  }
  return large;
}

}  // namespace crowd
