#include "navigation/mesh_cache.h"

#include <algorithm>
#include <list>
#include <mutex>

#include "navigation/way_claims.h"

namespace crowd {
namespace {

constexpr std::size_t MAX_KEPT = 8;

struct Entry {
  FloorPlan floor;
  double radius;
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

}  // namespace

std::shared_ptr<const NavigationData> navigationData(const FloorPlan& floor, double radius, const StopRequest& stop) {
  static std::mutex mutex;
  static std::list<Entry> kept;  // the last used one in front
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = std::find_if(kept.begin(), kept.end(), [&](const Entry& entry) {
    return entry.radius == radius && isSame(entry.floor, floor);
  });
  if (found != kept.end()) {
    kept.splice(kept.begin(), kept, found);
    return found->data;
  }
  auto data = std::make_shared<const NavigationData>(
      NavigationData{NavigationMesh(floor, radius + COMFORTABLE_MARGIN, NavigationMesh::DEFAULT_CELL_SIZE, stop),
                     NavigationMesh(floor, radius + TIGHT_MARGIN, NavigationMesh::DEFAULT_CELL_SIZE, stop),
                     FloorRuler(floor, WayClaims::wideClearance(radius), stop)});
  kept.push_front({floor, radius, data});
  if (kept.size() > MAX_KEPT) kept.pop_back();
  return data;
}

}  // namespace crowd
