#include "navigation/mesh_cache.h"

#include <algorithm>
#include <list>
#include <mutex>

#include "navigation/way_claims.h"

namespace crowd {
namespace {

constexpr std::size_t MAX_KEPT = 16;

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

/// What was made of the last floors.
template <typename Data>
class FloorCache {
 public:
  template <typename Make>
  std::shared_ptr<const Data> get(const FloorPlan& floor, double radius, const Make& make) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Entry& entry) {
      return entry.radius == radius && isSame(entry.floor, floor);
    });
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
    } else {
      kept_.push_front({floor, radius, std::make_shared<const Data>(make())});
      if (kept_.size() > MAX_KEPT) kept_.pop_back();
    }
    return kept_.front().data;
  }

 private:
  struct Entry {
    FloorPlan floor;
    double radius = 0.0;
    std::shared_ptr<const Data> data;
  };

  std::mutex mutex_;
  std::list<Entry> kept_;  // the last used one in front
};

}  // namespace

std::shared_ptr<const NavigationData> navigationData(const FloorPlan& floor, double radius, const StopRequest& stop) {
  static FloorCache<NavigationData> cache;
  return cache.get(floor, radius, [&] {
    return NavigationData{NavigationMesh(floor, radius + COMFORTABLE_MARGIN, NavigationMesh::DEFAULT_CELL_SIZE, stop),
                          NavigationMesh(floor, radius + TIGHT_MARGIN, NavigationMesh::DEFAULT_CELL_SIZE, stop)};
  });
}

std::shared_ptr<const FloorRuler> floorRuler(const FloorPlan& floor, double radius, const StopRequest& stop) {
  static FloorCache<FloorRuler> cache;
  return cache.get(floor, radius, [&] { return FloorRuler(floor, WayClaims::wideClearance(radius), stop); });
}

}  // namespace crowd
