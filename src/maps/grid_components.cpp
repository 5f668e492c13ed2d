#include "maps/grid_components.h"

namespace crowd {

GridComponents::GridComponents(const ClearanceGrid& grid, const std::vector<bool>& fits, const StopRequest& stop)
    : numbers(grid.size(), NONE) {
  constexpr std::size_t LOOK_AFTER = 1U << 16U;  // [points]
  using Index = ClearanceGrid::Index;
  std::vector<Index> found;
  for (Index seed = 0; seed < grid.size(); ++seed) {
    if (!fits[seed] || numbers[seed] != NONE) continue;
    found.assign(1, seed);
    const auto number = static_cast<std::uint32_t>(sizes.size());
    numbers[seed] = number;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (i % LOOK_AFTER == 0) stop.throwIfMade();
      grid.forNeighbours(found[i], [&](Index at) {
        if (!fits[at] || numbers[at] != NONE) return;
        numbers[at] = number;
        found.push_back(at);
      });
    }
    sizes.push_back(found.size());
  }
}

}  // namespace crowd
