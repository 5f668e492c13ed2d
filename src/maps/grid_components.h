#pragma once

#include <cstdint>
#include <vector>

#include "maps/clearance_grid.h"

namespace crowd {

/// @brief The connected parts of the points of a grid where an agent fits.
struct GridComponents {
  static constexpr std::uint32_t NONE = 0xFFFFFFFF;

  /// @param fits by grid point @throws Stopped if `stop` is made
  GridComponents(const ClearanceGrid& grid, const std::vector<bool>& fits, const StopRequest& stop = {});

  std::vector<std::uint32_t> numbers;  ///< of the component, by grid point; NONE where the agent does not fit
  std::vector<std::size_t> sizes;      ///< number of points, by component
};

}  // namespace crowd
