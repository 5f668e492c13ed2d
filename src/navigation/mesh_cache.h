#pragma once

#include <memory>

#include "navigation/floor_ruler.h"
#include "navigation/navigation_mesh.h"

namespace crowd {

/// @brief What way-finding needs of a floor for agents up to one radius.
struct NavigationData {
  NavigationMesh comfortable;  ///< keeps a margin from walls
  NavigationMesh tight;        ///< for passages that are too narrow for that
  FloorRuler ruler;            ///< finds narrow places
};

/// @brief Margin between agents and walls on their way where there is room [m].
constexpr double COMFORTABLE_MARGIN = 0.1;
/// @brief The same in narrow passages [m].
constexpr double TIGHT_MARGIN = 0.02;

/// @brief The navigation data of a floor. The last few floors are kept, since episodes of one scenario share their
/// floor and gates alternate between two. Thread-safe.
/// @param radius of the agents [m]
/// @throws InputError and Stopped as NavigationMesh
std::shared_ptr<const NavigationData> navigationData(const FloorPlan& floor, double radius,
                                                     const StopRequest& stop = {});

}  // namespace crowd
