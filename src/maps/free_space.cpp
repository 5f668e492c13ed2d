#include "maps/free_space.h"

#include <algorithm>
#include <utility>

namespace crowd {

FreeSpace::FreeSpace(const OccupancyMap& map, const FloorPlan& floor, double radius, const StopRequest& stop)
    : clearance_(floor, 0.5 * map.resolution, radius + ROOM + map.resolution, stop) {
  using Index = ClearanceGrid::Index;
  const CellFrame frame(map);
  std::vector<bool> fits(clearance_.size(), false);
  for (Index point = 0; point < clearance_.size(); ++point) {
    if (point % clearance_.columns() == 0) stop.throwIfMade();
    fits[point] = clearance_[point] >= radius + ROOM && map.isFree(frame.cellAt(clearance_.place(point)));
    if (fits[point]) points_.push_back(point);
  }
  GridComponents components(clearance_, fits, stop);
  const std::vector<std::size_t>& sizes = components.sizes;
  components_ = std::move(components.numbers);
  const std::size_t largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  const auto is_pocket = [&](Index point) {
    const auto size = static_cast<double>(sizes[components_[point]]);
    return size < POCKET_SHARE * static_cast<double>(largest);
  };
  points_.erase(std::remove_if(points_.begin(), points_.end(), is_pocket), points_.end());
}

Vector2 FreeSpace::draw(KeyedRandom& random) const {
  const Vector2 centre = clearance_.place(points_[random.below(static_cast<std::uint32_t>(points_.size()))]);
  const double half = 0.5 * clearance_.spacing();
  const double dx = random.uniform(-half, half);
  return centre + Vector2(dx, random.uniform(-half, half));
}

}  // namespace crowd
