#pragma once

#include "maps/floor_plan.h"

namespace crowd {

/// @brief A floor without the walls of small things, such as legs of a table or single occupied cells of a map: the
/// gaps beside them are no passages where agents must go one after the other. A thing consists of walls that share
/// ends; it is small if the diagonal of its bounding box is below 0.8 m.
FloorPlan withoutSmallThings(const FloorPlan& floor);

}  // namespace crowd
