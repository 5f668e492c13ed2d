#include "social_crowd/navigation/mesh_cache.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <list>
#include <map>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace crowd {
namespace {

constexpr std::size_t MAX_KEPT = 8;

struct Entry {
  FloorPlan floor;
  double radius;
  double passage_width;
  std::shared_ptr<const NavigationData> data;
};

bool isSame(const FloorPlan& a, const FloorPlan& b) {
  const auto same_wall = [](const Segment& p, const Segment& q) { return p.from == q.from && p.to == q.to; };
  const auto same_disc = [](const FloorPlan::Disc& p, const FloorPlan::Disc& q) {
    return p.centre == q.centre && p.radius == q.radius;
  };
  if (a.bounds.has_value() != b.bounds.has_value()) return false;
  if (a.bounds && (a.bounds->low != b.bounds->low || a.bounds->high != b.bounds->high)) return false;
  return std::equal(a.walls.begin(), a.walls.end(), b.walls.begin(), b.walls.end(), same_wall) &&
         std::equal(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end(), same_disc);
}

/// Connected walls with less than this extent are small: agents walk round them on both sides [m].
constexpr double SMALL = 0.8;

/// The root of a wall's set, in a forest where each element refers to another one of its set.
std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t element) {
  while (parents[element] != element) element = parents[element] = parents[parents[element]];
  return element;
}

/// Leaves out walls that belong to small things, such as legs of a table or single occupied cells of a map: the gaps
/// beside them are no passages where people must go one after the other.
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

}  // namespace

std::shared_ptr<const NavigationData> navigationData(const FloorPlan& floor, double radius, double passage_width) {
  static std::mutex mutex;
  static std::list<Entry> kept;  // the last used one in front
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const Entry& entry) {
    return entry.radius == radius && entry.passage_width == passage_width && isSame(entry.floor, floor);
  });
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
    return found->data;
  }
  auto data = std::make_shared<const NavigationData>(
      NavigationData{NavigationMesh(floor, radius + COMFORTABLE_MARGIN), NavigationMesh(floor, radius + TIGHT_MARGIN),
                     Passages(withoutSmallThings(floor), radius, passage_width)});
  kept.push_front({floor, radius, passage_width, data});
  if (kept.size() > MAX_KEPT) kept.pop_back();
  return data;
}

}  // namespace crowd
